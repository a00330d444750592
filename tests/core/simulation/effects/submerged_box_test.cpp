#include "core/simulation/effects/submerged_box.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace rubble {
namespace {

Quat randomTurn(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Quat(normal(random), normal(random), normal(random), normal(random)).normalized();
}

/// The same by the mid-point rule on n^3 cells of the box.
SubmergedBox summed(const OrientedBox& box, double level, int n) {
    SubmergedBox below;
    Vec3 moment = Vec3::Zero();
    const double cell = box.volume() / (n * n * n);
    for (int i = 0; i < n * n * n; ++i) {
        const Vec3 share((i % n + 0.5) / n, (i / n % n + 0.5) / n, (i / n / n + 0.5) / n);
        const Vec3 p = box.centre + box.orientation * ((2.0 * share - Vec3::Ones()).cwiseProduct(box.halfExtents));
        if (p.z() <= level) {
            below.volume += cell;
            moment += cell * p;
        }
    }
    below.centroid = below.volume > 0.0 ? Vec3(moment / below.volume) : box.centre;
    return below;
}

TEST(SubmergedBox, AgreesWithASumOverCellsForAnyTilt) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> size(0.1, 2.0), place(-1.0, 1.0);
    for (int i = 0; i < 40; ++i) {
        const OrientedBox box{
            {place(random), place(random), place(random)}, randomTurn(random), {size(random), size(random), size(random)}};
        const double level = box.centre.z() + 0.6 * place(random);
        const SubmergedBox exact = submerge(box, level);
        const SubmergedBox sum = summed(box, level, 60);
        // Of the cells that the plane cuts, sqrt(3) n^2 at most, each is off by half a cell at random: far below 0.5 % for n = 60.
        EXPECT_NEAR(exact.volume, sum.volume, 0.005 * box.volume()) << i;
        EXPECT_LT((exact.centroid - sum.centroid).norm(), 0.01 * box.halfExtents.norm()) << i;
        EXPECT_LE(exact.volume, box.volume() * (1.0 + 1e-12));
    }
}

TEST(SubmergedBox, VolumeGrowsWithTheLevelByTheWaterplane) {
    std::mt19937 random(11);
    const OrientedBox box{{1.0, -2.0, 3.0}, randomTurn(random), {0.7, 0.4, 1.1}};
    for (double level = 2.0; level < 4.0; level += 0.1) {
        const double step = 1e-5;
        const double slope = (submerge(box, level + step).volume - submerge(box, level - step).volume) / (2.0 * step);
        // A central difference of a piecewise cubic: exact but for step^2 and rounding.
        EXPECT_NEAR(submerge(box, level).waterplane, slope, 1e-6) << level;
    }
}

TEST(SubmergedBox, MomentsOfTheCutAreThoseOfARectangleForAnUprightBox) {
    const OrientedBox box{{5.0, 6.0, 0.0}, Quat::Identity(), {1.0, 2.0, 0.5}};
    const SubmergedBox below = submerge(box, 0.1);
    EXPECT_NEAR(below.volume, 2.0 * 4.0 * 0.6, 1e-12);
    EXPECT_LT((below.centroid - Vec3(5.0, 6.0, -0.2)).norm(), 1e-12);
    EXPECT_NEAR(below.waterplane, 8.0, 1e-12);
    EXPECT_NEAR(below.momentX, 2.0 * 64.0 / 12.0, 1e-11);  // l b^3 / 12
    EXPECT_NEAR(below.momentY, 4.0 * 8.0 / 12.0, 1e-11);
}

TEST(SubmergedBox, IsAllOrNothingFarFromTheLevel) {
    const OrientedBox box{{0.0, 0.0, 5.0}, Quat(Eigen::AngleAxisd(0.3, Vec3::UnitX())), {1.0, 1.0, 1.0}};
    EXPECT_EQ(submerge(box, 0.0).volume, 0.0);
    EXPECT_EQ(submerge(box, 10.0).volume, box.volume());
    EXPECT_EQ(submerge(box, 10.0).waterplane, 0.0);
    // Just touching, with corners exactly in the plane.
    const OrientedBox upright{{0.0, 0.0, 1.0}, Quat::Identity(), {1.0, 1.0, 1.0}};
    EXPECT_EQ(submerge(upright, 0.0).volume, 0.0);
    EXPECT_NEAR(submerge(upright, 2.0).volume, 8.0, 1e-12);
}

TEST(SubmergedBox, ProjectedAreaIsFaceOnEdgeOnAndItsMean) {
    const OrientedBox box{Vec3::Zero(), Quat::Identity(), {0.5, 0.5, 0.5}};
    EXPECT_NEAR(projectedArea(box, Vec3::UnitZ()), 1.0, 1e-12);
    EXPECT_NEAR(projectedArea(box, Vec3(1, 1, 0).normalized()), std::numbers::sqrt2, 1e-12);
    EXPECT_NEAR(projectedArea(box, Vec3(1, 1, 1).normalized()), std::numbers::sqrt3, 1e-12);
    // Cauchy: the mean over all directions of a convex body is a quarter of its surface.
    std::mt19937 random(3);
    double sum = 0.0;
    const int directions = 20000;
    for (int i = 0; i < directions; ++i) {
        sum += projectedArea(box, randomTurn(random) * Vec3::UnitX());
    }
    EXPECT_NEAR(sum / directions, 6.0 / 4.0, 0.01);  // 1 / sqrt(20000) of a spread of 0.2
}

}  // namespace
}  // namespace rubble
