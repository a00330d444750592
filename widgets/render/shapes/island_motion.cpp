#include "widgets/render/shapes/island_motion.h"

#include <algorithm>
#include <cmath>

namespace rubble::render {

const Eigen::Vector3f* IslandMotion::Held::find(std::uint32_t node) const {
    const auto place = std::lower_bound(nodes.begin(), nodes.end(), node);
    return place != nodes.end() && *place == node ? &places[static_cast<std::size_t>(place - nodes.begin())] : nullptr;
}

void IslandMotion::bind(std::vector<IslandRecord> islands, std::span<const BodyRecord> bodies) {
    const std::size_t elements = m_fe->mesh().elementCount();
    m_islands.clear();
    m_events.clear();
    m_slot = ~std::size_t{0};
    for (IslandRecord& record : islands) {
        const bool known = at(record.body) < bodies.size() &&
                           std::ranges::all_of(record.elements, [&](ElementIndex e) { return at(e) < elements; });
        if (!known) {
            continue;
        }
        const BodyRecord& body = bodies[at(record.body)];
        m_islands.push_back({at(record.body), body.from, body.to, std::min<std::size_t>(record.state, m_fe->stateCount() - 1),
                             record.inFe, body.atBirth, std::move(record.elements)});
        m_events.push_back(body.from);
        if (std::isfinite(body.to)) {
            m_events.push_back(body.to);
        }
    }
    std::sort(m_events.begin(), m_events.end());
    m_events.erase(std::unique(m_events.begin(), m_events.end()), m_events.end());
}

/// Reads the places of the nodes of all islands with a state.
void IslandMotion::hold(std::size_t state) {
    const Mesh& mesh = m_fe->mesh();
    std::vector<bool> wanted(mesh.nodeCount(), false);
    for (const Island& island : m_islands) {
        for (std::size_t i = 0; island.state == state && i < island.elements.size(); ++i) {
            for (const std::uint32_t node : mesh.cornersOf(island.elements[i])) {
                wanted[node] = true;
            }
        }
    }
    const auto then = m_fe->state(state);
    Held held;
    for (std::uint32_t node = 0; node < wanted.size(); ++node) {
        if (wanted[node]) {
            held.nodes.push_back(node);
            held.places.push_back(then->positions[node].cast<float>());
        }
    }
    m_held[state] = std::move(held);
}

/// False where places of the island are not held.
bool IslandMotion::ride(std::vector<Ride>& rides, const Island& island, std::uint32_t index) const {
    const auto held = m_held.find(island.state);
    if (held == m_held.end()) {
        return false;
    }
    for (const ElementIndex e : island.elements) {
        for (const std::uint32_t node : m_fe->mesh().cornersOf(e)) {
            if (rides[node].island == index) {
                continue;
            }
            const Eigen::Vector3f* place = held->second.find(node);
            if (place == nullptr) {
                return false;
            }
            rides[node] = {index, *place};
        }
    }
    return true;
}

void IslandMotion::changeOver(double time) {
    std::vector<There> there;
    std::vector<Ride> rides;
    std::size_t elements = 0;
    for (std::size_t i = 0; i < m_islands.size(); ++i) {
        const Island& island = m_islands[i];
        if (!(island.from <= time && time < island.to)) {
            continue;
        }
        const auto index = static_cast<std::uint32_t>(there.size());
        rides.resize(m_fe->mesh().nodeCount());
        if (!ride(rides, island, index)) {
            hold(island.state);
            ride(rides, island, index);
        }
        there.push_back({i, {}});
        elements += island.elements.size();
    }
    m_there = std::move(there);
    m_rides = std::move(rides);
    m_elements = elements;
    ++m_version;
}

void IslandMotion::moveTo(const TrajectoryFrame& frame, double time) {
    if (m_islands.empty() && m_there.empty()) {
        return;
    }
    const auto slot = static_cast<std::size_t>(std::upper_bound(m_events.begin(), m_events.end(), time) - m_events.begin());
    if (slot != m_slot) {
        changeOver(time);
        m_slot = slot;
    }
    for (There& there : m_there) {
        const Island& island = m_islands[there.island];
        Pose now = island.atBirth;
        if (island.body < frame.bodies()) {
            now.position = frame.positions[island.body].cast<double>();
            now.orientation = frame.orientations[island.body].cast<double>().normalized();
        }
        const Quat turn = now.orientation * island.inFe.orientation.conjugate();
        there.motion = {island.inFe.position.cast<float>(), turn.toRotationMatrix().cast<float>(), now.position.cast<float>()};
    }
}

}  // namespace rubble::render
