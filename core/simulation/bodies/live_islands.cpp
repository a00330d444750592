#include "core/simulation/bodies/live_islands.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rubble {

namespace {

/// m, to the ground.
constexpr double touchesGround = 0.05;
/// m. Files round coordinates to 1 mm, and a support gives a little.
constexpr double hasNotMoved = 0.01;
/// m, along the ground: a foundation that slid in an earthquake still is one.
constexpr double hasNotLeft = 0.5;
/// m/s. Differences of coordinates that are rounded to 1 mm say as much as 0.05 m/s of a node that stands still.
constexpr double isMoving = 0.1;

std::uint32_t rootOf(std::vector<std::uint32_t>& parent, std::uint32_t node) {
    while (parent[node] != node) {
        parent[node] = parent[parent[node]];
        node = parent[node];
    }
    return node;
}

/// The last FE state and how its nodes move.
class LastState {
public:
    explicit LastState(const FeResult& fe) : m_mesh(fe.mesh()), m_now(fe.state(fe.stateCount() - 1)) {
        if (m_now->velocities.empty() && fe.stateCount() > 1) {
            m_before = fe.state(fe.stateCount() - 2);
        }
    }

    const Vec3& place(std::uint32_t node) const { return m_now->positions[node]; }
    Vec3 velocity(std::uint32_t node) const {
        if (!m_now->velocities.empty()) {
            return m_now->velocities[node];
        }
        return m_before ? Vec3((m_now->positions[node] - m_before->positions[node]) / (m_now->time - m_before->time))
                        : Vec3::Zero();
    }
    double centreSpeed(ElementIndex e) const {
        Vec3 sum = Vec3::Zero();
        for (const std::uint32_t node : m_mesh.cornersOf(e)) {
            sum += velocity(node);
        }
        return sum.norm() / static_cast<double>(m_mesh.cornersOf(e).size());
    }

private:
    const Mesh& m_mesh;
    std::shared_ptr<const FeState> m_now;
    std::shared_ptr<const FeState> m_before;
};

/// Corners that make a face of an element.
std::ptrdiff_t faceCorners(ElementShape shape) {
    return isSolid(shape) ? 3 : isShell(shape) ? 2 : 1;
}

bool held(const Mesh& mesh, ElementIndex e, const LastState& last, const SiteSurface& ground) {
    std::ptrdiff_t inPlace = 0;
    std::ptrdiff_t onGround = 0;
    for (const std::uint32_t node : mesh.cornersOf(e)) {
        const Vec3& rest = mesh.nodes[node];
        const Vec3& place = last.place(node);
        // Written so that what is no number holds nothing.
        if (!(last.velocity(node).norm() < isMoving)) {
            continue;
        }
        inPlace += (place - rest).norm() < hasNotMoved;
        onGround += std::abs(ground.depth(rest)) < touchesGround && std::abs(ground.depth(place)) < touchesGround &&
                    (place - rest).norm() < hasNotLeft;
    }
    return std::max(inPlace, onGround) >= faceCorners(mesh.shapes[at(e)]);
}

}  // namespace

std::vector<LiveIsland> liveIslands(const FeResult& fe, const Activity& activity, const SiteSurface& ground) {
    const Mesh& mesh = fe.mesh();
    const std::size_t k = fe.stateCount() - 1;
    std::vector<std::uint32_t> parent(mesh.nodeCount());
    std::iota(parent.begin(), parent.end(), 0u);
    for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
        const auto corners = mesh.cornersOf(idAt<ElementIndex>(i));
        for (std::size_t c = 1; c < corners.size() && activity.active(k, idAt<ElementIndex>(i)); ++c) {
            parent[rootOf(parent, corners[c])] = rootOf(parent, corners.front());
        }
    }
    const LastState last(fe);
    std::vector<LiveIsland> islands;
    std::vector<std::int64_t> islandOf(mesh.nodeCount(), -1);
    for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
        const ElementIndex e = idAt<ElementIndex>(i);
        if (!activity.active(k, e)) {
            continue;
        }
        std::int64_t& island = islandOf[rootOf(parent, mesh.cornersOf(e).front())];
        if (island < 0) {
            island = static_cast<std::int64_t>(islands.size());
            islands.emplace_back();
        }
        LiveIsland& mine = islands[static_cast<std::size_t>(island)];
        mine.elements.push_back(e);
        mine.supported = mine.supported || held(mesh, e, last, ground);
    }
    return islands;
}

LiveIslands countLoose(const FeResult& fe, const Components& components, std::span<const LiveIsland> islands) {
    const LastState last(fe);
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
            count.moving += last.centreSpeed(e) > isMoving;
        }
    }
    return count;
}

}  // namespace rubble
