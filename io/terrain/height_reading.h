#pragma once

#include <optional>
#include <string>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "io/terrain/height_raster.h"
#include "io/terrain/site_place.h"

namespace rubble::io {

/// Nodes of a terrain at most: 64 MB of heights.
inline constexpr double terrainNodesMax = 8e6;
/// Heights of the structure around it that fragments may reach.
inline constexpr double windowHeights = 10.0;

/// Heights of a file in the local frame, with gaps.
struct HeightReading {
    HeightRaster raster;  ///< m; rows and columns along x and y
    std::string crs;      ///< name of the file's system
    std::string verticalDatum;
    /// A debris map of our own: its heights are above the ground and were not brought to those of the case, and fallen live
    /// structure lies in another band.
    bool debrisMap = false;
    double missing = 0.0;  ///< m, by which the file ends short of the outline of the structure
    Findings findings;
};

/// Reads the heights of a file around a structure: a window ten times its height or its own length to each side, whichever is
/// more. A raster in another system than the case's, in degrees, turned, or in a case with control points is brought to cells
/// along x and y by bilinear interpolation; one with more heights than a terrain may have is made coarser by averaging. What cannot
/// be a height of land is a gap. Every such liberty is a finding.
/// A map of our own without heights is refused.
/// @param around  m, local, of the structure at rest; empty: the whole raster is read
/// Throws as openTerrain().
HeightReading readHeights(const std::string& path, const Frame& frame, const Site& site, const Aabb& around,
                          const Execution& execution);

}  // namespace rubble::io
