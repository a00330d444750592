#pragma once

#include <span>

#include "core/fe/components.h"
#include "core/fe/live_islands.h"
#include "core/simulation/bodies/run_account.h"

namespace rubble {

/// Counts islands of the last FE state without a path to a support; none released. An element counts as moving when its centre is
/// faster than 0.1 m/s, by the file's velocities or else by the difference of the last two states.
LiveIslands countLoose(const FeResult& fe, const Components& components, std::span<const LiveIsland> islands);

}  // namespace rubble
