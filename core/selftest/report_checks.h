#pragma once

#include <vector>

#include "core/evidence/report_facts.h"
#include "core/selftest/suite.h"

namespace rubble::selftest {

/// What a report says of cases that were run, those that were finished.
std::vector<ReportCheck> reportChecks(const std::vector<CaseResult>& results);

}  // namespace rubble::selftest
