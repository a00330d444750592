#include "core/evidence/scanned_site.h"

#include "core/analysis/debris/debris.h"
#include "core/fe/components.h"

namespace rubble {

ScannedSite scannedSite(MappedRun run, std::optional<double> time, double liveThreshold, const Execution& execution) {
    ScannedSite site;
    site.ground = groundOf(run);
    // The ground is added where the rays go, with all of its nodes.
    run.terrain = nullptr;
    site.shape = siteOfRun(run, time, liveThreshold, Vec3::Zero(), execution);
    const Components components =
        groupComponents(run.fe->mesh(), run.scenario.regrouping, run.scenario.components, run.scenario.assumptions);
    for (const DebrisFragment& each : debrisAt(*run.fragments, components, *run.trajectory, site.shape.time).fragments) {
        site.volumes.push_back(each.volume);
    }
    return site;
}

}  // namespace rubble
