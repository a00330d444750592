#pragma once

#include <string>

#include "io/fe/meshes/raw_mesh.h"

namespace rubble::io {

/// Reads the triangles of an STL, binary or text; its normals are passed over. It states no unit: one is taken as a metre, which is
/// a finding. Throws WorldError, ParseError (cut short; a line that cannot be read, named; no face; too many), Cancelled.
RawMesh readStlMesh(const std::string& path, const Execution& execution);

}  // namespace rubble::io
