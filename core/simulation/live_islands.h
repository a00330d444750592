#pragma once

#include "core/fe/activity.h"
#include "core/fe/components.h"
#include "core/fe/fe_result.h"
#include "core/simulation/simulation.h"

namespace rubble {

/// Islands of live elements without a path to a support, at the last FE state. Elements hang together by shared nodes. An island is
/// supported when a node of it touches the ground (closer than 0.05 m) or has not moved from its place at rest (by less than
/// 0.01 m): that is where a model is held. An element counts as moving when its centre is faster than 0.1 m/s, by the file's
/// velocities or else by the difference of the last two states.
LiveIslands countLiveIslands(const FeResult& fe, const Components& components, const Activity& activity, bool ground,
                             double groundHeight);

}  // namespace rubble
