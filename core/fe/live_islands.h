#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/fe/activity.h"
#include "core/fe/fe_result.h"
#include "core/fe/site_surface.h"

namespace rubble {

/// m/s. What is faster moves; differences of coordinates that are rounded to 1 mm say as much as 0.05 m/s of a node that stands.
constexpr double movingSpeed = 0.1;

/// Elements that are alive at one FE state and hang together by shared nodes.
struct LiveIsland {
    std::vector<ElementIndex> elements;  ///< ascending
    bool supported = false;              ///< has a path to a support
};

/// Places and velocities of the nodes at one FE state: velocities of the file, or else the difference to the state before it; at
/// rest at the first state.
class NodeState {
public:
    NodeState(const FeResult& fe, std::size_t state);

    const Vec3& place(std::uint32_t node) const { return m_now->positions[node]; }  ///< m
    Vec3 velocity(std::uint32_t node) const;                                        ///< m/s
    double centreSpeed(ElementIndex e) const;                                       ///< m/s, of the mean of the corners

private:
    const Mesh& m_mesh;
    std::shared_ptr<const FeState> m_now;
    std::shared_ptr<const FeState> m_before;
};

/// How the ground that carries the structure has moved, as an earthquake moves it.
struct BaseMotion {
    Vec3 displacement = Vec3::Zero();  ///< m, from where it is at the last state
    Vec3 velocity = Vec3::Zero();      ///< m/s
};

/// Which elements hold up what is joined to them. An element is held by a face (three corners; two of a shell, one of a beam) that
/// stands still (slower than 0.1 m/s) where it was at rest (within 0.01 m), or that stood on the ground at rest and still does
/// (within 0.05 m of it, moved along it by less than 0.5 m, slower than 0.1 m/s). What fell and lies on the ground is not held:
/// nothing but its weight and friction keeps it there. What is held by contact or by ties without shared nodes alone, and has
/// moved, counts as loose; files do not name such joints. At states before the last one all of this is told relative to the base:
/// the corners that are held at the last state and move together.
class Supports {
public:
    /// Reads the last FE state, the one before it where the file has no velocities, and others as held() is asked for them.
    /// @param activity  under the revival policy; all must outlive this object
    Supports(const FeResult& fe, const Activity& activity, const SiteSurface& ground);

    /// The median motion of the base at a state; none at the last state, and where nothing is held there.
    BaseMotion base(const NodeState& nodes, std::size_t state) const;
    bool held(ElementIndex element, const NodeState& nodes, const BaseMotion& base) const;

private:
    const FeResult& m_fe;
    const Mesh& m_mesh;
    const SiteSurface& m_ground;
    std::vector<std::uint32_t> m_base;  ///< nodes, ascending
    std::vector<Vec3> m_last;           ///< m, their places at the last state
};

/// The islands of the last FE state, in the order of their first elements.
/// @param activity  under the revival policy
std::vector<LiveIsland> liveIslands(const FeResult& fe, const Activity& activity, const SiteSurface& ground);

/// A disjoint-set forest over nodes: which hang together by the elements that were added.
class NodeGroups {
public:
    explicit NodeGroups(std::size_t nodes);

    void join(std::span<const std::uint32_t> corners);
    std::uint32_t rootOf(std::uint32_t node);

private:
    std::vector<std::uint32_t> m_parent;
};

/// The parts of a set of elements that hang together by shared nodes, in the order of their first elements.
/// @param elements  ascending
std::vector<std::vector<ElementIndex>> partsOf(const Mesh& mesh, std::span<const ElementIndex> elements);

/// The islands of one state by groups of nodes that its active elements have joined, in the order of their first elements.
std::vector<LiveIsland> islandsAt(const FeResult& fe, const Activity& activity, const Supports& supports, NodeGroups& groups,
                                  std::size_t state);

}  // namespace rubble
