#pragma once

#include <optional>
#include <vector>

#include "core/base/finding.h"
#include "core/engine/world/rigid_world.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// Bodies that entered at one FE state, for the trajectory and the ledger.
struct HandOver {
    std::vector<BodyRecord> bodies;
    std::vector<Carrier> carriers;
    std::vector<ClusterId> clusters;  ///< of the bodies, in the same order
};

/// A cluster as the engine takes it, or nothing if its mass, inertia, place or velocity is no number or not positive: such a
/// cluster is refused and counted by handOver(), never repaired.
std::optional<NewBody> bodyOf(const RunDescription& description, ClusterId cluster);

/// A fragment as a body of its own at its hand-over; nothing where bodyOf() would refuse it.
std::optional<NewBody> bodyOfFragment(const RunDescription& description, FragmentId fragment);

/// Puts the clusters [first, last) into the world in id order.
HandOver handOver(const RunDescription& description, std::size_t first, std::size_t last, RigidWorld& world, Findings& findings);

}  // namespace rubble
