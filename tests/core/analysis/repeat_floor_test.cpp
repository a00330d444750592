#include "core/analysis/accuracy/repeat_floor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

class RepeatFloorTest : public testing::Test {
protected:
    void SetUp() override {
        scenario.simulation.settleTime = 1.0;
        scenario.grid.oneBodyPerFragment = true;
    }
    RepeatFloor floor(int repeats, int threads) const {
        StudySettings settings;
        settings.repeats = repeats;
        settings.threads = threads;
        return repeatFloor(inputs, scenario, settings, Execution());
    }
    Inputs inputs{scenes::collapsingWall(4, 3), {}};
    Scenario scenario;
};

void expectSame(const DebrisDifference& a, const DebrisDifference& b) {
    EXPECT_EQ(a.values, b.values);
    EXPECT_EQ(a.accuracy, b.accuracy);
}

TEST_F(RepeatFloorTest, DoesNotDependOnTheNumberOfThreads) {
    const RepeatFloor one = floor(3, 1);
    ASSERT_EQ(one.repeats.size(), 3u);
    for (const int threads : {2, 4}) {
        const RepeatFloor other = floor(3, threads);
        EXPECT_EQ(other.trajectoryHash, one.trajectoryHash);
        ASSERT_EQ(other.repeats.size(), 3u);
        for (std::size_t r = 0; r < 3; ++r) {
            EXPECT_EQ(other.repeats[r].trajectoryHash, one.repeats[r].trajectoryHash);
            EXPECT_EQ(other.repeats[r].seed, one.repeats[r].seed);
            expectSame(other.repeats[r].difference, one.repeats[r].difference);
        }
        expectSame(other.largest, one.largest);
    }
}

// The pipeline itself, with the shift as a user would set it, makes the same worlds.
TEST_F(RepeatFloorTest, ItsWorldsAreThoseOfThePipeline) {
    const RepeatFloor measured = floor(2, 2);
    const auto hashOf = [&](const Scenario& one) {
        DebrisRecorder sink;
        return run(inputs, one, Stage::Simulation, {}, &sink, Execution()).simulation->trajectoryHash;
    };
    EXPECT_EQ(hashOf(scenario), measured.trajectoryHash);
    for (const RepeatRow& row : measured.repeats) {
        Scenario shifted = scenario;
        shifted.fragments.birthShift = 1e-6;
        shifted.fragments.seed = row.seed;
        EXPECT_EQ(hashOf(shifted), row.trajectoryHash) << row.seed;
    }
    EXPECT_EQ(measured.repeats[0].seed, scenario.fragments.seed + 1);
}

TEST_F(RepeatFloorTest, ItsLargestIsNoSmallerThanAnyOfItsRepeats) {
    const RepeatFloor measured = floor(3, 2);
    for (const RepeatRow& row : measured.repeats) {
        EXPECT_GT(row.difference.of(Measure::MedianDistance), 0.0) << "a shift of 1e-6 m is seen";
        for (std::size_t m = 0; m < measureCount; ++m) {
            EXPECT_LE(row.difference.departure(static_cast<Measure>(m)), measured.largest.departure(static_cast<Measure>(m)));
        }
        EXPECT_EQ(row.figures.fragments, 12);
        EXPECT_NEAR(row.figures.mass, measured.figures.mass, 1e-6);
    }
}

TEST_F(RepeatFloorTest, AClusteredRunIsRepeatedWithItsOwnClusters) {
    // Cells of 1 m in boxes of exactly 2 m: a shift of 1e-6 m would pull every pair of them apart.
    scenario.grid.oneBodyPerFragment = false;
    scenario.grid.length = scenario.grid.width = scenario.grid.height = 2.0;
    const StudySettings settings;
    const StudyBase base = beginStudy(inputs, scenario, settings, Execution());
    const RunDescription repeat = describeRepeat({base.inputs, base.scenario, base.results}, settings.birthShift, 1, Execution());
    EXPECT_LT(base.results.clustering->list.size(), base.results.fragments->size());
    EXPECT_EQ(repeat.clustering->of, base.results.clustering->of);
    EXPECT_NE(repeat.fragments->list[0].centre, base.results.fragments->list[0].centre);
    EXPECT_LE((repeat.fragments->list[0].centre - base.results.fragments->list[0].centre).norm(), 1.001e-6);
    EXPECT_NE(repeat.fingerprint, describeBase(base).fingerprint);
}

TEST_F(RepeatFloorTest, WithoutFragmentsItIsEmpty) {
    scenes::Block standing;
    inputs.fe = scenes::makeScene({standing}, 3, 0.1);
    const RepeatFloor measured = floor(2, 2);
    EXPECT_EQ(measured.figures.fragments, 0);
    EXPECT_EQ(measured.largest.of(Measure::MassMap), 0.0);
    EXPECT_TRUE(std::isnan(measured.largest.of(Measure::MedianDistance)));
}

TEST_F(RepeatFloorTest, RefusesSettingsOutOfRange) {
    EXPECT_THROW(floor(0, 1), UsageError);
    EXPECT_THROW(floor(2, -1), UsageError);
    StudySettings settings;
    settings.birthShift = 0.0;
    EXPECT_THROW(repeatFloor(inputs, scenario, settings, Execution()), UsageError);
}

TEST_F(RepeatFloorTest, CancelLeavesByTheCancelledException) {
    const Execution execution;
    execution.cancel();
    EXPECT_THROW(repeatFloor(inputs, scenario, {}, execution), Cancelled);
}

}  // namespace
}  // namespace rubble
