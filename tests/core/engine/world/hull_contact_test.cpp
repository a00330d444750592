#include "core/engine/world/hull_contact.h"

#include <gtest/gtest.h>

#include <random>

#include "core/engine/soft/box_contact.h"

namespace rubble {
namespace {

struct Both {
    ConvexHull hull;
    PlacedBox box;
    PlacedHull placed;
};

Both cuboid(const Vec3& half, const Vec3& centre, const Quat& turn) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.push_back(Vec3(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0).cwiseProduct(half));
    }
    const Mat3 axes = turn.toRotationMatrix();
    return {hullFaces(corners), {centre, axes, half}, {nullptr, centre, axes, half.minCoeff()}};
}

Quat anyTurn(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Quat(normal(random), normal(random), normal(random), normal(random)).normalized();
}

double nearest(const ContactPatch& in, const PatchPoint& point) {
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < in.count; ++i) {
        const PatchPoint& other = in.points[static_cast<std::size_t>(i)];
        best = std::min(best, (other.position - point.position).norm() + std::abs(other.separation - point.separation));
    }
    return best;
}

/// Boxes as hulls have the contacts of boxes, in whatever way they lie: each point of one is a point of the other.
TEST(HullContact, OfBoxesIsThatOfBoxes) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> even(-1.0, 1.0);
    int touching = 0, edges = 0;
    for (int n = 0; n < 20000; ++n) {
        const Vec3 half(0.3 + 0.2 * even(random), 0.3 + 0.2 * even(random), 0.3 + 0.2 * even(random));
        Both a = cuboid(half, Vec3::Zero(), anyTurn(random));
        Both b = cuboid(half.reverse(), 0.7 * Vec3(even(random), even(random), even(random)), anyTurn(random));
        a.placed.hull = &a.hull;
        b.placed.hull = &b.hull;
        const ContactPatch boxes = collideBoxes(a.box, b.box, 0.01);
        const ContactPatch hulls = collideHulls(a.placed, b.placed, 0.01);
        if (boxes.separation < -0.1) {
            continue;  // deeper than any body gets into another in a step
        }
        ASSERT_EQ(boxes.count > 0, hulls.count > 0) << n;
        if (boxes.count == 0) {
            continue;
        }
        ++touching;
        edges += boxes.count == 1;
        EXPECT_NEAR(boxes.separation, hulls.separation, 1e-9) << n;
        EXPECT_GT(boxes.normal.dot(hulls.normal), 1.0 - 1e-9) << n;
        if (boxes.count == 4 || hulls.count == 4) {
            continue;  // of more than four points the choice may differ
        }
        EXPECT_EQ(boxes.count, hulls.count) << n;
        for (int i = 0; i < boxes.count; ++i) {
            EXPECT_LT(nearest(hulls, boxes.points[static_cast<std::size_t>(i)]), 1e-6) << n;
        }
    }
    EXPECT_GT(touching, 1000);
    EXPECT_GT(edges, 100);
}

TEST(HullContact, OfFacesHasFourPoints) {
    Both a = cuboid(Vec3::Constant(0.5), Vec3::Zero(), Quat::Identity());
    Both b = cuboid(Vec3::Constant(0.5), {0.2, 0.1, 0.999}, Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ())));
    a.placed.hull = &a.hull;
    b.placed.hull = &b.hull;
    const ContactPatch patch = collideHulls(a.placed, b.placed, 0.01);
    ASSERT_EQ(patch.count, 4);
    EXPECT_NEAR(patch.separation, -0.001, 1e-12);
    for (const PatchPoint& point : patch.points) {
        EXPECT_NEAR(point.separation, -0.001, 1e-12);
        EXPECT_NEAR(point.position.z(), 0.4995, 1e-12);
    }
    EXPECT_EQ(collideHulls(a.placed, b.placed, -0.01).count, 0);
}

}  // namespace
}  // namespace rubble
