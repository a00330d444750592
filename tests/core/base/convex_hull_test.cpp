#include "core/base/convex_hull.h"

#include <gtest/gtest.h>

#include <random>

namespace rubble {
namespace {

std::vector<Vec3> cubeCorners(double half) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back(i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half);
    }
    return corners;
}

TEST(ConvexHull, OfACubeHasSixSquares) {
    const ConvexHull hull = hullFaces(cubeCorners(0.5));
    ASSERT_EQ(hull.faces.size(), 6u);
    EXPECT_EQ(hull.edges.size(), 12u);
    for (const HullFace& face : hull.faces) {
        EXPECT_EQ(face.corners.size(), 4u);
        EXPECT_NEAR(face.distance, 0.5, 1e-12);
        const Vec3& a = hull.corners[face.corners[0]];
        const Vec3 around = (hull.corners[face.corners[1]] - a).cross(hull.corners[face.corners[2]] - a);
        EXPECT_NEAR(around.normalized().dot(face.normal), 1.0, 1e-12);
    }
    for (const HullEdge& edge : hull.edges) {
        EXPECT_NEAR((hull.corners[edge.to] - hull.corners[edge.from]).norm(), 1.0, 1e-12);
        EXPECT_NEAR(hull.faces[edge.left].normal.dot(hull.faces[edge.right].normal), 0.0, 1e-12);
    }
}

TEST(ConvexHull, HoldsEulersLawAndAllPoints) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> even(-1.0, 1.0);
    for (int n = 0; n < 20; ++n) {
        std::vector<Vec3> points;
        for (int i = 0; i < 24; ++i) {
            points.push_back(Vec3(even(random), even(random), even(random)).normalized());
        }
        const ConvexHull hull = hullFaces(points);
        // Every point of a sphere is a corner: V - E + F = 2, and all faces are triangles.
        EXPECT_EQ(hull.faces.size(), 2u * 24u - 4u);
        EXPECT_EQ(hull.edges.size(), 3u * 24u - 6u);
        for (const HullFace& face : hull.faces) {
            for (const Vec3& p : points) {
                EXPECT_LE(face.normal.dot(p), face.distance + 1e-9);
            }
        }
    }
}

TEST(ConvexHull, OfWhatIsFlatHasNoFaces) {
    std::vector<Vec3> square = cubeCorners(0.5);
    square.resize(4);
    EXPECT_TRUE(hullFaces(square).faces.empty());
    EXPECT_TRUE(hullFaces({}).faces.empty());
}

}  // namespace
}  // namespace rubble
