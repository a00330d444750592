#pragma once

#include <string>

#include "io/fe/meshes/raw_mesh.h"

namespace rubble::io {

/// Reads the triangles of a glTF 2.0 (.gltf with its buffers, .glb) at rest, placed by its nodes in double precision and turned
/// from y up to z up. Textures are not opened. Sparse and quantised positions are read. A file that requires an extension which is
/// not known is refused by its name; one that is used but not required, skins and morph targets are findings.
/// Throws WorldError, ParseError (the file and its place named), Cancelled.
RawMesh readGltfMesh(const std::string& path, const Execution& execution);

}  // namespace rubble::io
