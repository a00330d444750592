#pragma once

#include "core/fe/loose_structure.h"
#include "core/pipeline/pipeline.h"

namespace rubble {

/// The ground that structure is held by, before a run has decided on it: terrain or level ground, unless they are set off.
SiteSurface groundBeforeRun(const Inputs& inputs, const Scenario& scenario);

/// The islands of an FE result as a scenario has them, whoever is to move them: those that are listed and drawn. Throws Cancelled.
LooseStructure looseScene(const Inputs& inputs, const Scenario& scenario, const Execution& execution);

}  // namespace rubble
