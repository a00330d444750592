#pragma once

#include <string>

#include "core/base/execution.h"
#include "core/fe/frame.h"
#include "core/fe/site_mesh.h"
#include "core/scenario/site.h"

namespace rubble::io {

/// Reads a mesh of the surroundings: OBJ, PLY, glTF (.gltf, .glb). Its coordinates are easting, northing and height in metres,
/// brought to the local frame as a terrain is; glTF has y up by its definition. Materials are left out. Damaged files are tried in
/// a child process first. Throws WorldError, ParseError (no mesh, too many triangles), UsageError, Cancelled.
SiteMesh readSiteMesh(const std::string& path, const Frame& frame, const Site& site, const Execution& execution);

}  // namespace rubble::io
