#include "widgets/render/shapes/island_motion.h"

#include <algorithm>

namespace rubble::render {

void IslandMotion::bind(const Mesh& mesh, std::span<const IslandRecord> islands, std::span<const BodyRecord> bodies) {
    m_islands.clear();
    m_elements = 0;
    m_islandOf.assign(mesh.nodeCount(), none);
    for (const IslandRecord& record : islands) {
        const bool known = at(record.body) < bodies.size() && std::all_of(
                                                                  record.elements.begin(), record.elements.end(),
                                                                  [&](ElementIndex e) { return at(e) < mesh.elementCount(); });
        if (!known) {
            continue;
        }
        const BodyRecord& body = bodies[at(record.body)];
        Island island;
        island.body = at(record.body);
        island.fromBirth = body.atBirth.orientation.conjugate();
        island.pivot = island.position = body.atBirth.position.cast<float>();
        for (const ElementIndex e : record.elements) {
            for (const std::uint32_t node : mesh.cornersOf(e)) {
                m_islandOf[node] = static_cast<std::uint32_t>(m_islands.size());
            }
        }
        m_from = body.from;
        m_elements += record.elements.size();
        m_islands.push_back(island);
    }
}

void IslandMotion::moveTo(const TrajectoryFrame& frame) {
    for (Island& island : m_islands) {
        const bool there = island.body < frame.bodies();
        island.position = there ? frame.positions[island.body] : island.pivot;
        island.turn = there ? Eigen::Matrix3f((frame.orientations[island.body].cast<double>().normalized() * island.fromBirth)
                                                  .toRotationMatrix()
                                                  .cast<float>())
                            : Eigen::Matrix3f::Identity();
    }
}

}  // namespace rubble::render
