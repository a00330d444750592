#include "io/fe/xdmf/xdmf_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <pugixml.hpp>
#include <set>

#include "core/base/error.h"
#include "io/base/hdf5_extent.h"
#include "io/fe/series/numbered_files.h"
#include "io/fe/series/series_result.h"
#include "io/fe/vtk/grid_series.h"
#include "io/fe/xdmf/xdmf_item.h"
#include "io/fe/xdmf/xdmf_states.h"

namespace rubble::io {

namespace {

constexpr std::uintmax_t longestText = std::uintmax_t{1} << 30;

/// A cell type: how XDMF writes it in words and codes, and what VTK calls it.
struct XdmfCell {
    std::string_view name;
    int code;
    std::size_t nodes;  // 0: a count follows the code
    std::uint8_t vtk;
};

constexpr int polyhedronCode = 16;

// Xdmf model and format, topology types.
constexpr std::array<XdmfCell, 21> cells{{{"polyvertex", 1, 0, 1},
                                          {"polyline", 2, 0, 3},
                                          {"polygon", 3, 0, 7},
                                          {"triangle", 4, 3, 5},
                                          {"quadrilateral", 5, 4, 9},
                                          {"tetrahedron", 6, 4, 10},
                                          {"pyramid", 7, 5, 14},
                                          {"wedge", 8, 6, 13},
                                          {"hexahedron", 9, 8, 12},
                                          {"polyhedron", polyhedronCode, 0, 42},
                                          {"edge_3", 0x22, 3, 21},
                                          {"triangle_6", 0x24, 6, 22},
                                          {"quadrilateral_8", 0x25, 8, 23},
                                          {"tetrahedron_10", 0x26, 10, 24},
                                          {"pyramid_13", 0x27, 13, 27},
                                          {"wedge_15", 0x28, 15, 26},
                                          {"wedge_18", 0x29, 18, 32},
                                          {"hexahedron_20", 0x30, 20, 25},
                                          {"hexahedron_24", 0x31, 24, 33},
                                          {"hexahedron_27", 0x32, 27, 29},
                                          {"quadrilateral_9", 0x23, 9, 28}}};

pugi::xml_document documentOf(const std::string& path) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    pugi::xml_document document;
    const auto result = !error && size <= longestText ? document.load_file(path.c_str()) : pugi::xml_parse_result();
    if (!result) {
        throw ParseError({"xdmf.xml",
                          "{0} is no sound XML: {1} at byte {2}",
                          {path, result.description(), static_cast<std::int64_t>(result.offset)}},
                         {"xdmf.xml.remedy", "The file is damaged or not yet whole: copy it again or write it again.", {}});
    }
    return document;
}

class XdmfGrids : public GridSource {
public:
    explicit XdmfGrids(const std::string& path)
        : m_document(documentOf(path)), m_items(path), m_states(findXdmfStates(m_document, m_items)) {
        for (const XdmfState& state : m_states.list) {
            m_times.push_back(state.time);
        }
    }

    const std::vector<double>& times() const override { return m_times; }
    bool timed() const { return m_states.timed; }
    std::size_t dropped() const { return m_states.dropped; }
    const Findings& findings() const { return m_states.findings; }

    bool sameCells(std::size_t k, const std::vector<std::string>& cellArrays) const override {
        if (k == 0 || m_states.list[k].pieces.size() != m_states.list[k - 1].pieces.size()) {
            return false;
        }
        for (std::size_t p = 0; p < m_states.list[k].pieces.size(); ++p) {
            const Grids &a = m_states.list[k - 1].pieces[p], &b = m_states.list[k].pieces[p];
            bool same = sameXdmfItem(part(a.front(), "Topology"), part(b.front(), "Topology"), m_items);
            for (const std::string& name : cellArrays) {
                same = same && sameXdmfItem(attribute(a, name), attribute(b, name), m_items);
            }
            if (!same) {
                return false;
            }
        }
        return true;
    }

    Grid read(std::size_t k, const GridSelection& selection) const override {
        std::optional<Grid> joined;
        for (const Grids& piece : m_states.list[k].pieces) {
            joinGrid(joined, readPiece(piece, selection));
        }
        Grid grid = std::move(joined).value_or(Grid());
        grid.time = m_times[k];
        return grid;
    }

private:
    using Grids = std::vector<pugi::xml_node>;

    pugi::xml_node part(pugi::xml_node grid, const std::string& name) const { return xdmfPart(grid, name, m_items); }

    static pugi::xml_node attribute(const Grids& grids, const std::string& name) {
        for (const pugi::xml_node grid : grids) {
            if (const pugi::xml_node found = grid.find_child_by_attribute("Attribute", "Name", name.c_str());
                found && !name.empty()) {
                return found;
            }
        }
        return {};
    }

    // The mesh of the first grid and the arrays of all.
    Grid readPiece(const Grids& grids, const GridSelection& selection) const {
        Grid grid = readGrid(grids.front(), selection);
        for (std::size_t g = 1; g < grids.size(); ++g) {
            for (const pugi::xml_node array : grids[g].children("Attribute")) {
                readArray(array, selection, grid);
            }
        }
        return grid;
    }

    Grid readGrid(pugi::xml_node node, const GridSelection& selection) const {
        Grid grid;
        const pugi::xml_node topology = part(node, "Topology");
        const pugi::xml_node geometry = part(node, "Geometry");
        if (!topology || !geometry) {
            m_items.fail("a grid has no topology or no geometry");
        }
        if (selection.points || selection.everything) {
            readPoints(geometry, grid);
        }
        if (selection.cells || selection.everything) {
            readCells(topology, grid);
        }
        const pugi::xml_attribute stored = topology.attribute("NumberOfElements");
        grid.storedCells = (stored ? stored : topology.attribute("Dimensions")).as_ullong(grid.types.size());
        for (const pugi::xml_node array : node.children("Attribute")) {
            readArray(array, selection, grid);
        }
        addHiddenNumbers(topology, selection, grid);
        return grid;
    }

    void readPoints(pugi::xml_node geometry, Grid& grid) const {
        const std::string type = xdmfType(geometry, "GeometryType");
        const std::size_t axes = type == "xy" ? 2 : 3;
        if (!type.empty() && type != "xyz" && type != "xy") {
            m_items.fail("geometry of type " + type.substr(0, 40) + " is not read");
        }
        const std::vector<double> values = m_items.reals(m_items.itemOf(geometry));
        for (std::size_t i = 0; i + axes <= values.size(); i += axes) {
            grid.points.emplace_back(values[i], values[i + 1], axes == 3 ? values[i + 2] : 0.0);
        }
    }

    void readCells(pugi::xml_node topology, Grid& grid) const {
        const std::string type = xdmfType(topology, "TopologyType");
        const std::vector<std::int64_t> values = m_items.integers(m_items.itemOf(topology));
        grid.offsets.push_back(0);
        if (type == "mixed") {
            readMixed(values, grid);
            return;
        }
        const auto known = std::find_if(cells.begin(), cells.end(), [&](const XdmfCell& cell) {
            return cell.name == type || (type.starts_with("hex_") && cell.name == "hexahedron" + type.substr(3)) ||
                   (type.starts_with("tet_") && cell.name == "tetrahedron" + type.substr(3)) ||
                   (type.starts_with("tri_") && cell.name == "triangle" + type.substr(3)) ||
                   (type.starts_with("quad_") && cell.name == "quadrilateral" + type.substr(4));
        });
        if (known == cells.end()) {
            m_items.fail("topology of type " + (type.empty() ? "(none)" : type.substr(0, 40)) + " is not read");
        }
        const std::size_t own = topology.attribute("NodesPerElement").as_uint(2);
        const std::size_t nodes = std::max<std::size_t>(known->nodes > 0 ? known->nodes : own, 1);
        for (std::size_t i = 0; i + nodes <= values.size(); i += nodes) {
            grid.types.push_back(typeOfCell(*known, nodes));
            grid.connectivity.insert(grid.connectivity.end(), values.begin() + static_cast<std::ptrdiff_t>(i),
                                     values.begin() + static_cast<std::ptrdiff_t>(i + nodes));
            grid.offsets.push_back(static_cast<std::int64_t>(grid.connectivity.size()));
        }
    }

    void readMixed(const std::vector<std::int64_t>& values, Grid& grid) const {
        for (std::size_t i = 0; i < values.size();) {
            const auto known =
                std::find_if(cells.begin(), cells.end(), [&](const XdmfCell& cell) { return cell.code == values[i]; });
            if (known == cells.end()) {
                m_items.fail("the mixed topology has the cell type " + std::to_string(values[i]) + " at entry " +
                             std::to_string(i));
            }
            ++i;
            if (known->code == polyhedronCode) {
                i = readPolyhedron(values, i, grid);
                continue;
            }
            std::int64_t nodes = static_cast<std::int64_t>(known->nodes);
            if (nodes == 0 && i < values.size()) {
                nodes = values[i++];
            }
            if (nodes < 1 || static_cast<std::uint64_t>(nodes) > values.size() - i) {
                m_items.fail("the mixed topology ends inside a cell");
            }
            grid.types.push_back(typeOfCell(*known, static_cast<std::size_t>(nodes)));
            for (std::int64_t n = 0; n < nodes; ++n) {
                grid.connectivity.push_back(values[i++]);
            }
            grid.offsets.push_back(static_cast<std::int64_t>(grid.connectivity.size()));
        }
    }

    // A polyline of two nodes is a line.
    static std::uint8_t typeOfCell(const XdmfCell& cell, std::size_t nodes) {
        constexpr std::uint8_t line = 3, polyline = 4;
        return cell.vtk == line && nodes > 2 ? polyline : cell.vtk;
    }

    // How many faces, then each with its count of nodes. Gives the place behind; the cell has each node once.
    std::size_t readPolyhedron(const std::vector<std::int64_t>& values, std::size_t at, Grid& grid) const {
        std::set<std::int64_t> nodes;
        const auto next = [&] {
            if (at >= values.size()) {
                m_items.fail("the mixed topology ends inside a polyhedron");
            }
            return values[at++];
        };
        for (std::int64_t faces = next(); faces > 0; --faces) {
            for (std::int64_t count = next(); count > 0; --count) {
                nodes.insert(next());
            }
        }
        grid.types.push_back(42);
        grid.connectivity.insert(grid.connectivity.end(), nodes.begin(), nodes.end());
        grid.offsets.push_back(static_cast<std::int64_t>(grid.connectivity.size()));
        return at;
    }

    void readArray(pugi::xml_node array, const GridSelection& selection, Grid& grid) const {
        const std::string centre = xdmfLowerCase(array.attribute("Center").as_string("node"));
        const std::string name = array.attribute("Name").as_string();
        if (centre != "node" && centre != "cell") {
            return;
        }
        const bool node = centre == "node";
        if (findArray(node ? grid.pointData : grid.cellData, name)) {
            return;
        }
        GridArray& result = (node ? grid.pointData : grid.cellData).emplace_back();
        result.name = name;
        const pugi::xml_node item = m_items.itemOf(array);
        const std::vector<std::uint64_t> dimensions = m_items.dimensions(item);
        result.components = dimensions.size() > 1 ? std::max<std::uint64_t>(dimensions.back(), 1) : 1;
        if (node ? selection.wantsPoint(name) : selection.wantsCell(name)) {
            result.values = m_items.reals(item);
        }
    }

    // Writers that put numbers of elements into the HDF5 file often leave them out of the XML: they lie beside the connectivity.
    void addHiddenNumbers(pugi::xml_node topology, const GridSelection& selection, Grid& grid) const {
        const pugi::xml_node item = m_items.itemOf(topology);
        const auto [path, table] = m_items.placeOf(item);
        const std::vector<std::uint64_t> dimensions = m_items.dimensions(item);
        if (path.empty() || dimensions.empty()) {
            return;
        }
        const Hdf5Table& file = m_items.file(path);
        const std::string group = table.substr(0, table.rfind('/'));
        for (const std::string& name : file.tablesIn(group.empty() ? "/" : group)) {
            const std::string key = xdmfLowerCase(name);
            const bool numbers =
                key == "element_id" || key == "elementid" || key == "eid" || key == "element_ids" || key == "cell_ids";
            const Hdf5Table::Shape shape = numbers ? file.shape(group + "/" + name) : Hdf5Table::Shape();
            if (!numbers || findArray(grid.cellData, name) || shape.rows != dimensions.front() || shape.columns != 1) {
                continue;
            }
            GridArray& array = grid.cellData.emplace_back();
            array.name = name;
            if (selection.wantsCell(name)) {
                array.values = file.reals(group + "/" + name, 0, shape.rows);
            }
        }
    }

    pugi::xml_document m_document;
    XdmfItems m_items;
    XdmfStates m_states;
    std::vector<double> m_times;
};

// Files of tables that a text names.
std::set<std::string> tablesOf(const std::string& path) {
    const pugi::xml_document document = documentOf(path);
    const XdmfItems items(path);
    std::set<std::string> tables;
    for (const pugi::xpath_node& found : document.select_nodes("//DataItem[@Format='HDF']")) {
        tables.insert(items.placeOf(found.node()).first);
    }
    return tables;
}

// The text beside a file of tables that names it; empty: there is none.
std::string textNaming(const std::string& tables) {
    const auto plain = [](const std::string& path) { return std::filesystem::path(path).lexically_normal(); };
    for (const std::string& beside : filesBeside(tables)) {
        if (!beside.ends_with(".xdmf") && !beside.ends_with(".xmf")) {
            continue;
        }
        try {
            const std::set<std::string> named = tablesOf(beside);
            if (std::any_of(named.begin(), named.end(), [&](const auto& file) { return plain(file) == plain(tables); })) {
                return beside;
            }
        } catch (const std::exception&) {
            // A text that cannot be read names nothing.
        }
    }
    return {};
}

bool isHdf5(std::string_view bytes) {
    return bytes.starts_with(hdf5Signature);
}

bool isHdf5File(const std::string& path) {
    std::string bytes(8, '\0');
    return std::ifstream(path, std::ios::binary).read(bytes.data(), 8) && isHdf5(bytes);
}

// HDF5 that is a result by itself: our own files, VTKHDF, Exodus II.
bool isResultByItself(const FileHead& head) {
    const auto& names = head.hdf5Names;
    return !head.hdf5Format.empty() ||
           std::any_of(names.begin(), names.end(), [](const auto& name) { return name == "VTKHDF" || name == "time_whole"; });
}

}  // namespace

bool recognisesXdmf(const FileHead& head) {
    if (head.packed) {
        return false;
    }
    return isHdf5(head.bytes) ? !isResultByItself(head) && !textNaming(head.path).empty()
                              : head.bytes.substr(0, 1024).find("<Xdmf") != std::string::npos;
}

std::vector<std::string> xdmfMembers(const std::string& path) {
    const std::string text = isHdf5File(path) ? textNaming(path) : std::string();
    std::vector<std::string> files{text.empty() ? path : text};
    try {
        std::error_code ignored;
        for (const std::string& file : tablesOf(files.front())) {
            if (std::filesystem::is_regular_file(file, ignored)) {
                files.push_back(file);
            }
        }
    } catch (const std::exception&) {
        // What cannot be read stands alone; opening it says why.
    }
    return withDeathList(std::move(files));
}

FeResult::Contents readXdmf(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    auto source = std::make_unique<const XdmfGrids>(path);
    const bool timed = source->timed();
    const std::size_t dropped = source->dropped();
    const Findings findings = source->findings();
    const auto series = std::make_shared<GridSeries>(path, std::move(source), settings);
    series->note(findings);
    if (!timed) {
        series->noteMissingTimes({path});
    }
    if (dropped > 0) {
        series->noteDroppedTimes(dropped);
    }
    return readSeries(path, series, settings, execution);
}

}  // namespace rubble::io
