#include "io/vtk/grid_file.h"

#include <sys/resource.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArraySelection.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <filesystem>
#include <fstream>
#include <new>

#include "core/base/error.h"
#include "io/exodus/exodus_names.h"
#include "io/exodus/trial.h"
#include "io/vtk/quiet_vtk.h"

namespace rubble::io {

namespace {

constexpr std::uint64_t leastTrialMemory = std::uint64_t{2} << 30;
// Deflate rarely does better on results: memory beyond this per byte of the file is asked for by damage.
constexpr std::uint64_t memoryPerByte = 64;

[[noreturn]] void failRead(const std::string& path, const std::string& why) {
    throw ParseError({"vtk.read", "{0} cannot be read as a VTK grid: {1}", {path, why}},
                     {"vtk.read.remedy", "The file is damaged or not yet whole: copy it again or write it again.", {}});
}

std::string headOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string head(512, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    if (head.empty()) {
        throw WorldError({"io.file.unreadable", "Cannot read {0}", {path}},
                         {"io.file.unreadable.remedy", "Check that the file exists and that you may read it.", {}});
    }
    return head;
}

vtkSmartPointer<vtkUnstructuredGrid> readLegacy(const std::string& path) {
    vtkNew<vtkUnstructuredGridReader> reader;
    reader->SetFileName(path.c_str());
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllFieldsOn();
    if (!reader->IsFileUnstructuredGrid()) {
        failRead(path, "it is no unstructured grid");
    }
    reader->Update();
    return reader->GetOutput();
}

void choose(vtkDataArraySelection* arrays, const GridSelection& selection, bool points) {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i) {
        const std::string name = arrays->GetArrayName(i);
        if (points ? selection.wantsPoint(name) : selection.wantsCell(name)) {
            arrays->EnableArray(name.c_str());
        } else {
            arrays->DisableArray(name.c_str());
        }
    }
}

vtkSmartPointer<vtkUnstructuredGrid> readXml(const std::string& path, const GridSelection& selection) {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(path.c_str());
    reader->UpdateInformation();
    choose(reader->GetPointDataArraySelection(), selection, true);
    choose(reader->GetCellDataArraySelection(), selection, false);
    reader->Update();
    return reader->GetOutput();
}

std::vector<GridArray> arraysOf(vtkFieldData* data, const GridSelection& selection, bool points) {
    std::vector<GridArray> arrays;
    for (int a = 0; a < data->GetNumberOfArrays(); ++a) {
        vtkDataArray* const array = data->GetArray(a);
        if (!array || !array->GetName()) {
            continue;
        }
        GridArray& result = arrays.emplace_back();
        result.name = array->GetName();
        result.components = static_cast<std::size_t>(array->GetNumberOfComponents());
        if (!(points ? selection.wantsPoint(result.name) : selection.wantsCell(result.name))) {
            continue;
        }
        result.values.reserve(static_cast<std::size_t>(array->GetNumberOfValues()));
        for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
            for (int c = 0; c < array->GetNumberOfComponents(); ++c) {
                result.values.push_back(array->GetComponent(i, c));
            }
        }
    }
    return arrays;
}

void takeCells(vtkUnstructuredGrid& grid, Grid& result) {
    vtkUnsignedCharArray* const types = grid.GetCellTypesArray();
    vtkCellArray* const cells = grid.GetCells();
    if (!types || !cells) {
        return;
    }
    result.offsets.push_back(0);
    for (vtkIdType c = 0; c < grid.GetNumberOfCells(); ++c) {
        result.types.push_back(types->GetValue(c));
        vtkIdType count = 0;
        const vtkIdType* points = nullptr;
        cells->GetCellAtId(c, count, points);
        result.connectivity.insert(result.connectivity.end(), points, points + count);
        result.offsets.push_back(static_cast<std::int64_t>(result.connectivity.size()));
    }
}

void takeComponentNames(vtkUnstructuredGrid& grid, Grid& result) {
    auto* const names = vtkStringArray::SafeDownCast(grid.GetFieldData()->GetAbstractArray("component_names"));
    for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i) {
        result.componentNames.push_back(shownName(names->GetValue(i)));
    }
}

void takeTime(vtkUnstructuredGrid& grid, Grid& result) {
    for (const char* name : {"TimeValue", "TIME", "Time", "time"}) {
        vtkDataArray* const array = grid.GetFieldData()->GetArray(name);
        if (array && array->GetNumberOfTuples() > 0) {
            result.time = array->GetComponent(0, 0);
            return;
        }
    }
}

// In the child alone: more memory than this is asked for by damage, and must not reach the machine.
void boundMemory(const std::vector<std::string>& paths) {
    std::uint64_t largest = 0;
    for (const std::string& path : paths) {
        std::error_code ignored;
        const auto size = std::filesystem::file_size(path, ignored);
        largest = ignored ? largest : std::max<std::uint64_t>(largest, size);
    }
    std::ifstream pages("/proc/self/statm");
    std::uint64_t used = 0;
    pages >> used;
    const rlim_t most = used * 4096 + std::max(leastTrialMemory, largest * memoryPerByte);
    const rlimit limit{most, most};
    ::setrlimit(RLIMIT_AS, &limit);
}

}  // namespace

Grid readGridFile(const std::string& path, const GridSelection& selection) {
    const bool legacy = headOf(path).starts_with("# vtk DataFile");
    const QuietVtk quiet;
    const vtkSmartPointer<vtkUnstructuredGrid> grid = legacy ? readLegacy(path) : readXml(path, selection);
    // The legacy reader only warns where a file ends before its time.
    const std::string error = quiet.error().empty() && legacy ? quiet.warning() : quiet.error();
    if (!error.empty() || !grid) {
        failRead(path, error);
    }
    Grid result;
    const vtkIdType points = grid->GetPoints() ? grid->GetNumberOfPoints() : 0;
    for (vtkIdType p = 0; p < points; ++p) {
        double place[3];
        grid->GetPoint(p, place);
        result.points.emplace_back(place[0], place[1], place[2]);
    }
    if (selection.cells || selection.everything) {
        takeCells(*grid, result);
    }
    result.pointData = arraysOf(grid->GetPointData(), selection, true);
    result.cellData = arraysOf(grid->GetCellData(), selection, false);
    takeTime(*grid, result);
    takeComponentNames(*grid, result);
    return result;
}

void tryGridFiles(const std::vector<std::string>& paths) {
    const std::scoped_lock lock(nativeLibraries());
    const auto readAll = [&paths] {
        boundMemory(paths);
        GridSelection everything;
        everything.everything = true;
        for (const std::string& path : paths) {
            readGridFile(path, everything);
        }
    };
    if (!survivesTrial(readAll)) {
        failRead(paths.size() == 1 ? paths.front() : paths.front() + " or one of its series", "VTK's reader fails on it");
    }
}

}  // namespace rubble::io
