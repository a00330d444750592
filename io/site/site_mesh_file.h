#pragma once

#include <optional>
#include <string>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/fe/frame.h"
#include "core/fe/site_mesh.h"
#include "core/scenario/cloud_request.h"
#include "core/scenario/site.h"
#include "io/site/site_place.h"

namespace rubble::io {

/// How a mesh of the surroundings is to be taken.
struct SiteMeshRequest {
    /// m, added to its coordinates: easting, northing and height; unset: what a file beside it says, where the mesh needs it.
    std::optional<Vec3> offset;
    /// Where it has to lie, at least in part; a point cloud is read about the structure alone. Whole: anywhere.
    SiteWindow around;
    CloudRequest read = {};  ///< of a point cloud
};

/// A mesh of the surroundings as it was read.
struct SiteMeshReading {
    SiteMesh mesh;
    Vec3 offset = Vec3::Zero();  ///< m, that was added
    Findings findings;
};

/// Reads a mesh of the surroundings: OBJ, PLY, STL, glTF (.gltf, .glb), in double precision. Its coordinates are easting, northing
/// and height in metres, after its offset is added, brought to the local frame as a terrain is; glTF has y up by its definition.
/// Materials are left out. What is left out of its shape, an offset from a file and coarse coordinates are findings.
/// A point cloud is taken as the surface of its grid (readHeights()), where its coordinates say, without an offset; also a finding.
/// Throws WorldError, ParseError (no mesh, too many triangles, nothing of it in the window), UsageError, Cancelled; of a cloud
/// as readHeights().
SiteMeshReading readSiteMesh(const std::string& path, const Frame& frame, const Site& site, const Execution& execution,
                             const SiteMeshRequest& request = {});

}  // namespace rubble::io
