#pragma once

#include <string>

#include "io/fe/meshes/raw_mesh.h"

namespace rubble::io {

/// Reads the faces and triangle strips of a PLY: text or bytes of either order, numbers of any kind, other elements and properties
/// passed over. Text is read in double precision whatever kind its header names.
/// Throws WorldError, ParseError (no PLY, fewer numbers than it promises, no face; too many), Cancelled.
RawMesh readPlyMesh(const std::string& path, const Execution& execution);

}  // namespace rubble::io
