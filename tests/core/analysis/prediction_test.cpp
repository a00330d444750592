#include "core/analysis/accuracy/prediction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/scenario/parameters.h"
#include "tests/core/analysis/random_numbers.h"

namespace rubble {
namespace {

Digest sceneOf(int number) {
    return Hasher().value(number).finish();
}

KnownPoint open(std::int64_t bodies, const Scenario& scenario = {}, int scene = 1) {
    KnownPoint point = openPoint(sceneOf(scene), "here", 2, scenario, 10000, bodies);
    point.carries = false;  // nothing comes loose there
    return point;
}

KnownPoint known(std::int64_t bodies, Predicted what, double value, const Scenario& scenario = {}, int scene = 1) {
    KnownPoint point = open(bodies, scenario, scene);
    point.values[static_cast<std::size_t>(what)] = value;
    return point;
}

/// A sweep whose cost is a power of the bodies and whose accuracy falls with them, both with a known scatter.
std::vector<KnownPoint> sweep(RandomNumbers& random, int scene, std::size_t points, double scatter) {
    std::vector<KnownPoint> all;
    for (std::size_t i = 0; i < points; ++i) {
        const double bodies = std::exp(random.between(std::log(800.0), std::log(8000.0)));
        KnownPoint point = open(std::llround(bodies), {}, scene);
        point.values[static_cast<std::size_t>(Predicted::WallSeconds)] =
            0.002 * std::pow(bodies, 1.2) * std::exp(scatter * random.normal());
        point.values[static_cast<std::size_t>(Predicted::Fps)] = 4e4 / std::pow(bodies, 0.9) * std::exp(scatter * random.normal());
        point.values[static_cast<std::size_t>(Predicted::MassMap)] = 5.0 / std::sqrt(bodies) * std::exp(scatter * random.normal());
        point.values[static_cast<std::size_t>(Predicted::CoreIou)] =
            1.0 - 6.0 / std::sqrt(bodies) * std::exp(scatter * random.normal());
        all.push_back(point);
    }
    return all;
}

// Twenty sweeps of twelve points: 240 draws of a chance of 0.8 scatter by 0.026.
TEST(Prediction, IntervalsHoldSeventyToNinetyPerCentOfLeftOutPoints) {
    RandomNumbers random(11);
    std::vector<KnownPoint> all;
    for (int scene = 0; scene < 20; ++scene) {
        for (KnownPoint& point : sweep(random, scene, 12, 0.1)) {
            all.push_back(std::move(point));
        }
    }
    for (const PredictionCheck& check : checkPredictions(all)) {
        if (check.what == Predicted::WallSeconds || check.what == Predicted::Fps || check.what == Predicted::MassMap ||
            check.what == Predicted::CoreIou) {
            EXPECT_EQ(check.points, 240u);
            EXPECT_LT(check.unknown, 40u) << predictedKey(check.what);
            EXPECT_GE(check.coverage(), 0.7) << predictedKey(check.what);
            EXPECT_LE(check.coverage(), 0.9) << predictedKey(check.what);
            EXPECT_LE(check.halfWidth, 0.3) << predictedKey(check.what);
            EXPECT_GT(check.halfWidth, 0.0);
        } else {
            EXPECT_EQ(check.points, 0u);
            EXPECT_TRUE(std::isnan(check.halfWidth));
        }
    }
}

TEST(Prediction, SaysWhenItDoesNotKnow) {
    RandomNumbers random(3);
    const std::vector<KnownPoint> points = sweep(random, 1, 10, 0.1);
    const auto knows = [&](const KnownPoint& point, std::span<const KnownPoint> from) {
        const Prediction prediction = predict(Predicted::WallSeconds, point, from, nullptr);
        EXPECT_EQ(prediction.known, prediction.reason.empty());
        return prediction.known;
    };
    EXPECT_TRUE(knows(open(3000), points));
    EXPECT_FALSE(knows(open(3000), std::span(points).first(3))) << "three points are too few";
    EXPECT_FALSE(knows(open(3000, {}, 2), points)) << "another scene";
    EXPECT_FALSE(knows(open(200000), points)) << "far more bodies than were ever simulated";
    EXPECT_FALSE(knows(open(20), points));
    KnownPoint elsewhere = open(3000);
    elsewhere.machine = "another machine";
    EXPECT_FALSE(knows(elsewhere, points)) << "figures of time hold for one machine";
    KnownPoint onFour = open(3000);
    onFour.threads = 4;
    EXPECT_FALSE(knows(onFour, points)) << "and for one number of threads";
    EXPECT_TRUE(predict(Predicted::MassMap, elsewhere, points, nullptr).known) << "debris does not depend on the machine";
    Scenario hulls;
    hulls.simulation.shape = ClusterShape::Hull;
    EXPECT_FALSE(knows(open(3000, hulls), points)) << "no point with hulls";
    Scenario fine;
    fine.simulation.stepRate = 240.0;
    EXPECT_FALSE(knows(open(3000, fine), points)) << "no point with another step";
}

TEST(Prediction, ScatterWithoutMeaningIsNotKnown) {
    std::vector<KnownPoint> points;
    RandomNumbers random(5);
    for (int i = 0; i < 8; ++i) {
        points.push_back(known(1000 + 200 * i, Predicted::WallSeconds, std::exp(2.0 * random.normal())));
    }
    const Prediction prediction = predict(Predicted::WallSeconds, open(1700), points, nullptr);
    EXPECT_FALSE(prediction.known);
    EXPECT_EQ(prediction.reason.id, "prediction.wide");
}

TEST(Prediction, NumbersAreCoordinatesOfTheirOwn) {
    // Cost goes with bodies and with the steps per second; the grid itself is no coordinate, for the bodies stand for it.
    std::vector<KnownPoint> points;
    for (const double rate : {30.0, 60.0, 120.0}) {
        for (const std::int64_t bodies : {1000, 2000, 4000, 6000}) {
            Scenario scenario;
            scenario.simulation.stepRate = rate;
            scenario.grid.multiple = 10.0 / static_cast<double>(bodies);
            points.push_back(known(bodies, Predicted::WallSeconds, 1e-5 * rate * static_cast<double>(bodies), scenario));
        }
    }
    Scenario asked;
    asked.simulation.stepRate = 90.0;
    const Prediction prediction = predict(Predicted::WallSeconds, open(3000, asked), points, nullptr);
    ASSERT_TRUE(prediction.known);
    EXPECT_EQ(prediction.points, 12u);
    // 1e-5 * 90 * 3000 = 2.7 s; the points are exact, so the middle is too, up to the smooth part of the model.
    EXPECT_NEAR(prediction.value, 2.7, 0.1);
    EXPECT_LE(prediction.low, 2.7);
    EXPECT_GE(prediction.high, 2.7);
}

TEST(Prediction, LiveRatesOfAnUnknownSceneComeFromTheCalibration) {
    Calibration calibration;
    calibration.machine = "here";
    calibration.threads = 2;
    for (const std::int64_t bodies : {500, 1000, 2000, 4000, 8000}) {
        const double typical = 1e5 / static_cast<double>(bodies);
        calibration.points.push_back({PileKind::Typical, bodies, 2.0 * typical, 2.0 * typical, typical});
        calibration.points.push_back({PileKind::Worst, bodies, typical, typical, 0.5 * typical});
    }
    const Prediction prediction = predict(Predicted::Fps, open(3000), {}, &calibration);
    ASSERT_TRUE(prediction.known);
    EXPECT_TRUE(prediction.fromCalibration);
    EXPECT_NEAR(prediction.value, 1e5 / 3000.0, 1.0);
    EXPECT_LT(prediction.low, 0.5 * 1e5 / 3000.0 * 1.05) << "the worst pile is within it";
    EXPECT_FALSE(predict(Predicted::Fps, open(100000), {}, &calibration).known) << "more than was calibrated";
    EXPECT_FALSE(predict(Predicted::WallSeconds, open(3000), {}, &calibration).known)
        << "how long the collapse is it does not know";
    // 10 s of collapse and up to 10 s to settle, at 24 frames a second of which a machine makes 2e5 / 3000 = 66.7, or half of them.
    KnownPoint lasting = open(3000);
    lasting.span = 10.0;
    const Prediction wall = predict(Predicted::WallSeconds, lasting, {}, &calibration);
    ASSERT_TRUE(wall.known);
    EXPECT_NEAR(wall.value, 15.0 * 24.0 / (2e5 / 3000.0), 0.1);
    EXPECT_LT(wall.low, 10.0 * 24.0 / (2e5 / 3000.0));
    EXPECT_GT(wall.high, 20.0 * 24.0 / (1e5 / 3000.0));
    EXPECT_FALSE(predict(Predicted::MassMap, lasting, {}, &calibration).known) << "of debris it says nothing";
    KnownPoint carrying = lasting;
    carrying.carries = true;
    for (const Predicted what : {Predicted::Fps, Predicted::WallSeconds}) {
        EXPECT_EQ(predict(what, carrying, {}, &calibration).reason.id, "prediction.carries_loose") << "calibrated without spans";
    }
    calibration.othersShare = 0.3;
    EXPECT_EQ(predict(Predicted::Fps, open(3000), {}, &calibration).reason.id, "prediction.calibration_disturbed");
    calibration.othersShare = 0.02;
    EXPECT_TRUE(predict(Predicted::Fps, open(3000), {}, &calibration).known);
    calibration.machine = "elsewhere";
    EXPECT_FALSE(predict(Predicted::Fps, open(3000), {}, &calibration).known);
}

// The same setting measured on two numbers of threads has one accuracy: it must not predict itself.
TEST(Prediction, ASettingDoesNotPredictItself) {
    RandomNumbers random(9);
    std::vector<KnownPoint> points = sweep(random, 1, 5, 0.5);
    const std::vector<PredictionCheck> once = checkPredictions(points);
    for (const KnownPoint& point : std::vector<KnownPoint>(points)) {
        points.push_back(point);
        points.back().threads = 4;
    }
    EXPECT_EQ(pointsBut(points[0], points).size(), 8u);
    const PredictionCheck& mass = once[static_cast<std::size_t>(Predicted::MassMap)];
    const PredictionCheck twice = checkPredictions(points)[static_cast<std::size_t>(Predicted::MassMap)];
    EXPECT_EQ(mass.points, 5u);
    EXPECT_EQ(twice.points, 10u);
}

TEST(Prediction, KnownPointsHoldWhatAPointOfASweepSays) {
    AccuracyReport report;
    AccuracyPoint& reference = report.reference;
    reference.setting = std::string(referenceSetting);
    reference.done = true;
    reference.cost.wallSeconds = 7.0;
    AccuracyPoint point;
    point.setting = "multiple=2";
    point.scenario.grid.multiple = 2.0;
    point.scenario.simulation.stepRate = 120.0;
    point.bodies = 400;
    point.done = true;
    point.origin.machine = "here";
    point.difference.of(Measure::MassMap) = 0.2;
    point.difference.of(Measure::MeanHeight) = -0.3;
    const KnownPoint kept = knownPoint(point, report);
    EXPECT_EQ(kept.of(Predicted::MassMap), 0.2);
    EXPECT_EQ(kept.of(Predicted::MeanHeight), 0.3) << "a departure has no sign";
    EXPECT_TRUE(std::isnan(kept.of(Predicted::WallSeconds)));
    EXPECT_EQ(kept.parameters, (std::map<std::string, std::string>{{"step_rate", "120"}})) << "the grid is left out";
    const KnownPoint ofReference = knownPoint(reference, report);
    EXPECT_EQ(ofReference.of(Predicted::WallSeconds), 7.0);
    EXPECT_TRUE(std::isnan(ofReference.of(Predicted::CoreIou))) << "its distance from itself says nothing of others";
    EXPECT_EQ(kept.scene, ofReference.scene);
    point.cost.wallSeconds = 9.0;
    EXPECT_EQ(knownPoint(point, report).of(Predicted::WallSeconds), 9.0);
    point.cost.othersShare = 0.4;
    EXPECT_TRUE(std::isnan(knownPoint(point, report).of(Predicted::WallSeconds))) << "timed beside other work";
    EXPECT_EQ(knownPoint(point, report).of(Predicted::MassMap), 0.2);
    AccuracyReport atFeEnd = report;
    atFeEnd.instant = DebrisInstant::AtFeEnd;
    EXPECT_NE(knownPoint(point, atFeEnd).scene, kept.scene);
}

}  // namespace
// The grid decides the bodies and nothing else: sizes by hand tell a point from none with the same bodies.
TEST(Prediction, SizesByHandPartNoPoints) {
    Scenario byHand;
    byHand.grid.length = 2.0;
    byHand.grid.width = 3.0;
    byHand.grid.height = 4.0;
    byHand.grid.multiple = 5.0;
    EXPECT_TRUE(openPoint({}, "here", 2, byHand, 100, 10).parameters.empty());
}

}  // namespace rubble
