#pragma once

#include "core/evidence/surveys/survey_comparison.h"

namespace rubble {

/// The shift of least squares that brings a survey to the ground, or to the debris. See SurveyFit.
/// @param debris    heights of the debris on the grid
/// @param compared  [cells] 1: belongs to the comparison; ground beside the debris counts beyond them too, unless it is left out
/// Throws UsageError where nothing in common is left to fit to; Cancelled.
SurveyShift registered(const CellGrid& debris, const std::vector<std::uint8_t>& compared, const Survey& survey,
                       const SiteSurface& ground, const SurveySettings& settings, const Execution& execution);

}  // namespace rubble
