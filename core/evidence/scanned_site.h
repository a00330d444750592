#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/execution.h"
#include "core/evidence/maps/run_map.h"
#include "core/evidence/photographs/site_picture.h"

namespace rubble {

/// How many bodies of a run move at an instant.
struct MovingBodies {
    std::int64_t moving = 0;
    std::int64_t bodies = 0;  ///< that are there then
};

/// What a run says stands and lies on a site, as scanners meet it.
struct ScannedSite {
    SiteShape shape;  ///< without ground
    SiteSurface ground;
    std::vector<double> volumes;  ///< m3, [fragments]
    MovingBodies moving = {};     ///< at the instant of the shape
};

/// The site of a run at an instant; unset: at its end. @param liveThreshold  m, farther than this live structure has fallen
/// Throws as siteOfRun().
ScannedSite scannedSite(MappedRun run, std::optional<double> time, double liveThreshold, const Execution& execution);

}  // namespace rubble
