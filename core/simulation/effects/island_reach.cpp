#include "core/simulation/effects/island_reach.h"

#include <algorithm>
#include <limits>

#include "core/fe/live_islands.h"
#include "core/fragments/birth_windows.h"

namespace rubble {

LiveReach liveReach(const EffectScene& scene, const SiteSurface& ground, const FallLimits& limits) {
    LiveReach live;
    const FeResult& fe = scene.fe;
    const bool release = scene.scenario.effects.islands == LiveIslandPolicy::Released;
    const Activity activity = simulatedActivity(fe, scene.scenario.fragments);
    const std::shared_ptr<const FeState> last = fe.state(fe.stateCount() - 1);
    const std::shared_ptr<const FeState> before = fe.stateCount() > 1 ? fe.state(fe.stateCount() - 2) : last;
    const double interval = last->time - before->time;
    for (const LiveIsland& island : liveIslands(fe, activity, ground)) {
        Aabb box;
        double speed = 0.0;
        for (const ElementIndex e : island.elements) {
            for (const std::uint32_t node : fe.mesh().cornersOf(e)) {
                box.extend(last->positions[node]);
                const double fast = !last->velocities.empty() ? last->velocities[node].norm()
                                    : interval > 0.0          ? (last->positions[node] - before->positions[node]).norm() / interval
                                                              : 0.0;
                speed = std::max(speed, fast);
            }
        }
        if (!box.min().allFinite() || !box.max().allFinite()) {
            continue;
        }
        if (island.supported || !release) {
            live.standing.push_back(box);
            continue;
        }
        live.released.push_back(launched(box, speed, box.center().z(), limits.end - fe.times().back(), limits));
        live.site.extend(live.released.back().box);
    }
    return live;
}

double deepestOverlap(const std::vector<Reach>& released, const std::vector<Aabb>& boxes) {
    double deepest = -std::numeric_limits<double>::infinity();
    for (const Reach& reach : released) {
        for (const Aabb& box : boxes) {
            const Vec3 overlap = reach.box.max().cwiseMin(box.max()) - reach.box.min().cwiseMax(box.min());
            deepest = std::max(deepest, overlap.minCoeff());
        }
    }
    return deepest;
}

}  // namespace rubble
