#include "core/evidence/maps/fragment_path.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "tests/core/evidence/carried_fragment.h"

namespace rubble {
namespace {

/// At 50 frames a second.
struct Flight : CarriedFragment {
    template <class Place>
    Flight(double end, Place place, double leaves = std::numeric_limits<double>::infinity())
        : CarriedFragment(end, 0.02, place, 0.0, leaves) {}
    FragmentPath path() const { return fragmentPath(fragments, trajectory, FragmentId{0}, standardGravity, Execution()); }
};

/// Falls from 10 m, bounces off the ground at 0.3 of its speed once, then lies.
Vec3 bouncing(double t) {
    const double first = std::sqrt(20.0 / standardGravity);
    const double up = 0.3 * standardGravity * first;
    const double flight = t - first;
    const double z = flight < 0.0 ? 10.0 - 0.5 * standardGravity * t * t : up * flight - 0.5 * standardGravity * flight * flight;
    return {2.0, 3.0, std::max(0.0, z)};
}

TEST(FragmentPath, FallBounceAndRestAreFound) {
    const Flight flight(4.0, bouncing);
    const FragmentPath path = flight.path();
    ASSERT_EQ(path.points.size(), 201U);
    EXPECT_NEAR(path.points[50].place.z(), 10.0 - 0.5 * standardGravity, 1e-5);
    ASSERT_EQ(path.impacts.size(), 2U);
    // A frame lasts 0.02 s: the time is known to it, the speed to what gravity adds in it.
    EXPECT_NEAR(path.impacts[0].time, std::sqrt(20.0 / standardGravity), 0.021);
    EXPECT_NEAR(path.impacts[0].speed, std::sqrt(20.0 * standardGravity), 0.02 * standardGravity * 1.5);
    EXPECT_NEAR(path.impacts[0].energy, 10.0 * standardGravity * 10.0, 10.0 * standardGravity * 10.0 * 0.04);
    EXPECT_NEAR(path.impacts[1].speed, 0.3 * std::sqrt(20.0 * standardGravity), 0.02 * standardGravity * 1.5);
    EXPECT_NEAR(path.restTime, std::sqrt(20.0 / standardGravity) * 1.6, 0.05);
    EXPECT_FALSE(path.removed);
}

TEST(FragmentPath, FreeFallIsNoImpact) {
    const Flight flight(1.2, [](double t) { return Vec3(4.0 * t, 0.0, 20.0 - 0.5 * standardGravity * t * t); });
    EXPECT_TRUE(flight.path().impacts.empty());
    EXPECT_NEAR(flight.path().points.back().speed, std::hypot(4.0, standardGravity * 1.19), 0.02);
}

TEST(FragmentPath, ABodyThatLeftEndsIt) {
    const Flight flight(2.0, [](double t) { return Vec3(t, 0.0, 0.0); }, 1.0);
    const FragmentPath path = flight.path();
    EXPECT_TRUE(path.removed);
    EXPECT_LT(path.points.back().time, 1.0);
    EXPECT_FALSE(fragmentPlace(flight.fragments, flight.trajectory, FragmentId{0}, 1.5));
    EXPECT_NEAR(fragmentPlace(flight.fragments, flight.trajectory, FragmentId{0}, 0.51)->x(), 0.51, 1e-6);
}

TEST(FragmentPath, CanBeCancelled) {
    const Flight flight(1.0, bouncing);
    Execution execution;
    execution.cancel();
    EXPECT_THROW(fragmentPath(flight.fragments, flight.trajectory, FragmentId{0}, standardGravity, execution), Cancelled);
}

}  // namespace
}  // namespace rubble
