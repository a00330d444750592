#pragma once

#include <string>

#include "core/base/finding.h"
#include "core/evidence/surveys/survey_comparison.h"
#include "core/scenario/case.h"

namespace rubble {

/// Date and time as a person may write them, "2021-06-25 16:30" or "2021-06-25T16:30:00", as clockTime() gives them; empty if that
/// is no time. The clock is that of the site for everything in a case.
std::string clockTimeFrom(const std::string& text);

/// What of a survey is compared, if it is held against debris at rest or in motion: its scope, without the places whose debris had
/// been removed when it was taken. Removals that may or may not have been done by then are a finding.
SurveyScope scopeWhenTaken(const Case& theCase, const CaseInput& survey, Findings& findings);

/// What surveys of a case are compared with, where nothing else is asked for.
SurveySettings surveySettingsOf(const Case& theCase);

/// Takes what the case says of a survey where nothing else was asked for: what it shows, noise, errors, and what is compared. The
/// error of its registration stands for that of an offset that nobody stated.
void takeStated(SurveySettings& settings, const Case& theCase, const CaseInput& survey, Findings& findings);

/// Throws UsageError for a survey of before the collapse and for points that are held as control, which show no debris.
void checkShowsDebris(const CaseInput& survey);
/// Throws UsageError for a survey of an instant of the collapse: members of an ensemble are held against what lies at rest.
void checkShowsRest(const CaseInput& survey);

}  // namespace rubble
