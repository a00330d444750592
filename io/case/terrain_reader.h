#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/fe/frame.h"
#include "core/fe/mesh.h"
#include "core/fe/orthophoto.h"
#include "core/fe/site_mesh.h"
#include "core/fe/terrain_grid.h"
#include "core/scenario/case.h"

namespace rubble::io {

/// A file of the surroundings of a case as it was read.
struct SiteFile {
    std::string input;  ///< id in the case
    std::string path;
    std::string sha256;
    Vec3 offset = Vec3::Zero();  ///< m, added to the coordinates of a mesh
    std::string fileSha256{};    ///< of the file alone, without what lies beside it
    CloudRequest read = {};      ///< of a cloud
};

/// A terrain as it was read, where it came from, and what stands on it.
struct TerrainInput {
    std::shared_ptr<const TerrainGrid> grid;  ///< null: none was given
    std::string path;
    CloudRequest read;           ///< of a cloud
    std::string sha256;          ///< of the file and what lies beside it (digestOfInput()), hex
    std::string fileSha256;      ///< of the file alone
    std::string crs;             ///< name of its coordinate reference system, empty if it states none
    std::string verticalDatum;   ///< that its heights count from, empty if it states none
    std::optional<SiteFit> fit;  ///< of the control points of the case; unset: the origin of the frame places everything
    std::shared_ptr<const Orthophoto> orthophoto;               ///< null: none
    std::shared_ptr<const std::vector<SiteMesh>> surroundings;  ///< null: none
    bool collided = false;                                      ///< the grid is raised by the surroundings
    std::string orthophotoInput;                                ///< its id in the case
    std::vector<SiteFile> files;                                ///< of orthophoto and surroundings
    Findings findings;
};

/// Reads a raster of heights (one band; GeoTIFF, ESRI ASCII grid and other single-file formats), or a mesh (STL, OBJ, PLY) as a
/// height function, into the local frame of a case:
/// easting, northing and height become x, y and z in metres, less the origin of the frame, or by its control points. A window about
/// the structure is read first, ten times its height or its own length to each side, whichever is more. It decides the cells:
/// another projection, degrees and turned rasters are resampled, too many heights averaged, spikes and gaps filled from their rims;
/// every such liberty is a counted finding. Around it all of the raster is read on the same nodes, as much as a terrain may have;
/// that changes no height within the window.
/// @param around  m, local, of the structure at rest; empty: the whole raster is read
/// @param read    of a point cloud
/// Throws WorldError (cannot be read), ParseError (no terrain, too few heights, elsewhere than the structure, degrees in a case
/// without a coordinate system), UsageError (control points in one place), Cancelled; each names file, place and remedy.
TerrainInput openTerrain(const std::string& path, const Frame& frame, const Aabb& around, const Execution& execution,
                         const Site& site = Site(), const CloudRequest& read = {});

/// The terrain of a case: its first input of that role, around its FE result. Without grid if it has none. A second terrain and a
/// file with another SHA-256 than the case keeps are findings. Throws as openTerrain().
TerrainInput openTerrainOfCase(const Case& theCase, const std::string& casePath, const Mesh& fe, const Execution& execution);

/// Box around the nodes of a structure at rest, m.
Aabb boundsAtRest(const Mesh& mesh);

}  // namespace rubble::io
