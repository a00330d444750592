#include "core/validation/box_overlap.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/selftest/pile.h"

namespace rubble::selftest {
namespace {

OrientedBox cubeAt(const Vec3& centre, const Quat& turn = Quat::Identity()) {
    return {centre, turn, Vec3::Constant(0.5)};
}

TEST(BoxOverlap, OfBoxesAlongTheAxesIsTheLeastOfThree) {
    EXPECT_NEAR(overlapOf(cubeAt({0, 0, 0}), cubeAt({0.9, 0.2, 0.3})), 0.1, 1e-12);
    EXPECT_NEAR(overlapOf(cubeAt({0, 0, 0}), cubeAt({1.25, 0, 0})), -0.25, 1e-12);
    EXPECT_NEAR(overlapOf(cubeAt({0, 0, 0}), cubeAt({0, 0, 0})), 1.0, 1e-12);
}

TEST(BoxOverlap, OfATurnedCubeReachesHalfItsDiagonal) {
    const Quat turn(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitZ()));
    // An upright edge points at the face.
    EXPECT_NEAR(overlapOf(cubeAt({0, 0, 0}), cubeAt({1.2, 0, 0}, turn)), 0.5 + std::sqrt(0.5) - 1.2, 1e-12);
    // Two edges across each other: the way out is along both their normals.
    const Quat other(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitX()));
    const Quat edge(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitY()));
    EXPECT_NEAR(overlapOf(cubeAt({0, 0, 0}, other), cubeAt({0, 0, 1.35}, edge)), 2.0 * std::sqrt(0.5) - 1.35, 1e-12);
}

TEST(BoxOverlap, DoesNotDependOnTheOrderNorOnTheFrame) {
    Sequence random(1);
    for (int i = 0; i < 200; ++i) {
        const OrientedBox a{
            2.0 * random.direction(), random.turn(), {random.between(0.3, 2), random.between(0.3, 2), random.between(0.3, 2)}};
        const OrientedBox b{2.0 * random.direction(), random.turn(), {random.between(0.3, 2), random.between(0.3, 2), 0.5}};
        const double depth = overlapOf(a, b);
        EXPECT_NEAR(depth, overlapOf(b, a), 1e-9);
        const Quat turn = random.turn();
        const Vec3 shift = 10.0 * random.direction();
        const OrientedBox c{turn * a.centre + shift, turn * a.orientation, a.halfExtents};
        const OrientedBox d{turn * b.centre + shift, turn * b.orientation, b.halfExtents};
        EXPECT_NEAR(depth, overlapOf(c, d), 1e-9);
        // Taken apart along the line of centres by more than the reach of both, they are apart; what overlaps has points in common.
        const Vec3 apart = (b.centre - a.centre).normalized() * (a.halfExtents.norm() + b.halfExtents.norm());
        EXPECT_LT(overlapOf(a, {a.centre + 1.001 * apart, b.orientation, b.halfExtents}), 0.0);
    }
}

TEST(BoxOverlap, MeasureFindsEveryPair) {
    Sequence random(2);
    std::vector<OrientedBox> boxes;
    for (int i = 0; i < 120; ++i) {
        boxes.push_back({{random.between(0, 4), random.between(0, 4), random.between(0, 4)}, random.turn(), Vec3::Constant(0.3)});
    }
    double deepest = 0.0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            deepest = std::max(deepest, overlapOf(boxes[i], boxes[j]));
        }
    }
    const OverlapMeasure measure = measureOverlap(boxes);
    EXPECT_EQ(measure.deepest, deepest);
    EXPECT_NEAR(measure.deepestShare, deepest / 0.6, 1e-12);
    EXPECT_GT(measure.beyondFive, 0);
    EXPECT_LE(measure.p99, measure.deepest);
    EXPECT_EQ(measureOverlap({}).deepest, 0.0);
}

TEST(Sequence, IsEvenAndTheSameEverywhere) {
    Sequence random(42);
    double sum = 0.0;
    Vec3 mean = Vec3::Zero();
    for (int i = 0; i < 20000; ++i) {
        const double x = random.between(2.0, 3.0);
        EXPECT_GE(x, 2.0);
        EXPECT_LT(x, 3.0);
        sum += x;
        mean += random.turn() * Vec3::UnitX() / 20000.0;
    }
    // The mean of 20,000 even numbers scatters by 0.002, that of as many directions by 0.004 along each axis.
    EXPECT_NEAR(sum / 20000, 2.5, 0.01);
    EXPECT_LT(mean.norm(), 0.03);
    EXPECT_EQ(Sequence(7).between(0, 1), Sequence(7).between(0, 1));
    EXPECT_NE(Sequence(7).between(0, 1), Sequence(8).between(0, 1));
}

}  // namespace
}  // namespace rubble::selftest
