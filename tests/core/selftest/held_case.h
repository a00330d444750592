#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/selftest/suite.h"

namespace rubble::selftest {

/// The cases of the suite that users run, apart by the time that they take: up to so many seconds, or more.
std::vector<const HardCase*> casesWithin(double seconds);
std::vector<const HardCase*> casesBeyond(double seconds);
/// What parts the two files of cases.
inline constexpr double longCase = 5.0;

/// Runs a case and expects all of its checks to hold. The long ones run in a smaller size with the same criteria; `./run test all`
/// and `rubble-cli self-test` run the full size.
void expectHeld(const HardCase& hardCase);

/// "form-column-axis": FormColumnAxis.
std::string nameOf(const testing::TestParamInfo<const HardCase*>& info);

}  // namespace rubble::selftest
