#include "core/engine/world/bricks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rubble {
namespace {

/// A hexahedron of 2 x 1 x 1 m at a place, its upper side moved by a share of its height.
std::vector<Vec3> sheared(const Vec3& low, double shear) {
    std::vector<Vec3> corners;
    for (const double z : {0.0, 1.0}) {
        for (const Vec3& c : {Vec3(0, 0, z), Vec3(2, 0, z), Vec3(2, 1, z), Vec3(0, 1, z)}) {
            corners.push_back(low + c + Vec3(shear * z, 0, 0));
        }
    }
    return corners;
}

bool contains(const OrientedBox& box, const Vec3& p) {
    return ((box.orientation.conjugate() * (p - box.centre)).cwiseAbs().array() <= box.halfExtents.array() + 1e-9).all();
}

TEST(Bricks, ABoxIsItsOwnBrick) {
    const OrientedBox brick = brickOf(ElementShape::Hexahedron, sheared(Vec3(1, 2, 3), 0.0));
    EXPECT_LT((brick.centre - Vec3(2, 2.5, 3.5)).norm(), 1e-12);
    EXPECT_NEAR(brick.volume(), 2.0, 1e-12);
    for (const Vec3& corner : sheared(Vec3(1, 2, 3), 0.0)) {
        EXPECT_TRUE(contains(brick, corner));
    }
}

TEST(Bricks, SkewedOnesHaveTheVolumeOfTheirSolidsAndLieInCourses) {
    const OrientedBox lower = brickOf(ElementShape::Hexahedron, sheared(Vec3(0, 0, 0), 0.4));
    const OrientedBox upper = brickOf(ElementShape::Hexahedron, sheared(Vec3(0.4, 0, 1), 0.4));
    EXPECT_NEAR(lower.volume(), 2.0, 1e-12) << "shear keeps the volume";
    EXPECT_NEAR((upper.centre - lower.centre).z(), 1.0, 1e-12);
    // Courses: the long edge stays an axis, so the heights of two courses do not overlap.
    EXPECT_NEAR(std::abs((lower.orientation * Vec3::UnitX()).x()), 1.0, 1e-12);
    const double reach = (lower.orientation.toRotationMatrix().cwiseAbs() * lower.halfExtents).z();
    EXPECT_LE(2.0 * reach, 1.0 + 1e-12);
}

TEST(Bricks, OtherShapesKeepCentreAndVolume) {
    const std::vector<Vec3> tetrahedron{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    const OrientedBox brick = brickOf(ElementShape::Tetrahedron, tetrahedron);
    EXPECT_NEAR(brick.volume(), 1.0 / 6.0, 1e-12);
    EXPECT_LT((brick.centre - Vec3(0.25, 0.25, 0.25)).norm(), 1e-12);
}

TEST(Bricks, AreJoinedWhereTheyFillABox) {
    std::vector<OrientedBox> bricks;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 3; ++j) {
            bricks.push_back(brickOf(ElementShape::Hexahedron, sheared(Vec3(2.0 * i, 1.0 * j, 0), 0.0)));
        }
    }
    const std::vector<OrientedBox> wall = joinedBricks(bricks, {});
    ASSERT_EQ(wall.size(), 1u);
    EXPECT_NEAR(wall.front().volume(), 24.0, 1e-9);
    // One that stands out stays apart, and what touches nothing too.
    bricks.push_back(brickOf(ElementShape::Hexahedron, sheared(Vec3(0, 0, 1), 0.0)));
    bricks.push_back(brickOf(ElementShape::Hexahedron, sheared(Vec3(0, 0, 9), 0.0)));
    const std::vector<OrientedBox> three = joinedBricks(bricks, {});
    ASSERT_EQ(three.size(), 3u);
    double volume = 0.0;
    for (const OrientedBox& box : three) {
        volume += box.volume();
    }
    EXPECT_NEAR(volume, 28.0, 1e-9) << "every box has the volume of its bricks";
}

TEST(Bricks, OfAMeshFarFinerThanDebrisAreJoinedOverGaps) {
    // A wall of 4 by 4 columns of ten slices each, of which every other one has gone.
    std::vector<OrientedBox> bricks;
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 40; k += 2) {
            OrientedBox& slice = bricks.emplace_back();
            slice.centre = Vec3(i, 0, 0.1 * k + 0.05);
            slice.halfExtents = Vec3(0.5, 0.5, 0.05);
        }
    }
    EXPECT_EQ(joinedBricks(bricks, {}).size(), 20u) << "rows, one by one";
    JoinLimits limits;
    limits.finest = 0.95;
    EXPECT_EQ(joinedBricks(bricks, limits).size(), 20u) << "a slice is a metre long: none is shorter";
    limits.finest = 1.0;
    std::vector<OrientedBox> few = bricks;
    std::erase_if(few, [](const OrientedBox& slice) { return slice.centre.x() > 0.5; });
    const std::vector<OrientedBox> blocks = joinedBricks(few, limits);
    EXPECT_LE(blocks.size(), 5u);
    double volume = 0.0;
    for (const OrientedBox& block : blocks) {
        EXPECT_LE(block.halfExtents.maxCoeff(), 0.5 + 1e-12);
        volume += block.volume();
    }
    EXPECT_NEAR(volume, 20 * 0.1, 1e-9) << "gaps give no volume";
}

TEST(Bricks, AreCoarserWhereThereWouldBeTooMany) {
    std::vector<OrientedBox> scattered;
    for (int i = 0; i < 300; ++i) {
        OrientedBox& brick = scattered.emplace_back();
        brick.centre = Vec3(3.0 * (i % 20), 5.0 * (i / 20), i % 7);
        brick.halfExtents = Vec3(0.5, 0.4, 0.3);
    }
    EXPECT_EQ(joinedBricks(scattered, {}).size(), 300u);
    JoinLimits limits;
    limits.boxesMax = 50;
    const std::vector<OrientedBox> boxes = joinedBricks(scattered, limits);
    EXPECT_LE(boxes.size(), 50u);
    double volume = 0.0;
    for (const OrientedBox& box : boxes) {
        volume += box.volume();
    }
    EXPECT_NEAR(volume, 300 * 0.48, 1e-9);
}

TEST(Bricks, NoneGiveNone) {
    EXPECT_TRUE(joinedBricks({}, {}).empty());
}

}  // namespace
}  // namespace rubble
