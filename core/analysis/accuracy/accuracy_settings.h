#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/scenario/scenario.h"

namespace rubble {

// Rows of a sweep that are no setting of the user's.
inline constexpr std::string_view referenceSetting = "reference";  ///< a body per fragment
inline constexpr std::string_view floorSetting = "floor";          ///< how far the reference repeats
inline constexpr std::string_view paperSetting = "paper";          ///< the published method as printed

/// Multiples of the mean distance that a sweep has where nobody says which.
std::vector<std::string> usualMultiples();

/// One row of a sweep: a scenario and what to call it.
struct AccuracySetting {
    std::string name;  ///< "multiple=2 cluster_shape=hull": what departs from the subject's scenario
    Scenario scenario;
};

/// A parameter and the values that a sweep gives it, as text of the command line.
struct VariedParameter {
    std::string key;
    std::vector<std::string> values;
};

/// Every combination of the multiples and of all values of the varied parameters, the last one changing fastest, and the preset
/// "paper" as the last row. A multiple takes the place of sizes set by hand and of one body per fragment; "auto" is the search.
/// @param multiples  of the mean distance, as text; empty: the grid is that of the scenario
/// Throws UsageError for a value that its parameter refuses, for a key that says what is simulated rather than how (import,
/// components, fragments; gravity and what else describes the scene), for a key or value given twice and for more than 1,000 rows.
std::vector<AccuracySetting> sweepSettings(const Scenario& scenario, std::span<const std::string> multiples,
                                           std::span<const VariedParameter> varied);

/// The scenario of the reference run (DESIGN.md 2.6): the same scene, each fragment a body with an oriented box, our own method.
Scenario referenceScenario(const Scenario& scenario);
/// The published method as printed, on the same scene.
Scenario paperScenario(const Scenario& scenario);

}  // namespace rubble
