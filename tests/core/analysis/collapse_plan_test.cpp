#include "core/analysis/debris/collapse_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/base/execution.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

TEST(CollapsePlan, DistanceFromARectangleIsZeroWithinAndStraightOutside) {
    const CollapsePlan plan({Vec2(0, 0), Vec2(10, 0), Vec2(10, 4), Vec2(0, 4), Vec2(5, 2), Vec2(5, 0), Vec2(0, 0)});
    EXPECT_EQ(plan.outline().size(), 4u) << "points within, on an edge and repeated are no corners";
    EXPECT_EQ(plan.distance(Vec2(5, 2)), 0.0);
    EXPECT_EQ(plan.distance(Vec2(10, 4)), 0.0);
    EXPECT_EQ(plan.distance(Vec2(3, 0)), 0.0);
    EXPECT_DOUBLE_EQ(plan.distance(Vec2(5, 7)), 3.0);
    EXPECT_DOUBLE_EQ(plan.distance(Vec2(-2, 1)), 2.0);
    EXPECT_DOUBLE_EQ(plan.distance(Vec2(13, 8)), 5.0) << "3 and 4 from the corner";
}

TEST(CollapsePlan, WithoutAreaItIsASegmentOrAPoint) {
    const CollapsePlan line({Vec2(0, 0), Vec2(2, 2), Vec2(1, 1)});
    EXPECT_NEAR(line.distance(Vec2(2, 0)), std::sqrt(2.0), 1e-15);
    EXPECT_DOUBLE_EQ(line.distance(Vec2(5, 6)), 5.0);
    EXPECT_DOUBLE_EQ(CollapsePlan({Vec2(1, 1), Vec2(1, 1)}).distance(Vec2(4, 5)), 5.0);
    const CollapsePlan none({Vec2(std::numeric_limits<double>::quiet_NaN(), 0.0)});
    EXPECT_TRUE(none.outline().empty());
    EXPECT_TRUE(std::isnan(none.distance(Vec2(0, 0))));
}

TEST(CollapsePlan, HoldsAllItsPointsWhateverTheirOrder) {
    std::mt19937 random(4);
    std::vector<Vec2> points;
    for (int i = 0; i < 300; ++i) {
        points.emplace_back(std::normal_distribution(0.0, 5.0)(random), std::normal_distribution(0.0, 2.0)(random));
    }
    const CollapsePlan plan(points);
    for (const Vec2& p : points) {
        EXPECT_LT(plan.distance(p), 1e-12);
    }
    std::shuffle(points.begin(), points.end(), random);
    EXPECT_EQ(CollapsePlan(points).outline(), plan.outline());
}

TEST(CollapsePlan, IsThatOfWhatDies) {
    scenes::Block ground;
    ground.name = "ground";
    ground.low = Vec3(-50, -50, -1);
    ground.size = Vec3(100, 100, 1);
    scenes::Block wall;
    wall.name = "wall";
    wall.low = Vec3(2, 3, 0);
    wall.size = Vec3(4, 1, 3);
    wall.cells = {4, 1, 3};
    wall.deathState = [](std::size_t e) { return e == 3 ? scenes::never : std::size_t{2}; };
    const auto fe = scenes::makeScene({ground, wall}, 4, 0.1);
    const Components components = groupComponents(fe->mesh(), {}, {}, {});
    const FragmentSet fragments = makeFragments(*fe, components, {}, Execution());
    ASSERT_EQ(fragments.size(), 11u);
    const CollapsePlan plan(fragments, fe->mesh());
    EXPECT_DOUBLE_EQ(plan.distance(Vec2(4, 6)), 2.0);
    EXPECT_DOUBLE_EQ(plan.distance(Vec2(0, 3.5)), 2.0);
    EXPECT_EQ(plan.distance(Vec2(6, 4)), 0.0);
}

}  // namespace
}  // namespace rubble
