#pragma once

#include <string>

#include "io/fe/meshes/raw_mesh.h"

namespace rubble::io {

/// Reads the faces of a Wavefront OBJ line by line, in double precision. Normals, texture coordinates, materials, groups and the
/// weights or colours of points are passed over.
/// Throws WorldError, ParseError (a line that cannot be read, named; no face; too many), Cancelled.
RawMesh readObjMesh(const std::string& path, const Execution& execution);

}  // namespace rubble::io
