#include "io/exports/convert/grid_writer.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <regex>
#include <vector>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/base/single_precision.h"
#include "io/exports/pvd_index.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

constexpr unsigned char hiddenCell = 32;

std::string stateName(std::size_t k) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "state_%05zu.vtu", k);
    return name.data();
}

// Single precision where that loses nothing.
vtkSmartPointer<vtkDataArray> vectorArray(const char* name, const std::vector<Vec3>& values, const Vec3& offset) {
    std::vector<Vec3> moved = values;
    for (Vec3& value : moved) {
        value += offset;
    }
    vtkSmartPointer<vtkDataArray> array;
    if (fitsSinglePrecision(moved)) {
        array = vtkSmartPointer<vtkFloatArray>::New();
    } else {
        array = vtkSmartPointer<vtkDoubleArray>::New();
    }
    array->SetName(name);
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(moved.size()));
    for (std::size_t n = 0; n < moved.size(); ++n) {
        array->SetTuple(static_cast<vtkIdType>(n), moved[n].data());
    }
    return array;
}

/// Makes the files of a result, one state after the other.
class GridWriter {
public:
    GridWriter(const FeResult& fe, const Vec3& offset) : m_fe(fe), m_mesh(fe.mesh()), m_offset(offset) {
        makeCells();
        addNumbers();
        addMaterial();
    }

    std::string text(std::size_t k) {
        const FeState state = m_fe.contents().source->read(k);
        vtkNew<vtkPoints> points;
        points->SetData(vectorArray("Points", state.positions, m_offset));
        m_grid->SetPoints(points);
        for (std::size_t e = 0; e < m_mesh.elementCount(); ++e) {
            const bool active = m_fe.activity().active(k, idAt<ElementIndex>(e));
            m_status->SetValue(static_cast<vtkIdType>(e), active ? 1 : 0);
            m_ghosts->SetValue(static_cast<vtkIdType>(e), active ? 0 : hiddenCell);
        }
        m_status->Modified();
        m_ghosts->Modified();
        if (!state.velocities.empty()) {
            m_grid->GetPointData()->AddArray(vectorArray("velocity", state.velocities, Vec3::Zero()));
        }
        m_time->SetValue(0, state.time);
        m_time->Modified();
        m_grid->Modified();
        return written();
    }

private:
    void makeCells() {
        static constexpr std::array<int, 7> types{VTK_HEXAHEDRON, VTK_WEDGE,    VTK_PYRAMID, VTK_TETRA,
                                                  VTK_QUAD,       VTK_TRIANGLE, VTK_LINE};
        vtkNew<vtkCellArray> cells;
        vtkNew<vtkUnsignedCharArray> kinds;
        std::vector<vtkIdType> corners;
        for (std::size_t e = 0; e < m_mesh.elementCount(); ++e) {
            const auto nodes = m_mesh.cornersOf(idAt<ElementIndex>(e));
            corners.assign(nodes.begin(), nodes.end());
            cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
            kinds->InsertNextValue(static_cast<unsigned char>(types[static_cast<std::size_t>(m_mesh.shapes[e])]));
        }
        m_grid->SetCells(kinds, cells);
    }

    void addNumbers() {
        const auto cellsOf = static_cast<vtkIdType>(m_mesh.elementCount());
        m_status->SetName("STATUS");
        m_status->SetNumberOfTuples(cellsOf);
        m_ghosts->SetName("vtkGhostType");
        m_ghosts->SetNumberOfTuples(cellsOf);
        vtkNew<vtkTypeInt64Array> elements, nodes, parts;
        vtkNew<vtkTypeInt32Array> components;
        elements->SetName("ELEMENT_ID");
        nodes->SetName("NODE_ID");
        parts->SetName("PART_ID");
        components->SetName("component");
        for (std::size_t e = 0; e < m_mesh.elementCount(); ++e) {
            elements->InsertNextValue(m_mesh.elementIds[e]);
            parts->InsertNextValue(m_mesh.parts[m_mesh.part[e]].fileId);
            components->InsertNextValue(static_cast<vtkTypeInt32>(m_mesh.part[e]));
        }
        for (const std::int64_t number : m_mesh.nodeIds) {
            nodes->InsertNextValue(number);
        }
        vtkNew<vtkStringArray> names;
        names->SetName("component_names");
        for (const Part& part : m_mesh.parts) {
            names->InsertNextValue(part.name);
        }
        m_time->SetName("TimeValue");
        m_time->SetNumberOfTuples(1);
        for (vtkDataArray* const array :
             {static_cast<vtkDataArray*>(m_status), static_cast<vtkDataArray*>(m_ghosts), static_cast<vtkDataArray*>(elements),
              static_cast<vtkDataArray*>(parts), static_cast<vtkDataArray*>(components)}) {
            m_grid->GetCellData()->AddArray(array);
        }
        m_grid->GetPointData()->AddArray(nodes);
        m_grid->GetPointData()->AddArray(vectorArray("initial_position", m_mesh.nodes, m_offset));
        m_grid->GetFieldData()->AddArray(names);
        m_grid->GetFieldData()->AddArray(m_time);
    }

    void addMaterial() {
        std::vector<double> thickness = m_mesh.section, area = m_mesh.section;
        constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
        for (std::size_t e = 0; e < m_mesh.elementCount(); ++e) {
            if (!isShell(m_mesh.shapes[e])) {
                thickness[e] = nothing;
            }
            if (m_mesh.shapes[e] != ElementShape::Beam) {
                area[e] = nothing;
            }
        }
        addScalars("density", m_mesh.density);
        addScalars("thickness", thickness);
        addScalars("area", area);
        addScalars("death_time", m_fe.contents().deathTime);
    }

    void addScalars(const char* name, const std::vector<double>& values) {
        if (std::none_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); })) {
            return;
        }
        vtkNew<vtkDoubleArray> array;
        array->SetName(name);
        for (const double value : values) {
            array->InsertNextValue(value);
        }
        m_grid->GetCellData()->AddArray(array);
    }

    std::string written() {
        vtkNew<vtkZLibDataCompressor> compressor;
        compressor->SetCompressionLevel(1);
        vtkNew<vtkXMLUnstructuredGridWriter> writer;
        writer->SetInputData(m_grid);
        writer->SetCompressor(compressor);
        // As of a series of a run: appended data is not read everywhere.
        writer->SetDataModeToBinary();
        writer->WriteToOutputStringOn();
        writer->Write();
        return writer->GetOutputString();
    }

    const FeResult& m_fe;
    const Mesh& m_mesh;
    const Vec3 m_offset;
    vtkNew<vtkUnstructuredGrid> m_grid;
    vtkNew<vtkUnsignedCharArray> m_status;
    vtkNew<vtkUnsignedCharArray> m_ghosts;
    vtkNew<vtkDoubleArray> m_time;
};

void writeIndex(const std::string& path, const std::vector<double>& times) {
    const std::string prefix = fs::path(gridFolder(path)).filename().string() + "/";
    std::vector<PvdEntry> entries;
    for (std::size_t k = 0; k < times.size(); ++k) {
        entries.push_back({times[k], 0, "", prefix + stateName(k)});
    }
    writePvdIndex(path, entries);
}

/// A folder that goes with all it holds unless it was moved to its place.
class UnfinishedFolder {
public:
    /// @param folder  what it is to become
    explicit UnfinishedFolder(const std::string& folder) : m_path(unfinishedName(folder)) {
        std::error_code error;
        fs::create_directory(m_path, error);
        if (error) {
            fail(folder, error);
        }
    }
    ~UnfinishedFolder() {
        std::error_code ignored;
        fs::remove_all(m_path, ignored);
    }
    UnfinishedFolder(const UnfinishedFolder&) = delete;
    UnfinishedFolder& operator=(const UnfinishedFolder&) = delete;

    const std::string& path() const { return m_path; }

    [[noreturn]] static void fail(const std::string& path, const std::error_code& error) {
        throw WorldError({"convert.folder", "Cannot make the folder {0}: {1}", {path, error.message()}},
                         {"convert.folder.remedy", "Check rights and free space, or choose another place.", {}});
    }

private:
    std::string m_path;
};

// What lies in the folder must be a series of ours: anything else is somebody's.
void requireOwnFolder(const std::string& folder) {
    static const std::regex own("state_[0-9]+\\.vtu");
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        if (!std::regex_match(entry->path().filename().string(), own)) {
            throw WorldError({"convert.foreign_folder",
                              "The folder {0} would be replaced, but holds {1}",
                              {folder, entry->path().filename().string()}},
                             {"convert.foreign_folder.remedy", "Choose another name, or move the folder away.", {}});
        }
    }
    if (error && fs::exists(folder)) {
        UnfinishedFolder::fail(folder, error);
    }
}

// The index that leads to the old folder goes first: no moment shows half of each.
void moveIntoPlace(const UnfinishedFolder& made, const std::string& path) {
    const std::string folder = gridFolder(path);
    std::error_code error;
    fs::remove(path, error);
    if (!error) {
        fs::remove_all(folder, error);
    }
    if (!error) {
        fs::rename(made.path(), folder, error);
    }
    if (error) {
        UnfinishedFolder::fail(folder, error);
    }
}

}  // namespace

std::string gridFolder(const std::string& path) {
    return fs::path(path).replace_extension().string();
}

void writeGridSeries(const std::string& path, const FeResult& fe, const Vec3& offset, bool replace, const Execution& execution) {
    const std::string folder = gridFolder(path);
    if (replace) {
        requireOwnFolder(folder);
    }
    const UnfinishedFolder made(folder);
    GridWriter writer(fe, offset);
    const Message stage{"convert.state", "Writing the states", {}};
    const std::size_t states = fe.stateCount();
    for (std::size_t k = 0; k < states; ++k) {
        execution.report(stage, static_cast<double>(k) / static_cast<double>(states));
        const std::string text = writer.text(k);
        writeAtomically((fs::path(made.path()) / stateName(k)).string(),
                        [&](std::ostream& out) { out.write(text.data(), static_cast<std::streamsize>(text.size())); });
    }
    moveIntoPlace(made, path);
    writeIndex(path, fe.times());
    execution.report(stage, 1.0);
}

}  // namespace rubble::io
