#include "core/evidence/maps/element_places.h"

#include <algorithm>

namespace rubble {

namespace {

std::vector<CarriedIsland> carriedAt(const FragmentSet& fragments, const TrajectoryReader& trajectory, double time) {
    const std::vector<IslandRecord> islands = trajectory.islands();
    if (islands.empty() || trajectory.frameCount() == 0) {
        return {};
    }
    const TrajectoryFrame frame = frameAtTime(trajectory, time);
    std::vector<CarriedIsland> carried = carriedIslands(islands, trajectory.bodies(), frame);
    std::ranges::copy(leftIslands(fragments, islands, trajectory.carriers(), frame), std::back_inserter(carried));
    return carried;
}

}  // namespace

ElementPlaces::ElementPlaces(const FeResult& fe, const Activity& activity, const FragmentSet& fragments,
                             const TrajectoryReader& trajectory, double time)
    : ElementPlaces(fe, activity, carriedAt(fragments, trajectory, time), time) {}

ElementPlaces::ElementPlaces(const FeResult& fe, const Activity& activity, std::span<const CarriedIsland> islands, double time)
    : m_activity(activity), m_carried(fe.mesh().elementCount(), -1), m_mesh(fe.mesh()) {
    for (const CarriedIsland& island : islands) {
        const auto then = fe.state(std::min<std::size_t>(island.state, fe.stateCount() - 1));
        for (const ElementIndex e : island.elements) {
            if (at(e) < m_carried.size()) {
                m_carried[at(e)] = static_cast<std::int32_t>(m_corners.size());
                for (const std::uint32_t node : m_mesh.cornersOf(e)) {
                    m_corners.push_back(island.moved * then->positions[node]);
                }
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
    if (m_carried[at(e)] >= 0) {
        const auto corners = m_mesh.cornersOf(e);
        const auto corner = std::ranges::find(corners, node) - corners.begin();
        return m_corners[static_cast<std::size_t>(m_carried[at(e)] + corner)];
    }
    Vec3 place = m_now->positions[node];
    // What dies on the way has no place after.
    if (m_next && m_activity.active(m_state + 1, e)) {
        place += m_share * (m_next->positions[node] - place);
    }
    return place;
}

}  // namespace rubble
