#include "core/evidence/maps/fragment_history.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/evidence/carried_fragment.h"

namespace rubble {
namespace {

struct OnePath : CarriedFragment {
    Debris debris;

    template <class Path>
    OnePath(double end, double interval, Path path, double birth = 0.0) : CarriedFragment(end, interval, path, birth) {
        DebrisFragment lies;
        lies.present = true;
        lies.centre = path(end);
        debris = {end, {lies}};
    }
    double arrival(double distance) const { return arrivalTimes(fragments, trajectory, debris, distance, Execution()).front(); }
    double hit() const { return hardestHitTimes(fragments, trajectory, standardGravity, Execution()).front(); }
};

TEST(FragmentHistory, ArrivesWhenItComesNearAndStays) {
    // Along x at 2 m/s until 3 s, then it lies at 6 m.
    const OnePath path(5.0, 0.1, [](double t) { return Vec3(2.0 * std::min(t, 3.0), 0.0, 0.0); });
    EXPECT_NEAR(path.arrival(0.5), 2.75, 1e-5) << "between two frames, in single precision";
    EXPECT_NEAR(path.arrival(3.0), 1.5, 1e-5);
}

TEST(FragmentHistory, WhatPassedByAndCameBackArrivedTheSecondTime) {
    const OnePath path(8.0, 0.05, [](double t) { return Vec3(t < 6.0 ? 5.0 * std::sin(t) : 5.0 * std::sin(6.0), 0.0, 0.0); });
    // |5 sin t - 5 sin 6| = 0.5 on the way up to 6 s, where sin t = sin 6 - 0.1.
    EXPECT_NEAR(path.arrival(0.5), 2.0 * M_PI - std::asin(-(std::sin(6.0) - 0.1)), 1e-3) << "linear over 0.05 s";
}

TEST(FragmentHistory, WhatNeverMovedArrivedAtItsBirth) {
    const OnePath still(2.0, 0.1, [](double) { return Vec3(1.0, 2.0, 3.0); }, 0.7);
    EXPECT_EQ(still.arrival(0.5), 0.7);
    OnePath absent(2.0, 0.1, [](double) { return Vec3(1.0, 2.0, 3.0); });
    absent.debris.fragments[0].present = false;
    EXPECT_TRUE(std::isnan(absent.arrival(0.5)));
}

TEST(FragmentHistory, TheHardestHitIsWhereTheFallEnds) {
    // Falls from 10 m until 1.428 s, then lies.
    const double landing = std::sqrt(20.0 / standardGravity);
    const OnePath fall(3.0, 0.02,
                       [&](double t) { return Vec3(0.0, 0.0, 10.0 - 0.5 * standardGravity * std::pow(std::min(t, landing), 2)); });
    EXPECT_NEAR(fall.hit(), landing, 0.021) << "to a frame";
}

TEST(FragmentHistory, ImpactEnergyIsThatOfTheCentre) {
    FragmentSet fragments;
    fragments.list.resize(2);
    fragments.list[0].mass = 10.0;
    fragments.list[1].mass = 3.0;
    std::vector<FragmentOutcome> outcomes(2);
    outcomes[0].impactSpeed = 4.0;
    EXPECT_EQ(impactEnergies(fragments, outcomes), (std::vector<double>{80.0, 0.0}));
}

}  // namespace
}  // namespace rubble
