#include "core/evidence/maps/element_places.h"

#include <algorithm>

namespace rubble {

namespace {

/// Where the released islands are at a time; none before the last FE state.
std::vector<CarriedIsland> islandsAt(const FeResult& fe, const TrajectoryReader& trajectory, double time) {
    if (!(time > fe.times().back())) {
        return {};
    }
    const std::vector<BodyRecord> bodies = trajectory.bodies();
    return carriedIslands(trajectory.islands(), bodies, frameAtTime(trajectory, time));
}

}  // namespace

ElementPlaces::ElementPlaces(const FeResult& fe, const Activity& activity, const TrajectoryReader& trajectory, double time)
    : ElementPlaces(fe, activity, islandsAt(fe, trajectory, time), time) {}

ElementPlaces::ElementPlaces(const FeResult& fe, const Activity& activity, std::span<const CarriedIsland> islands, double time)
    : m_activity(activity), m_carried(fe.mesh().elementCount()) {
    for (const CarriedIsland& island : islands) {
        for (const ElementIndex e : island.elements) {
            if (at(e) < m_carried.size()) {
                m_carried[at(e)] = island.moved;
            }
        }
    }
    const std::vector<double>& times = fe.times();
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    m_state = after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1;
    m_now = fe.state(m_state);
    if (after != times.begin() && after != times.end() && time > times[m_state]) {
        m_next = fe.state(m_state + 1);
        m_share = (time - times[m_state]) / (*after - times[m_state]);
    }
}

Vec3 ElementPlaces::place(ElementIndex e, std::uint32_t node) const {
    Vec3 place = m_now->positions[node];
    // What dies on the way has no place after.
    if (m_next && m_activity.active(m_state + 1, e)) {
        place += m_share * (m_next->positions[node] - place);
    }
    return m_carried[at(e)] ? *m_carried[at(e)] * place : place;
}

}  // namespace rubble
