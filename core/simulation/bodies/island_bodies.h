#pragma once

#include <optional>
#include <vector>

#include "core/clusters/rigid_motion.h"
#include "core/engine/world/rigid_world.h"
#include "core/fe/live_islands.h"
#include "core/fragments/corner_motion.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// An element of an island at the FE state at which it becomes a body.
struct IslandElement {
    ElementIndex element{};
    ComponentId component{};
    MovingMass motion;         ///< mass 0: it weighs nothing and goes along
    Vec3 rest = Vec3::Zero();  ///< m, its centre at rest
    OrientedBox box;           ///< around it
    ElementShape solid = ElementShape::Hexahedron;
    std::vector<Vec3> vertices;  ///< m, of its solid
};

/// An island of live structure at one FE state, as one rigid body.
struct IslandBody {
    std::vector<ElementIndex> elements;  ///< ascending
    std::vector<IslandElement> parts;    ///< the same, in their order
    MovingMass motion;                   ///< mass, momentum and angular momentum of all elements
    Momenta fe;                          ///< of the elements by quadrature of the nodal velocity field
    Momenta rigid;                       ///< of the elements as rigid solids
    double volume = 0.0;                 ///< m3, at rest
    ComponentId component{};             ///< that most of this volume belongs to
    CollisionShape shape;                ///< in the frame of the body
    Pose pose;                           ///< of centre of mass and principal axes
    Vec3 inertia = Vec3::Zero();         ///< kg m2, principal
};

/// Makes rigid bodies of islands: mass, inertia, velocity and spin by the quadrature and the rigid fit that fragments are made by,
/// joined with momentum and angular momentum conserved; velocities from the file, or else from differences of positions at the last
/// three states; at rest where bodies are born at rest by setting. The collision shape is a compound of boxes: joined bricks where
/// clusters are made of them, else as of the pieces one around the elements of each component in each cell of a grid at rest
/// (piece_size, doubled until there are at most 64).
class IslandMaker {
public:
    /// Reads three FE states at most.
    /// @param activity  under the revival policy; must outlive the maker
    /// @param islands   those that make() will be asked for
    /// @param state     at which they become bodies
    IslandMaker(const RunDescription& description, const Activity& activity, std::span<const LiveIsland> islands,
                std::size_t state);

    /// Nothing if a corner has no finite place, if no element has mass, or if the numbers overflow: such an island is counted as a
    /// finding and held.
    std::optional<IslandBody> make(const LiveIsland& island, Findings& findings);

private:
    Lifetime lifeOf(ElementIndex element) const;
    bool addElement(ElementIndex element, IslandBody& body);

    const RunDescription& m_description;
    const Activity& m_activity;
    CornerMotionReader m_motion;
    std::uint32_t m_state;
    std::size_t m_withoutVelocity = 0;
};

/// A body of the elements in `parts`: mass properties, frame and shape; false if it has no mass, or none to turn.
bool giveBody(IslandBody& body, const RunDescription& description);

NewBody newBody(const IslandBody& island, const RunDescription& description);

}  // namespace rubble
