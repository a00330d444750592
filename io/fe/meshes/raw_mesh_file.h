#pragma once

#include <string>

#include "io/fe/meshes/raw_mesh.h"

namespace rubble::io {

/// Whether a name ends as that of a mesh of triangles does: .stl, .obj, .ply.
bool isMeshPath(const std::string& path);

/// Reads such a mesh. Throws as readStlMesh(), readObjMesh() and readPlyMesh().
/// @param path  isMeshPath()
RawMesh readTriangleMesh(const std::string& path, const Execution& execution);

}  // namespace rubble::io
