#pragma once

#include <string>
#include <vector>

#include "core/scenario/parameters.h"

namespace rubble {

/// A setting in which two scenarios differ.
struct SettingDifference {
    const Parameter* row = nullptr;
    std::string subject;  ///< what stands in the brackets of a keyed row
    ParameterValue first;
    ParameterValue second;
};

/// All of them, in the order of the parameter table; regrouping steps are no settings, compare `regrouping` for them.
std::vector<SettingDifference> differencesBetween(const Scenario& first, const Scenario& second);

}  // namespace rubble
