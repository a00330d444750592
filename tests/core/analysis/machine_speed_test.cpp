#include "core/analysis/accuracy/machine_speed.h"

#include <gtest/gtest.h>

#include <chrono>

#include "core/base/elapsed.h"

namespace rubble {
namespace {

FragmentSet bornAt(const std::vector<double>& births) {
    FragmentSet set;
    for (const double birth : births) {
        Fragment fragment;
        fragment.handOverTime = birth;
        set.list.push_back(fragment);
    }
    return set;
}

TEST(MachineSpeed, IsMeasuredInAboutASecond) {
    const auto start = std::chrono::steady_clock::now();
    const MachineSpeed speed = measureMachineSpeed(Execution());
    // Sanitizers and a busy machine take longer; an hour would be another thing.
    EXPECT_LT(secondsSince(start), 60.0);
    EXPECT_GT(speed.secondsPerWork, 1e-7);
    EXPECT_LT(speed.secondsPerWork, 1e-1);
    EXPECT_GT(speed.stepRate, 10.0);
}

TEST(CrudePrediction, GrowsWithBodiesAndWithTheTimeThatTheyMove) {
    const MachineSpeed speed{1e-3, 60.0, 4};
    Scenario scenario;
    scenario.simulation.settleTime = 1.0;
    scenario.effects.loose = LooseStructurePolicy::Fe;
    const FragmentSet early = bornAt({0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0});
    const Prediction few = crudeWallSeconds(early, 100, 2.0, scenario, speed);
    const Prediction many = crudeWallSeconds(early, 1000, 2.0, scenario, speed);
    ASSERT_TRUE(few.known);
    EXPECT_TRUE(few.fromSpeed);
    // Half of the bodies move for 3 s, half for 2 s, and steps cost as much as 20 bodies.
    EXPECT_NEAR(few.value, 1e-3 * (100 * 2.5 + 20 * 3.0), 1e-9);
    EXPECT_NEAR(many.value, 1e-3 * (1000 * 2.5 + 20 * 3.0), 1e-9);
    EXPECT_LT(few.low, 0.5 * few.value) << "crude, and it says so";
    EXPECT_GT(few.high, 2.0 * few.value);
    scenario.simulation.stepRate = 240.0;
    EXPECT_NEAR(crudeWallSeconds(early, 100, 2.0, scenario, speed).value, 4.0 * few.value, 1e-9);
    scenario.simulation.stepRate.reset();
    scenario.effects.loose = LooseStructurePolicy::AtOnce;
    EXPECT_NEAR(crudeWallSeconds(early, 100, 2.0, scenario, speed).value, 3.0 * few.value, 1e-9) << "12 substeps for 4";
    EXPECT_NEAR(crudeWallSeconds(early, 100, 2.0, scenario, speed, true).value, 7.5 * few.value, 1e-9)
        << "what the engine carries beside the fragments is not left out";
}

TEST(CrudePrediction, OfNothingIsNotKnown) {
    const Prediction none = crudeWallSeconds({}, 100, 2.0, {}, {1e-3, 60.0, 4});
    EXPECT_FALSE(none.known);
    EXPECT_FALSE(none.reason.empty());
}

}  // namespace
}  // namespace rubble
