#include "core/evidence/element_places.h"

#include <algorithm>

namespace rubble {

namespace {

/// Where the released islands have been carried since the last FE state.
std::vector<std::optional<Pose>> carriedSince(const FeResult& fe, const TrajectoryReader& trajectory, double time) {
    std::vector<std::optional<Pose>> carried(fe.mesh().elementCount());
    if (!(time > fe.times().back())) {
        return carried;
    }
    const std::vector<BodyRecord> bodies = trajectory.bodies();
    const TrajectoryFrame frame = frameAtTime(trajectory, time);
    for (const IslandRecord& island : trajectory.islands()) {
        const std::size_t b = at(island.body);
        if (b >= frame.bodies() || b >= bodies.size()) {
            continue;
        }
        const Quat turn = frame.orientations[b].cast<double>().normalized() * bodies[b].atBirth.orientation.conjugate();
        const Pose pose{frame.positions[b].cast<double>() - turn * bodies[b].atBirth.position, turn};
        for (const ElementIndex e : island.elements) {
            if (at(e) < carried.size()) {
                carried[at(e)] = pose;
            }
        }
    }
    return carried;
}

}  // namespace

ElementPlaces::ElementPlaces(const FeResult& fe, const Activity& activity, const TrajectoryReader& trajectory, double time)
    : m_activity(activity), m_carried(carriedSince(fe, trajectory, time)) {
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
