#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
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
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/exports/exports.h"
#include "io/exports/pvd_index.h"
#include "io/run/run_grids.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

template <class Array, class Value>
void addArray(vtkUnstructuredGrid& grid, const char* name, const std::vector<Value>& values) {
    // A part without fragments has no numbers of fragments.
    if (values.size() != static_cast<std::size_t>(grid.GetNumberOfCells())) {
        return;
    }
    vtkNew<Array> array;
    array->SetName(name);
    array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), array->Begin());
    grid.GetCellData()->AddArray(array);
}

/// A grid as the text of a VTU file.
std::string gridText(const CellGrid& cells, const RunGrids& grids) {
    vtkNew<vtkPoints> points;
    points->SetDataType(grids.needsDoublePrecision() ? VTK_DOUBLE : VTK_FLOAT);
    points->SetNumberOfPoints(static_cast<vtkIdType>(cells.points.size()));
    for (std::size_t p = 0; p < cells.points.size(); ++p) {
        points->SetPoint(static_cast<vtkIdType>(p), cells.points[p].data());
    }
    vtkNew<vtkCellArray> corners;
    corners->Use32BitStorage();
    vtkNew<vtkUnsignedCharArray> types;
    std::vector<vtkIdType> cell;
    for (std::size_t c = 0; c < cells.cells(); ++c) {
        cell.assign(cells.connectivity.begin() + cells.offsets[c], cells.connectivity.begin() + cells.offsets[c + 1]);
        corners->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
        types->InsertNextValue(cells.types[c]);
    }
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(points);
    grid->SetCells(types, corners);
    addArray<vtkTypeInt32Array>(*grid, "fragment_id", cells.fragments);
    addArray<vtkTypeInt64Array>(*grid, "element_id", cells.elements);
    addArray<vtkTypeInt32Array>(*grid, "component", cells.components);
    addArray<vtkTypeInt32Array>(*grid, "cluster_id", cells.clusters);
    addArray<vtkFloatArray>(*grid, "speed", cells.speeds);
    vtkNew<vtkStringArray> names;
    names->SetName("component_names");
    for (const std::string& name : grids.componentNames()) {
        names->InsertNextValue(name);
    }
    grid->GetFieldData()->AddArray(names);
    vtkNew<vtkZLibDataCompressor> compressor;
    compressor->SetCompressionLevel(1);
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(grid);
    writer->SetCompressor(compressor);
    // Data that is appended to the XML cannot be read by VTK 9.1 and ParaView 5.11 with the expat of their distributions since
    // 2024.
    writer->SetDataModeToBinary();
    writer->SetIdTypeToInt32();
    writer->WriteToOutputStringOn();
    writer->Write();
    return writer->GetOutputString();
}

std::string numberedName(const char* stem, std::size_t number) {
    std::array<char, 48> name{};
    std::snprintf(name.data(), name.size(), "%s_%05zu.vtu", stem, number);
    return name.data();
}

// Files of an earlier, longer series in the same folder would only mislead.
void removeStale(const fs::path& folder, const std::vector<PvdEntry>& entries) {
    std::set<std::string> current;
    for (const PvdEntry& entry : entries) {
        current.insert(fs::path(entry.file).filename().string());
    }
    std::error_code ignored;
    std::vector<fs::path> stale;
    for (const auto& file : fs::directory_iterator(folder, ignored)) {
        const std::string name = file.path().filename().string();
        const bool ours = file.path().extension() == ".vtu" &&
                          std::any_of(std::begin(RunGrids::partNames), std::end(RunGrids::partNames),
                                      [&](const char* part) { return name.starts_with(std::string(part) + '_'); });
        if (ours && !current.contains(name)) {
            stale.push_back(file.path());
        }
    }
    for (const fs::path& file : stale) {
        fs::remove(file, ignored);
    }
}

void writeText(const fs::path& path, const std::string& text) {
    writeAtomically(path.string(), [&text](std::ostream& out) { out << text; });
}

void writeInstants(const RunGrids& grids, const fs::path& folder, const std::string& path, std::vector<PvdEntry>& entries,
                   const Execution& execution) {
    const std::vector<RunInstant> instants = grids.instants();
    std::optional<std::pair<std::size_t, std::string>> lastStructure;
    for (std::size_t i = 0; i < instants.size(); ++i) {
        execution.report(Message{"io.export.series", "Writing {0}", {path}},
                         static_cast<double>(i) / static_cast<double>(instants.size()));
        const RunInstant& instant = instants[i];
        const auto add = [&](int part, const std::string& file) {
            entries.push_back({instant.time, part, RunGrids::partNames[part], folder.filename().string() + "/" + file});
        };
        const std::vector<FragmentPlaces::Place> places = grids.places(instant);
        const std::string fragments = numberedName("fragments", i);
        writeText(folder / fragments, gridText(grids.fragments(places), grids));
        // The structure stands still after the last state: one file serves all these instants.
        if (!lastStructure || lastStructure->first != instant.state) {
            lastStructure = {instant.state, numberedName("structure", instant.state)};
            writeText(folder / lastStructure->second, gridText(grids.structure(instant, places), grids));
        }
        add(0, fragments);
        add(1, lastStructure->second);
        if (grids.hasReleased(instant)) {
            const std::string released = numberedName("released", i);
            writeText(folder / released, gridText(grids.released(instant), grids));
            add(2, released);
        }
    }
}

}  // namespace

void exportSeries(const std::string& path, const RunReader& run, const FeResult& fe, const Execution& execution) {
    const RunGrids grids(run, fe);
    fs::path folder = fs::path(path).replace_extension();
    if (folder == fs::path(path)) {
        folder += "_files";
    }
    makeFolder(folder.string());
    std::vector<PvdEntry> entries;
    try {
        writeInstants(grids, folder, path, entries, execution);
    } catch (const Cancelled&) {
        // What was written so far is a series as well.
        writePvdIndex(path, entries);
        throw;
    }
    writePvdIndex(path, entries);
    removeStale(folder, entries);
    writeProvenance(path, provenanceText(run));
    execution.report(Message{"io.export.series", "Writing {0}", {path}}, 1.0);
}

}  // namespace rubble::io
