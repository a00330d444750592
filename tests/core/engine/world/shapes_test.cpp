#include <gtest/gtest.h>

#include <random>

#include "core/engine/world/body_shapes.h"
#include "core/engine/world/tight_box.h"
#include "core/simulation/run/bulking.h"
#include "tests/core/fragments/element_scene.h"

namespace rubble {
namespace {

std::vector<Vec3> boxCorners(const Vec3& half, const Mat3& turn, const Vec3& centre) {
    std::vector<Vec3> points;
    for (int i = 0; i < 8; ++i) {
        const Vec3 sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        points.push_back(centre + turn * sign.cwiseProduct(half));
    }
    return points;
}

TEST(TightBox, FindsATurnedBox) {
    std::mt19937 random(7);
    for (int i = 0; i < 50; ++i) {
        const Mat3 turn = test::randomRotation(random);
        const Vec3 half(0.3, 0.9, 1.7);
        const OrientedBox box = tightBox(boxCorners(half, turn, {1, 2, 3}), {});
        EXPECT_NEAR(box.volume(), 8 * half.prod(), 0.02 * 8 * half.prod());
        EXPECT_LT((box.centre - Vec3(1, 2, 3)).norm(), 0.02);
    }
}

TEST(TightBox, HoldsEveryPointAndIsNoLargerThanTheAxisBox) {
    std::mt19937 random(11);
    for (int i = 0; i < 50; ++i) {
        std::vector<Vec3> points;
        for (int j = 0; j < 30; ++j) {
            points.push_back(test::randomVector(random, 2.0));
        }
        const OrientedBox box = tightBox(points, {});
        for (const Vec3& p : points) {
            const Vec3 local = box.orientation.conjugate() * (p - box.centre);
            EXPECT_TRUE((local.cwiseAbs().array() <= box.halfExtents.array() + 1e-9).all());
        }
        EXPECT_LE(box.volume(), boxWithAxes(points, Mat3::Identity()).volume() + 1e-12);
    }
}

TEST(Hull, KeepsItsSize) {
    const ConvexPart hull = hullOf(boxCorners({0.5, 0.4, 0.3}, Mat3::Identity(), Vec3::Zero()), 0.005);
    ASSERT_EQ(hull.points.size(), 8u);
    Aabb extent;
    for (const Vec3& p : hull.points) {
        extent.extend(p);
    }
    // The engine's hull computer works on a grid of integers.
    EXPECT_NEAR(extent.max().x(), 0.5, 1e-4);
    EXPECT_NEAR(extent.max().z(), 0.3, 1e-4);
}

TEST(Hull, HasFewVerticesAndFlatSetsBecomeBoxes) {
    std::mt19937 random(3);
    std::vector<Vec3> ball;
    std::vector<Vec3> flat;
    for (int i = 0; i < 500; ++i) {
        ball.push_back(test::randomVector(random, 1.0).normalized());
        flat.emplace_back(ball.back().x(), ball.back().y(), 0.0);
    }
    EXPECT_LE(hullOf(ball, 0.005).points.size(), 32u);
    EXPECT_GE(hullOf(ball, 0.005).points.size(), 16u);
    const ConvexPart plate = hullOf(flat, 0.005);
    EXPECT_TRUE(plate.points.empty());
    EXPECT_GE(plate.box.halfExtents.minCoeff(), 0.005);
}

TEST(Bulking, IsOneForAClosePileAndMoreForALooseOne) {
    std::vector<DebrisBox> close;
    std::vector<DebrisBox> loose;
    for (int i = 0; i < 40; ++i) {
        for (int j = 0; j < 40; ++j) {
            OrientedBox box;
            box.halfExtents = Vec3::Constant(0.5);
            box.centre = Vec3(i, j, 0.5);
            close.push_back({box, 1.0});
            box.centre.z() = 1.0;
            loose.push_back({box, 1.0});
        }
    }
    // The outline is sampled at points, so that an edge counts half a raster more or less: 0.25 m of 40 m, twice.
    EXPECT_NEAR(measurePile(close, {}, {}).bulking, 1.0, 0.02);
    EXPECT_NEAR(measurePile(loose, {}, {}).bulking, 1.5, 0.03);
    EXPECT_TRUE(std::isnan(measurePile({}, {}, {}).bulking));
    // What lies where the structure stands is left out with its place.
    const std::vector<Aabb> standing{Aabb(Vec3(-1, -1, 0), Vec3(20, 60, 30))};
    EXPECT_NEAR(measurePile(loose, standing, {}).bulking, 1.5, 0.06);
}

TEST(Bulking, IsMeasuredFromTheTerrain) {
    // A slope of one in four from 10 m up, and the pile of loose slabs that lies along it.
    const auto slope = std::make_shared<const TerrainGrid>(-50.0, -50.0, 100.0, 2, 2, std::vector<double>{-2.5, 22.5, -2.5, 22.5});
    const Quat along = Quat::FromTwoVectors(Vec3::UnitX(), Vec3(4.0, 0.0, 1.0));
    std::vector<DebrisBox> pile;
    for (int i = 0; i < 40; ++i) {
        for (int j = 0; j < 40; ++j) {
            OrientedBox box;
            box.halfExtents = Vec3(0.5 * std::sqrt(17.0) / 4.0, 0.5, 0.5 * 4.0 / std::sqrt(17.0));
            box.orientation = along;
            box.centre = Vec3(i, j, slope->height(i, j) + 1.0);
            pile.push_back({box, box.volume()});
        }
    }
    // Slabs 1 m thick straight down, each half a metre above the slope: as loose as the level pile.
    EXPECT_NEAR(measurePile(pile, {}, {true, -5.0, slope}).bulking, 1.5, 0.03);
}

}  // namespace
}  // namespace rubble
