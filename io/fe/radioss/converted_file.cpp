#include "io/fe/radioss/converted_file.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "core/base/error.h"
#include "io/base/files.h"

namespace rubble::io {

namespace {

constexpr std::array<std::string_view, animKinds> prefixes{"3DELEM_", "2DELEM_", "1DELEM_", "SPHELEM_"};

std::optional<AnimKind> kindOfCell(std::int64_t type) {
    switch (type) {
        case 1:
            return AnimKind::Particle;
        case 3:
            return AnimKind::Beam;
        case 5:
        case 9:
            return AnimKind::Shell;
        case 10:
        case 12:
            return AnimKind::Solid;
        default:
            return std::nullopt;
    }
}

/// Words of a text, one after the other.
class Words {
public:
    explicit Words(const std::string& path) : m_path(path) {
        std::ifstream file(path, std::ios::binary);
        std::ostringstream text;
        text << file.rdbuf();
        if (!file) {
            failToRead(path);
        }
        m_text = std::move(text).str();
        if (m_text.empty()) {
            failCut("its header");
        }
    }

    const std::string& path() const { return m_path; }
    std::size_t place() const { return m_place; }
    std::size_t size() const { return m_text.size(); }

    /// The next word; empty at the end.
    std::string_view next() {
        const std::size_t begin = std::min(m_text.find_first_not_of(blanks, m_place), m_text.size());
        m_place = std::min(m_text.find_first_of(blanks, begin), m_text.size());
        return std::string_view(m_text).substr(begin, m_place - begin);
    }

    void nextLine() { m_place = std::min(m_text.find('\n', m_place), m_text.size() - 1) + 1; }

    void skip(std::size_t count, const char* what) {
        for (std::size_t i = 0; i < count; ++i) {
            if (next().empty()) {
                failCut(what);
            }
        }
    }

    template <class Number>
    Number number(const char* what) {
        const std::string_view word = next();
        // The last word of a file that is cut off may be half a number.
        if (word.empty() || m_place == m_text.size()) {
            failCut(what);
        }
        Number value{};
        const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
        if (result.ec == std::errc::invalid_argument || result.ptr != word.data() + word.size()) {
            throw ParseError({"anim.bad_number",
                              "{0}: \"{1}\" before byte {2} is no number; expected: {3}",
                              {m_path, std::string(word.substr(0, 40)), m_place, what}},
                             {"anim.damaged.remedy", "The file is damaged: copy it again or leave it out.", {}});
        }
        return value;
    }

    /// A count of things that take at least two bytes each.
    std::size_t count(const char* what) {
        const auto value = number<std::int64_t>(what);
        if (value < 0 || static_cast<std::uint64_t>(value) > m_text.size() / 2) {
            throw ParseError({"anim.bad_count",
                              "{0}: the number of {1} before byte {2} is {3}; expected: 0 to {4}, what the file can hold",
                              {m_path, what, m_place, value, m_text.size() / 2}},
                             {"anim.damaged.remedy", "The file is damaged: copy it again or leave it out.", {}});
        }
        return static_cast<std::size_t>(value);
    }

    [[noreturn]] void failCut(const char* what) const {
        throw ParseError({"anim.cut", "{0} is cut off: it ends at byte {1} within {2}", {m_path, m_text.size(), what}},
                         {"anim.cut.remedy", "Copy the file again, or wait until the analysis has written it.", {}});
    }

private:
    static constexpr const char* blanks = " \t\r\n";

    std::string m_path;
    std::string m_text;
    std::size_t m_place = 0;
};

/// Reads the sections in the order in which they come.
class ConvertedReader {
public:
    ConvertedReader(const std::string& path, AnimWanted wanted) : m_words(path), m_wanted(wanted) {}

    AnimState read() {
        for (int line = 0; line < 4; ++line) {
            m_words.nextLine();
        }
        for (std::string_view word = m_words.next(); !word.empty(); word = m_words.next()) {
            readSection(std::string(word));
        }
        finish();
        return std::move(m_state);
    }

private:
    bool everything() const { return m_wanted == AnimWanted::Everything; }

    void readSection(const std::string& word) {
        if (word == "FIELD") {
            m_words.skip(2, "the fields");
        } else if (word == "TIME" || word == "CYCLE") {
            m_words.skip(3, "the fields");
            const double value = m_words.number<double>("the time");
            if (word == "TIME") {
                m_state.time = value;
            }
        } else if ((word == "POINTS" && m_nodes > 0) || (word == "CELLS" && m_cells > 0)) {
            throw ParseError(
                {"anim.twice", "{0} has a second section {1} before byte {2}", {m_words.path(), word, m_words.place()}},
                {"anim.damaged.remedy", "The file is damaged: copy it again or leave it out.", {}});
        } else if (word == "POINTS") {
            m_nodes = m_words.count("points");
            m_words.skip(1, "the points");
            takeVectors(m_state.positions, m_wanted != AnimWanted::Status, "the points");
        } else if (word == "CELLS") {
            readCells();
        } else if (word == "CELL_TYPES") {
            readTypes();
        } else if (word == "POINT_DATA" || word == "CELL_DATA") {
            m_ofCells = word == "CELL_DATA";
            require(m_words.count("values"), m_ofCells ? m_cells : m_nodes, m_ofCells ? "values of cells" : "values of points");
        } else {
            readArray(word);
        }
    }

    void require(std::size_t found, std::size_t expected, const char* what) const {
        if (found != expected) {
            throw ParseError({"anim.bad_length",
                              "{0}: {1} before byte {2}: {3}; expected: {4}",
                              {m_words.path(), what, m_words.place(), found, expected}},
                             {"anim.damaged.remedy", "The file is damaged: copy it again or leave it out.", {}});
        }
    }

    void takeVectors(std::vector<Vec3>& target, bool wanted, const char* what) {
        if (!wanted) {
            m_words.skip(3 * m_nodes, what);
            return;
        }
        target.clear();
        for (std::size_t n = 0; n < m_nodes; ++n) {
            const auto x = m_words.number<double>(what), y = m_words.number<double>(what), z = m_words.number<double>(what);
            target.emplace_back(x, y, z);
        }
    }

    void readCells() {
        m_cells = m_words.count("cells");
        const std::size_t total = m_words.count("words of cells");
        if (!everything()) {
            m_words.skip(total, "the cells");
            return;
        }
        std::size_t used = 0;
        m_corners.clear();
        for (std::size_t c = 0; c < m_cells; ++c) {
            const std::size_t corners = m_words.count("corners of a cell");
            used += corners + 1;
            m_corners.emplace_back();
            for (std::size_t i = 0; i < corners; ++i) {
                const auto node = m_words.number<std::int64_t>("the corner of a cell");
                if (node < 0 || node >= static_cast<std::int64_t>(m_nodes)) {
                    throw ParseError({"anim.bad_node",
                                      "{0}: the cell before byte {1} uses node {2} of {3}",
                                      {m_words.path(), m_words.place(), node, m_nodes}},
                                     {"anim.damaged.remedy", "The file is damaged: copy it again or leave it out.", {}});
                }
                m_corners.back().push_back(node);
            }
        }
        require(used, total, "words of cells");
    }

    void readTypes() {
        require(m_words.count("types of cells"), m_cells, "types of cells");
        m_kinds.clear();
        for (std::size_t c = 0; c < m_cells; ++c) {
            const auto type = m_words.number<std::int64_t>("the type of a cell");
            const auto kind = kindOfCell(type);
            if (!kind) {
                throw ParseError({"anim.bad_cell",
                                  "{0}: the type of a cell before byte {1} is {2}; expected: 1, 3, 5, 9, 10 or 12",
                                  {m_words.path(), m_words.place(), type}},
                                 {"anim.damaged.remedy", "The file is damaged: copy it again or leave it out.", {}});
            }
            m_kinds.push_back(*kind);
        }
    }

    void readArray(const std::string& kind) {
        if (kind == "LOOKUP_TABLE") {
            m_words.skip(1, "a table");
            return;
        }
        const std::size_t width = kind == "SCALARS" ? 1 : kind == "VECTORS" ? 3 : kind == "TENSORS" ? 9 : 0;
        if (width == 0 && m_words.place() == m_words.size()) {
            m_words.failCut("the name of a section");
        }
        if (width == 0) {
            throw ParseError({"anim.bad_section",
                              "{0}: \"{1}\" before byte {2} is no section of such a file",
                              {m_words.path(), kind.substr(0, 40), m_words.place()}},
                             {"anim.damaged.remedy", "The file is damaged: copy it again or leave it out.", {}});
        }
        const std::string name(m_words.next());
        m_words.nextLine();
        if (width == 1) {
            m_words.skip(2, "a table");
        }
        if (kind == "VECTORS" && !m_ofCells && name == "Velocity") {
            takeVectors(m_state.velocities, m_wanted != AnimWanted::Status, "the velocities");
        } else if (width == 1 && wantedScalar(name)) {
            std::vector<double>& values = m_scalars[name];
            values.clear();
            for (std::size_t i = 0; i < (m_ofCells ? m_cells : m_nodes); ++i) {
                values.push_back(m_words.number<double>("values"));
            }
        } else {
            m_words.skip(width * (m_ofCells ? m_cells : m_nodes), "values");
        }
    }

    bool wantedScalar(const std::string& name) const {
        if (!m_ofCells) {
            return everything() && name == "NODE_ID";
        }
        const bool ofCells = name == "ELEMENT_ID" || name == "EROSION_STATUS" || name.ends_with("_TIME_DELETION_ELEMENT") ||
                             (everything() && (name == "PART_ID" || name.ends_with("_Density") || name.ends_with("_Thickness")));
        return m_wanted != AnimWanted::Nodes && ofCells;
    }

    void finish() {
        if (m_wanted == AnimWanted::Nodes) {
            if (m_state.positions.empty()) {
                m_words.failCut("the points");
            }
            return;
        }
        if (m_cells == 0) {
            m_words.failCut("the cells");
        }
        require(m_kinds.size(), m_cells, "types of cells");
        for (const char* name : {"ELEMENT_ID", "EROSION_STATUS", "PART_ID"}) {
            if (m_scalars[name].size() != m_cells && (everything() || std::string_view(name) != "PART_ID")) {
                m_words.failCut(name);
            }
        }
        for (const double id : m_scalars["NODE_ID"]) {
            m_state.nodeIds.push_back(integer(id));
        }
        for (std::size_t c = 0; c < m_cells; ++c) {
            finishCell(c);
        }
    }

    static std::int64_t integer(double value) { return value > -1e15 && value < 1e15 ? static_cast<std::int64_t>(value) : 0; }

    void finishCell(std::size_t c) {
        const AnimKind kind = m_kinds[c];
        AnimElements& elements = m_state.of(kind);
        ++elements.count;
        elements.ids.push_back(integer(m_scalars["ELEMENT_ID"][c]));
        elements.off.push_back(m_scalars["EROSION_STATUS"][c] > 0.0 ? 1 : 0);
        const std::string prefix(prefixes[static_cast<std::size_t>(kind)]);
        for (const auto& [name, list] : {std::pair{"TIME_DELETION_ELEMENT", &elements.deletion},
                                         std::pair{"Density", &elements.density}, std::pair{"Thickness", &elements.thickness}}) {
            const auto values = m_scalars.find(prefix + name);
            if (values != m_scalars.end() && values->second.size() == m_cells) {
                list->push_back(values->second[c]);
            }
        }
        if (everything()) {
            addCorners(elements, kind, c);
            addPart(elements, integer(m_scalars["PART_ID"][c]));
        }
    }

    // Corners that are fewer than the kind has are repeated: the last of shells, and of tetrahedra the third and the fourth.
    void addCorners(AnimElements& elements, AnimKind kind, std::size_t c) {
        std::vector<std::int64_t> corners = m_corners[c];
        const std::size_t width = animWidth(kind);
        if (kind == AnimKind::Solid && corners.size() == 4) {
            corners = {corners[0], corners[1], corners[2], corners[2], corners[3], corners[3], corners[3], corners[3]};
        } else if (kind == AnimKind::Shell && corners.size() == 3) {
            corners.push_back(corners.back());
        }
        require(corners.size(), width, "corners of a cell");
        elements.nodes.insert(elements.nodes.end(), corners.begin(), corners.end());
    }

    static void addPart(AnimElements& elements, std::int64_t id) {
        const auto known =
            std::find_if(elements.parts.begin(), elements.parts.end(), [id](const AnimPart& part) { return part.id == id; });
        elements.part.push_back(static_cast<std::uint32_t>(known - elements.parts.begin()));
        if (known == elements.parts.end()) {
            elements.parts.push_back({id, {}});
        }
    }

    Words m_words;
    const AnimWanted m_wanted;
    bool m_ofCells = false;
    std::size_t m_nodes = 0, m_cells = 0;
    std::vector<std::vector<std::int64_t>> m_corners;
    std::vector<AnimKind> m_kinds;
    std::map<std::string, std::vector<double>> m_scalars;
    AnimState m_state;
};

}  // namespace

AnimState readConvertedFile(const std::string& path, AnimWanted wanted) {
    return ConvertedReader(path, wanted).read();
}

}  // namespace rubble::io
