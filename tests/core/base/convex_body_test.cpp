#include "core/base/convex_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/sequence.h"

namespace rubble {

namespace {

TEST(ConvexBody, ACubeOfManyPointsHasItsEightCorners) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 6; ++i) {
        for (int j = 0; j <= 6; ++j) {
            for (int k = 0; k <= 6; ++k) {
                points.emplace_back(10.0 + i / 3.0, -5.0 + j / 3.0, 100.0 + k / 3.0);
            }
        }
    }
    const auto body = convexBodyOf(points);
    ASSERT_TRUE(body.has_value());
    EXPECT_EQ(body->corners.size(), 8u);
    EXPECT_EQ(body->triangles.size(), 12u);
    EXPECT_NEAR(body->volume, 8.0, 1e-9);
    EXPECT_TRUE(body->sides.isApprox(Vec3(2, 2, 2), 1e-9));
    EXPECT_DOUBLE_EQ(body->leftOut, 0.0);
    for (const Vec3& corner : body->corners) {
        EXPECT_TRUE(corner.cwiseAbs().isApprox(Vec3(1, 1, 1), 1e-9));
    }
}

TEST(ConvexBody, LiesAboutItsCentreOfMass) {
    // A tetrahedron of three legs of 1, 2 and 3 m: its centre of mass lies a quarter of each from the corner.
    const auto body = convexBodyOf(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {0.1, 0.1, 0.1}});
    ASSERT_TRUE(body.has_value());
    EXPECT_NEAR(body->volume, 1.0, 1e-12);
    EXPECT_TRUE(std::any_of(body->corners.begin(), body->corners.end(),
                            [](const Vec3& corner) { return corner.isApprox(Vec3(-0.25, -0.5, -0.75), 1e-12); }));
    const ConvexBody half = stretchedTo(*body, {0.5, 2.0, 3.0});
    EXPECT_NEAR(half.volume, 0.5, 1e-12);
    EXPECT_TRUE(half.sides.isApprox(Vec3(0.5, 2.0, 3.0)));
}

TEST(ConvexBody, ABallKeepsTheCornersThatStandOutMost) {
    Sequence random(3);
    std::vector<Vec3> points;
    for (int i = 0; i < 5000; ++i) {
        points.push_back(random.turn() * Vec3(0.5, 0.0, 0.0));
    }
    const auto body = convexBodyOf(points);
    ASSERT_TRUE(body.has_value());
    EXPECT_EQ(body->corners.size(), hullCornersMax);
    // A ball of 0.5 m by 32 of its points: between an icosahedron's (0.61) and the whole.
    const double ball = 4.0 / 3.0 * std::numbers::pi * 0.125;
    EXPECT_GT(body->volume, 0.7 * ball);
    EXPECT_LT(body->volume, ball);
    EXPECT_GT(body->leftOut, 0.02);
    EXPECT_LT(body->leftOut, 0.15);
}

TEST(ConvexBody, WhatSpansNoVolumeIsNone) {
    EXPECT_FALSE(convexBodyOf({}).has_value());
    EXPECT_FALSE(convexBodyOf(std::vector<Vec3>(9, Vec3(1, 2, 3))).has_value());
    EXPECT_FALSE(convexBodyOf(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).has_value());
    EXPECT_FALSE(convexBodyOf(std::vector<Vec3>{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 1}}).has_value());
}

}  // namespace

}  // namespace rubble
