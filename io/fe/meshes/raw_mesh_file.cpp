#include "io/fe/meshes/raw_mesh_file.h"

#include "io/base/files.h"
#include "io/fe/meshes/obj_mesh.h"
#include "io/fe/meshes/ply_mesh.h"
#include "io/fe/meshes/stl_mesh.h"

namespace rubble::io {

bool isMeshPath(const std::string& path) {
    return hasEnding(path, ".stl") || hasEnding(path, ".obj") || hasEnding(path, ".ply");
}

RawMesh readTriangleMesh(const std::string& path, const Execution& execution) {
    if (hasEnding(path, ".obj")) {
        return readObjMesh(path, execution);
    }
    return hasEnding(path, ".ply") ? readPlyMesh(path, execution) : readStlMesh(path, execution);
}

}  // namespace rubble::io
