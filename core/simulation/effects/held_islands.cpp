#include "core/simulation/effects/held_islands.h"

namespace rubble {

std::optional<Finding> notHeld(const Scenario& settled) {
    if (settled.effects.islands != LiveIslandPolicy::Held || settled.effects.loose == LooseStructurePolicy::Fe) {
        return std::nullopt;
    }
    return Finding{
        {"effect.not_held",
         "live_islands = held holds what comes loose where the FE result ends, and nothing else: what the engine carries by "
         "then (loose_structure = at_once) goes on moving",
         {}},
        {"effect.not_held.remedy", "Take loose_structure = fe to hold all of it where the FE result leaves it", {}},
        1,
        {}};
}

}  // namespace rubble
