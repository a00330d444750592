#include "core/evidence/surveys/edge_rings.h"

#include <gtest/gtest.h>

namespace rubble {

namespace {

using Plan = Eigen::Vector2d;

constexpr double edgeGap = 0.05;  // m

double areaOf(const OutlineRing& ring) {
    double twice = 0.0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Plan& a = ring[k];
        const Plan& b = ring[(k + 1) % ring.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return std::abs(0.5 * twice);
}

TEST(EdgeRings, AnOpenLineIsClosedAndItsGapMeasured) {
    const EdgeRings made = joinedRings({{Plan(0, 0), Plan(4, 0), Plan(4, 0), Plan(4, 3), Plan(0, 3)}}, edgeGap);
    ASSERT_EQ(made.rings.size(), 1u);
    EXPECT_EQ(made.rings[0], (OutlineRing{Plan(0, 0), Plan(4, 0), Plan(4, 3), Plan(0, 3)})) << "in its order, each corner once";
    EXPECT_EQ(made.closed, 1u);
    EXPECT_DOUBLE_EQ(made.longest, 3.0);
}

TEST(EdgeRings, ALineThatEndsWhereItBeganIsClosedAlready) {
    const EdgeRings made = joinedRings({{Plan(0, 0), Plan(4, 0), Plan(4, 3), Plan(0.01, 0.01)}}, edgeGap);
    ASSERT_EQ(made.rings.size(), 1u);
    EXPECT_EQ(made.rings[0].size(), 3u);
    EXPECT_EQ(made.closed, 0u);
}

TEST(EdgeRings, PiecesAreJoinedAtTheirEndsWhicheverWayTheyRun) {
    // A square in four pieces, two of them drawn backwards, in no order, and the second ring whole.
    const EdgeRings made = joinedRings({{Plan(0, 0), Plan(10, 0)},
                                        {Plan(0, 10), Plan(10, 10)},
                                        {Plan(20, 0), Plan(22, 0), Plan(22, 2), Plan(20, 0)},
                                        {Plan(10, 0.02), Plan(10, 10)},
                                        {Plan(0, 10), Plan(0, 0.03)},
                                        {Plan(50, 50), Plan(51, 50)}},
                                       edgeGap);
    ASSERT_EQ(made.rings.size(), 2u);
    EXPECT_NEAR(areaOf(made.rings[0]), 100.0, 0.5);
    EXPECT_NEAR(areaOf(made.rings[1]), 2.0, 1e-12);
    EXPECT_EQ(made.closed, 0u);
    EXPECT_EQ(made.leftOut, 1u) << "a line of two corners that meets no other encloses nothing";
    for (const OutlineRing& ring : made.rings) {
        EXPECT_FALSE(crossesItself(ring));
    }
}

TEST(EdgeRings, PlacesOutOfOrderCross) {
    EXPECT_TRUE(crossesItself({Plan(0, 0), Plan(4, 3), Plan(4, 0), Plan(0, 3)}));
    EXPECT_FALSE(crossesItself({Plan(0, 0), Plan(4, 0), Plan(4, 3), Plan(0, 3)}));
    EXPECT_FALSE(crossesItself({Plan(0, 0), Plan(4, 0), Plan(1, 1)}));
}

}  // namespace

}  // namespace rubble
