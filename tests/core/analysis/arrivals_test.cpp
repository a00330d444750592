#include "core/analysis/debris/arrivals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "core/analysis/accuracy/settled_world.h"
#include "core/pipeline/pipeline.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

/// One fragment of 2 m on a body of its own, where and when a test wants it.
class OneFragment : public testing::Test {
protected:
    OneFragment() {
        auto fragments = std::make_shared<FragmentSet>();
        Fragment& fragment = fragments->list.emplace_back();
        fragment.box.halfExtents = Vec3::Ones();
        m_description.fragments = fragments;
        m_description.scenario.simulation.groundHeight = 10.0;
        const Carrier carrier{idAt<FragmentId>(0), idAt<BodyId>(0), 1.0, std::numeric_limits<double>::infinity(), {}};
        recorder.emplace(m_description, nullptr);
        recorder->addBodies({}, std::span(&carrier, 1));
    }
    void frame(double time, const Vec3& place, BodyState state = BodyState::Awake) {
        TrajectoryFrame frame;
        frame.time = time;
        frame.positions = {place.cast<float>()};
        frame.orientations = {Eigen::Quaternionf::Identity()};
        frame.states = {state};
        recorder->commit(frame);
    }

    RunDescription m_description;
    std::optional<ArrivalRecorder> recorder;
};

TEST_F(OneFragment, LiesWhereItsLowestPointIsWithinAMetreOfTheGround) {
    frame(0.5, {0.5, 0.5, 11.0});                       // before its hand-over
    frame(1.0, {3.5, -0.5, 12.1});                      // its underside is 1.1 m above
    frame(2.0, {4.5, -0.5, 11.9});                      // and 0.9 m
    frame(3.0, {4.2, -0.2, 11.0});                      // the same square again
    frame(4.0, {5.5, -0.5, 11.0});                      //
    frame(5.0, {6.5, -0.5, 11.0}, BodyState::Removed);  // gone
    frame(6.0, {NAN, -0.5, 11.0});
    const DebrisArrivals arrivals = recorder->arrivals();
    EXPECT_EQ(arrivals.squares, (std::vector<DebrisArrival>{{-1, 4, 2.0}, {-1, 5, 4.0}}));
    EXPECT_EQ(arrivals.first(), 2.0);
    EXPECT_EQ(arrivals.firstWithin({5.6, -0.5}, 0.2), 4.0) << "the square that holds the place";
    EXPECT_EQ(arrivals.firstWithin({5.6, -0.5}, 3.0), 2.0);
    EXPECT_TRUE(std::isnan(arrivals.firstWithin({0.0, 20.0}, 3.0)));
    EXPECT_EQ(arrivals.firstIn({Eigen::Vector2d(5.0, -1.0), Eigen::Vector2d(9.0, 0.0)}), 4.0);
}

TEST_F(OneFragment, GoesOnFromAMark) {
    frame(2.0, {4.5, -0.5, 11.0});
    const std::string mark = recorder->mark().value();
    ArrivalRecorder resumed(m_description, nullptr);
    ASSERT_TRUE(resumed.resume(m_description, mark));
    recorder.emplace(std::move(resumed));
    frame(3.0, {7.5, -0.5, 11.0});
    EXPECT_EQ(recorder->arrivals().squares, (std::vector<DebrisArrival>{{-1, 4, 2.0}, {-1, 7, 3.0}}));
}

TEST(Arrivals, OfASettledWorldBeginWhereStructureComesDown) {
    const Inputs inputs{scenes::collapsingWall(5, 4), {}};
    Scenario scenario;
    scenario.simulation.settleTime = 2.0;
    const Results results = run(inputs, scenario, Stage::Clusters, {}, nullptr, Execution());
    const RunDescription description = describeRun(inputs, scenario, results);
    const SettledWorld settled = simulateSettled(description, Execution());
    ASSERT_FALSE(settled.arrivals.squares.empty());
    EXPECT_GE(settled.arrivals.first(), description.fragments->list.front().handOverTime);
    for (const DebrisArrival& arrival : settled.arrivals.squares) {
        EXPECT_LE(arrival.time, settled.world.endTime);
    }
    // Whatever lies at rest on the ground came there at some time.
    for (const DebrisFragment& lies : settled.world.atRest.fragments) {
        if (lies.present && lies.centre.z() < scenario.simulation.groundHeight + 0.5) {
            EXPECT_FALSE(std::isnan(settled.arrivals.firstWithin(lies.centre.head<2>(), 1.0))) << lies.centre.transpose();
        }
    }
    EXPECT_EQ(simulateSettled(description, Execution()).arrivals, settled.arrivals);
}

}  // namespace
}  // namespace rubble
