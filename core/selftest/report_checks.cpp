#include "core/selftest/report_checks.h"

namespace rubble::selftest {

std::vector<ReportCheck> reportChecks(const std::vector<CaseResult>& results) {
    std::vector<ReportCheck> checks;
    for (const CaseResult& result : results) {
        if (!result.finished) {
            continue;
        }
        ReportCheck check;
        check.id = result.hardCase->id;
        check.title = result.hardCase->title;
        check.criterion = result.hardCase->criterion;
        check.passed = result.pass();
        if (const Check* governing = result.outcome.governing()) {
            check.measured = governing->measured;
            check.limit = governing->limit;
            check.unit = governing->unit;
        }
        checks.push_back(std::move(check));
    }
    return checks;
}

}  // namespace rubble::selftest
