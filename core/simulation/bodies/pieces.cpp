#include "core/simulation/bodies/pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "core/base/same_bits.h"
#include "core/engine/world/body_shapes.h"
#include "core/engine/world/bricks.h"
#include "core/engine/world/constants.h"
#include "core/engine/world/tight_box.h"
#include "core/fe/live_islands.h"
#include "core/fragments/solids.h"
#include "core/simulation/bodies/element_nodes.h"

namespace rubble {

namespace {

/// m. A piece is at least twice this thick.
constexpr double leastPieceHalfExtent = 0.005;
/// Groups that one thread reshapes at a time.
constexpr std::size_t groupGrain = 4;

/// Corners of an element's solid where its nodes are: shells and beams with their section.
/// @param nodes  m, of the mesh
ElementShape appendSolid(const Mesh& mesh, const std::vector<Vec3>& nodes, ElementIndex e, double section,
                         std::vector<Vec3>& points) {
    const auto corners = mesh.cornersOf(e);
    if (isSolid(mesh.shapes[at(e)])) {
        for (const std::uint32_t node : corners) {
            points.push_back(nodes[node]);
        }
        return mesh.shapes[at(e)];
    }
    Corners positions = Corners::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        positions.col(static_cast<Eigen::Index>(i)) = nodes[corners[i]];
    }
    const MovingSolid solid = solidOf(mesh.shapes[at(e)], positions, Corners::Zero(), section);
    for (int i = 0; i < cornerCount(solid.shape); ++i) {
        points.emplace_back(solid.positions.col(i));
    }
    return solid.shape;
}

/// How far the farthest corner of a box goes from one pose to another, m.
double travel(const Aabb& box, const Pose& a, const Pose& b) {
    double most = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p = box.corner(static_cast<Aabb::CornerType>(corner));
        most = std::max(most, (b * p - a * p).norm());
    }
    return most;
}

/// Where the mean of nodes goes and how they turn from one set of places to another, by least squares; nothing if a place is no
/// number.
std::optional<Pose> fittedMotion(const std::vector<std::uint32_t>& nodes, const std::vector<Vec3>& from,
                                 const std::vector<Vec3>& to) {
    // In one pass over the nodes, which lie anywhere: places from that of the first one, so that little cancels.
    const Vec3 fromFirst = from[nodes.front()], toFirst = to[nodes.front()];
    Vec3 fromSum = Vec3::Zero(), toSum = Vec3::Zero();
    Mat3 products = Mat3::Zero();
    for (const std::uint32_t node : nodes) {
        const Vec3 a = from[node] - fromFirst, b = to[node] - toFirst;
        fromSum += a;
        toSum += b;
        products += b * a.transpose();
    }
    const auto count = static_cast<double>(nodes.size());
    const Vec3 after = toFirst + toSum / count;
    const Mat3 covariance = products - toSum * fromSum.transpose() / count;
    if (!covariance.allFinite() || !after.allFinite()) {
        return std::nullopt;
    }
    return Pose{after, Quat(nearestRotation(covariance)).normalized()};
}

}  // namespace

Pieces::Pieces(const FeResult& fe, const Components& components, const Activity& activity, const Scenario& scenario,
               double finestBrick)
    : m_fe(fe),
      m_components(components),
      m_activity(activity),
      m_kind(scenario.simulation.pieces),
      m_bricks(m_kind == PieceKind::GridBoxes && shapeOfClusters(scenario) == ClusterShape::Bricks),
      m_finestBrick(finestBrick),
      m_leastHalfExtent(leastPieceHalfExtent) {
    makeGroups(scenario.simulation);
    if (m_kind == PieceKind::Surface) {
        findNeighbours();
    }
}

void Pieces::makeGroups(const SimulationSettings& settings) {
    const Mesh& mesh = m_fe.mesh();
    if (m_kind == PieceKind::None) {
        return;
    }
    // Ordered, so that pieces enter the engine in the same order every time.
    std::map<std::tuple<std::size_t, std::int64_t, std::int64_t, std::int64_t>, std::size_t> found;
    // By the user's numbers, so that the order of the elements in the file reaches no result.
    std::vector<std::size_t> order(mesh.elementCount());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(mesh.elementIds[i], i); });
    for (const std::size_t i : order) {
        const ElementIndex e = idAt<ElementIndex>(i);
        const std::size_t component = at(m_components.of[i]);
        std::tuple<std::size_t, std::int64_t, std::int64_t, std::int64_t> key{component, 0, 0, 0};
        if (m_kind == PieceKind::Surface) {
            key = {component, static_cast<std::int64_t>(i), 0, 0};
        } else if (m_kind == PieceKind::GridBoxes) {
            Vec3 centre = Vec3::Zero();
            for (const std::uint32_t node : mesh.cornersOf(e)) {
                centre += mesh.nodes[node];
            }
            centre /= static_cast<double>(mesh.cornersOf(e).size());
            const Vec3 cell = (centre - m_components.list[component].bounds.min()) / settings.pieceSize;
            if (!cell.allFinite()) {
                continue;
            }
            key = {component, std::llround(std::floor(cell.x())), std::llround(std::floor(cell.y())),
                   std::llround(std::floor(cell.z()))};
        }
        found[key];
        auto& slot = found[key];
        if (slot == 0) {
            m_groups.emplace_back().component = m_components.of[i];
            slot = m_groups.size();
        }
        m_groups[slot - 1].elements.push_back(e);
    }
}

void Pieces::findNeighbours() {
    const Mesh& mesh = m_fe.mesh();
    std::map<std::array<std::uint32_t, 4>, std::uint32_t> open;
    m_faceOffsets.assign(1, 0);
    std::vector<std::uint32_t> owner;
    for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
        const ElementIndex e = idAt<ElementIndex>(i);
        const auto corners = mesh.cornersOf(e);
        if (isSolid(mesh.shapes[i])) {
            for (const auto& face : facesOf(mesh.shapes[i])) {
                std::array<std::uint32_t, 4> key{};
                for (std::size_t c = 0; c < 4; ++c) {
                    key[c] = corners[static_cast<std::size_t>(face[c] < 0 ? face[0] : face[c])];
                }
                std::sort(key.begin(), key.end());
                const auto index = static_cast<std::uint32_t>(m_neighbour.size());
                m_neighbour.push_back(-1);
                owner.push_back(static_cast<std::uint32_t>(i));
                const auto [other, first] = open.emplace(key, index);
                if (!first) {
                    m_neighbour[index] = owner[other->second];
                    m_neighbour[other->second] = static_cast<std::int64_t>(i);
                }
            }
        }
        m_faceOffsets.push_back(static_cast<std::uint32_t>(m_neighbour.size()));
    }
}

bool Pieces::activeThrough(ElementIndex e, std::size_t k) const {
    return m_activity.active(k, e) && m_activity.active(k + 1, e) && (m_gone.empty() || !m_gone[at(e)]);
}

bool Pieces::exposed(ElementIndex e, std::size_t k) const {
    if (m_faceOffsets[at(e)] == m_faceOffsets[at(e) + 1]) {
        return true;
    }
    for (std::uint32_t face = m_faceOffsets[at(e)]; face < m_faceOffsets[at(e) + 1]; ++face) {
        if (m_neighbour[face] < 0 || !activeThrough(idAt<ElementIndex>(static_cast<std::size_t>(m_neighbour[face])), k)) {
            return true;
        }
    }
    return false;
}

/// The group's elements that belong to its piece in the interval after state k, if they are others than in the one before.
std::optional<std::vector<ElementIndex>> Pieces::newMembers(const Group& group, std::size_t k) const {
    const auto belongs = [&](ElementIndex e) { return activeThrough(e, k) && (m_kind != PieceKind::Surface || exposed(e, k)); };
    // Most groups stay what they are.
    std::size_t same = 0;
    const bool changed = std::ranges::any_of(
        group.elements, [&](ElementIndex e) { return belongs(e) && (same == group.members.size() || group.members[same++] != e); });
    if (!changed && same == group.members.size()) {
        return std::nullopt;
    }
    std::vector<ElementIndex> members;
    std::ranges::copy_if(group.elements, std::back_inserter(members), belongs);
    return members;
}

std::optional<Pose> Pieces::follow(const Group& group, const FeState& from, const FeState& to) {
    std::optional<Pose> motion = fittedMotion(group.nodes, from.positions, to.positions);
    if (motion) {
        motion->orientation = (motion->orientation * group.pose.orientation).normalized();
    }
    return motion;
}

CollisionShape Pieces::bricksOf(const Group& group, const std::vector<Vec3>& nodes) const {
    std::vector<OrientedBox> bricks;
    for (const ElementIndex e : group.members) {
        std::vector<Vec3> points;
        const ElementShape solid = appendSolid(m_fe.mesh(), nodes, e, m_components.section[at(e)], points);
        bricks.push_back(brickOf(solid, points));
    }
    JoinLimits limits;
    limits.finest = m_finestBrick;
    CollisionShape parts;
    for (const OrientedBox& box : joinedBricks(bricks, limits)) {
        ConvexPart& part = parts.emplace_back();
        part.box = box;
        part.box.centre -= group.centre;
        part.box.halfExtents = part.box.halfExtents.cwiseMax(m_leastHalfExtent);
    }
    return parts;
}

CollisionShape Pieces::shapeOf(const Group& group, const std::vector<Vec3>& nodes) const {
    if (m_bricks) {
        return bricksOf(group, nodes);
    }
    std::vector<Vec3> points;
    for (const ElementIndex e : group.members) {
        appendSolid(m_fe.mesh(), nodes, e, m_components.section[at(e)], points);
    }
    for (Vec3& p : points) {
        p -= group.centre;
    }
    if (m_kind == PieceKind::Surface) {
        return {hullOf(points, m_leastHalfExtent)};
    }
    ConvexPart part;
    part.box = m_kind == PieceKind::ComponentBox ? boxWithAxes(points, Mat3::Identity()) : tightBox(points, {}, true);
    part.box.halfExtents = part.box.halfExtents.cwiseMax(m_leastHalfExtent);
    return {part};
}

std::optional<CollisionShape> Pieces::reshape(Group& group, const FeState& from) const {
    if (group.members.empty()) {
        return std::nullopt;
    }
    const Mesh& mesh = m_fe.mesh();
    group.nodes = nodesOf(mesh, group.members);
    // Bricks lie where the elements are now, as fragments and loose structure do; other shapes are those at rest.
    const std::vector<Vec3>& nodes = m_bricks ? from.positions : mesh.nodes;
    group.centre = Vec3::Zero();
    group.box.setEmpty();
    for (const std::uint32_t node : group.nodes) {
        group.centre += nodes[node];
        group.box.extend(nodes[node]);
    }
    group.centre /= static_cast<double>(group.nodes.size());
    group.box.translate(-group.centre);
    const std::optional<Pose> pose = fittedMotion(group.nodes, nodes, from.positions);
    CollisionShape shape = shapeOf(group, nodes);
    const bool sound = std::all_of(shape.begin(), shape.end(), [](const ConvexPart& part) {
        return part.box.centre.allFinite() && part.box.halfExtents.allFinite();
    });
    if (!pose || !sound) {
        return std::nullopt;
    }
    group.pose = *pose;
    return shape;
}

/// The parts of a group's members that hang together, where those move on their own.
Pieces::Parts Pieces::partsFor(std::span<const ElementIndex> members) const {
    return m_bricks ? partsOf(m_fe.mesh(), members) : Parts{};
}

/// A rigid fit of what has come apart would be wrong by half of the gap: every part but the first becomes a group of its own.
void Pieces::divide(std::size_t group, const Parts& parts) {
    std::vector<ElementIndex> gone;
    for (std::size_t i = 1; i < parts.size(); ++i) {
        Group part;
        part.component = m_groups[group].component;
        part.elements = part.members = parts[i];
        gone.insert(gone.end(), parts[i].begin(), parts[i].end());
        m_groups.push_back(std::move(part));
    }
    std::ranges::sort(gone);
    const auto left = [&](ElementIndex e) { return std::ranges::binary_search(gone, e); };
    std::erase_if(m_groups[group].elements, left);
    std::erase_if(m_groups[group].members, left);
}

void Pieces::replace(RigidWorld& world, Group& group, const std::optional<CollisionShape>& shape) {
    if (group.piece) {
        world.removePiece(*group.piece);
        group.piece.reset();
        --m_present;
    }
    if (shape) {
        group.piece = world.addPiece(*shape, group.pose, m_components.list[at(group.component)].material, group.nodes);
        ++m_present;
    }
}

void Pieces::rebuild(RigidWorld& world, Group& group, const FeState& from) {
    replace(world, group, reshape(group, from));
}

void Pieces::beginInterval(RigidWorld& world, std::size_t k) {
    m_moving.clear();
    if (m_groups.empty()) {
        return;
    }
    const std::shared_ptr<const FeState> from = m_fe.state(k);
    const std::shared_ptr<const FeState> to = m_fe.state(k + 1);
    /// What an interval makes of a group.
    struct Next {
        bool changed = false;
        Parts parts;                          ///< of a changed one
        std::optional<CollisionShape> shape;  ///< the same; nothing: there is no piece
        std::optional<Pose> finish;           ///< where it is at the end of the interval
    };
    std::vector<Next> next(m_groups.size());
    world.onThreads(m_groups.size(), groupGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            if (std::optional<std::vector<ElementIndex>> members = newMembers(m_groups[i], k)) {
                next[i].changed = true;
                next[i].parts = partsFor(*members);
                m_groups[i].members = std::move(*members);
            }
        }
    });
    const std::size_t before = m_groups.size();
    for (std::size_t i = 0; i < before; ++i) {
        divide(i, next[i].parts);
    }
    next.resize(m_groups.size());
    std::for_each(next.begin() + static_cast<std::ptrdiff_t>(before), next.end(), [](Next& added) { added.changed = true; });
    world.onThreads(m_groups.size(), groupGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            Group& group = m_groups[i];
            if (next[i].changed) {
                next[i].shape = reshape(group, *from);
            }
            if (next[i].changed ? next[i].shape.has_value() : group.piece.has_value()) {
                next[i].finish = follow(group, *from, *to);
            }
        }
    });

    for (std::size_t i = 0; i < m_groups.size(); ++i) {
        Group& group = m_groups[i];
        if (next[i].changed) {
            replace(world, group, next[i].shape);
        }
        if (next[i].finish && travel(group.box, group.pose, *next[i].finish) > pieceStillTravel) {
            group.start = group.pose;
            group.finish = *next[i].finish;
            m_moving.push_back(&group);
        }
    }
}

void Pieces::standAt(RigidWorld& world, std::size_t k) {
    m_moving.clear();
    const std::shared_ptr<const FeState> state = m_fe.state(k);
    for (std::size_t i = 0; i < m_groups.size(); ++i) {
        Group& group = m_groups[i];
        group.members.clear();
        std::copy_if(group.elements.begin(), group.elements.end(), std::back_inserter(group.members),
                     [&](ElementIndex e) { return m_activity.active(k, e); });
        divide(i, partsFor(group.members));
        rebuild(world, m_groups[i], *state);
    }
}

void Pieces::release(RigidWorld& world, const std::vector<bool>& gone, std::size_t k) {
    m_moving.clear();
    if (m_gone.empty()) {
        m_gone = gone;
    }
    for (std::size_t i = 0; i < gone.size(); ++i) {
        m_gone[i] = m_gone[i] || gone[i];
    }
    const std::shared_ptr<const FeState> state = m_fe.state(k);
    const std::size_t before = m_groups.size();
    for (std::size_t i = 0; i < m_groups.size(); ++i) {
        const bool changed = std::erase_if(m_groups[i].members, [&](ElementIndex e) { return gone[at(e)]; }) > 0;
        if (changed) {
            divide(i, partsFor(m_groups[i].members));
        }
        if (changed || i >= before) {
            rebuild(world, m_groups[i], *state);
        }
    }
}

void Pieces::keep(Archive& archive) {
    // Groups are only ever added.
    const std::size_t groups = archive.count(m_groups.size());
    if (groups < m_groups.size()) {
        Archive::fail();
    }
    m_groups.resize(groups);
    for (Group& group : m_groups) {
        archive(group);
    }
    m_moving.resize(archive.count(m_moving.size()));
    for (Group*& moving : m_moving) {
        auto index = static_cast<std::size_t>(archive.reading() ? 0 : moving - m_groups.data());
        archive(index);
        if (index >= groups || !m_groups[index].piece) {
            Archive::fail();
        }
        moving = &m_groups[index];
    }
    archive(m_present, m_gone);
}

void Pieces::moveTo(RigidWorld& world, double share) {
    for (Group* group : m_moving) {
        group->pose = {group->start.position + share * (group->finish.position - group->start.position),
                       turnBetween(group->start.orientation, share, group->finish.orientation)};
        if (share >= 1.0) {
            group->pose = group->finish;
        }
        world.movePiece(*group->piece, group->pose);
    }
}

}  // namespace rubble
