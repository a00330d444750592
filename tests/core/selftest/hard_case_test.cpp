#include <gtest/gtest.h>

#include <cctype>
#include <string>
#include <string_view>

#include "core/selftest/suite.h"
#include "tests/support/run_tests.h"

namespace rubble::selftest {
namespace {

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

/// The suite that users run, case by case. The long ones (pile-50000, shaft-900, pile-rest-60s, form-repose, the columns) run in a
/// smaller size here, with the same criteria; `./run test all` and `rubble-cli self-test` run the full size.
class HardCases : public testing::TestWithParam<const HardCase*> {};

TEST_P(HardCases, HoldItsCriterion) {
    SuiteSettings settings;
    settings.small = !wholeTests();
    const CaseResult result = runCase(*GetParam(), settings, Execution());
    EXPECT_TRUE(result.finished);
    EXPECT_EQ(result.error, "");
    for (const Check& check : result.outcome.checks()) {
        EXPECT_TRUE(check.pass()) << check.name << ": " << check.measured
                                  << (check.bound == Bound::AtMost ? ", at most " : ", at least ") << check.limit << ' '
                                  << check.unit;
    }
    EXPECT_TRUE(result.pass());
}

INSTANTIATE_TEST_SUITE_P(SelfTest, HardCases, testing::ValuesIn(chosenCases({})), nameOf);

}  // namespace
}  // namespace rubble::selftest
