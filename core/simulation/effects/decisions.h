#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "core/base/message.h"
#include "core/clusters/clustering.h"
#include "core/fe/components.h"
#include "core/fe/fe_result.h"
#include "core/fe/terrain_grid.h"
#include "core/fragments/fragment_set.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// "ground", "terrain", "structure_contact", "fragment_contact", "water", "air_drag", "ties", "break_up": the keys of the switches.
std::string_view effectName(EffectKind kind);

/// Whether an effect takes part in a run, and why.
struct EffectDecision {
    EffectKind kind{};
    EffectSwitch asked = EffectSwitch::Auto;
    bool on = false;
    Message reason;          ///< in words and numbers: "weight/drag at the highest possible speed is 310, off"
    double measure = 0.0;    ///< the number the test looked at; NaN where there is none
    double threshold = 0.0;  ///< what it was held against; NaN where there is none
};
using EffectDecisions = std::array<EffectDecision, effectCount>;

/// What the tests look at.
struct EffectScene {
    const FeResult& fe;
    const Components& components;
    const FragmentSet& fragments;
    const Clustering& clustering;
    const TerrainGrid* terrain = nullptr;  ///< null: the case has none
    const Scenario& scenario;
};

/// Decides on every effect without simulating; cheap against a run. Every entry has a reason, also those that the user set.
EffectDecisions decideEffects(const EffectScene& scene);

/// The scenario as a run takes it: where nothing comes loose before the FE result ends, loose_structure has nothing to do, and what
/// it would ask for (steps, substeps, shapes of clusters) is that of fe.
Scenario settledScenario(const EffectScene& scene);

/// An effect after a run.
struct EffectReport {
    EffectDecision decision;
    double msPerStep = 0.0;   ///< measured in the run, mean over its steps
    double share = 0.0;       ///< of the whole step
    double work = 0.0;        ///< J, done on bodies; negative where it took energy
    std::int64_t events = 0;  ///< ties broken, clusters broken up; 0 for the others
};

}  // namespace rubble
