#include "core/analysis/accuracy/live_cost.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "core/base/error.h"
#include "core/pipeline/pipeline.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

TEST(LiveRate, IsCountedOverTheBirthsAndTheWorstSecond) {
    std::vector<FrameStamp> frames;
    double wall = 0.0;
    // A second at 10 frames, half a second at 2, and so on at 10, a frame each 0.1 s of the collapse.
    for (int i = 0; i <= 40; ++i) {
        frames.push_back({0.1 * i, wall});
        wall += i >= 20 && i < 22 ? 0.5 : 0.1;
    }
    const LiveRate all = rateOf(frames, 0.0, 4.0);
    EXPECT_EQ(all.frames, 41);
    EXPECT_NEAR(all.mean, 40 / 4.8, 1e-9);
    EXPECT_NEAR(all.worst, 2.0, 1e-9) << "the two slow frames fill the worst second";
    EXPECT_NEAR(rateOf(frames, 0.0, 1.0).mean, 10.0, 1e-9);
    EXPECT_NEAR(rateOf(frames, 7.0, 8.0).mean, all.mean, 1e-9) << "no frame within: all count";
    EXPECT_TRUE(std::isnan(rateOf({{0.0, 0.0}}, 0.0, 1.0).mean));
}

TEST(LiveRate, OfFramesLongerThanASecondIsThatOfTheLongest) {
    const LiveRate rate = rateOf({{0.0, 0.0}, {0.1, 2.0}, {0.2, 6.0}}, 0.0, 1.0);
    EXPECT_NEAR(rate.worst, 0.25, 1e-12);
    EXPECT_NEAR(rate.mean, 2.0 / 6.0, 1e-12);
}

/// Notes what it was asked to draw, and what the run held then.
class NotingScreen : public LiveScreen {
public:
    struct Note {
        double time;
        std::size_t bodies;
        std::thread::id thread;
    };
    NotingScreen(std::shared_ptr<const TrajectoryReader> run, std::vector<Note>& notes) : m_run(std::move(run)), m_notes(notes) {}
    void draw(double time) override {
        const TrajectoryFrame frame = frameAtTime(*m_run, time);
        EXPECT_EQ(frame.time, time);
        EXPECT_LE(frame.bodies(), m_run->bodies().size());
        for (const Carrier& carrier : m_run->carriers()) {
            EXPECT_LT(at(carrier.body), m_run->bodies().size());
        }
        m_notes.push_back({time, frame.bodies(), std::this_thread::get_id()});
    }

private:
    std::shared_ptr<const TrajectoryReader> m_run;
    std::vector<Note>& m_notes;
};

class LiveCost : public testing::Test {
protected:
    void SetUp() override {
        scenario.grid.oneBodyPerFragment = true;
        scenario.simulation.settleTime = 1.0;
        inputs.fe = scenes::collapsingWall(4, 3);
        const Results results = run(inputs, scenario, Stage::Clusters, {}, nullptr, Execution());
        description = describeRun(inputs, scenario, results);
    }
    ScreenMaker noting() {
        return [this](const RunDescription&, std::shared_ptr<const TrajectoryReader> trajectory) {
            return std::make_unique<NotingScreen>(std::move(trajectory), notes);
        };
    }
    Inputs inputs;
    Scenario scenario;
    RunDescription description;
    std::vector<NotingScreen::Note> notes;
};

TEST_F(LiveCost, DrawsOneFrameForEachFrameTimeOnTheCallingThread) {
    const LiveRate rate = measureLive(description, 24.0, noting(), Execution());
    const double first = notes.front().time;
    const double span = inputs.fe->times().back() - first;
    // One frame for each 1/24 s, give or take one at the ends: a frame stands at the end of the second step at most that passes it.
    EXPECT_NEAR(static_cast<double>(notes.size()), 1.0 + span * 24.0, 1.5);
    EXPECT_EQ(rate.frames, static_cast<std::int64_t>(notes.size()));
    EXPECT_GT(rate.mean, 0.0);
    EXPECT_LE(rate.worst, rate.mean * (1.0 + 1e-12));
    for (std::size_t i = 0; i < notes.size(); ++i) {
        EXPECT_EQ(notes[i].thread, std::this_thread::get_id());
        EXPECT_TRUE(i == 0 || (notes[i].time > notes[i - 1].time && notes[i].bodies >= notes[i - 1].bodies));
    }
    EXPECT_GE(notes.back().bodies, 12u) << "a body for each fragment, and the beam once it is released";
}

TEST_F(LiveCost, RunsWithoutAScreenAndDrawsWithoutARun) {
    EXPECT_GT(measureLive(description, 24.0, {}, Execution()).mean, 0.0);
    const auto trajectory = std::make_shared<MemoryTrajectory>();
    simulate(description, *trajectory, Execution());
    const LiveRate rate = measureDrawing(description, trajectory, 24.0, noting(), Execution());
    EXPECT_EQ(rate.frames, static_cast<std::int64_t>(notes.size()));
    EXPECT_GT(notes.size(), 4u);
    EXPECT_LE(notes.back().time, inputs.fe->times().back());
}

TEST_F(LiveCost, ErrorsOfTheScreenAndCancelEndIt) {
    const ScreenMaker broken = [](const RunDescription&,
                                  const std::shared_ptr<const TrajectoryReader>&) -> std::unique_ptr<LiveScreen> {
        throw WorldError({"test.no_display", "no display", {}}, {"test.none", "none", {}});
    };
    EXPECT_THROW(measureLive(description, 24.0, broken, Execution()), WorldError);
    description.scenario.simulation.stepRate = 10000.0;
    const Execution execution([&](const Progress& progress) {
        if (progress.fraction > 0.0) {
            execution.cancel();
        }
    });
    EXPECT_THROW(measureLive(description, 24.0, noting(), execution), Cancelled);
}

TEST_F(LiveCost, TimesARunWithTheThreadsItWasGiven) {
    const SettingCost cost = timeRun(description, Execution().withThreads(2));
    EXPECT_TRUE(cost.timed());
    EXPECT_EQ(cost.threads, 2);
    EXPECT_GT(cost.stepMeanMs, 0.0);
    EXPECT_GE(cost.stepWorstMs, cost.stepMeanMs);
    EXPECT_TRUE(std::isnan(cost.fps));
}

}  // namespace
}  // namespace rubble
