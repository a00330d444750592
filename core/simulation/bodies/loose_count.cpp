#include "core/simulation/bodies/loose_count.h"

#include <cmath>

namespace rubble {

LiveIslands countLoose(const FeResult& fe, const Components& components, std::span<const LiveIsland> islands) {
    const NodeState last(fe, fe.stateCount() - 1);
    LiveIslands count;
    for (const LiveIsland& island : islands) {
        if (island.supported) {
            continue;
        }
        ++count.islands;
        count.elements += static_cast<std::int64_t>(island.elements.size());
        for (const ElementIndex e : island.elements) {
            const double mass = components.mass(e);
            count.mass += std::isfinite(mass) ? mass : 0.0;
            count.moving += last.centreSpeed(e) > movingSpeed;
        }
    }
    return count;
}

}  // namespace rubble
