#pragma once

#include "core/scenario/scenario.h"

namespace rubble {

/// The scenario with one more regrouping step. What the user said about components that the step renames goes with them; what was
/// said about components that the step dissolves is dropped, unless all of a merge agree.
Scenario withRegrouping(const Scenario& scenario, const RegroupStep& step);
/// The scenario with the parts of the file as components; settings of components that only regrouping made are dropped.
/// @param parts  names of the parts of the file
Scenario withoutRegrouping(const Scenario& scenario, const std::vector<std::string>& parts);

}  // namespace rubble
