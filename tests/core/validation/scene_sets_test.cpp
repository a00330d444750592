#include "core/validation/scene_sets.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/validation/packing.h"
#include "core/validation/tilting_table.h"
#include "core/validation/voussoir_arch.h"

namespace rubble {

namespace {

TEST(Packing, DiceHaveTheCornersAndTheVolumeOfTheirKind) {
    EXPECT_EQ(dieCorners(Die::Cube).size(), 8u);
    EXPECT_EQ(dieCorners(Die::Tetrahedron).size(), 4u);
    EXPECT_EQ(dieCorners(Die::Octahedron).size(), 6u);
    EXPECT_EQ(dieCorners(Die::Dodecahedron).size(), 20u);
    EXPECT_EQ(dieCorners(Die::Icosahedron).size(), 12u);
    // Radius of the sphere around a regular body of 1 m3, by its edge.
    EXPECT_NEAR(dieCorners(Die::Tetrahedron).front().norm(), std::sqrt(6.0) / 4.0 * std::cbrt(6.0 * std::sqrt(2.0)), 1e-12);
    EXPECT_NEAR(dieCorners(Die::Dodecahedron).front().norm(),
                std::sqrt(3.0) * (1.0 + std::sqrt(5.0)) / 4.0 * std::cbrt(4.0 / (15.0 + 7.0 * std::sqrt(5.0))), 1e-12);
}

TEST(Packing, FewCubesFillAboutHalfOfTheMiddle) {
    Pour pour;
    pour.width = 1.8;
    pour.dice = 180;
    const double filled = pouredSolidFraction(pour, Execution{});
    // Walls are near: between the loosest and the densest that are known of cubes, with room for that.
    EXPECT_GT(filled, 0.45);
    EXPECT_LT(filled, 0.72);
    EXPECT_EQ(pouredSolidFraction(pour, Execution{}), filled);
}

TEST(Packing, RoundDiceAreNotPressedIntoEachOther) {
    Pour pour;
    pour.die = Die::Dodecahedron;
    pour.width = 1.8;
    pour.dice = 180;
    const double filled = pouredSolidFraction(pour, Execution{});
    // As hulls by GJK and EPA 0.68 of the middle was solid; closest random packing is 0.63.
    EXPECT_GT(filled, 0.45);
    EXPECT_LT(filled, 0.64);
}

TEST(VoussoirArch, StandsFromTheThicknessOfLimitAnalysisOn) {
    VoussoirArch arch;
    arch.voussoirs = 15;
    EXPECT_NEAR(leastArchThickness(arch, Execution{}) / limitArchThickness, 1.0, 0.05);
}

TEST(TiltingTable, WallGivesWayWhereLimitAnalysisSays) {
    const TiltedWall wall{{0.4, 0.6, 0.3}, 5, 3, 0.65};
    EXPECT_NEAR(tiltingAngle(wall, Execution{}) / limitAngle(wall), 1.0, 0.03);
}

TEST(TiltingTable, LimitAnalysisTellsSlidingFromToppling) {
    EXPECT_NEAR(limitAngle({{1.0, 1.0, 1.0}, 1, 1, 0.5}), 26.565, 1e-3);
    EXPECT_NEAR(limitAngle({{1.0, 1.0, 1.0}, 1, 1, 1.2}), 45.0, 1e-9);
    EXPECT_NEAR(limitAngle({{0.2, 0.4, 0.2}, 5, 3, 0.65}), 11.310, 1e-3);
}

TEST(TiltingTable, CubeSlidesAtItsAngleOfFriction) {
    const TiltedWall cube{{1.0, 1.0, 1.0}, 1, 1, 0.65};
    EXPECT_NEAR(tiltingAngle(cube, Execution{}) / limitAngle(cube), 1.0, 0.03);
}

}  // namespace

}  // namespace rubble
