#pragma once

#include "core/evidence/surveys/survey_comparison.h"

namespace rubble {

/// The shift of least squares that brings a survey to the ground, or to the debris. See SurveyFit.
/// @param debris  heights of the debris on the grid
/// Throws UsageError where nothing in common is left to fit to; Cancelled.
SurveyShift registered(const CellGrid& debris, const Survey& survey, const SiteSurface& ground, const SurveySettings& settings,
                       const Execution& execution);

}  // namespace rubble
