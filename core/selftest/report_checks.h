#pragma once

#include <string>

#include "core/base/execution.h"
#include "core/evidence/report_facts.h"
#include "core/selftest/suite.h"

namespace rubble::selftest {

/// Runs the cases of a report on this machine now, and puts what came of those that were finished into its facts.
/// @param scope  as reportCases() takes it, or "none": nothing is run
/// Throws Cancelled.
void addReportChecks(ReportFacts& facts, const std::string& scope, const Execution& execution);

}  // namespace rubble::selftest
