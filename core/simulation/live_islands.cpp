#include "core/simulation/live_islands.h"

#include <numeric>
#include <vector>

namespace rubble {

namespace {

constexpr double touchesGround = 0.05;
constexpr double hasNotMoved = 0.01;
constexpr double isMoving = 0.1;

std::uint32_t rootOf(std::vector<std::uint32_t>& parent, std::uint32_t node) {
    while (parent[node] != node) {
        parent[node] = parent[parent[node]];
        node = parent[node];
    }
    return node;
}

double centreSpeed(const Mesh& mesh, ElementIndex e, const FeState& last, const FeState* before) {
    Vec3 velocity = Vec3::Zero();
    for (const std::uint32_t node : mesh.cornersOf(e)) {
        if (!last.velocities.empty()) {
            velocity += last.velocities[node];
        } else if (before != nullptr) {
            velocity += (last.positions[node] - before->positions[node]) / (last.time - before->time);
        }
    }
    return velocity.norm() / static_cast<double>(mesh.cornersOf(e).size());
}

}  // namespace

LiveIslands countLiveIslands(const FeResult& fe, const Components& components, const Activity& activity, bool ground,
                             double groundHeight) {
    const Mesh& mesh = fe.mesh();
    const std::size_t k = fe.stateCount() - 1;
    const auto last = fe.state(k);
    const auto before = k > 0 ? fe.state(k - 1) : nullptr;
    std::vector<std::uint32_t> parent(mesh.nodeCount());
    std::iota(parent.begin(), parent.end(), 0u);
    for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
        const ElementIndex e = idAt<ElementIndex>(i);
        if (activity.active(k, e)) {
            for (const std::uint32_t node : mesh.cornersOf(e)) {
                parent[rootOf(parent, node)] = rootOf(parent, mesh.cornersOf(e).front());
            }
        }
    }
    std::vector<bool> supported(mesh.nodeCount(), false);
    for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
        const ElementIndex e = idAt<ElementIndex>(i);
        if (!activity.active(k, e)) {
            continue;
        }
        for (const std::uint32_t node : mesh.cornersOf(e)) {
            const Vec3& place = last->positions[node];
            if ((ground && place.z() < groundHeight + touchesGround) || (place - mesh.nodes[node]).norm() < hasNotMoved) {
                supported[rootOf(parent, node)] = true;
            }
        }
    }
    LiveIslands islands;
    std::vector<bool> counted(mesh.nodeCount(), false);
    for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
        const ElementIndex e = idAt<ElementIndex>(i);
        if (!activity.active(k, e)) {
            continue;
        }
        const std::uint32_t root = rootOf(parent, mesh.cornersOf(e).front());
        if (supported[root]) {
            continue;
        }
        islands.islands += !counted[root];
        counted[root] = true;
        ++islands.elements;
        islands.mass += components.mass(e);
        islands.moving += centreSpeed(mesh, e, *last, before.get()) > isMoving;
    }
    return islands;
}

}  // namespace rubble
