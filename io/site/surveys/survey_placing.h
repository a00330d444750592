#pragma once

#include "core/evidence/surveys/survey.h"
#include "core/scenario/registration.h"
#include "io/site/survey_file.h"

namespace rubble::io {

/// Moves a survey that was read to where a case says that it lies, and says so. Heights of a raster are kept: its nodes are moved,
/// in plan as its mean height is and in height each by itself. What a tilt moves nodes besides is a finding with its size. Throws
/// UsageError for heights above the ground, which belong to no place by themselves.
void placeSurvey(SurveyInput& input, const Registration& registration);

/// Says how well a file lies in the case: what it was placed by, and what is left.
void addPlacedFinding(Findings& findings, const std::string& path, const Registration& registration);

}  // namespace rubble::io
