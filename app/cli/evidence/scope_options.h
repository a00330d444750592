#pragma once

#include "app/cli/frame/arguments.h"
#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/fe/frame.h"
#include "core/scenario/site.h"
#include "core/scenario/survey_scope.h"

namespace rubble::cli {

/// The options --area and --leave-out.
Option areaOption();
Option leaveOutOption();
/// What their files say that is compared. What reading them found is added to the findings. Throws as readScope().
SurveyScope scopeFrom(const Arguments& arguments, const Frame& frame, const Site& site, Findings& findings,
                      const Execution& execution);

}  // namespace rubble::cli
