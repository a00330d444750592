#include "core/base/normal_distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rubble {
namespace {

TEST(NormalDistribution, PlacesAreThoseOfTables) {
    EXPECT_NEAR(normalPlaceAbove(0.5), 0.0, 1e-12);
    EXPECT_NEAR(normalPlaceAbove(0.025), 1.959963984540054, 1e-12);
    EXPECT_NEAR(normalPlaceAbove(0.975), -1.959963984540054, 1e-12);
    EXPECT_NEAR(normalPlaceAbove(0.0013498980316300946), 3.0, 1e-12);
    // Far out a share is known to as many digits as in the middle.
    for (double x = 0.0; x < 9.0; x += 0.01) {
        EXPECT_NEAR(normalPlaceAbove(normalShareAbove(x)), x, 1e-12);
    }
}

TEST(NormalDistribution, WhatIsCutHasItsSharesBetweenItsEnds) {
    const double none = std::numeric_limits<double>::infinity();
    EXPECT_NEAR(cutNormalPlace(-none, none, 0.975), 1.959963984540054, 1e-12);
    EXPECT_NEAR(cutNormalPlace(0.0, none, 0.5), 0.674489750196082, 1e-12);
    EXPECT_NEAR(cutNormalPlace(-none, 0.0, 0.5), -0.674489750196082, 1e-12);
    for (const double end : {1e-4, 0.5, 3.0, 7.0}) {
        for (double share = 0.001; share < 1.0; share += 0.001) {
            const double place = cutNormalPlace(-end, 2.0 * end, share);
            ASSERT_GE(place, -end);
            ASSERT_LE(place, 2.0 * end);
            const double whole = normalShareAbove(-end) - normalShareAbove(2.0 * end);
            ASSERT_NEAR((normalShareAbove(-end) - normalShareAbove(place)) / whole, share, 1e-9) << end;
        }
    }
}

}  // namespace
}  // namespace rubble
