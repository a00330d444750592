#pragma once

#include <cstddef>
#include <optional>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/fe/loose_structure.h"
#include "core/pipeline/pipeline.h"

namespace rubble {

/// What the engine will move beside the fragments (setting loose_structure), where that is most; nothing where the FE result moves
/// it, and where nothing comes loose that lives on. Reads each FE state once. Throws Cancelled.
std::optional<LooseAtOnce> looseBeside(const Inputs& inputs, const Scenario& scenario, const Execution& execution);

/// That the bodies that a live frame rate allows, and the rate within reach, are those of fragments alone (Sizing).
/// @param fpsTarget  frames per second
/// @param elements   of the model
Finding looseBesideCaution(double fpsTarget, const LooseAtOnce& beside, std::size_t elements);

/// The same after a run, with what it came to; nothing where the engine moved no loose structure.
std::optional<Finding> looseBesideCaution(double fpsTarget, const SimulationResult& run, std::size_t elements);

}  // namespace rubble
