#include "core/analysis/accuracy/accuracy_front.h"
#include <gtest/gtest.h>

#include "core/base/unknown.h"

#include <cmath>

namespace rubble {
namespace {

AccuracyPoint costing(std::int64_t bodies, double stepMs, double fps) {
    AccuracyPoint point;
    point.bodies = bodies;
    point.cost.stepMeanMs = stepMs;
    point.cost.wallSeconds = 100.0 * stepMs;
    point.cost.fps = fps;
    return point;
}

/// On the front by its definition: no other is at least as good in both and better in one; of equals the first.
bool onFront(const std::vector<CostAccuracy>& points, std::size_t i, bool moreCost, bool moreAccuracy) {
    const auto cost = [&](std::size_t k) { return moreCost ? -points[k].cost : points[k].cost; };
    const auto loss = [&](std::size_t k) { return moreAccuracy ? -points[k].accuracy : points[k].accuracy; };
    for (std::size_t k = 0; k < points.size(); ++k) {
        const bool better = cost(k) <= cost(i) && loss(k) <= loss(i) && (cost(k) < cost(i) || loss(k) < loss(i) || k < i);
        if (k != i && better) {
            return false;
        }
    }
    return true;
}

}  // namespace

TEST(AccuracyFront, HoldsWhatNoOtherBeats) {
    std::uint64_t state = 7;
    const auto next = [&state] {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>((state >> 33) % 12) + 1.0;  // few values, so that some are equal
    };
    for (int round = 0; round < 200; ++round) {
        std::vector<CostAccuracy> points;
        for (int i = 0; i < 9; ++i) {
            points.push_back({next(), next()});
        }
        for (const bool moreCost : {false, true}) {
            for (const bool moreAccuracy : {false, true}) {
                const std::vector<std::size_t> front = paretoFront(points, moreCost, moreAccuracy);
                std::vector<bool> found(points.size(), false);
                for (std::size_t k = 0; k < front.size(); ++k) {
                    found[front[k]] = true;
                    EXPECT_TRUE(k == 0 || points[front[k - 1]].cost < points[front[k]].cost);
                }
                for (std::size_t i = 0; i < points.size(); ++i) {
                    EXPECT_EQ(found[i], onFront(points, i, moreCost, moreAccuracy)) << round << ' ' << i;
                }
            }
        }
    }
}

TEST(AccuracyFront, WhatIsNoNumberIsOnNoFront) {
    const std::vector<CostAccuracy> points{{unknown, 0.9}, {1.0, unknown}, {2.0, 0.5}};
    EXPECT_EQ(paretoFront(points, false, true), (std::vector<std::size_t>{2}));
    EXPECT_TRUE(paretoFront({}, false, true).empty());
}

TEST(AccuracyFront, TheRateLiesBetweenTheSettingsThatEncloseIt) {
    AccuracyReport report;
    report.reference = costing(4000, 20.0, 12.0);
    report.points = {costing(1000, 5.0, 48.0), costing(0, unknown, 30.0), costing(500, 2.0, unknown)};
    // FPS fall as one over the cost here, so in logarithms the place is exact.
    EXPECT_NEAR(costAtRate(report, CostKind::StepMean, 24.0).value(), 10.0, 1e-12);
    EXPECT_NEAR(costAtRate(report, CostKind::Wall, 24.0).value(), 1000.0, 1e-9);
    EXPECT_EQ(costAtRate(report, CostKind::Fps, 24.0), 24.0);
    EXPECT_NEAR(costAtRate(report, CostKind::Bodies, 24.0).value(), 2000.0, 1e-9)
        << "a setting whose bodies are not known counts for none";
    EXPECT_FALSE(costAtRate(report, CostKind::StepMean, 60.0).has_value()) << "nothing is said beyond what was measured";
    EXPECT_FALSE(costAtRate(AccuracyReport(), CostKind::StepMean, 24.0).has_value());
}

TEST(AccuracyFront, SignedMeasuresAreAmountsAndRatesGoByTheirTolerance) {
    DebrisDifference difference;
    difference.of(Measure::RunOut) = -0.4;
    difference.of(Measure::CoreIou) = 0.8;
    difference.tolerances = {0.1, 0.2};
    difference.accuracy = {0.3, 0.6};
    EXPECT_EQ(accuracyOf(difference, {Measure::RunOut, std::nullopt}), 0.4);
    EXPECT_EQ(accuracyOf(difference, {Measure::CoreIou, std::nullopt}), 0.8);
    EXPECT_EQ(accuracyOf(difference, {Measure::CoreIou, 0.2}), 0.6);
    EXPECT_TRUE(std::isnan(accuracyOf(difference, {Measure::CoreIou, 0.5})));
    EXPECT_TRUE((AccuracyKind{Measure::RunOut, 0.1}.moreIsBetter()));
    EXPECT_FALSE((AccuracyKind{Measure::RunOut, std::nullopt}.moreIsBetter()));
}

TEST(AccuracyFront, TheBandReachesFromTheReferenceToTheFloor) {
    AccuracyReport report;
    const AccuracyKind core{Measure::CoreIou, std::nullopt};
    EXPECT_FALSE(floorBand(report, core).has_value());
    report.floor.emplace();
    report.floor->largest.of(Measure::CoreIou) = 0.9;
    report.floor->largest.of(Measure::RunOut) = -0.2;
    report.floor->largest.of(Measure::HeightRms) = unknown;
    EXPECT_FALSE(floorBand(report, core).has_value()) << "no repeat is there";
    report.floor->repeats.emplace_back();
    EXPECT_EQ(floorBand(report, core), std::pair(0.9, 1.0));
    EXPECT_EQ(floorBand(report, {Measure::RunOut, std::nullopt}), std::pair(0.0, 0.2));
    EXPECT_FALSE(floorBand(report, {Measure::HeightRms, std::nullopt}).has_value());
}

}  // namespace rubble
