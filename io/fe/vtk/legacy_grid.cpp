#include "io/fe/vtk/legacy_grid.h"

#include <algorithm>
#include <set>

#include "io/fe/vtk/legacy_text.h"

namespace rubble::io {

namespace {

std::string upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return text;
}

/// Reads the sections in the order in which they come.
class LegacyGridReader {
public:
    LegacyGridReader(const std::string& path, const GridSelection& selection) : m_text(path), m_selection(selection) {
        m_text.line();
        m_text.line();
        const std::string kind = upper(m_text.word());
        if (kind != "ASCII" && kind != "BINARY") {
            m_text.fail("it should say ASCII or BINARY");
        }
        m_text.setBinary(kind == "BINARY");
        const std::string dataset = upper(m_text.word()), what = upper(m_text.word());
        if (dataset != "DATASET" || what != "UNSTRUCTURED_GRID") {
            m_text.fail("it should say DATASET UNSTRUCTURED_GRID");
        }
    }

    Grid read() {
        for (std::string word = m_text.word(); !word.empty(); word = m_text.word()) {
            readSection(upper(word));
        }
        finish();
        m_grid.storedCells = static_cast<std::size_t>(m_cells);
        m_grid.vacant = m_points == 0 && m_cells == 0;
        return std::move(m_grid);
    }

    // Field data stand before those of points and cells.
    std::optional<double> time() {
        for (std::string word = upper(m_text.word()); !word.empty() && word != "POINT_DATA" && word != "CELL_DATA";
             word = upper(m_text.word())) {
            readSection(word);
            if (m_grid.time) {
                break;
            }
        }
        return m_grid.time;
    }

private:
    enum class Owner { Grid, Points, Cells };

    bool wantsPoints() const { return m_selection.points || m_selection.everything; }
    bool wantsCells() const { return m_selection.cells || m_selection.everything; }

    void readSection(const std::string& word) {
        if (word == "FIELD") {
            readField();
        } else if (word == "POINTS") {
            readPoints();
        } else if (word == "CELLS") {
            readCells();
        } else if (word == "CELL_TYPES") {
            readTypes();
        } else if (word == "POINT_DATA" || word == "CELL_DATA") {
            m_owner = word == "POINT_DATA" ? Owner::Points : Owner::Cells;
            m_entities = m_text.count("values");
            const std::uint64_t expected = m_owner == Owner::Points ? m_points : m_cells;
            if (m_entities != expected) {
                m_text.fail(word + " is for " + std::to_string(m_entities) + " instead of " + std::to_string(expected));
            }
        } else if (word == "METADATA") {
            skipMetadata();
        } else if (m_owner == Owner::Grid || !readAttribute(word)) {
            m_text.fail("\"" + word.substr(0, 40) + "\" is no section of such a file");
        }
    }

    // Lines up to an empty one.
    void skipMetadata() {
        m_text.line();
        while (!m_text.atEnd() && !m_text.line().empty()) {
        }
    }

    void readPoints() {
        if (m_points > 0) {
            m_text.fail("there is a second section POINTS");
        }
        m_points = m_text.count("points");
        const std::string type = m_text.word();
        if (m_points > UINT64_MAX / 3 || !wantsPoints()) {
            m_text.skip(m_points > UINT64_MAX / 3 ? UINT64_MAX : 3 * m_points, type, "the points");
            return;
        }
        const std::vector<double> values = m_text.reals(3 * m_points, type, "the points");
        m_grid.points.resize(values.size() / 3);
        for (std::size_t p = 0; p < m_grid.points.size(); ++p) {
            m_grid.points[p] = {values[3 * p], values[3 * p + 1], values[3 * p + 2]};
        }
    }

    // Until version 5: how many corners, and the corners, cell by cell. Since: where each cell begins, and all corners.
    void readCells() {
        if (m_hasCells) {
            m_text.fail("there is a second section CELLS");
        }
        m_hasCells = true;
        const std::uint64_t first = m_text.count("cells"), second = m_text.count("corners of cells");
        const std::uint64_t before = m_text.place();
        if (upper(m_text.word()) != "OFFSETS") {
            m_text.seek(before);
            m_cells = first;
            readCountedCells(second);
            return;
        }
        m_cells = first == 0 ? 0 : first - 1;
        const std::string offsetType = m_text.word();
        if (wantsCells()) {
            m_grid.offsets = m_text.integers(first, offsetType, "the offsets of cells");
        } else {
            m_text.skip(first, offsetType, "the offsets of cells");
        }
        if (upper(m_text.word()) != "CONNECTIVITY") {
            m_text.fail("CONNECTIVITY should follow OFFSETS");
        }
        const std::string type = m_text.word();
        if (wantsCells()) {
            m_grid.connectivity = m_text.integers(second, type, "the corners of cells");
        } else {
            m_text.skip(second, type, "the corners of cells");
        }
    }

    void readCountedCells(std::uint64_t words) {
        if (!wantsCells()) {
            m_text.skip(words, "int", "the cells");
            return;
        }
        const std::vector<std::int64_t> list = m_text.integers(words, "int", "the cells");
        m_grid.offsets.push_back(0);
        std::size_t at = 0;
        for (std::uint64_t c = 0; c < m_cells; ++c) {
            const std::int64_t corners = at < list.size() ? list[at] : -1;
            if (corners < 0 || static_cast<std::uint64_t>(corners) > list.size() - at - 1) {
                m_text.fail("cell " + std::to_string(c) + " has " + std::to_string(corners) + " corners, more than the section");
            }
            const auto begin = list.begin() + static_cast<std::ptrdiff_t>(at + 1);
            m_grid.connectivity.insert(m_grid.connectivity.end(), begin, begin + corners);
            m_grid.offsets.push_back(static_cast<std::int64_t>(m_grid.connectivity.size()));
            at += static_cast<std::size_t>(corners) + 1;
        }
        if (at != list.size()) {
            m_text.fail("the cells take " + std::to_string(at) + " words instead of " + std::to_string(list.size()));
        }
    }

    void readTypes() {
        const std::uint64_t count = m_text.count("types of cells");
        if (count != m_cells || m_hasTypes) {
            m_text.fail("there are " + std::to_string(count) + " types for " + std::to_string(m_cells) + " cells");
        }
        m_hasTypes = true;
        if (!wantsCells()) {
            m_text.skip(count, "int", "the types of cells");
            return;
        }
        for (const std::int64_t type : m_text.integers(count, "int", "the types of cells")) {
            m_grid.types.push_back(type >= 0 && type <= 255 ? static_cast<std::uint8_t>(type) : std::uint8_t{255});
        }
    }

    // @return false for a word that begins no attribute
    bool readAttribute(const std::string& kind) {
        if (kind == "LOOKUP_TABLE") {
            m_text.word();
            const std::uint64_t entries = m_text.count("colours");
            m_text.skip(times(entries, 4), "unsigned_char", "a table of colours");
            return true;
        }
        const std::uint64_t width = kind == "VECTORS" || kind == "NORMALS" ? 3
                                    : kind == "TENSORS"                    ? 9
                                    : kind == "TENSORS6"                   ? 6
                                    : kind == "GLOBAL_IDS" || kind == "PEDIGREE_IDS" || kind == "EDGE_FLAGS" || kind == "SCALARS"
                                        ? 1
                                        : 0;
        const std::string name = legacyName(m_text.word());
        if (kind == "COLOR_SCALARS") {
            const std::uint64_t colours = m_text.count("components");
            readArray(name, colours, "unsigned_char");
        } else if (kind == "TEXTURE_COORDINATES") {
            const std::uint64_t dimensions = m_text.count("components");
            readArray(name, dimensions, m_text.word());
        } else if (kind == "SCALARS") {
            readScalars(name);
        } else if (width > 0) {
            readArray(name, width, m_text.word());
        }
        return width > 0 || kind == "COLOR_SCALARS" || kind == "TEXTURE_COORDINATES";
    }

    // SCALARS name type [components], and mostly a line with the name of a table of colours.
    void readScalars(const std::string& name) {
        const std::string type = m_text.word();
        std::uint64_t before = m_text.place();
        const bool moreWords = m_text.line().find_first_not_of(" \t") != std::string::npos;
        m_text.seek(before);
        const std::uint64_t components = moreWords ? m_text.count("components") : 1;
        before = m_text.place();
        if (upper(m_text.word()) == "LOOKUP_TABLE") {
            m_text.word();
        } else {
            m_text.seek(before);
        }
        readArray(name, components, type);
    }

    void readField() {
        m_text.word();
        const std::uint64_t arrays = m_text.count("arrays");
        for (std::uint64_t a = 0; a < arrays; ++a) {
            std::string word = m_text.word();
            while (upper(word) == "METADATA") {
                skipMetadata();
                word = m_text.word();
            }
            if (word.empty()) {
                m_text.failCut("the arrays of a field");
            }
            const std::string name = legacyName(word);
            const std::uint64_t components = m_text.count("components"), tuples = m_text.count("values");
            const std::string type = m_text.word();
            if (m_owner == Owner::Grid) {
                readFieldOfGrid(name, times(components, tuples), type);
            } else if (tuples == m_entities) {
                readArray(name, components, type);
            } else {
                m_text.fail(name + " has " + std::to_string(tuples) + " values for " + std::to_string(m_entities));
            }
        }
    }

    void readFieldOfGrid(const std::string& name, std::uint64_t count, const std::string& type) {
        const auto known = std::find(gridTimeNames.begin(), gridTimeNames.end(), name);
        const std::size_t rank = static_cast<std::size_t>(known - gridTimeNames.begin());
        if (rank < m_timeName && count > 0) {
            m_grid.time = m_text.reals(count, type, name).front();
            m_timeName = rank;
        } else {
            m_text.skip(count, type, name);
        }
    }

    void readArray(const std::string& name, std::uint64_t components, const std::string& type) {
        const bool points = m_owner == Owner::Points;
        if (components < 1 || components > 1 << 16) {
            m_text.fail(name + " has " + std::to_string(components) + " components");
        }
        const std::uint64_t count = times(components, m_entities);
        if (type == "string" || type == "utf8_string") {
            m_text.skip(count, type, name);
            return;
        }
        GridArray array{name, static_cast<std::size_t>(components), {}};
        if (points ? m_selection.wantsPoint(name) : m_selection.wantsCell(name)) {
            array.values = m_text.reals(count, type, name);
        } else {
            m_text.skip(count, type, name);
        }
        (points ? m_grid.pointData : m_grid.cellData).push_back(std::move(array));
    }

    void finish() {
        if (m_cells > 0 && !m_hasTypes) {
            m_text.failCut("the types of cells");
        }
        if (wantsCells() && m_grid.offsets.empty()) {
            m_grid.offsets.push_back(0);
        }
        constexpr std::uint8_t polyhedron = 42;
        if (std::find(m_grid.types.begin(), m_grid.types.end(), polyhedron) != m_grid.types.end()) {
            unfoldPolyhedra(polyhedron);
        }
    }

    // Polyhedra stand as faces: how many, then each with its count of points. They become lists of their points.
    void unfoldPolyhedra(std::uint8_t polyhedron) {
        std::vector<std::int64_t> offsets{0}, connectivity;
        for (std::size_t c = 0; c + 1 < m_grid.offsets.size() && c < m_grid.types.size(); ++c) {
            const std::int64_t begin = std::max<std::int64_t>(m_grid.offsets[c], 0), end = m_grid.offsets[c + 1];
            std::vector<std::int64_t> points;
            for (std::int64_t i = begin; i < end && static_cast<std::size_t>(i) < m_grid.connectivity.size(); ++i) {
                points.push_back(m_grid.connectivity[static_cast<std::size_t>(i)]);
            }
            if (m_grid.types[c] == polyhedron) {
                points = pointsOfFaces(points);
            }
            connectivity.insert(connectivity.end(), points.begin(), points.end());
            offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
        }
        m_grid.offsets = std::move(offsets);
        m_grid.connectivity = std::move(connectivity);
    }

    // What is no list of faces is one of points.
    static std::vector<std::int64_t> pointsOfFaces(const std::vector<std::int64_t>& words) {
        std::set<std::int64_t> points;
        std::size_t at = 1;
        const std::int64_t faces = words.empty() ? 0 : words.front();
        for (std::int64_t f = 0; f < faces; ++f) {
            const std::int64_t count = at < words.size() ? words[at] : -1;
            if (count < 3 || static_cast<std::uint64_t>(count) >= words.size() - at) {
                return words;
            }
            const auto first = words.begin() + static_cast<std::ptrdiff_t>(at) + 1;
            points.insert(first, first + count);
            at += static_cast<std::size_t>(count) + 1;
        }
        return at == words.size() ? std::vector<std::int64_t>(points.begin(), points.end()) : words;
    }

    // What overflows is more than any file holds.
    static std::uint64_t times(std::uint64_t a, std::uint64_t b) { return b != 0 && a > UINT64_MAX / b ? UINT64_MAX : a * b; }

    LegacyText m_text;
    const GridSelection& m_selection;
    Grid m_grid;
    Owner m_owner = Owner::Grid;
    std::uint64_t m_points = 0, m_cells = 0, m_entities = 0;
    std::size_t m_timeName = gridTimeNames.size();
    bool m_hasCells = false, m_hasTypes = false;
};

}  // namespace

Grid readLegacyGrid(const std::string& path, const GridSelection& selection) {
    return LegacyGridReader(path, selection).read();
}

std::optional<double> timeOfLegacyGrid(const std::string& path) {
    GridSelection nothing;
    nothing.points = false;
    nothing.cells = false;
    return LegacyGridReader(path, nothing).time();
}

}  // namespace rubble::io
