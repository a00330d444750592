#include "core/analysis/accuracy/interval_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/core/analysis/random_numbers.h"

namespace rubble {
namespace {

// Values of Student's distribution in closed form: one degree of freedom is Cauchy's, two have a root (Abramowitz & Stegun 26.7.3).
TEST(IntervalFit, StudentAgreesWithClosedForms) {
    for (const double t : {-8.0, -1.5, -0.2, 0.0, 0.3, 1.0, 4.0, 60.0}) {
        EXPECT_NEAR(studentBelow(t, 1.0), 0.5 + std::atan(t) / std::numbers::pi, 1e-12) << t;
        EXPECT_NEAR(studentBelow(t, 2.0), 0.5 + t / (2.0 * std::sqrt(2.0 + t * t)), 1e-12) << t;
        // With many degrees it is the normal one; the difference is of the order of 1 / degrees.
        EXPECT_NEAR(studentBelow(t, 1e6), 0.5 * std::erfc(-t / std::numbers::sqrt2), 1e-6) << t;
    }
}

TEST(IntervalFit, StudentQuantilesHoldWhatTheNormalOnesDo) {
    for (const double degrees : {3.0, 4.0, 5.5, 9.0, 30.0, 1e6}) {
        EXPECT_NEAR(studentBelow(studentQuantile(1.959964, degrees), degrees), 0.975, 1e-4) << degrees;
        EXPECT_NEAR(studentBelow(studentQuantile(-1.281552, degrees), degrees), 0.1, 1e-4) << degrees;
    }
}

/// Share of further samples within the 80 % interval, over many fits to n samples of a curve with a known scatter.
double coverage(const std::function<double(double)>& curve, std::size_t n, double scatter, std::uint64_t seed) {
    RandomNumbers random(seed);
    int held = 0;
    constexpr int fits = 300;
    for (int k = 0; k < fits; ++k) {
        std::vector<FitSample> samples;
        for (std::size_t i = 0; i < n; ++i) {
            const double x = random.between(0.0, 3.0);
            samples.push_back({{x}, curve(x) + scatter * random.normal()});
        }
        const double x = random.between(0.2, 2.8);
        const FitInterval found = IntervalFit(samples, 0.1).predict({x}, 0.8);
        const double further = curve(x) + scatter * random.normal();
        held += further >= found.low && further <= found.high;
    }
    return static_cast<double>(held) / fits;
}

// 300 draws of a chance of 0.8 scatter by 0.023: four of these and a little for the model itself.
TEST(IntervalFit, HoldsWhatItPromisesOnDataOfKnownScatter) {
    const auto line = [](double x) { return 1.0 - 0.7 * x; };
    const auto bent = [](double x) { return std::sin(1.3 * x); };
    EXPECT_NEAR(coverage(line, 6, 0.1, 1), 0.8, 0.1);
    EXPECT_NEAR(coverage(line, 10, 0.2, 2), 0.8, 0.1);
    EXPECT_NEAR(coverage(line, 20, 0.05, 3), 0.8, 0.1);
    EXPECT_NEAR(coverage(bent, 12, 0.1, 4), 0.8, 0.1);
}

TEST(IntervalFit, IsSurerWithMoreSamplesAndLessSureFurtherAway) {
    const auto width = [](std::size_t n, double x) {
        RandomNumbers random(7);
        std::vector<FitSample> samples;
        for (std::size_t i = 0; i < n; ++i) {
            const double at = static_cast<double>(i) / static_cast<double>(n - 1);
            samples.push_back({{at}, 2.0 * at + 0.1 * random.normal()});
        }
        const FitInterval found = IntervalFit(samples, 0.1).predict({x}, 0.8);
        EXPECT_LT(found.low, found.value);
        EXPECT_LT(found.value, found.high);
        return found.high - found.low;
    };
    EXPECT_LT(width(20, 0.5), width(4, 0.5));
    EXPECT_GT(width(8, 3.0), 2.0 * width(8, 0.5));
}

TEST(IntervalFit, FollowsALineExactlyWhereNothingScatters) {
    std::vector<FitSample> samples;
    for (int i = 0; i < 8; ++i) {
        samples.push_back({{1.0 * i, 5.0}, 3.0 - 0.5 * i});
    }
    // The second coordinate never varies and plays no part. The prior of scatter is all that keeps the interval open.
    const FitInterval found = IntervalFit(samples, 0.01).predict({3.5, 5.0}, 0.8);
    EXPECT_NEAR(found.value, 3.0 - 0.5 * 3.5, 1e-3);
    EXPECT_LT(found.high - found.low, 0.05);
}

TEST(IntervalFit, CoordinatesThatChangeTogetherDoNoHarm) {
    std::vector<FitSample> samples;
    for (int i = 0; i < 8; ++i) {
        samples.push_back({{1.0 * i, 2.0 * i}, 1.0 * i});
    }
    const FitInterval found = IntervalFit(samples, 0.1).predict({3.5, 7.0}, 0.8);
    EXPECT_NEAR(found.value, 3.5, 0.1);
}

}  // namespace
}  // namespace rubble
