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

/// The same change of a keyed setting for several subjects, told once.
struct SharedDifference {
    SettingDifference change;           ///< of the first of them
    std::vector<std::string> subjects;  ///< one empty name for a row that is not keyed

    /// "component[*].material (22)" for several, else the key itself.
    std::string key() const;
};

/// Differences in their order, those of one row with equal values on both sides joined.
std::vector<SharedDifference> sharedDifferences(const std::vector<SettingDifference>& differences);

}  // namespace rubble
