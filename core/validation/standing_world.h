#pragma once

#include <memory>
#include <vector>

#include "core/base/execution.h"
#include "core/engine/world/rigid_world.h"

namespace rubble {

/// A world for blocks that stand or fall, without ground, with the rules that a collapse takes by default, so that what is found
/// holds there. Its other rules find nothing here: no block is born in another, and none has contacts enough to be split.
std::unique_ptr<RigidWorld> standingWorld(double friction, const Execution& execution);

/// Whether all bodies stay within `moved` of their places for so long. @param places  m, [body]. @param moved  m, below it
/// Throws Cancelled.
bool staysInPlace(RigidWorld& world, const std::vector<Vec3>& places, double moved, double seconds, double stepRate,
                  const Execution& execution);

}  // namespace rubble
