#pragma once

#include <optional>
#include <vector>

#include "core/base/standard_gravity.h"
#include "core/simulation/effects/decisions.h"

namespace rubble {

/// What limits a fall.
struct FallLimits {
    double gravity = standardGravity;  ///< m/s2
    std::optional<double> surface;     ///< m, the lowest place that anything can fall to; unset: there is no ground
    double end = 0.0;                  ///< s, nothing moves after that
};

/// Where a cluster can get without touching anything, and how fast.
struct Reach {
    Aabb box;            ///< m, at its hand-over and all the way down; empty if its place is no number
    double speed = 0.0;  ///< m/s, the highest possible
    double fall = 0.0;   ///< m, from its centre to the surface
};

/// The ballistic envelope of a box launched at speed v in any direction from height h of its centre above the surface:
/// v / g sqrt(v^2 + 2 g h) sideways, v^2 / (2 g) upwards, the surface downwards; speed sqrt(v^2 + 2 g h). Without ground or
/// gravity, what the time allows.
/// @param v         m/s
/// @param duration  s, of the flight at most
Reach launched(const Aabb& box, double v, double centreHeight, double duration, const FallLimits& limits);

/// That of a cluster from its hand-over on.
Reach reachOf(const EffectScene& scene, ClusterId cluster, const FallLimits& limits);

/// One for each cluster.
std::vector<Reach> reaches(const EffectScene& scene, const FallLimits& limits);

}  // namespace rubble
