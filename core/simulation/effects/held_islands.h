#pragma once

#include <optional>

#include "core/base/finding.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// What live_islands=held does not hold: islands that the engine carries already. Nothing where the engine carries none.
/// @param settled  scenario as a run takes it (settledScenario()), or before that is known as it was asked for
std::optional<Finding> notHeld(const Scenario& settled);

}  // namespace rubble
