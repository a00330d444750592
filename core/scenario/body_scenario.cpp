#include "core/scenario/body_scenario.h"

namespace rubble {

namespace {

/// s. A block that runs down a slope takes longer than debris that falls from a building.
constexpr double timeToRest = 60.0;

}  // namespace

void prepareForBodies(Scenario& scenario, const std::vector<LooseBody>& bodies) {
    scenario.grid.oneBodyPerFragment = true;
    scenario.fragments.birthWindow = 0.0;
    scenario.effects.of(EffectKind::StructureContact) = EffectSwitch::Off;
    scenario.simulation.settleTime = timeToRest;
    scenario.simulation.bounceFriction = true;
    for (const LooseBody& body : bodies) {
        if (body.material) {
            scenario.components[partOf(body)].material = body.material;
        }
    }
}

}  // namespace rubble
