#pragma once

#include <optional>
#include <string>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/fe/raster_lattice.h"
#include "core/fe/terrain_grid.h"
#include "core/scenario/cloud_request.h"
#include "io/site/height_raster.h"
#include "io/site/site_place.h"

namespace rubble::io {

/// Nodes of a terrain at most: 64 MB of heights.
inline constexpr double terrainNodesMax = 8e6;

/// What the heights of a file are, and which of its bands count.
struct HeightMeaning {
    bool aboveGround = false;  ///< they count from the ground and are means of cells: neither brought to the case nor interpolated
    bool withFallen = false;   ///< of a map of our own also the heights of fallen live structure, where they are greater
    /// Nodes are wanted along x and y: a raster that is turned or projected is interpolated to such, once. Heights above the ground
    /// never are.
    bool alongAxes = false;
    /// Of a point cloud all that stands there counts but vegetation; else its ground alone, where it knows any.
    bool surface = false;
    CloudRequest read = {};  ///< of a point cloud
};

/// What a file holds around the window about the structure.
struct WiderHeights {
    HeightGrid raster;       ///< m, with gaps; its nodes are those of the window and more of them. Empty: nothing more was read
    std::size_t column = 0;  ///< of the window's first node in it
    std::size_t row = 0;
    GridSides unread{};  ///< rows and columns of the file beyond each side for which there was no room
};

/// How much of a file is read.
enum class HeightReach {
    Window,
    Whole,  ///< and what lies around it, as much as a terrain may have
};

/// Heights of a file in the local frame, with gaps.
struct HeightReading {
    HeightGrid raster;  ///< m; rows and columns along x and y, or those of the file where there is a lattice
    /// Where the columns and rows of the file lie, if they do not run along x and y. The raster then begins at 0 with steps of 1.
    std::optional<RasterLattice> lattice;
    std::string crs;  ///< name of the file's system
    std::string verticalDatum;
    /// A debris map of our own, or the median of an ensemble: its heights are above the ground whatever was said of them, and where
    /// it has none lies nothing.
    bool debrisMap = false;
    double missing = 0.0;  ///< m, by which the file ends short of the outline of the structure
    WiderHeights wider;    ///< with HeightReach::Whole
    Findings findings;
};

/// Reads the heights of a file, a raster or a point cloud that is laid on a grid (cloudRaster()), in a window. A raster whose rows
/// run along x and y, shifted or scaled as it may be, keeps its heights. Of one in another system than the case's, in degrees or
/// turned, they are kept with a lattice that places them, or interpolated to cells along x and y if asked for. One with more
/// heights than a terrain may have is made coarser by averaging. What cannot be a height of land, and what stands out from all
/// around it, is a gap, before anything is interpolated. Every such liberty is a finding with its size. A map of our own without
/// heights is refused. All is read in a child process first, for GDAL may crash on a damaged file. What lies around the window
/// changes nothing within it; where it cannot be read, that is a finding. Throws as openTerrain().
HeightReading readHeights(const std::string& path, const Frame& frame, const Site& site, const SiteWindow& window,
                          const Execution& execution, const HeightMeaning& meaning = {}, HeightReach reach = HeightReach::Window);

}  // namespace rubble::io
