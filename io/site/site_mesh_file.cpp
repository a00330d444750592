#include "io/site/site_mesh_file.h"

#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkCompositeDataIterator.h>
#include <vtkGLTFReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/fe/exodus/library_lock.h"
#include "io/fe/exodus/trial.h"
#include "io/site/site_place.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t trianglesMax = 5'000'000;
constexpr std::uintmax_t meshBytesMax = std::uintmax_t{2} << 30;

std::string endingOf(const std::string& path) {
    std::string ending = fs::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

[[noreturn]] void refuse(const std::string& path) {
    throw ParseError({"surroundings.unreadable", "{0} is no mesh that can be read", {path}},
                     {"surroundings.unreadable.remedy", "Give an OBJ, PLY or glTF file of triangles, exported anew.", {}});
}

void checkMesh(const std::string& path) {
    std::error_code error;
    if (!fs::is_regular_file(path, error) || !std::ifstream(path, std::ios::binary)) {
        throw WorldError({"surroundings.missing", "There is no mesh of surroundings {0} that may be read", {path}},
                         {"surroundings.missing.remedy", "Check the path, or leave the mesh out.", {}});
    }
    if (fs::file_size(path, error) > meshBytesMax) {
        throw ParseError({"surroundings.too_large", "{0} is too large for a mesh of surroundings", {path}},
                         {"surroundings.too_large.remedy", "Make it simpler, to 5,000,000 triangles or fewer.", {}});
    }
}

/// Adds the triangles of a polydata; glTF has y up.
void add(SiteMesh& mesh, vtkPolyData& part, bool yUp, const std::string& path) {
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(&part);
    triangles->PassLinesOff();
    triangles->PassVertsOff();
    triangles->Update();
    vtkPolyData& data = *triangles->GetOutput();
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    const vtkIdType points = data.GetNumberOfPoints();
    if (static_cast<std::size_t>(data.GetNumberOfPolys()) + mesh.triangles.size() > trianglesMax) {
        throw ParseError({"surroundings.too_many", "{0} has more than {1} triangles", {path, trianglesMax}},
                         {"surroundings.too_many.remedy", "Make the mesh simpler, or cut it to the site.", {}});
    }
    for (vtkIdType p = 0; p < points; ++p) {
        const double* at = data.GetPoint(p);
        mesh.points.push_back(yUp ? Vec3(at[0], -at[2], at[1]) : Vec3(at[0], at[1], at[2]));
    }
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    vtkCellArray& polys = *data.GetPolys();
    for (polys.InitTraversal(); polys.GetNextCell(count, ids) != 0;) {
        if (count == 3 && std::all_of(ids, ids + 3, [&](vtkIdType id) { return id >= 0 && id < points; })) {
            mesh.triangles.push_back({first + static_cast<std::uint32_t>(ids[0]), first + static_cast<std::uint32_t>(ids[1]),
                                      first + static_cast<std::uint32_t>(ids[2])});
        }
    }
}

template <class Reader>
SiteMesh readFlat(const std::string& path) {
    vtkNew<Reader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    SiteMesh mesh;
    if (reader->GetOutput() != nullptr) {
        add(mesh, *reader->GetOutput(), false, path);
    }
    return mesh;
}

SiteMesh readGltf(const std::string& path) {
    vtkNew<vtkGLTFReader> reader;
    reader->SetFileName(path.c_str());
    reader->ApplyDeformationsToGeometryOn();
    reader->Update();
    SiteMesh mesh;
    auto* scene = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
    if (scene == nullptr) {
        return mesh;
    }
    const auto parts = vtkSmartPointer<vtkCompositeDataIterator>::Take(scene->NewIterator());
    for (parts->InitTraversal(); !parts->IsDoneWithTraversal(); parts->GoToNextItem()) {
        if (auto* part = vtkPolyData::SafeDownCast(parts->GetCurrentDataObject()); part != nullptr) {
            add(mesh, *part, true, path);
        }
    }
    return mesh;
}

SiteMesh readAny(const std::string& path) {
    const std::string ending = endingOf(path);
    SiteMesh mesh = ending == ".obj"   ? readFlat<vtkOBJReader>(path)
                    : ending == ".ply" ? readFlat<vtkPLYReader>(path)
                    : ending == ".gltf" || ending == ".glb"
                        ? readGltf(path)
                        : throw ParseError({"surroundings.ending", "{0} does not end in .obj, .ply, .gltf or .glb", {path}},
                                           {"surroundings.ending.remedy", "Give a mesh in one of these formats.", {}});
    if (mesh.triangles.empty() ||
        !std::all_of(mesh.points.begin(), mesh.points.end(), [](const Vec3& p) { return p.allFinite(); })) {
        refuse(path);
    }
    return mesh;
}

}  // namespace

SiteMesh readSiteMesh(const std::string& path, const Frame& frame, const Site& site, const Execution& execution) {
    checkMesh(path);
    execution.check();
    const SitePlace place(frame, site);
    const LibraryLock lock;
    if (!survivesTrial([&] { readAny(path); })) {
        refuse(path);
    }
    SiteMesh mesh = readAny(path);
    mesh.name = fs::path(path).filename().string();
    for (Vec3& point : mesh.points) {
        point = place.toLocal(point) + Vec3(0.0, 0.0, site.heightShift);
    }
    return mesh;
}

}  // namespace rubble::io
