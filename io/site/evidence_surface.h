#pragma once

#include "core/base/execution.h"
#include "core/evidence/ensembles/cause_comparison.h"
#include "core/fe/site_surface.h"
#include "core/scenario/survey_scope.h"
#include "io/site/survey_file.h"

namespace rubble::io {

/// Lays a survey on the cells that hypotheses are mapped on. Of an outline a cell is covered if its middle is. Of heights a cell
/// has the mean above the ground of four by four points; where more than half of these have none it was not looked at. Less than 5
/// cm is no debris, but for a map of our own.
/// @param scope  what counts; nothing else was looked at
/// @param cell   m, of the ensembles
/// Throws ParseError (covers no cell, shows no debris), UsageError (too many cells), Cancelled.
SurfaceEvidence surfaceEvidence(const SurveyInput& input, const SurveyScope& scope, double cell, const SiteSurface& ground,
                                const Execution& execution);

}  // namespace rubble::io
