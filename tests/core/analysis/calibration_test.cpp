#include "core/analysis/accuracy/calibration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/unknown.h"

namespace rubble {
namespace {

/// FPS that fall as a power of the bodies: 48,000 / n for the physics, 1,200 / sqrt(n) for drawing.
Calibration powerLaws() {
    Calibration calibration;
    for (const std::int64_t n : {500, 1000, 2000, 4000}) {
        const double physics = 48000.0 / static_cast<double>(n);
        const double drawing = 1200.0 / std::sqrt(static_cast<double>(n));
        calibration.points.push_back({PileKind::Typical, n, physics, drawing, 1.0 / (1.0 / physics + 1.0 / drawing)});
        calibration.points.push_back({PileKind::Worst, n, 0.25 * physics, unknown, unknown});
    }
    return calibration;
}

TEST(Calibration, ReadsTheMostBodiesOffTheCurve) {
    const Calibration calibration = powerLaws();
    const auto typical = calibration.bodiesMax(PileKind::Typical, LiveLoad::Physics, 24.0);
    ASSERT_TRUE(typical);
    EXPECT_NEAR(typical->bodies, 2000.0, 20.0) << "48,000 / 24";
    EXPECT_FALSE(typical->atLeast || typical->atMost);
    const auto worst = calibration.bodiesMax(PileKind::Worst, LiveLoad::Physics, 24.0);
    ASSERT_TRUE(worst);
    EXPECT_NEAR(worst->bodies, 500.0, 5.0);
    const auto slow = calibration.bodiesMax(PileKind::Typical, LiveLoad::Physics, 1.0);
    EXPECT_TRUE(slow->atLeast);
    EXPECT_NEAR(slow->bodies, 6000.0, 1.0) << "1.5 times the most that was measured";
    const auto fast = calibration.bodiesMax(PileKind::Typical, LiveLoad::Physics, 1000.0);
    EXPECT_TRUE(fast->atMost);
    EXPECT_NEAR(*calibration.exponent(PileKind::Typical, LiveLoad::Physics), 1.0, 1e-12);
    EXPECT_NEAR(*calibration.exponent(PileKind::Typical, LiveLoad::Drawing), 0.5, 1e-12);
    EXPECT_FALSE(calibration.bodiesMax(PileKind::Worst, LiveLoad::Both, 24.0)) << "nothing was drawn";
    EXPECT_FALSE(calibration.exponent(PileKind::Worst, LiveLoad::Both));
}

TEST(Calibration, SaysNothingFarBeyondWhatWasMeasured) {
    const Calibration calibration = powerLaws();
    const auto within = calibration.fps(PileKind::Typical, LiveLoad::Both, 2500.0);
    ASSERT_TRUE(within);
    EXPECT_LT(within->low, within->value);
    EXPECT_LT(within->value, within->high);
    EXPECT_FALSE(calibration.fps(PileKind::Typical, LiveLoad::Both, 6100.0));
    EXPECT_FALSE(calibration.fps(PileKind::Typical, LiveLoad::Both, 300.0));
    EXPECT_FALSE(calibration.fps(PileKind::Typical, LiveLoad::Both, 0.0));
    EXPECT_FALSE(Calibration{}.fps(PileKind::Typical, LiveLoad::Both, 1000.0));
}

TEST(Calibration, PilesAreOfAboutAsManyBodiesAsAskedFor) {
    for (const PileKind kind : {PileKind::Typical, PileKind::Worst}) {
        for (const std::int64_t n : {8, 100, 1000}) {
            const auto [inputs, scenario] = pileScene(kind, n);
            const Results results = run(inputs, scenario, Stage::Clusters, {}, nullptr, Execution());
            const double bodies = static_cast<double>(results.clustering->list.size());
            EXPECT_NEAR(bodies / static_cast<double>(n), 1.0, 0.15);
            double last = 0.0, first = 1e9;
            for (const Fragment& fragment : results.fragments->list) {
                first = std::min(first, fragment.birthTime);
                last = std::max(last, fragment.birthTime);
                EXPECT_GT(fragment.centre.z(), -1.5) << "nothing is born far below the ground";
            }
            EXPECT_LE(last, 2.9);
            EXPECT_TRUE(kind == PileKind::Typical ? last > first : last == first);
        }
    }
}

class DrawnAtOnce : public LiveScreen {
public:
    void draw(double) override {}
};

TEST(Calibration, MeasuresBothPilesInEveryWay) {
    CalibrationSettings settings;
    settings.bodies = {27, 8};
    settings.machine = "here";
    settings.renderer = [] { return std::string("nobody"); };
    settings.screen = [](const RunDescription&, const std::shared_ptr<const TrajectoryReader>&) {
        return std::make_unique<DrawnAtOnce>();
    };
    const Calibration calibration = calibrate(settings, Execution());
    EXPECT_TRUE(calibration.complete);
    EXPECT_EQ(calibration.machine, "here");
    EXPECT_EQ(calibration.renderer, "nobody");
    ASSERT_EQ(calibration.points.size(), 4u);
    EXPECT_EQ(calibration.points[0].bodies, 8) << "smallest first";
    for (const CalibrationPoint& point : calibration.points) {
        EXPECT_GT(point.physicsFps, 0.0);
        EXPECT_GT(point.drawingFps, 0.0);
        EXPECT_GT(point.liveFps, 0.0);
    }
}

TEST(Calibration, WithoutADisplayThePhysicsIsMeasured) {
    CalibrationSettings settings;
    settings.bodies = {8};
    settings.screen = [](const RunDescription&, const std::shared_ptr<const TrajectoryReader>&) -> std::unique_ptr<LiveScreen> {
        throw WorldError({"test.no_display", "no display", {}}, {"test.remedy", "start one", {}});
    };
    const Calibration calibration = calibrate(settings, Execution());
    EXPECT_TRUE(calibration.complete);
    EXPECT_EQ(calibration.findings.count("calibration.no_screen"), 1);
    EXPECT_GT(calibration.points[1].physicsFps, 0.0);
    EXPECT_TRUE(std::isnan(calibration.points[1].liveFps));
    EXPECT_TRUE(calibration.renderer.empty());
}

TEST(Calibration, RefusesWhatCannotBeMeasuredAndKeepsWhatIsDone) {
    CalibrationSettings settings;
    settings.bodies = {4};
    EXPECT_THROW(calibrate(settings, Execution()), UsageError);
    settings.bodies = {1000000};
    EXPECT_THROW(calibrate(settings, Execution()), UsageError);
    settings.bodies = {8, 27};
    const Execution execution;
    int screens = 0;
    // Each point is drawn twice: the fifth screen is that of the third point.
    settings.screen = [&](const RunDescription&, const std::shared_ptr<const TrajectoryReader>&) {
        if (++screens == 5) {
            execution.cancel();
        }
        return std::make_unique<DrawnAtOnce>();
    };
    const Calibration partial = calibrate(settings, execution);
    EXPECT_FALSE(partial.complete);
    EXPECT_EQ(partial.points.size(), 2u);
}

}  // namespace
}  // namespace rubble
