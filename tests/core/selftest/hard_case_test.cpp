#include "tests/core/selftest/held_case.h"

namespace rubble::selftest {
namespace {

class HardCases : public testing::TestWithParam<const HardCase*> {};

TEST_P(HardCases, HoldItsCriterion) {
    expectHeld(*GetParam());
}

INSTANTIATE_TEST_SUITE_P(SelfTest, HardCases, testing::ValuesIn(casesWithin(longCase)), nameOf);

TEST(HardCaseFiles, HoldAllCasesTogether) {
    EXPECT_EQ(casesWithin(longCase).size() + casesBeyond(longCase).size(), hardCases().size());
    EXPECT_GT(casesBeyond(longCase).size(), 3u);
}

}  // namespace
}  // namespace rubble::selftest
