#include "core/pipeline/loose_scene.h"

#include "core/fragments/lifetimes.h"

namespace rubble {

SiteSurface groundBeforeRun(const Inputs& inputs, const Scenario& scenario) {
    const EffectSettings& effects = scenario.effects;
    SiteSurface ground{effects.of(EffectKind::Ground) != EffectSwitch::Off, scenario.simulation.groundHeight, nullptr};
    if (effects.of(EffectKind::Terrain) != EffectSwitch::Off) {
        ground.terrain = inputs.terrain;
    }
    return ground;
}

LooseStructure looseScene(const Inputs& inputs, const Scenario& scenario, const Execution& execution) {
    return looseStructure(*inputs.fe, activityUnder(inputs.fe->activity(), scenario.fragments.revival),
                          groundBeforeRun(inputs, scenario), execution);
}

}  // namespace rubble
