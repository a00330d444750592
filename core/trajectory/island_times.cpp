#include "core/trajectory/island_times.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace rubble {

bool IslandTimes::carried(ElementIndex element) const {
    return at(element) < since.size() && std::isfinite(since[at(element)]);
}

std::vector<double> IslandTimes::deathsByState(const Activity& activity, const std::vector<double>& times) const {
    std::vector<double> deaths(times.size(), 0.0);
    for (std::size_t i = 0; i < since.size(); ++i) {
        const ElementIndex e = idAt<ElementIndex>(i);
        for (std::size_t k = 1; carried(e) && k < times.size(); ++k) {
            // Its body has it to its last active state at least.
            if (activity.active(k - 1, e) && !activity.active(k, e) && since[i] < times[k]) {
                deaths[k] += 1.0;
            }
        }
    }
    return deaths;
}

IslandTimes islandTimes(const TrajectoryReader& trajectory, std::size_t elements) {
    IslandTimes found;
    found.since.assign(elements, std::numeric_limits<double>::infinity());
    const std::vector<IslandRecord> islands = trajectory.islands();
    const std::vector<BodyRecord> bodies = islands.empty() ? std::vector<BodyRecord>() : trajectory.bodies();
    std::map<double, IslandTimes::HandOver> byTime;
    for (const IslandRecord& island : islands) {
        if (at(island.body) >= bodies.size()) {
            continue;
        }
        const BodyRecord& body = bodies[at(island.body)];
        std::size_t fresh = 0;
        for (const ElementIndex e : island.elements) {
            if (at(e) < elements && !found.carried(e)) {
                found.since[at(e)] = body.from;
                ++fresh;
            }
        }
        if (fresh > 0) {
            IslandTimes::HandOver& handOver = byTime[body.from];
            handOver.time = body.from;
            handOver.islands += 1;
            handOver.elements += fresh;
            handOver.mass += body.mass;
        }
    }
    for (const auto& [time, handOver] : byTime) {
        found.handOvers.push_back(handOver);
    }
    return found;
}

}  // namespace rubble
