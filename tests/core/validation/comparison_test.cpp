#include "core/validation/comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/sequence.h"

namespace rubble {

namespace {

TEST(Comparison, AreaOfAShiftedSampleIsTheShift) {
    const std::vector<double> sample{1.0, 2.0, 4.0, 8.0};
    EXPECT_DOUBLE_EQ(areaBetween(sample, sample), 0.0);
    EXPECT_DOUBLE_EQ(areaBetween(sample, {1.5, 2.5, 4.5, 8.5}), 0.5);
    // Two points against their mean: half of each moves by one.
    EXPECT_DOUBLE_EQ(areaBetween({-1.0, 1.0}, {0.0}), 1.0);
    EXPECT_TRUE(std::isnan(areaBetween(sample, {})));
}

PairedValues drawn(double shift, double scatter, std::size_t bodies, std::size_t repeats) {
    Sequence random(7);
    PairedValues values;
    for (std::size_t i = 0; i < bodies; ++i) {
        values.measured.push_back(random.between(-1.0, 1.0));
        values.simulated.emplace_back();
        for (std::size_t r = 0; r < repeats; ++r) {
            values.simulated.back().push_back(shift + scatter * random.between(-1.0, 1.0));
        }
    }
    return values;
}

TEST(Comparison, KnownDifferenceLiesInItsInterval) {
    const SampleComparison found = compareSamples(drawn(0.5, 1.0, 200, 3));
    EXPECT_LT(found.error.low, 0.5);
    EXPECT_GT(found.error.high, 0.5);
    EXPECT_GT(found.error.low, 0.2);  // and zero does not: the mean of 200 has a deviation of 0.04
    EXPECT_LT(found.scatterRatio.low, 1.0);
    EXPECT_GT(found.scatterRatio.high, 1.0);
    EXPECT_NEAR(found.area, 0.5, 0.1);
    EXPECT_GT(found.area, found.areaByChance);
}

TEST(Comparison, EqualDistributionsDifferByChanceAlone) {
    const SampleComparison found = compareSamples(drawn(0.0, 1.0, 200, 1));
    EXPECT_LT(found.error.low, 0.0);
    EXPECT_GT(found.error.high, 0.0);
    EXPECT_LT(found.area, found.areaByChance);
}

TEST(Comparison, HalfTheScatterIsSeen) {
    const SampleComparison found = compareSamples(drawn(0.0, 0.5, 200, 2));
    EXPECT_LT(found.scatterRatio.high, 0.65);
    EXPECT_GT(found.scatterRatio.low, 0.4);
}

TEST(Comparison, WhatIsLostIsCountedAndInNoMean) {
    PairedValues values = drawn(0.0, 1.0, 20, 2);
    values.simulated[3][1] = std::numeric_limits<double>::quiet_NaN();
    const SampleComparison found = compareSamples(values);
    EXPECT_EQ(found.lost, 1);
    EXPECT_EQ(found.simulated.count, 39u);
    EXPECT_TRUE(std::isfinite(found.error.value));
}

TEST(Comparison, TheSameSeedGivesTheSameInterval) {
    const PairedValues values = drawn(0.1, 1.0, 30, 2);
    EXPECT_EQ(compareSamples(values, 300, 5).error.low, compareSamples(values, 300, 5).error.low);
    EXPECT_NE(compareSamples(values, 300, 5).error.low, compareSamples(values, 300, 6).error.low);
}

}  // namespace

}  // namespace rubble
