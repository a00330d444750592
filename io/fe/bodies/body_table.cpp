#include "io/fe/bodies/body_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "core/base/error.h"
#include "core/base/nearest_names.h"
#include "core/fe/material.h"
#include "io/base/trimmed.h"
#include "io/fe/bodies/body_columns.h"
#include "io/fe/bodies/body_meshes.h"

namespace rubble::io {

namespace {

constexpr std::uintmax_t mostBytes = std::uintmax_t{256} << 20;
/// A quaternion of six digits has this length at least.
constexpr double turnTolerance = 1e-3;

/// Reads the rows of one table.
class BodyReading {
public:
    explicit BodyReading(const NamedColumns& columns) : m_columns(columns), m_meshes(columns.path), m_line(1) {}

    BodyTable read() {
        takeNames();
        checkNames();
        for (const DelimitedRow& row : m_columns.table.rows) {
            m_row = &row;
            m_line = row.line;
            readBody();
        }
        if (m_table.bodies.empty()) {
            refuse({"bodies.none", "{0} holds no bodies", {m_columns.path}},
                   {"bodies.none.remedy", "Give a heading and one line for each body.", {}});
        }
        addAssumptions();
        m_table.findings.append(m_meshes.findings());
        return std::move(m_table);
    }

private:
    struct Source {
        std::optional<std::size_t> index;  ///< column; unset: the constant
        std::string constant;
        double unit = 1.0;
    };

    [[noreturn]] void refuse(Message what, Message remedy) const { throw ParseError(std::move(what), std::move(remedy)); }

    void takeNames() {
        for (std::size_t i = 0; i < m_columns.names.size(); ++i) {
            take(m_columns.names[i], {i, {}, 1.0});
        }
        for (const auto& [name, text] : m_columns.constants) {
            take(name, {std::nullopt, text, 1.0});
        }
    }

    void take(const std::string& name, Source source) {
        const ReadColumn read = columnNamed(name);
        if (read.withoutFrame) {
            refuse({"bodies.no_frame", "{0}: the column {1} does not say of which axes the spin is", {m_columns.path, name}},
                   {"bodies.no_frame.remedy",
                    "Name it {0}_world_rad_s or {0}_body_rad_s: about the axes of the table or the body's.",
                    {name.substr(0, 2)}});
        }
        if (read.column == nullptr) {
            m_unknown.push_back(name);
            return;
        }
        const std::string column(read.column->name);
        if (read.withoutUnit || !read.unknownUnit.empty()) {
            refuse({"bodies.no_unit", "{0}: the column {1} has no unit that is known", {m_columns.path, name}},
                   {"bodies.no_unit.remedy",
                    "Write {0} and one of these behind it, with a line between: {1}.",
                    {column, unitsOf(read.column->quantity)}});
        }
        source.unit = read.unit;
        if (!m_sources.emplace(column, source).second) {
            refuse({"bodies.twice", "{0}: the column {1} stands twice", {m_columns.path, column}},
                   {"bodies.twice.remedy", "Keep one of the two.", {}});
        }
    }

    bool has(const std::string& column) const { return m_sources.contains(column); }

    /// All three, or none of them.
    bool hasAll(const std::vector<std::string>& names) const {
        const auto found = std::count_if(names.begin(), names.end(), [this](const std::string& name) { return has(name); });
        if (found > 0 && found < static_cast<std::ptrdiff_t>(names.size())) {
            const auto missing = std::find_if(names.begin(), names.end(), [this](const std::string& name) { return !has(name); });
            refuseMissing(*missing);
        }
        return found > 0;
    }

    [[noreturn]] void refuseMissing(const std::string& column) const {
        refuse({"bodies.missing", "{0}: there is no column {1}", {m_columns.path, column}},
               {"bodies.missing.remedy",
                "A table of bodies has the columns mass_kg, side_x_m, side_y_m, side_z_m (or mesh), x_m, y_m and z_m at least.",
                {}});
    }

    void checkNames() {
        for (const char* column : {"mass", "x", "y", "z"}) {
            if (!has(column)) {
                refuseMissing(column);
            }
        }
        m_sides = hasAll({"side_x", "side_y", "side_z"});
        if (!m_sides && !has("mesh")) {
            refuseMissing("side_x");
        }
        m_moves = hasAll({"vx", "vy", "vz"});
        m_spinsInWorld = hasAll({"wx_world", "wy_world", "wz_world"});
        m_spinsInBody = hasAll({"wx_body", "wy_body", "wz_body"});
        m_quaternions = hasAll({"qw", "qx", "qy", "qz"});
        m_angles = hasAll({"roll", "pitch", "yaw"});
        m_measured = hasAll({"measured_x", "measured_y", "measured_z"});
        m_measuredTurn = hasAll({"measured_qw", "measured_qx", "measured_qy", "measured_qz"});
        if (m_spinsInWorld && m_spinsInBody) {
            refuse(
                {"bodies.two_frames", "{0}: spins stand about the axes of the table and about those of the body", {m_columns.path}},
                {"bodies.two_frames.remedy", "Keep the columns of one of the two.", {}});
        }
        if (m_quaternions && m_angles) {
            refuse({"bodies.two_turns", "{0}: orientations stand as quaternions and as angles", {m_columns.path}},
                   {"bodies.two_turns.remedy", "Keep the columns of one of the two.", {}});
        }
        m_table.turned = m_quaternions || m_angles;
        m_table.spins = m_spinsInWorld || m_spinsInBody;
    }

    std::string text(const std::string& column) const {
        const Source& source = m_sources.at(column);
        if (!source.index) {
            return source.constant;
        }
        return *source.index < m_row->fields.size() ? m_row->fields[*source.index] : std::string();
    }

    double number(const std::string& column) const {
        const std::string field = text(column);
        const std::optional<double> value = m_columns.table.numberIn(field);
        if (!value) {
            refuse({"bodies.no_number",
                    "{0}: line {1} has \"{2}\" in the column {3}, which is no number",
                    {m_columns.path, m_line, field, column}},
                   {"bodies.no_number.remedy", "Correct the line, or take the body out of the table.", {}});
        }
        return *value * m_sources.at(column).unit;
    }

    double positive(const std::string& column) const {
        const double value = number(column);
        if (!(value > 0.0)) {
            refuse({"bodies.not_positive",
                    "{0}: line {1} has {2} in the column {3}, which must be above zero",
                    {m_columns.path, m_line, value, column}},
                   {"bodies.not_positive.remedy", "Correct the line, or take the body out of the table.", {}});
        }
        return value;
    }

    Vec3 vector(const std::string& x, const std::string& y, const std::string& z) const {
        return {number(x), number(y), number(z)};
    }

    Quat quaternion(const std::string& prefix) const {
        const Quat turn(number(prefix + "qw"), number(prefix + "qx"), number(prefix + "qy"), number(prefix + "qz"));
        if (std::abs(turn.norm() - 1.0) > turnTolerance) {
            refuse({"bodies.no_turn",
                    "{0}: line {1} has an orientation of length {2}, which is no rotation",
                    {m_columns.path, m_line, turn.norm()}},
                   {"bodies.no_turn.remedy", "Write unit quaternions, {0}qw first.", {prefix}});
        }
        return turn.normalized();
    }

    /// Yaw about z, then pitch about the new y, then roll about the new x.
    Quat orientation() const {
        if (m_quaternions) {
            return quaternion("");
        }
        if (!m_angles) {
            return Quat::Identity();
        }
        return Eigen::AngleAxisd(number("yaw"), Vec3::UnitZ()) * Eigen::AngleAxisd(number("pitch"), Vec3::UnitY()) *
               Eigen::AngleAxisd(number("roll"), Vec3::UnitX());
    }

    std::optional<Material> material() {
        const std::string name = has("material") ? text("material") : std::string();
        if (name.empty()) {
            ++m_guessed;
            return std::nullopt;
        }
        const std::optional<Material> found = materialNamed(name);
        if (!found || !isBodyMaterial(*found)) {
            std::vector<std::string> names;
            for (std::size_t i = 0; i < materialCount; ++i) {
                if (isBodyMaterial(static_cast<Material>(i))) {
                    names.emplace_back(materialName(static_cast<Material>(i)));
                }
            }
            refuse({"bodies.material",
                    "{0}: line {1} names the material \"{2}\", of which no body is made",
                    {m_columns.path, m_line, name}},
                   {"bodies.material.remedy", "Name one of {0}, or leave the field empty.", {quotedList(names)}});
        }
        return found;
    }

    void readBody() {
        LooseBody body;
        body.id = has("id") ? text("id") : std::string();
        if (body.id.empty()) {
            body.id = std::to_string(m_table.bodies.size() + 1);
        }
        const auto [known, isNew] = m_ids.emplace(body.id, m_line);
        if (!isNew) {
            refuse({"bodies.same_id",
                    "{0}: line {1} has the id {2}, as line {3} has",
                    {m_columns.path, m_line, body.id, known->second}},
                   {"bodies.same_id.remedy", "Give each body an id of its own.", {}});
        }
        body.mass = positive("mass");
        takeShape(body);
        body.pose = {vector("x", "y", "z"), orientation()};
        if (m_moves) {
            body.velocity = vector("vx", "vy", "vz");
        }
        if (m_spinsInWorld) {
            body.spin = vector("wx_world", "wy_world", "wz_world");
        } else if (m_spinsInBody) {
            body.spin = body.pose.orientation * vector("wx_body", "wy_body", "wz_body");
        }
        body.material = material();
        body.time = has("time") ? number("time") : 0.0;
        noteDensity(body);
        m_table.bodies.push_back(std::move(body));
        m_table.measured.push_back(measuredEnd());
        m_table.lines.push_back(m_line);
    }

    bool isEmpty(const std::string& column) const { return !has(column) || text(column).empty(); }

    /// A box by its sides; the hull of a mesh as it is, or stretched to the sides that stand beside it.
    void takeShape(LooseBody& body) {
        const bool unsized = isEmpty("side_x") && isEmpty("side_y") && isEmpty("side_z");
        if (isEmpty("mesh")) {
            if (!m_sides || (unsized && has("mesh"))) {
                refuse({"bodies.no_shape", "{0}: line {1} has neither a mesh nor sides", {m_columns.path, m_line}},
                       {"bodies.no_shape.remedy", "Name a mesh, or give the three sides of a box.", {}});
            }
            body.sides = {positive("side_x"), positive("side_y"), positive("side_z")};
            return;
        }
        body.hull = m_meshes.shape(text("mesh"), m_line);
        if (!unsized) {
            body.hull = std::make_shared<const ConvexBody>(
                stretchedTo(*body.hull, {positive("side_x"), positive("side_y"), positive("side_z")}));
        }
        body.sides = body.hull->sides;
    }

    MeasuredEnd measuredEnd() const {
        MeasuredEnd end;
        if (m_measured) {
            end.place = vector("measured_x", "measured_y", "measured_z");
        }
        if (m_measuredTurn) {
            end.turn = quaternion("measured_");
        }
        if (has("measured_after")) {
            end.after = positive("measured_after");
        }
        end.group = has("group") ? text("group") : std::string();
        return end;
    }

    void noteDensity(const LooseBody& body) {
        if (!isMaterialDensity(body.density())) {
            m_table.findings.add(
                {"bodies.density", "bodies have a mass and sides that make {0}, which nothing weighs", {{body.density(), "kg/m3"}}},
                {"bodies.density.remedy", "look at the units in the heading", {}},
                m_columns.path + ", line " + std::to_string(m_line));
        }
    }

    void assume(const char* id, const char* pattern, const char* remedy, std::int64_t count) {
        m_table.findings.add({id, pattern, {count}}, {std::string(id) + ".remedy", remedy, {}}, m_columns.path, count);
    }

    void addAssumptions() {
        const auto count = static_cast<std::int64_t>(m_table.bodies.size());
        if (!m_moves) {
            assume("bodies.at_rest", "the table has no velocities: {0} bodies are let go at rest",
                   "add the columns vx_m_s, vy_m_s and vz_m_s if they move", count);
        }
        if (!m_table.spins) {
            assume("bodies.without_spin", "the table has no spins: {0} bodies are let go without",
                   "add the columns wx_world_rad_s and so on, or wx_body_rad_s and so on, if they turn", count);
        }
        if (!m_table.turned) {
            assume("bodies.along_axes", "the table has no orientations: {0} bodies lie along its axes",
                   "add the columns qw, qx, qy and qz, or turn them at random", count);
        }
        if (m_guessed > 0) {
            assume("bodies.material_guessed", "{0} bodies do not say what they are made of: their density decides",
                   "add the column material: stone, concrete, steel or masonry", m_guessed);
        }
        for (const std::string& name : m_unknown) {
            m_table.findings.add(
                {"bodies.column_unknown", "columns of the table are not known and were not read", {}},
                {"bodies.column_unknown.remedy", "none is needed, unless a name was meant to be one of the manual's", {}},
                m_columns.path + ", " + name);
        }
    }

    const NamedColumns& m_columns;
    BodyMeshes m_meshes;
    std::map<std::string, Source> m_sources;
    std::vector<std::string> m_unknown;
    std::map<std::string, std::size_t> m_ids;
    const DelimitedRow* m_row = nullptr;
    std::size_t m_line;
    bool m_sides = false, m_moves = false, m_spinsInWorld = false, m_spinsInBody = false, m_quaternions = false, m_angles = false;
    bool m_measured = false, m_measuredTurn = false;
    std::int64_t m_guessed = 0;
    BodyTable m_table;
};

}  // namespace

bool isBodyHeading(const std::string& line) {
    const auto names = [&line](const std::string& word) {
        for (std::size_t at = line.find(word); at != std::string::npos; at = line.find(word, at + 1)) {
            if (at == 0 || std::string_view(",;\t \"").find(line[at - 1]) != std::string_view::npos) {
                return true;
            }
        }
        return false;
    };
    return names("mass") && (names("side_x") || names("mesh"));
}

BodyTable bodyTableOf(const NamedColumns& columns) {
    return BodyReading(columns).read();
}

BodyTable readBodyTable(const std::string& path) {
    NamedColumns columns{path, readDelimitedTable(path, mostBytes), {}, {}};
    if (columns.table.rows.empty()) {
        throw ParseError({"bodies.none", "{0} holds no bodies", {path}},
                         {"bodies.none.remedy", "Give a heading and one line for each body.", {}});
    }
    const DelimitedRow heading = columns.table.rows.front();
    columns.names = heading.fields;
    columns.table.rows.erase(columns.table.rows.begin());
    for (const DelimitedRow& row : columns.table.rows) {
        requireNoMoreFields(path, heading, row);
    }
    return bodyTableOf(columns);
}

}  // namespace rubble::io
