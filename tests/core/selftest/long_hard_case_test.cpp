#include "tests/core/selftest/held_case.h"

namespace rubble::selftest {
namespace {

// Piles, shafts and columns: too long for sanitizers, whose preset leaves this file out.
class LongHardCases : public testing::TestWithParam<const HardCase*> {};

TEST_P(LongHardCases, HoldItsCriterion) {
    expectHeld(*GetParam());
}

INSTANTIATE_TEST_SUITE_P(SelfTest, LongHardCases, testing::ValuesIn(casesBeyond(longCase)), nameOf);

}  // namespace
}  // namespace rubble::selftest
