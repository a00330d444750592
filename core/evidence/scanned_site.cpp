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
    const TrajectoryFrame frame = frameAtTime(*run.trajectory, site.shape.time);
    for (const BodyRecord& body : run.trajectory->bodies()) {
        if (const std::size_t i = at(body.body); !body.isIsland() && i < frame.states.size()) {
            site.moving.bodies += frame.states[i] != BodyState::Removed ? 1 : 0;
            site.moving.moving += frame.states[i] == BodyState::Awake ? 1 : 0;
        }
    }
    return site;
}

}  // namespace rubble
