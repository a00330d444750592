#include "core/selftest/report_checks.h"

namespace rubble::selftest {

namespace {

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

}  // namespace

void addReportChecks(ReportFacts& facts, const std::string& scope, const Execution& execution) {
    if (scope == "none") {
        return;
    }
    execution.report({"report.testing", "Testing this machine", {}}, 0.5);
    const std::vector<const HardCase*> cases = reportCases(scope);
    facts.selfTest = reportChecks(runSuite(cases, {}, execution));
    execution.check();
    facts.selfTestLeft = scope == "all" ? 0 : chosenCases({scope}).size() - cases.size();
    facts.selfTestScope = scope;
}

}  // namespace rubble::selftest
