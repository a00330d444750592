#pragma once

#include "core/pipeline/pipeline.h"

namespace rubble {

/// What decides every bit of a setting's world among those of one sweep: its clusters and what of the scenario their simulation
/// reads. A parameter that has no effect beside the others (bodies_max next to a multiple set by hand, the iterations of a solver
/// that is not used, the density of water where there is none) does not count: settings that differ in nothing else are twins, and
/// one simulation serves both.
/// @param results  up to the clusters
Digest worldBits(const Inputs& inputs, const Scenario& scenario, const Results& results);

}  // namespace rubble
