#include "io/fe/vtk/vtkhdf_reader.h"

#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "io/fe/series/series_result.h"
#include "io/fe/vtk/grid_series.h"
#include "io/fe/vtk/hdf5_table.h"

namespace rubble::io {

namespace {

const std::string root = "/VTKHDF";

[[noreturn]] void failLayout(const std::string& path, const std::string& what) {
    throw ParseError(
        {"vtkhdf.layout", "{0} is no VTKHDF grid that can be read: {1}", {path, what}},
        {"vtkhdf.layout.remedy", "Write it as an unstructured grid (VTKHDF 1.0 or 2.x), or as .vtu files with a .pvd.", {}});
}

/// Where the pieces of one state stand in the tables.
struct Step {
    std::int64_t part = 0, parts = 1;
    std::int64_t point = 0, cell = 0, entry = 0;  // of points, cells, connectivity
    std::int64_t meshes = 0;                      // partitions before it in the tables: each has one offset more than it has cells
    std::map<std::string, std::int64_t> pointArrays, cellArrays;
};

/// A mesh in tables that do not say where it lies.
struct AppendedMesh {
    std::int64_t cell = 0, entry = 0;     // before it
    std::int64_t cells = 0, entries = 0;  // of its own
};

/// Grids in one VTKHDF file. The layout of steps is that of the VTK file format specification, VTKHDF 2.0.
class VtkHdfGrids : public GridSource {
public:
    explicit VtkHdfGrids(const std::string& path) : m_file(path) {
        const auto type = m_file.text(root, "Type");
        if (type != "UnstructuredGrid") {
            failLayout(path, "its type is " + type.value_or("not said") + " instead of UnstructuredGrid");
        }
        const std::int64_t version = m_file.number(root, "Version").value_or(1);
        if (version < 1 || version > 2) {
            failLayout(path, "its version is " + std::to_string(version));
        }
        m_points = all("NumberOfPoints");
        m_cells = all("NumberOfCells");
        m_entries = all("NumberOfConnectivityIds");
        if (m_points.size() != m_cells.size() || m_points.size() != m_entries.size() || m_points.empty()) {
            failLayout(path, "its counts of points, cells and connectivity do not go together");
        }
        for (const auto* counts : {&m_points, &m_cells, &m_entries}) {
            if (std::any_of(counts->begin(), counts->end(), [](std::int64_t count) { return count < 0; })) {
                failLayout(path, "a count is negative");
            }
        }
        m_pointArrays = m_file.tablesIn(root + "/PointData");
        m_cellArrays = m_file.tablesIn(root + "/CellData");
        readSteps();
    }

    const std::vector<double>& times() const override { return m_times; }

    bool sameCells(std::size_t k, const std::vector<std::string>& cellArrays) const override {
        if (k == 0) {
            return false;
        }
        const Step &a = m_steps[k - 1], &b = m_steps[k];
        const auto moved = [&](const std::string& name) {
            const auto left = a.cellArrays.find(name), right = b.cellArrays.find(name);
            return left != a.cellArrays.end() && right != b.cellArrays.end() && left->second != right->second;
        };
        return a.meshes == b.meshes && a.parts == b.parts && a.cell == b.cell && a.entry == b.entry &&
               std::none_of(cellArrays.begin(), cellArrays.end(), moved);
    }

    Grid read(std::size_t k, const GridSelection& selection) const override {
        const Step& step = m_steps[k];
        std::optional<Grid> joined;
        std::int64_t point = 0, cell = 0, entry = 0;
        for (std::int64_t p = 0; p < step.parts; ++p) {
            const auto part = static_cast<std::size_t>(step.part + p);
            joinGrid(joined, readPiece(step, part, {point, cell, entry}, step.meshes + p, selection));
            point = sum(point, m_points[part]);
            cell = sum(cell, m_cells[part]);
            entry = sum(entry, m_entries[part]);
        }
        Grid grid = std::move(joined).value_or(Grid());
        grid.time = m_times[k];
        return grid;
    }

private:
    struct Before {
        std::int64_t point, cell, entry;
    };

    static std::uint64_t sum(std::int64_t a, std::int64_t b) {
        std::int64_t result = 0;
        // What overflows lies behind the end of every table, and reading there says so.
        return a < 0 || b < 0 || __builtin_add_overflow(a, b, &result) ? static_cast<std::uint64_t>(INT64_MAX)
                                                                       : static_cast<std::uint64_t>(result);
    }

    std::vector<std::int64_t> all(const std::string& name) const {
        const std::string full = root + "/" + name;
        return m_file.integers(full, 0, m_file.shape(full).rows);
    }

    void readSteps() {
        if (!m_file.number(root + "/Steps", "NSteps")) {
            m_times = {0.0};
            m_steps.emplace_back();
            m_steps.back().parts = static_cast<std::int64_t>(m_points.size());
            requireParts();
            return;
        }
        const std::string steps = root + "/Steps";
        m_times = m_file.reals(steps + "/Values", 0, m_file.shape(steps + "/Values").rows);
        m_steps.resize(m_times.size());
        fill("Steps/PartOffsets", [](Step& step) -> std::int64_t& { return step.part; });
        countParts();
        fill("Steps/PointOffsets", [](Step& step) -> std::int64_t& { return step.point; });
        fill("Steps/CellOffsets", [](Step& step) -> std::int64_t& { return step.cell; });
        fill("Steps/ConnectivityIdOffsets", [](Step& step) -> std::int64_t& { return step.entry; });
        for (const std::string& name : m_file.tablesIn(steps + "/PointDataOffsets")) {
            fill("Steps/PointDataOffsets/" + name, [&](Step& step) -> std::int64_t& { return step.pointArrays[name]; });
        }
        for (const std::string& name : m_file.tablesIn(steps + "/CellDataOffsets")) {
            fill("Steps/CellDataOffsets/" + name, [&](Step& step) -> std::int64_t& { return step.cellArrays[name]; });
        }
        for (Step& step : m_steps) {
            step.meshes = step.part;
        }
        followAppendedMeshes();
        requireParts();
    }

    /// The recorder of OpenSees appends its mesh again whenever the model changes, and counts of it for every state. It leaves the
    /// places of partitions, cells and connectivity at zero: only those of the points say that a state has another mesh.
    void followAppendedMeshes() {
        const auto left = [](const Step& step) { return step.part == 0 && step.parts == 1 && step.cell == 0 && step.entry == 0; };
        const auto moved = [](const Step& step) { return step.point != 0; };
        if (m_points.size() != m_steps.size() || !std::all_of(m_steps.begin(), m_steps.end(), left) ||
            std::none_of(m_steps.begin(), m_steps.end(), moved)) {
            return;
        }
        const std::vector<AppendedMesh> meshes = appendedMeshes();
        std::size_t mesh = 0;
        for (std::size_t k = 0; k < m_steps.size(); ++k) {
            Step& step = m_steps[k];
            const std::int64_t before = k == 0 ? 0 : m_steps[k - 1].point, points = m_points[k == 0 ? 0 : k - 1];
            if (step.point > before) {
                // Some are of no state: the model changed more than once in between.
                mesh +=
                    static_cast<std::size_t>(std::max<std::int64_t>((step.point - before) / std::max<std::int64_t>(points, 1), 1));
            }
            while (mesh < meshes.size() && (meshes[mesh].cells != m_cells[k] || meshes[mesh].entries != m_entries[k])) {
                ++mesh;
            }
            if (mesh >= meshes.size() || step.point < before) {
                failLayout(m_file.path(), "none of its meshes has the counts of state " + std::to_string(k));
            }
            step.part = static_cast<std::int64_t>(k);
            step.meshes = static_cast<std::int64_t>(mesh);
            step.cell = meshes[mesh].cell;
            step.entry = meshes[mesh].entry;
        }
    }

    // Each begins with an offset of zero.
    std::vector<AppendedMesh> appendedMeshes() const {
        const auto entries = static_cast<std::int64_t>(m_file.shape(root + "/Connectivity").rows);
        std::vector<AppendedMesh> meshes;
        for (const std::int64_t offset : all("Offsets")) {
            if (offset == 0) {
                const AppendedMesh last = meshes.empty() ? AppendedMesh() : meshes.back();
                meshes.push_back({last.cell + last.cells, last.entry + last.entries, 0, 0});
            } else if (meshes.empty() || offset < 0 || offset > entries) {
                failLayout(m_file.path(), "its offsets lie outside its connectivity");
            } else {
                ++meshes.back().cells;
                meshes.back().entries = offset;
            }
        }
        return meshes;
    }

    /// States that do not say how many partitions they have take all up to those that follow.
    void countParts() {
        if (m_file.has(root + "/Steps/NumberOfParts")) {
            fill("Steps/NumberOfParts", [](Step& step) -> std::int64_t& { return step.parts; });
            return;
        }
        auto end = static_cast<std::int64_t>(m_points.size());
        for (std::size_t k = m_steps.size(); k-- > 0;) {
            if (k + 1 < m_steps.size() && m_steps[k].part < m_steps[k + 1].part) {
                end = m_steps[k + 1].part;
            }
            m_steps[k].parts = end - m_steps[k].part;
        }
    }

    template <class Member>
    void fill(const std::string& name, const Member& member) {
        if (!m_file.has(root + "/" + name)) {
            return;
        }
        const std::vector<std::int64_t> values = m_file.integers(root + "/" + name, 0, m_steps.size());
        const std::size_t columns = m_steps.empty() ? 1 : values.size() / m_steps.size();
        for (std::size_t k = 0; k < m_steps.size() && columns > 0; ++k) {
            member(m_steps[k]) = values[k * columns];
        }
    }

    void requireParts() const {
        for (std::size_t k = 0; k < m_steps.size(); ++k) {
            const Step& step = m_steps[k];
            const auto parts = static_cast<std::int64_t>(m_points.size());
            if (step.part < 0 || step.parts < 1 || step.part > parts || step.parts > parts - step.part) {
                failLayout(m_file.path(), "state " + std::to_string(k) + " has the parts " + std::to_string(step.part) + " to " +
                                              std::to_string(step.part) + " + " + std::to_string(step.parts) + " of " +
                                              std::to_string(parts));
            }
        }
    }

    Grid readPiece(const Step& step, std::size_t part, const Before& before, std::int64_t pieces,
                   const GridSelection& selection) const {
        Grid grid;
        const auto points = static_cast<std::uint64_t>(m_points[part]), cells = static_cast<std::uint64_t>(m_cells[part]);
        grid.storedCells = cells;
        grid.vacant = points == 0 && cells == 0;
        if (selection.points || selection.everything) {
            readPoints(sum(step.point, before.point), points, grid);
        }
        if ((selection.cells || selection.everything) && cells > 0) {
            // Every piece has one offset more than it has cells.
            const std::uint64_t first = sum(step.cell, before.cell);
            grid.offsets = m_file.integers(root + "/Offsets", sum(static_cast<std::int64_t>(first), pieces), cells + 1);
            for (const std::int64_t type : m_file.integers(root + "/Types", first, cells)) {
                grid.types.push_back(static_cast<std::uint8_t>(type));
            }
            grid.connectivity =
                m_file.integers(root + "/Connectivity", sum(step.entry, before.entry), static_cast<std::uint64_t>(m_entries[part]));
        }
        readArrays("/PointData", m_pointArrays, step.pointArrays, {step.point, before.point, points}, selection, true,
                   grid.pointData);
        readArrays("/CellData", m_cellArrays, step.cellArrays, {step.cell, before.cell, cells}, selection, false, grid.cellData);
        return grid;
    }

    void readPoints(std::uint64_t first, std::uint64_t points, Grid& grid) const {
        const std::vector<double> values = m_file.reals(root + "/Points", first, points);
        if (values.size() != 3 * points) {
            failLayout(m_file.path(), "its points do not have three coordinates");
        }
        for (std::size_t p = 0; p < points; ++p) {
            grid.points.emplace_back(values[3 * p], values[3 * p + 1], values[3 * p + 2]);
        }
    }

    struct Range {
        std::int64_t geometry, before;
        std::uint64_t count;
    };

    void readArrays(const std::string& group, const std::vector<std::string>& names,
                    const std::map<std::string, std::int64_t>& offsets, const Range& range, const GridSelection& selection,
                    bool points, std::vector<GridArray>& arrays) const {
        for (const std::string& name : names) {
            GridArray& array = arrays.emplace_back();
            array.name = name;
            array.components = std::max<std::uint64_t>(m_file.shape(root + group + "/" + name).columns, 1);
            if (points ? selection.wantsPoint(name) : selection.wantsCell(name)) {
                const auto own = offsets.find(name);
                const std::int64_t first = own == offsets.end() ? range.geometry : own->second;
                array.values = m_file.reals(root + group + "/" + name, sum(first, range.before), range.count);
            }
        }
    }

    Hdf5Table m_file;
    std::vector<std::int64_t> m_points, m_cells, m_entries;  // of every part
    std::vector<std::string> m_pointArrays, m_cellArrays;
    std::vector<double> m_times;
    std::vector<Step> m_steps;
};

}  // namespace

bool recognisesVtkHdf(const FileHead& head) {
    return std::find(head.hdf5Names.begin(), head.hdf5Names.end(), "VTKHDF") != head.hdf5Names.end();
}

FeResult::Contents readVtkHdf(const std::string& path, const ImportSettings& settings, const Execution& execution) {
    const auto series = std::make_shared<GridSeries>(path, std::make_unique<const VtkHdfGrids>(path), settings);
    return readSeries(path, series, settings, execution);
}

std::vector<std::string> aloneWithDeathList(const std::string& path) {
    return withDeathList({path});
}

}  // namespace rubble::io
