#include "tests/core/selftest/held_case.h"

#include <algorithm>
#include <cctype>

#include "tests/support/run_tests.h"

namespace rubble::selftest {

std::vector<const HardCase*> casesWithin(double seconds) {
    std::vector<const HardCase*> cases = chosenCases({});
    std::erase_if(cases, [&](const HardCase* one) { return one->seconds > seconds; });
    return cases;
}

std::vector<const HardCase*> casesBeyond(double seconds) {
    std::vector<const HardCase*> cases = chosenCases({});
    std::erase_if(cases, [&](const HardCase* one) { return one->seconds <= seconds; });
    return cases;
}

void expectHeld(const HardCase& hardCase) {
    SuiteSettings settings;
    settings.small = !wholeTests();
    const CaseResult result = runCase(hardCase, settings, Execution());
    EXPECT_TRUE(result.finished);
    EXPECT_EQ(result.error, "");
    for (const Check& check : result.outcome.checks()) {
        EXPECT_TRUE(check.pass()) << check.name << ": " << check.measured
                                  << (check.bound == Bound::AtMost ? ", at most " : ", at least ") << check.limit << ' '
                                  << check.unit;
    }
    EXPECT_TRUE(result.pass());
}

std::string nameOf(const testing::TestParamInfo<const HardCase*>& info) {
    std::string name;
    bool upper = true;
    for (const char c : info.param->id) {
        if (c == '-') {
            upper = true;
            continue;
        }
        name += upper ? static_cast<char>(std::toupper(c)) : c;
        upper = false;
    }
    return name;
}

}  // namespace rubble::selftest
