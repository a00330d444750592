#pragma once

#include <optional>
#include <vector>

#include "core/clusters/rigid_motion.h"
#include "core/engine/world/rigid_world.h"
#include "core/fe/live_islands.h"
#include "core/fragments/corner_motion.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// An island of live structure at the last FE state, as one rigid body.
struct IslandBody {
    std::vector<ElementIndex> elements;  ///< ascending
    MovingMass motion;                   ///< mass, momentum and angular momentum of all elements
    Momenta fe;                          ///< of the elements by quadrature of the nodal velocity field
    Momenta rigid;                       ///< of the elements as rigid solids
    double volume = 0.0;                 ///< m3, at rest
    ComponentId component{};             ///< that most of this volume belongs to
    std::vector<OrientedBox> boxes;      ///< around each element
    CollisionShape shape;                ///< in the frame of the body
    Pose pose;                           ///< of centre of mass and principal axes
    Vec3 inertia = Vec3::Zero();         ///< kg m2, principal
};

/// Makes rigid bodies of islands: mass, inertia, velocity and spin by the quadrature and the rigid fit that fragments are made by,
/// joined with momentum and angular momentum conserved; velocities from the file, or else from differences of positions at the last
/// three states; at rest where bodies are born at rest by setting. The collision shape is a compound of boxes, as of the pieces:
/// one around the elements of each component in each cell of a grid at rest (piece_size, doubled until there are at most 64).
class IslandMaker {
public:
    /// Reads the last three FE states at most.
    /// @param activity  under the revival policy; must outlive the maker
    /// @param islands   those that make() will be asked for
    IslandMaker(const RunDescription& description, const Activity& activity, std::span<const LiveIsland> islands);

    /// Nothing if a corner has no finite place, if no element has mass, or if the numbers overflow: such an island is counted as a
    /// finding and held.
    std::optional<IslandBody> make(const LiveIsland& island, Findings& findings);

private:
    struct Part;
    Lifetime lifeOf(ElementIndex element) const;
    bool addElement(ElementIndex element, IslandBody& body, std::vector<Part>& parts, std::vector<MovingMass>& masses);
    void giveShape(IslandBody& body, const std::vector<Part>& parts) const;

    const RunDescription& m_description;
    const Activity& m_activity;
    CornerMotionReader m_motion;
    std::uint32_t m_last;
    std::size_t m_withoutVelocity = 0;
};

NewBody newBody(const IslandBody& island, const Components& components);

}  // namespace rubble
