#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/clusters/rigid_motion.h"

namespace rubble {

/// Splits a set until the velocity of every fragment's centre departs by at most `tolerance` from the rigid motion of the cluster
/// that it ends up in (joinRigidly of that cluster).
///
/// While the worst misfit of a set exceeds the tolerance, the fragments whose misfit exceeds both the tolerance and half the worst
/// leave together, and the motion of the rest is taken anew. Where all would leave (two halves flying apart), those stay whose
/// velocity is within the tolerance of the fragment with the least misfit (the first on a tie). What stays is one cluster; what
/// left is then treated as a set of its own. Half the worst, and not all above the tolerance: one stray fragment pulls the motion
/// of its cluster, and its neighbours must not leave for that.
/// @param members  fragment indices, ascending; reordered cluster by cluster, ascending within each
/// @param sizes    the sizes of the clusters are appended
void splitByVelocity(std::span<const MovingMass> all, double tolerance, std::span<std::uint32_t> members,
                     std::vector<std::uint32_t>& sizes);

}  // namespace rubble
