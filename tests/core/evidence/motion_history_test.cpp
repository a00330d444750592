#include "core/evidence/maps/motion_history.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "core/base/error.h"
#include "core/simulation/run/simulation.h"

namespace rubble {
namespace {

/// Three fragments of 10, 30 and 20 kg; the last comes a second later, and leaves at 3 s. The first falls, the second lies.
struct ThreeBodies {
    FragmentSet fragments;
    MemoryTrajectory trajectory;

    ThreeBodies() {
        const std::array masses{10.0, 30.0, 20.0};
        std::vector<BodyRecord> bodies(3);
        std::vector<Carrier> carriers;
        for (std::size_t i = 0; i < 3; ++i) {
            Fragment fragment;
            fragment.mass = masses[i];
            fragment.centre = Vec3(static_cast<double>(i), 0.0, 5.0);
            fragment.velocity = Vec3(0.0, 0.0, -2.0);
            fragment.endTime = std::numeric_limits<double>::infinity();
            fragments.list.push_back(fragment);
            bodies[i].body = idAt<BodyId>(i);
            carriers.push_back({idAt<FragmentId>(i),
                                idAt<BodyId>(i),
                                i == 2 ? 1.0 : 0.0,
                                std::numeric_limits<double>::infinity(),
                                {-fragment.centre, Quat::Identity()}});
        }
        trajectory.begin({});
        trajectory.addBodies(bodies, carriers);
        for (int k = 0; k <= 4; ++k) {
            TrajectoryFrame frame;
            frame.time = k;
            const auto t = static_cast<float>(k);
            frame.positions = {{0, 0, 5.0f - t}, {1, 0, 1}, {2, 0, 4}};
            frame.orientations.assign(3, Eigen::Quaternionf::Identity());
            frame.speeds = {3.0f, 0.0f, 6.0f};
            frame.states = {BodyState::Awake, BodyState::Frozen, k < 3 ? BodyState::Awake : BodyState::Removed};
            trajectory.commit(frame);
        }
        trajectory.finish({});
    }
    std::vector<HistoryPoint> history(std::vector<FragmentId> which) const {
        return fragmentHistory(fragments, trajectory, which, 10.0, 1.0, Execution());
    }
};

TEST(MotionHistory, SumsAreThoseOfTheBodies) {
    const std::vector<HistoryPoint> points = ThreeBodies().history({FragmentId{0}, FragmentId{1}, FragmentId{2}});
    ASSERT_EQ(points.size(), 5U);
    EXPECT_EQ(points[0].fragments, 2U) << "the third has not come yet";
    EXPECT_DOUBLE_EQ(points[0].mass, 40.0);
    EXPECT_DOUBLE_EQ(points[0].speed, std::sqrt(10.0 * 9.0 / 40.0));
    EXPECT_DOUBLE_EQ(points[0].topSpeed, 3.0);
    EXPECT_DOUBLE_EQ(points[0].height, (10.0 * 5.0 + 30.0 * 1.0) / 40.0);
    EXPECT_DOUBLE_EQ(points[0].kinetic, 45.0);
    EXPECT_DOUBLE_EQ(points[0].potential, 10.0 * (10.0 * 4.0 + 30.0 * 0.0)) << "above the level of 1 m";
    EXPECT_EQ(points[2].fragments, 3U);
    EXPECT_DOUBLE_EQ(points[2].kinetic, 45.0 + 0.5 * 20.0 * 36.0);
    EXPECT_EQ(points[3].fragments, 2U) << "the third has left";
    EXPECT_DOUBLE_EQ(points[3].topSpeed, 3.0);
}

TEST(MotionHistory, AFragmentBeginsWithItsBodyAndEndsWithIt) {
    const std::vector<HistoryPoint> points = ThreeBodies().history({FragmentId{2}});
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points.front().time, 1.0);
    EXPECT_EQ(points.back().time, 2.0);
    EXPECT_DOUBLE_EQ(points.front().height, 4.0);
    EXPECT_DOUBLE_EQ(points.front().speed, 6.0);
}

TEST(MotionHistory, SpeedsOfAFrameAreThoseOfTheBodiesAndUnknownWithoutOne) {
    const ThreeBodies run;
    const std::vector<double> early = fragmentSpeeds(run.fragments, run.trajectory.carriers(), *run.trajectory.frame(0));
    EXPECT_EQ(early[0], 3.0);
    EXPECT_EQ(early[1], 0.0);
    EXPECT_TRUE(std::isnan(early[2])) << "not handed over yet";
    const std::vector<double> late = fragmentSpeeds(run.fragments, run.trajectory.carriers(), *run.trajectory.frame(4));
    EXPECT_TRUE(std::isnan(late[2])) << "it has left";
    TrajectoryFrame before = *run.trajectory.frame(2);
    before.positions.resize(2);
    before.orientations.resize(2);
    before.speeds.resize(2);
    before.states.resize(2);
    EXPECT_EQ(fragmentSpeeds(run.fragments, run.trajectory.carriers(), before)[2], 2.0) << "as it was handed over";
}

TEST(MotionHistory, ATableHasOneRowAFrame) {
    std::ostringstream out;
    writeHistoryCsv(ThreeBodies().history({FragmentId{0}}), out);
    EXPECT_EQ(out.str().substr(0, out.str().find('\n')),
              "time_s,fragments,mass_kg,height_m,speed_m_s,top_speed_m_s,kinetic_energy_j,potential_energy_j");
    EXPECT_NE(out.str().find("\n2,1,10,3,3,3,45,200\n"), std::string::npos) << out.str();
}

TEST(MotionHistory, ItCanBeCancelled) {
    const Execution cancelled([](const Progress&) { throw Cancelled(); });
    const ThreeBodies run;
    const std::vector<FragmentId> one{FragmentId{0}};
    EXPECT_THROW(fragmentHistory(run.fragments, run.trajectory, one, 10.0, 0.0, cancelled), Cancelled);
}

}  // namespace
}  // namespace rubble
