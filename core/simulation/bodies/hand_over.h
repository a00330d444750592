#pragma once

#include <optional>
#include <vector>

#include "core/base/finding.h"
#include "core/engine/world/body_shapes.h"
#include "core/engine/world/rigid_world.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// Bodies that entered at one FE state, for the trajectory and the ledger.
struct HandOver {
    std::vector<BodyRecord> bodies;
    std::vector<Carrier> carriers;
    Momenta clusters;  ///< of the clusters that the bodies carry, as they were formed
};

/// A cluster as the engine takes it, or nothing if its mass, inertia, place or velocity is no number or not positive: such a
/// cluster is refused and counted by handOver(), never repaired.
std::optional<NewBody> bodyOf(const RunDescription& description, ClusterId cluster);

/// A fragment as a body of its own at its hand-over; nothing where bodyOf() would refuse it.
std::optional<NewBody> bodyOfFragment(const RunDescription& description, FragmentId fragment);

/// Fragments that leave the body of an island: the engine has moved it, so they are elsewhere than in the FE result.
struct IslandBirth {
    Cluster cluster;     ///< mass, velocity and spin, centre and inertia in world axes
    BodyFrame frame;     ///< where the new body is
    Pose shapeFrame;     ///< where that frame lies among the places in `shapes`
    FragmentSet shapes;  ///< solids of the fragments as the island has them, in their order
    Pose feFrame;        ///< where that frame lies among the places of the FE result at the state of the birth
};

/// Who carries elements of live structure before they become fragments: by itself nobody, the FE result moves them all.
class IslandBirths {
public:
    virtual ~IslandBirths() = default;
    /// Index of the island's body that carries an element; nothing: the FE result moves it.
    virtual std::optional<std::int32_t> carrierOf(ElementIndex /*element*/) const { return std::nullopt; }
    /// Fragments whose elements one body carries; nothing if they have no mass or no finite place.
    virtual std::optional<IslandBirth> born(std::int32_t /*carrier*/, std::span<const FragmentId> /*members*/,
                                            std::size_t /*state*/, const RigidWorld& /*world*/) const {
        return std::nullopt;
    }
};

/// What entered at one FE state, by where it came from.
struct Births {
    HandOver fromFe;
    HandOver fromIslands;
};

/// Puts the clusters [first, last) into the world in id order. A cluster of which islands carry elements is parted by carriers.
Births handOver(const RunDescription& description, std::size_t first, std::size_t last, const IslandBirths& islands,
                RigidWorld& world, Findings& findings);

}  // namespace rubble
