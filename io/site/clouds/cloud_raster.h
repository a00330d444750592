#pragma once

#include <memory>
#include <string>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/fe/frame.h"
#include "core/scenario/cloud_request.h"
#include "core/scenario/site.h"
#include "io/site/gdal_memory.h"
#include "io/site/site_place.h"

namespace rubble::io {

/// Which points of a cloud make a surface.
enum class CloudPart {
    Ground,   ///< of class 2; all but vegetation and wires where the cloud has none of it
    Surface,  ///< all but vegetation and wires
};

/// Cells of the grid at most: 224 MB while it is made.
inline constexpr double cloudCellsMost = 8e6;

/// A point cloud laid on a grid of heights, in the coordinate system of the cloud, for readers of rasters.
struct CloudRaster {
    std::unique_ptr<GdalMemoryFile> file;  ///< a GeoTIFF; cells without points have no height
    Findings findings;                     ///< of the cloud, and how it was laid
};

/// Lays a cloud on cells so wide that six points fall into each in the mean, in the window and around it as far as there is room.
/// The height of a cell is that of a plane through its points and those of its neighbours, at its middle. Spacing and what was left
/// out are findings. Throws ParseError (no points that count, vegetation alone, places from the centre of the Earth), WorldError,
/// Cancelled.
CloudRaster cloudRaster(const std::string& path, CloudPart part, const CloudRequest& read, const Frame& frame, const Site& site,
                        const SiteWindow& window, const Execution& execution);

}  // namespace rubble::io
