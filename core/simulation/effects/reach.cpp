#include "core/simulation/effects/reach.h"

#include <algorithm>
#include <cmath>

namespace rubble {

Reach launched(const Aabb& box, double v, double centreHeight, double duration, const FallLimits& limits) {
    Reach reach;
    reach.box = box;
    const double g = limits.gravity;
    if (box.isEmpty() || !box.min().allFinite() || !box.max().allFinite() || !std::isfinite(v)) {
        reach.box.setEmpty();
        return reach;
    }
    const double time = std::max(0.0, duration);
    double sideways = v * time, upwards = v * time;
    double low = box.min().z() - v * time - 0.5 * g * time * time;
    reach.speed = v + g * time;
    if (g > 0.0) {
        upwards = std::min(upwards, 0.5 * v * v / g);
    }
    if (limits.surface) {
        reach.fall = std::max(0.0, centreHeight - *limits.surface);
        const double speed = std::sqrt(v * v + 2.0 * g * reach.fall);
        reach.speed = std::min(reach.speed, speed);
        low = std::min(box.min().z(), std::max(low, *limits.surface));
        if (g > 0.0) {
            sideways = std::min(sideways, v / g * speed);
        }
    }
    Vec3 least = box.min() - Vec3(sideways, sideways, 0.0), most = box.max() + Vec3(sideways, sideways, upwards);
    least.z() = low;
    reach.box = Aabb(least, most);
    return reach;
}

Reach reachOf(const EffectScene& scene, ClusterId id, const FallLimits& limits) {
    const Cluster& cluster = scene.clustering.list[at(id)];
    Aabb box;
    for (const FragmentId f : scene.clustering.membersOf(id)) {
        box.extend(scene.fragments.list[at(f)].bounds);
    }
    return launched(box, cluster.velocity.norm(), cluster.centre.z(), std::min(limits.end, cluster.endTime) - cluster.handOverTime,
                    limits);
}

std::vector<Reach> reaches(const EffectScene& scene, const FallLimits& limits) {
    std::vector<Reach> all;
    for (std::size_t c = 0; c < scene.clustering.list.size(); ++c) {
        all.push_back(reachOf(scene, idAt<ClusterId>(c), limits));
    }
    return all;
}

}  // namespace rubble
