#pragma once

#include <memory>
#include <string>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/fe/frame.h"
#include "core/fe/mesh.h"
#include "core/fe/terrain_grid.h"
#include "core/scenario/case.h"

namespace rubble::io {

/// A terrain as it was read, and where it came from.
struct TerrainInput {
    std::shared_ptr<const TerrainGrid> grid;  ///< null: none was given
    std::string path;
    std::string sha256;  ///< of the file, hex
    std::string crs;     ///< name of its coordinate reference system, empty if it states none
    Findings findings;
};

/// Reads a raster of heights (one band; GeoTIFF, ESRI ASCII grid and other single-file formats) into the local frame of a case:
/// easting, northing and height become x, y and z in metres, less the origin of the frame. Only a window around the structure is
/// read: ten times its height or its own length to each side, whichever is more. Cells that are not square are resampled, rows and
/// columns turned to run north and east, gaps filled from their rims; every such liberty is a counted finding.
/// @param around  m, local, of the structure at rest; empty: the whole raster is read
/// Throws WorldError (cannot be read), ParseError (no terrain, too few or too many heights, elsewhere than the structure, another
/// coordinate system than the frame's), Cancelled; each names file, place and remedy.
TerrainInput openTerrain(const std::string& path, const Frame& frame, const Aabb& around, const Execution& execution);

/// The terrain of a case: its first input of that role, around its FE result. Without grid if it has none. A second terrain and a
/// file with another SHA-256 than the case keeps are findings. Throws as openTerrain().
TerrainInput openTerrainOfCase(const Case& theCase, const std::string& casePath, const Mesh& fe, const Execution& execution);

/// Box around the nodes of a structure at rest, m.
Aabb boundsAtRest(const Mesh& mesh);

}  // namespace rubble::io
