#include "core/fe/live_islands.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace rubble {

namespace {

/// m, to the ground.
constexpr double touchesGround = 0.05;
/// m. Files round coordinates to 1 mm, and a support gives a little.
constexpr double hasNotMoved = 0.01;
/// m, along the ground: a foundation that slid in an earthquake still is one.
constexpr double hasNotLeft = 0.5;

/// Corners that make a face of an element.
std::ptrdiff_t faceCorners(ElementShape shape) {
    return isSolid(shape) ? 3 : isShell(shape) ? 2 : 1;
}

/// Of a corner that is at rest at `rest` and now at `place`. Written so that what is no number holds nothing.
bool standsInPlace(const Vec3& rest, const Vec3& place) {
    return (place - rest).norm() < hasNotMoved;
}

bool standsOnGround(const Vec3& rest, const Vec3& place, const SiteSurface& ground) {
    return std::abs(ground.depth(rest)) < touchesGround && std::abs(ground.depth(place)) < touchesGround &&
           (place - rest).norm() < hasNotLeft;
}

/// Component by component; of nothing, zero.
Vec3 median(std::vector<Vec3> values) {
    Vec3 middle = Vec3::Zero();
    for (int axis = 0; axis < 3 && !values.empty(); ++axis) {
        const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), at, values.end(), [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
        middle[axis] = (*at)[axis];
    }
    return middle;
}

}  // namespace

NodeState::NodeState(const FeResult& fe, std::size_t state) : m_mesh(fe.mesh()), m_now(fe.state(state)) {
    if (m_now->velocities.empty() && state > 0) {
        m_before = fe.state(state - 1);
    }
}

Vec3 NodeState::velocity(std::uint32_t node) const {
    if (!m_now->velocities.empty()) {
        return m_now->velocities[node];
    }
    if (!m_before) {
        return Vec3::Zero();
    }
    return (m_now->positions[node] - m_before->positions[node]) / (m_now->time - m_before->time);
}

double NodeState::centreSpeed(ElementIndex e) const {
    Vec3 sum = Vec3::Zero();
    for (const std::uint32_t node : m_mesh.cornersOf(e)) {
        sum += velocity(node);
    }
    return sum.norm() / static_cast<double>(m_mesh.cornersOf(e).size());
}

Supports::Supports(const FeResult& fe, const Activity& activity, const SiteSurface& ground)
    : m_fe(fe), m_mesh(fe.mesh()), m_ground(ground) {
    const std::size_t last = fe.stateCount() - 1;
    const NodeState nodes(fe, last);
    for (std::size_t i = 0; i < m_mesh.elementCount(); ++i) {
        const ElementIndex e = idAt<ElementIndex>(i);
        if (!activity.active(last, e) || !held(e, nodes, {})) {
            continue;
        }
        for (const std::uint32_t node : m_mesh.cornersOf(e)) {
            const Vec3& rest = m_mesh.nodes[node];
            const Vec3& place = nodes.place(node);
            if (nodes.velocity(node).norm() < movingSpeed && (standsInPlace(rest, place) || standsOnGround(rest, place, ground))) {
                m_base.push_back(node);
            }
        }
    }
    std::sort(m_base.begin(), m_base.end());
    m_base.erase(std::unique(m_base.begin(), m_base.end()), m_base.end());
    for (const std::uint32_t node : m_base) {
        m_last.push_back(nodes.place(node));
    }
}

BaseMotion Supports::base(const NodeState& nodes, std::size_t state) const {
    BaseMotion base;
    if (state + 1 == m_fe.stateCount()) {
        return base;
    }
    std::vector<Vec3> displacements;
    std::vector<Vec3> velocities;
    for (std::size_t i = 0; i < m_base.size(); ++i) {
        const Vec3 moved = nodes.place(m_base[i]) - m_last[i];
        const Vec3 velocity = nodes.velocity(m_base[i]);
        if (moved.allFinite() && velocity.allFinite()) {
            displacements.push_back(moved);
            velocities.push_back(velocity);
        }
    }
    base.displacement = median(std::move(displacements));
    base.velocity = median(std::move(velocities));
    return base;
}

bool Supports::held(ElementIndex element, const NodeState& nodes, const BaseMotion& base) const {
    std::ptrdiff_t inPlace = 0;
    std::ptrdiff_t onGround = 0;
    for (const std::uint32_t node : m_mesh.cornersOf(element)) {
        const Vec3& rest = m_mesh.nodes[node];
        const Vec3 place = nodes.place(node) - base.displacement;
        // Written so that what is no number holds nothing.
        if (!((nodes.velocity(node) - base.velocity).norm() < movingSpeed)) {
            continue;
        }
        inPlace += standsInPlace(rest, place);
        onGround += standsOnGround(rest, place, m_ground);
    }
    return std::max(inPlace, onGround) >= faceCorners(m_mesh.shapes[at(element)]);
}

NodeGroups::NodeGroups(std::size_t nodes) : m_parent(nodes) {
    std::iota(m_parent.begin(), m_parent.end(), 0u);
}

void NodeGroups::join(std::span<const std::uint32_t> corners) {
    for (const std::uint32_t corner : corners) {
        m_parent[rootOf(corner)] = rootOf(corners.front());
    }
}

std::uint32_t NodeGroups::rootOf(std::uint32_t node) {
    while (m_parent[node] != node) {
        m_parent[node] = m_parent[m_parent[node]];
        node = m_parent[node];
    }
    return node;
}

std::vector<std::vector<ElementIndex>> partsOf(const Mesh& mesh, std::span<const ElementIndex> elements) {
    // Few elements of a large mesh: their nodes are numbered anew.
    std::unordered_map<std::uint32_t, std::uint32_t> number;
    std::vector<std::vector<std::uint32_t>> corners;
    for (const ElementIndex e : elements) {
        std::vector<std::uint32_t>& of = corners.emplace_back();
        for (const std::uint32_t node : mesh.cornersOf(e)) {
            of.push_back(number.emplace(node, static_cast<std::uint32_t>(number.size())).first->second);
        }
    }
    NodeGroups groups(number.size());
    for (const std::vector<std::uint32_t>& of : corners) {
        groups.join(of);
    }
    std::vector<std::vector<ElementIndex>> parts;
    std::unordered_map<std::uint32_t, std::size_t> partOf;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const auto [part, first] = partOf.emplace(groups.rootOf(corners[i].front()), parts.size());
        if (first) {
            parts.emplace_back();
        }
        parts[part->second].push_back(elements[i]);
    }
    return parts;
}

std::vector<LiveIsland> islandsAt(const FeResult& fe, const Activity& activity, const Supports& supports, NodeGroups& groups,
                                  std::size_t state) {
    const Mesh& mesh = fe.mesh();
    const NodeState nodes(fe, state);
    const BaseMotion base = supports.base(nodes, state);
    std::vector<LiveIsland> islands;
    std::vector<std::int64_t> islandOf(mesh.nodeCount(), -1);
    for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
        const ElementIndex e = idAt<ElementIndex>(i);
        if (!activity.active(state, e)) {
            continue;
        }
        std::int64_t& island = islandOf[groups.rootOf(mesh.cornersOf(e).front())];
        if (island < 0) {
            island = static_cast<std::int64_t>(islands.size());
            islands.emplace_back();
        }
        LiveIsland& mine = islands[static_cast<std::size_t>(island)];
        mine.elements.push_back(e);
        mine.supported = mine.supported || supports.held(e, nodes, base);
    }
    return islands;
}

std::vector<LiveIsland> liveIslands(const FeResult& fe, const Activity& activity, const SiteSurface& ground) {
    const std::size_t last = fe.stateCount() - 1;
    NodeGroups groups(fe.mesh().nodeCount());
    for (std::size_t i = 0; i < fe.mesh().elementCount(); ++i) {
        if (activity.active(last, idAt<ElementIndex>(i))) {
            groups.join(fe.mesh().cornersOf(idAt<ElementIndex>(i)));
        }
    }
    return islandsAt(fe, activity, Supports(fe, activity, ground), groups, last);
}

}  // namespace rubble
