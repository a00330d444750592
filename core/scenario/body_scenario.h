#pragma once

#include <vector>

#include "core/fe/loose_bodies.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// What a scenario of loose bodies begins with: a body for each element, each let go at its own time, no structure that stands
/// before, 60 s to come to rest, and the materials that the bodies name.
void prepareForBodies(Scenario& scenario, const std::vector<LooseBody>& bodies);

}  // namespace rubble
