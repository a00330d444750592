#include "core/simulation/run/island_blows.h"

#include <gtest/gtest.h>

#include "core/base/standard_gravity.h"

namespace rubble {
namespace {

constexpr ElementIndex element{3};
/// m/s that gravity adds in 0.1 s.
const Vec3 fall(0, 0, -0.1 * standardGravity);

TEST(IslandBlows, AreSofterWhereTheEngineStopsLessThanHalfAsHard) {
    IslandBlows blows;
    blows.begin(element, Vec3(0, 0, -8));
    EXPECT_FALSE(blows.softer(element)) << "nothing has been hit yet";
    // The FE result stops it at once, the engine in four intervals.
    blows.advance(element, Vec3::Zero(), Vec3(0, 0, -6), fall);
    EXPECT_TRUE(blows.softer(element));
    blows.advance(element, Vec3::Zero(), Vec3(0, 0, -4), fall);
    EXPECT_TRUE(blows.softer(element)) << "3 of 9 m/s, free fall taken off";
    blows.advance(element, Vec3::Zero(), Vec3(0, 0, 2), fall);
    EXPECT_FALSE(blows.softer(element)) << "7 of 9 m/s";
}

TEST(IslandBlows, CountNoFreeFall) {
    IslandBlows blows;
    blows.begin(element, Vec3::Zero());
    for (int i = 1; i <= 20; ++i) {
        blows.advance(element, i * fall, Vec3::Zero(), fall);
    }
    EXPECT_FALSE(blows.softer(element)) << "the FE result lets it fall; what holds it up in the engine is a load";
    blows.advance(element, 21.0 * fall + Vec3(0.9, 0, 0), Vec3::Zero(), fall);
    EXPECT_FALSE(blows.softer(element)) << "less than 1 m/s is no blow";
    blows.advance(element, Vec3(30, 0, 0), Vec3::Zero(), fall);
    EXPECT_TRUE(blows.softer(element));
}

}  // namespace
}  // namespace rubble
