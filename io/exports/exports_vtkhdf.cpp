#include <array>
#include <cerrno>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "io/base/files.h"
#include "io/base/hdf5_rows.h"
#include "io/base/run_driver.h"
#include "io/exports/exports.h"
#include "io/run/run_grids.h"

namespace rubble::io {

namespace {

constexpr std::size_t rowsPerChunk = std::size_t{1} << 16;
constexpr std::size_t parts = std::size(RunGrids::partNames);

/// A dataset that grows: by cells or points, or by one row a step.
class Column {
public:
    /// @param memory, file  types of one number
    Column(hid_t store, const std::string& name, hid_t memory, hid_t file, hsize_t width = 0,
           std::size_t rowsOfChunk = rowsPerChunk)
        : m_rows{width, rowsOfChunk, std::max<std::size_t>(width, 1) * H5Tget_size(memory)}, m_memory(memory) {
        const std::string path = "/VTKHDF/" + name;
        m_rows.make(store, path.c_str(), file);
        m_set = m_rows.open(store, path.c_str());
    }

    bool valid() const { return m_set.valid(); }
    hsize_t count() const { return m_count; }
    /// Returns why it failed; nothing if it did not.
    std::optional<std::string> append(const void* rows, std::size_t count) {
        const auto failure = m_rows.append(m_set.get(), m_memory, m_count, rows, count);
        m_count += count;
        return failure;
    }

private:
    GrowingRows m_rows;
    hid_t m_memory;
    Hdf5Handle m_set;
    hsize_t m_count = 0;
};

/// A temporal unstructured grid, every step a partition of its own, so that readers without time find each as a piece.
/// "VTKHDF format specification" of VTK, version 2.0.
class VtkHdfFile {
public:
    /// @param path  what the file is to be called; @param unfinished  what it is called until it is whole
    VtkHdfFile(const std::string& path, const std::string& unfinished, const RunGrids& grids) : m_path(path), m_grids(grids) {
        const Hdf5Session session;
        const Hdf5Handle access = runFileAccess();
        m_file = Hdf5Handle(H5Fcreate(unfinished.c_str(), H5F_ACC_EXCL, H5P_DEFAULT, access.get()), H5Fclose);
        if (!m_file.valid()) {
            failToWrite(m_path, systemReason(runDriverOpenError()));
        }
        for (const char* name : {"/VTKHDF", "/VTKHDF/CellData", "/VTKHDF/FieldData", "/VTKHDF/PointData", "/VTKHDF/Steps"}) {
            const Hdf5Handle group(H5Gcreate2(m_file.get(), name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
        }
        putKind();
        putNames("component_names", grids.componentNames());
        putNames("part_names", {std::begin(RunGrids::partNames), std::end(RunGrids::partNames)});
        makeColumns();
    }

    /// @param shown  parts of the run, by their numbers; a part may be missing
    void addStep(double time, const std::array<const CellGrid*, parts>& shown) {
        const Hdf5Session session;
        Size size;
        // Where the step begins is where everything before it ends.
        const std::array<std::int64_t, 5> begin{m_steps, rows("Points"), rows("Types"), rows("Connectivity"), 0};
        const std::int64_t zero = 0, one = 1;
        for (std::size_t p = 0; p < parts; ++p) {
            if (shown[p] != nullptr) {
                addPart(static_cast<std::uint8_t>(p), *shown[p], size);
            }
        }
        put("Offsets", &size.connectivity, 1);
        put("NumberOfPoints", &size.points, 1);
        put("NumberOfCells", &size.cells, 1);
        put("NumberOfConnectivityIds", &size.connectivity, 1);
        put("Steps/Values", &time, 1);
        put("Steps/PartOffsets", begin.data(), 1);
        put("Steps/NumberOfParts", &one, 1);
        put("Steps/PointOffsets", &begin[1], 1);
        put("Steps/CellOffsets", &begin[2], 1);
        put("Steps/ConnectivityIdOffsets", &begin[3], 1);
        for (const char* name : cellArrays) {
            put(std::string("Steps/CellDataOffsets/") + name, &begin[2], 1);
        }
        for (const auto& [name, count] : m_names) {
            const std::array<std::int64_t, 2> extent{1, count};
            put("Steps/FieldDataOffsets/" + name, &zero, 1);
            put("Steps/FieldDataSizes/" + name, extent.data(), 1);
        }
        ++m_steps;
    }

    void close() {
        {
            const Hdf5Session session;
            const Hdf5Handle steps(H5Gopen2(m_file.get(), "/VTKHDF/Steps", H5P_DEFAULT), H5Gclose);
            putIntegers(steps.get(), "NSteps", std::array{m_steps}, true);
            m_columns.clear();
            require(H5Fflush(m_file.get(), H5F_SCOPE_GLOBAL) >= 0);
        }
        if (!m_file.reset()) {
            failToWrite(m_path, systemReason(EIO));
        }
    }

private:
    struct Size {
        std::int64_t points = 0, cells = 0, connectivity = 0;
    };
    static constexpr std::array<const char*, 6> cellArrays{"fragment_id", "element_id", "component", "cluster_id", "speed", "part"};

    void require(bool good) const {
        if (const int error = runDriverError(m_file.get())) {
            failToWrite(m_path, systemReason(error));
        }
        if (!good) {
            failToWrite(m_path, hdf5Reason());
        }
    }

    template <std::size_t N>
    void putIntegers(hid_t owner, const char* name, const std::array<std::int64_t, N>& values, bool scalar) const {
        const hsize_t extent = N;
        const Hdf5Handle space(scalar ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &extent, nullptr), H5Sclose);
        const Hdf5Handle attribute(H5Acreate2(owner, name, H5T_STD_I64LE, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
        require(attribute.valid() && H5Awrite(attribute.get(), H5T_NATIVE_INT64, values.data()) >= 0);
    }

    void putKind() const {
        const Hdf5Handle root(H5Gopen2(m_file.get(), "/VTKHDF", H5P_DEFAULT), H5Gclose);
        putIntegers(root.get(), "Version", std::array<std::int64_t, 2>{2, 0}, false);
        static constexpr char kind[] = "UnstructuredGrid";
        const Hdf5Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
        // Readers compare it as it is: no byte more.
        H5Tset_size(text.get(), sizeof kind - 1);
        H5Tset_strpad(text.get(), H5T_STR_NULLPAD);
        const Hdf5Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
        const Hdf5Handle type(H5Acreate2(root.get(), "Type", text.get(), scalar.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
        require(type.valid() && H5Awrite(type.get(), text.get(), kind) >= 0);
    }

    // UTF-8 that is not called so: VTK's readers ask for plain text, and the library converts nothing to it.
    void putNames(const std::string& name, const std::vector<std::string>& names) {
        std::vector<const char*> texts;
        for (const std::string& each : names) {
            texts.push_back(each.c_str());
        }
        const Hdf5Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
        H5Tset_size(text.get(), H5T_VARIABLE);
        const hsize_t count = texts.size();
        const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
        const std::string path = "/VTKHDF/FieldData/" + name;
        const Hdf5Handle set(H5Dcreate2(m_file.get(), path.c_str(), text.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                             H5Dclose);
        require(set.valid() &&
                (texts.empty() || H5Dwrite(set.get(), text.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()) >= 0));
        m_names.emplace_back(name, static_cast<std::int64_t>(count));
    }

    void addColumn(const std::string& name, hid_t memory, hid_t file, hsize_t width = 0) {
        const std::size_t rowsOfChunk = name.starts_with("Steps") || name.starts_with("Number") ? 256 : rowsPerChunk;
        require(m_columns.emplace(name, Column(m_file.get(), name, memory, file, width, rowsOfChunk)).first->second.valid());
    }

    void makeColumns() {
        addColumn("Points", H5T_NATIVE_DOUBLE, m_grids.needsDoublePrecision() ? H5T_IEEE_F64LE : H5T_IEEE_F32LE, 3);
        addColumn("Types", H5T_NATIVE_UINT8, H5T_STD_U8LE);
        addColumn("CellData/element_id", H5T_NATIVE_INT64, H5T_STD_I64LE);
        addColumn("CellData/part", H5T_NATIVE_UINT8, H5T_STD_U8LE);
        addColumn("CellData/speed", H5T_NATIVE_FLOAT, H5T_IEEE_F32LE);
        for (const char* name : {"CellData/component", "CellData/fragment_id", "CellData/cluster_id"}) {
            addColumn(name, H5T_NATIVE_INT32, H5T_STD_I32LE);
        }
        addColumn("Steps/Values", H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE);
        // One column a topology, of which an unstructured grid has one.
        for (const char* name : {"Steps/CellOffsets", "Steps/ConnectivityIdOffsets"}) {
            addColumn(name, H5T_NATIVE_INT64, H5T_STD_I64LE, 1);
        }
        for (const char* name : {"Connectivity", "Offsets", "NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds",
                                 "Steps/PartOffsets", "Steps/NumberOfParts", "Steps/PointOffsets"}) {
            addColumn(name, H5T_NATIVE_INT64, H5T_STD_I64LE);
        }
        for (const char* name : cellArrays) {
            addColumn(std::string("Steps/CellDataOffsets/") + name, H5T_NATIVE_INT64, H5T_STD_I64LE);
        }
        for (const auto& [name, count] : m_names) {
            addColumn("Steps/FieldDataOffsets/" + name, H5T_NATIVE_INT64, H5T_STD_I64LE);
            addColumn("Steps/FieldDataSizes/" + name, H5T_NATIVE_INT64, H5T_STD_I64LE, 2);
        }
    }

    std::int64_t rows(const char* name) const { return static_cast<std::int64_t>(m_columns.at(name).count()); }

    void put(const std::string& name, const void* values, std::size_t count) {
        const auto failure = m_columns.at(name).append(values, count);
        require(true);
        if (failure) {
            failToWrite(m_path, *failure);
        }
    }
    template <class T>
    void put(const std::string& name, const std::vector<T>& values) {
        put(name, values.data(), values.size());
    }

    static_assert(sizeof(Vec3) == 3 * sizeof(double));

    // Numbers of points and of entries go on from part to part within a step.
    void addPart(std::uint8_t part, const CellGrid& grid, Size& size) {
        const auto moved = [](const std::vector<std::int64_t>& values, std::int64_t by, std::size_t count) {
            std::vector<std::int64_t> result(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
            for (std::int64_t& value : result) {
                value += by;
            }
            return result;
        };
        const std::size_t cells = grid.cells();
        put("Points", grid.points);
        put("Connectivity", moved(grid.connectivity, size.points, grid.connectivity.size()));
        put("Offsets", moved(grid.offsets, size.connectivity, cells));
        put("Types", grid.types);
        put("CellData/element_id", grid.elements);
        put("CellData/component", grid.components);
        put("CellData/part", std::vector<std::uint8_t>(cells, part));
        const bool areFragments = !grid.fragments.empty();
        const std::vector<std::int32_t> none(areFragments ? 0 : cells, -1);
        put("CellData/fragment_id", areFragments ? grid.fragments : none);
        put("CellData/cluster_id", areFragments ? grid.clusters : none);
        put("CellData/speed", areFragments ? grid.speeds : std::vector<float>(cells, std::numeric_limits<float>::quiet_NaN()));
        size.points += static_cast<std::int64_t>(grid.points.size());
        size.cells += static_cast<std::int64_t>(cells);
        size.connectivity += static_cast<std::int64_t>(grid.connectivity.size());
    }

    const std::string& m_path;
    const RunGrids& m_grids;
    Hdf5Handle m_file;
    std::map<std::string, Column> m_columns;
    std::vector<std::pair<std::string, std::int64_t>> m_names;
    std::int64_t m_steps = 0;
};

}  // namespace

void exportVtkHdf(const std::string& path, const RunReader& run, const FeResult& fe, const Execution& execution) {
    const RunGrids grids(run, fe);
    const std::vector<RunInstant> instants = grids.instants();
    const Message stage{"io.export.vtkhdf", "Writing {0}", {path}};
    writeFileAtomically(path, [&](const std::string& unfinished) {
        VtkHdfFile file(path, unfinished, grids);
        // It stands still after the last state.
        std::optional<std::pair<std::size_t, CellGrid>> structure;
        for (std::size_t i = 0; i < instants.size(); ++i) {
            execution.report(stage, static_cast<double>(i) / static_cast<double>(instants.size()));
            const RunInstant& instant = instants[i];
            const std::vector<FragmentPlaces::Place> places = grids.places(instant);
            const CellGrid fragments = grids.fragments(places);
            if (!structure || structure->first != instant.state) {
                structure = {instant.state, grids.structure(instant, places)};
            }
            const std::optional<CellGrid> released =
                grids.hasReleased(instant) ? std::optional(grids.released(instant)) : std::nullopt;
            file.addStep(instant.time, {&fragments, &structure->second, released ? &*released : nullptr});
        }
        file.close();
    });
    writeProvenance(path, provenanceText(run));
    execution.report(stage, 1.0);
}

}  // namespace rubble::io
