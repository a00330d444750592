#pragma once

#include <optional>
#include <vector>

#include "core/base/execution.h"
#include "core/evidence/maps/run_map.h"
#include "core/evidence/photographs/site_picture.h"

namespace rubble {

/// What a run says stands and lies on a site, as scanners meet it.
struct ScannedSite {
    SiteShape shape;  ///< without ground
    SiteSurface ground;
    std::vector<double> volumes;  ///< m3, [fragments]
};

/// The site of a run at an instant; unset: at its end. @param liveThreshold  m, farther than this live structure has fallen
/// Throws as siteOfRun().
ScannedSite scannedSite(MappedRun run, std::optional<double> time, double liveThreshold, const Execution& execution);

}  // namespace rubble
