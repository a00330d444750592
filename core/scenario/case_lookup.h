#pragma once

#include <optional>
#include <string>

#include "core/scenario/case.h"

namespace rubble {

/// The scenario with this id or, if none has it, with this name; null if there is none.
/// @param wanted  unset: the one that is worked on, else the first
const CaseScenario* findScenario(const Case& theCase, const std::optional<std::string>& wanted);

/// The FE input that a scenario stands on: the one it names or, if it names none, the first; null if the case has no such input.
const CaseInput* findFeInput(const Case& theCase, const CaseScenario& scenario);

}  // namespace rubble
