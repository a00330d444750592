#include "io/fe/vtk/xml_grid.h"

#include <algorithm>

#include "io/fe/exodus/exodus_names.h"
#include "io/fe/vtk/xml_arrays.h"

namespace rubble::io {

namespace {

/// Reads the parts of one file.
class XmlGridReader {
public:
    XmlGridReader(const std::string& path, const GridSelection& selection) : m_file(path), m_selection(selection) {
        m_grid = m_file.root().child("UnstructuredGrid");
        if (std::string_view(m_file.root().attribute("type").as_string()) != "UnstructuredGrid" || !m_grid) {
            m_file.fail("it is no unstructured grid");
        }
    }

    Grid read() {
        std::optional<Grid> joined;
        for (const pugi::xml_node piece : m_grid.children("Piece")) {
            joinGrid(joined, readPiece(piece));
        }
        if (!joined) {
            m_file.fail("it has no piece");
        }
        Grid grid = std::move(*joined);
        grid.time = time();
        for (const pugi::xml_node array : m_grid.child("FieldData").children("Array")) {
            if (std::string_view(array.attribute("Name").as_string()) == "component_names") {
                for (const std::string& name : m_file.texts(array)) {
                    grid.componentNames.push_back(shownName(name.c_str()));
                }
            }
        }
        return grid;
    }

    std::optional<double> time() {
        for (const char* const name : gridTimeNames) {
            for (const pugi::xml_node array : m_grid.child("FieldData").children("DataArray")) {
                if (std::string_view(array.attribute("Name").as_string()) != name) {
                    continue;
                }
                if (const std::vector<double> values = m_file.reals(array); !values.empty()) {
                    return values.front();
                }
            }
        }
        return std::nullopt;
    }

private:
    Grid readPiece(pugi::xml_node piece) {
        Grid grid;
        m_points = count(piece, "NumberOfPoints");
        m_cells = count(piece, "NumberOfCells");
        grid.storedCells = static_cast<std::size_t>(m_cells);
        grid.vacant = m_points == 0 && m_cells == 0;
        if (m_selection.points || m_selection.everything) {
            readPoints(piece, grid);
        }
        if (m_selection.cells || m_selection.everything) {
            readCells(piece.child("Cells"), grid);
        }
        readArrays(piece.child("PointData"), true, grid.pointData);
        readArrays(piece.child("CellData"), false, grid.cellData);
        return grid;
    }

    std::uint64_t count(pugi::xml_node piece, const char* name) const {
        const pugi::xml_attribute attribute = piece.attribute(name);
        const long long value = attribute.as_llong(-1);
        if (value < 0) {
            m_file.fail(std::string("a piece does not say its ") + name);
        }
        return static_cast<std::uint64_t>(value);
    }

    void require(std::size_t found, std::uint64_t expected, const std::string& what) const {
        if (found != expected) {
            m_file.fail(what + " has " + std::to_string(found) + " values instead of " + std::to_string(expected));
        }
    }

    void readPoints(pugi::xml_node piece, Grid& grid) {
        if (m_points == 0) {
            return;
        }
        const std::vector<double> values = m_file.reals(piece.child("Points").child("DataArray"));
        if (m_points > values.size()) {
            require(values.size(), m_points, "Points, three numbers each,");
        }
        require(values.size(), 3 * m_points, "Points");
        grid.points.resize(static_cast<std::size_t>(m_points));
        for (std::size_t p = 0; p < grid.points.size(); ++p) {
            grid.points[p] = {values[3 * p], values[3 * p + 1], values[3 * p + 2]};
        }
    }

    void readCells(pugi::xml_node cells, Grid& grid) {
        grid.offsets.push_back(0);
        if (m_cells == 0) {
            return;
        }
        const auto integers = [&](const char* name) { return m_file.integers(cells.find_child_by_attribute("Name", name)); };
        const std::vector<std::int64_t> ends = integers("offsets"), types = integers("types");
        grid.connectivity = integers("connectivity");
        require(ends.size(), m_cells, "offsets");
        require(types.size(), m_cells, "types");
        grid.offsets.insert(grid.offsets.end(), ends.begin(), ends.end());
        for (const std::int64_t type : types) {
            // No cell has a type beyond a byte.
            grid.types.push_back(type >= 0 && type <= 255 ? static_cast<std::uint8_t>(type) : std::uint8_t{255});
        }
    }

    void readArrays(pugi::xml_node data, bool points, std::vector<GridArray>& arrays) {
        for (const pugi::xml_node node : data.children("DataArray")) {
            GridArray array;
            array.name = node.attribute("Name").as_string();
            array.components = static_cast<std::size_t>(std::clamp(node.attribute("NumberOfComponents").as_int(1), 1, 1 << 16));
            if (points ? m_selection.wantsPoint(array.name) : m_selection.wantsCell(array.name)) {
                array.values = m_file.reals(node);
                const std::uint64_t entities = points ? m_points : m_cells;
                if (entities > array.values.size() || array.values.size() != entities * array.components) {
                    m_file.fail(array.name + " has " + std::to_string(array.values.size()) + " values for " +
                                std::to_string(entities) + (points ? " points" : " cells"));
                }
            }
            arrays.push_back(std::move(array));
        }
    }

    XmlArrays m_file;
    const GridSelection& m_selection;
    pugi::xml_node m_grid;
    std::uint64_t m_points = 0, m_cells = 0;
};

}  // namespace

Grid readXmlGrid(const std::string& path, const GridSelection& selection) {
    return XmlGridReader(path, selection).read();
}

std::optional<double> timeOfXmlGrid(const std::string& path) {
    return XmlGridReader(path, {}).time();
}

}  // namespace rubble::io
