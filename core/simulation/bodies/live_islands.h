#pragma once

#include <span>
#include <vector>

#include "core/fe/activity.h"
#include "core/fe/components.h"
#include "core/fe/fe_result.h"
#include "core/fe/site_surface.h"
#include "core/simulation/bodies/run_account.h"

namespace rubble {

/// Elements that are alive at the last FE state and hang together by shared nodes.
struct LiveIsland {
    std::vector<ElementIndex> elements;  ///< ascending
    bool supported = false;
};

/// The islands of the last FE state, in the order of their first elements. One has a path to a support if one of its elements is
/// held: by a face (three corners; two of a shell, one of a beam) that stands still (slower than 0.1 m/s) where it was at rest
/// (within 0.01 m), or that stood on the ground at rest and still does (within 0.05 m of it, moved along it by less than 0.5 m,
/// slower than 0.1 m/s). What fell and lies on the ground is not held: nothing but its weight and friction keeps it there. What is
/// held by contact or by ties without shared nodes alone, and has moved, counts as loose; files do not name such joints.
/// @param activity  under the revival policy
std::vector<LiveIsland> liveIslands(const FeResult& fe, const Activity& activity, const SiteSurface& ground);

/// Counts islands without a path to a support; none released. An element counts as moving when its centre is faster than 0.1 m/s,
/// by the file's velocities or else by the difference of the last two states.
LiveIslands countLoose(const FeResult& fe, const Components& components, std::span<const LiveIsland> islands);

}  // namespace rubble
