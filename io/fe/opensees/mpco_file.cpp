#include "io/fe/opensees/mpco_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/base/error.h"

namespace rubble::io {

namespace {

constexpr std::string_view stageMark = "MODEL_STAGE[";

[[noreturn]] void failMpco(const std::string& path, const std::string& what) {
    throw ParseError({"mpco.layout", "{0} is no MPCO file that can be read: {1}", {path, what}},
                     {"mpco.layout.remedy", "The file is damaged or not yet whole: copy it again or write it again.", {}});
}

std::optional<std::int64_t> stageNumber(const std::string& group) {
    std::int64_t number = 0;
    const char* const begin = group.data() + stageMark.size();
    if (!group.starts_with(stageMark)) {
        return std::nullopt;
    }
    const auto [end, error] = std::from_chars(begin, group.data() + group.size(), number);
    return error == std::errc{} && end != group.data() + group.size() && *end == ']' ? std::optional(number) : std::nullopt;
}

std::vector<std::string> stagesOf(const Hdf5Table& table) {
    std::vector<std::pair<std::int64_t, std::string>> found;
    for (const std::string& group : table.groupsIn("/")) {
        if (const auto number = stageNumber(group)) {
            found.emplace_back(*number, "/" + group);
        }
    }
    std::sort(found.begin(), found.end());
    std::vector<std::string> stages;
    for (auto& [number, group] : found) {
        stages.push_back(std::move(group));
    }
    return stages;
}

std::string nodal(const std::string& stage, const std::string& result) {
    return stage + "/RESULTS/ON_NODES/" + result;
}

}  // namespace

MpcoFile::MpcoFile(const std::string& path, const std::string& displacement)
    : m_table(path), m_displacement(displacement), m_stages(stagesOf(m_table)) {
    for (std::size_t s = 0; s < m_stages.size(); ++s) {
        const Hdf5Table::Shape places = m_table.shape(m_stages[s] + "/MODEL/NODES/COORDINATES");
        m_plane = m_plane || (places.rows > 0 && places.columns < 3);
        addStates(s);
    }
}

std::vector<std::string> MpcoFile::nodalResults() const {
    std::vector<std::string> names;
    for (const std::string& stage : m_stages) {
        for (std::string& name : m_table.groupsIn(stage + "/RESULTS/ON_NODES")) {
            if (std::find(names.begin(), names.end(), name) == names.end()) {
                names.push_back(std::move(name));
            }
        }
    }
    return names;
}

bool MpcoFile::isWhole(const std::string& table, std::uint64_t rows) const {
    return m_table.has(table) && m_table.shape(table).rows == rows && m_table.shape(table).columns >= 1;
}

// What the analysis was writing when it ended has no time yet, or fewer rows than there are nodes.
void MpcoFile::addStates(std::size_t stage) {
    const std::string& group = m_stages[stage];
    if (m_displacement == "none") {
        if (const auto time = m_table.real(group, "TIME")) {
            m_states.push_back({stage, m_table.number(group, "STEP").value_or(static_cast<std::int64_t>(stage)), *time, "", ""});
        }
        return;
    }
    const std::string data = nodal(group, m_displacement) + "/DATA", velocities = nodal(group, "VELOCITY") + "/DATA";
    const std::uint64_t rows = m_table.shape(nodal(group, m_displacement) + "/ID").rows;
    std::vector<MpcoState> found;
    std::size_t broken = 0;
    for (const std::string& name : m_table.tablesIn(data)) {
        const std::string table = data + "/" + name;
        const auto time = m_table.real(table, "TIME");
        if (!time || !isWhole(table, rows)) {
            ++broken;
            continue;
        }
        const std::string velocity = velocities + "/" + name;
        const std::int64_t step = m_table.number(table, "STEP").value_or(static_cast<std::int64_t>(found.size()));
        found.push_back({stage, step, *time, table, isWhole(velocity, rows) ? velocity : ""});
    }
    const bool last = stage + 1 == m_stages.size();
    if (broken > (last ? 1u : 0u)) {
        failMpco(path(), "states of " + group.substr(1) + " have no time, or values for other nodes than it lists");
    }
    m_unfinished = m_unfinished || broken > 0;
    std::sort(found.begin(), found.end(), [](const MpcoState& a, const MpcoState& b) { return a.step < b.step; });
    m_states.insert(m_states.end(), found.begin(), found.end());
}

MpcoModel MpcoFile::model(std::size_t stage) const {
    MpcoModel model;
    const std::string& group = m_stages[stage];
    const std::string ids = group + "/MODEL/NODES/ID", places = group + "/MODEL/NODES/COORDINATES";
    const Hdf5Table::Shape shape = m_table.shape(places);
    model.nodeIds = m_table.has(ids) ? m_table.integers(ids, 0, m_table.shape(ids).rows) : std::vector<std::int64_t>{};
    model.nodes = m_table.has(places) ? vectors(places) : std::vector<Vec3>{};
    if (model.nodeIds.size() != model.nodes.size()) {
        failMpco(path(), group.substr(1) + " has " + std::to_string(model.nodeIds.size()) + " numbers for " +
                             std::to_string(shape.rows) + " nodes");
    }
    const std::string elements = group + "/MODEL/ELEMENTS";
    for (const std::string& name : m_table.tablesIn(elements)) {
        const std::string full = elements + "/" + name;
        const Hdf5Table::Shape extent = m_table.shape(full);
        model.tables.push_back({name, m_table.number(full, "GEOMETRY").value_or(0), std::max<std::size_t>(extent.columns, 1),
                                m_table.integers(full, 0, extent.rows)});
    }
    readSections(group, model);
    return model;
}

// Of sections made of fibres the areas are there: their sum is the area of a beam, of layers the thickness of a shell.
void MpcoFile::readSections(const std::string& stage, MpcoModel& model) const {
    const std::string sections = stage + "/MODEL/SECTION_ASSIGNMENTS";
    for (const std::string& name : m_table.groupsIn(sections)) {
        const std::string fibres = sections + "/" + name + "/FIBER_DATA", users = sections + "/" + name + "/ASSIGNMENT";
        const Hdf5Table::Shape shape = m_table.shape(fibres), assigned = m_table.shape(users);
        if (shape.rows == 0 || shape.columns != 3 || assigned.rows == 0 || assigned.columns != 2) {
            continue;
        }
        double area = 0.0;
        const std::vector<double> values = m_table.reals(fibres, 0, shape.rows);
        for (std::size_t i = 2; i < values.size(); i += 3) {
            area += values[i];
        }
        const std::vector<std::int64_t> pairs = m_table.integers(users, 0, assigned.rows);
        for (std::size_t i = 0; i < pairs.size(); i += 2) {
            model.section.try_emplace(pairs[i], area);
        }
    }
}

std::vector<std::int64_t> MpcoFile::rowNodes(std::size_t stage) const {
    const std::string ids = nodal(m_stages[stage], m_displacement) + "/ID";
    return m_table.has(ids) ? m_table.integers(ids, 0, m_table.shape(ids).rows) : std::vector<std::int64_t>{};
}

std::vector<Vec3> MpcoFile::vectors(const std::string& table) const {
    const Hdf5Table::Shape shape = m_table.shape(table);
    const std::vector<double> values = m_table.reals(table, 0, shape.rows);
    const std::size_t axes = std::min<std::size_t>(shape.columns, 3);
    std::vector<Vec3> result(shape.rows, Vec3::Zero());
    for (std::size_t n = 0; n < result.size(); ++n) {
        for (std::size_t axis = 0; axis < axes; ++axis) {
            result[n][static_cast<Eigen::Index>(axis)] = values[n * shape.columns + axis];
        }
    }
    return result;
}

}  // namespace rubble::io
