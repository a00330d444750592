#pragma once

#include "core/base/execution.h"
#include "core/evidence/ensembles/cause_comparison.h"
#include "core/fe/site_surface.h"
#include "core/scenario/case.h"
#include "io/site/survey_file.h"

namespace rubble::io {

/// Lays a survey on the cells that hypotheses are mapped on, by the rule of surveyedOn(). An outline covers a cell if half of it
/// lies within. Of heights a cell has the mean above the ground; where more than half of it has none it was not looked at. Less
/// than 5 cm is no debris, but for a map of our own.
/// @param stated  what the case says of the survey: noise, and the scope outside of which nothing was looked at
/// @param cell    m, of the ensembles
/// Throws ParseError (covers no cell, shows no debris), UsageError (too many cells), Cancelled.
SurfaceEvidence surfaceEvidence(const SurveyInput& input, const CaseInput& stated, double cell, const SiteSurface& ground,
                                const Execution& execution);

}  // namespace rubble::io
