#include "widgets/render/site/ground_shade.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "widgets/render/basics/sun.h"

namespace rubble::render {
namespace {

const Aabb model(Vec3(-20.0, -5.0, 0.0), Vec3(20.0, 5.0, 12.0));

struct Triangles {
    std::vector<float> points;
    std::vector<std::int32_t> corners;
};

/// A closed box, its faces outwards.
Triangles box(const Vec3& low, const Vec3& high) {
    Triangles made;
    for (int c = 0; c < 8; ++c) {
        for (int axis = 0; axis < 3; ++axis) {
            made.points.push_back(static_cast<float>((c >> axis & 1) != 0 ? high[axis] : low[axis]));
        }
    }
    made.corners = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    return made;
}

TEST(GroundShade, NothingIsInTheShadeBeforeAndAfter) {
    GroundShade shade;
    EXPECT_TRUE(shade.empty());
    EXPECT_EQ(shade.shadeAt(0.0, 0.0), 0.0);
    shade.set(model, SiteSurface{});
    const Triangles block = box({-1, -1, 0}, {1, 1, 2});
    EXPECT_EQ(shade.shadeAt(0.0, 0.0), 0.0);
    shade.bake(block.points, block.corners);
    EXPECT_GT(shade.shadeAt(0.0, 0.0), 0.5);
    const auto version = shade.version();
    shade.clear();
    EXPECT_GT(shade.version(), version);
    EXPECT_EQ(shade.shadeAt(0.0, 0.0), 0.0);
}

TEST(GroundShade, DebrisIsInTheShadowOfWhatStandsTowardsTheSun) {
    GroundShade shade;
    shade.set(model, SiteSurface{});
    // A wall, and two blocks that lie behind it and before it, seen from the sun.
    const Vec3 away = -Vec3(sun.x(), sun.y(), 0.0).normalized();
    Triangles all = box({-1, -1, 0}, {1, 1, 10});
    const auto add = [&](const Vec3& middle) {
        const auto first = static_cast<std::int32_t>(all.points.size() / 3);
        const Triangles block = box(middle - Vec3(0.4, 0.4, 0.0), middle + Vec3(0.4, 0.4, 0.5));
        all.points.insert(all.points.end(), block.points.begin(), block.points.end());
        for (const std::int32_t corner : block.corners) {
            all.corners.push_back(first + corner);
        }
    };
    add(3.0 * away);
    add(-6.0 * away);
    EXPECT_TRUE(shade.pointShade().empty());
    shade.bake(all.points, all.corners);
    ASSERT_EQ(shade.pointShade().size(), all.points.size() / 3);
    const auto top = [&](std::size_t box) { return shade.pointShade()[8 * box + 7]; };
    EXPECT_LT(top(0), 0.05F) << "the top of the wall is in the light";
    EXPECT_GT(top(1), 0.3F);
    EXPECT_LT(top(2), 0.15F);
    shade.clear();
    EXPECT_TRUE(shade.pointShade().empty());
}

TEST(GroundShade, AFragmentThatLiesDarkensTheGroundBeneathAndBeside) {
    GroundShade shade;
    shade.set(model, SiteSurface{});
    const Triangles block = box({-0.5, -0.5, 0}, {0.5, 0.5, 0.6});
    shade.bake(block.points, block.corners);
    EXPECT_GT(shade.shadeAt(0.0, 0.0), 0.6);
    // On all four sides, also towards the sun.
    for (const auto& [x, y] : {std::pair(-0.6, 0.0), std::pair(0.6, 0.0), std::pair(0.0, -0.6), std::pair(0.0, 0.6)}) {
        EXPECT_GT(shade.shadeAt(x, y), 0.05) << x << " " << y;
    }
    EXPECT_EQ(shade.shadeAt(-4.0, 0.0), 0.0);
    EXPECT_EQ(shade.shadeAt(4.0, 4.0), 0.0);
}

TEST(GroundShade, AHighSlabThrowsItsShadowAwayFromTheSunAndNoneStraightBelow) {
    GroundShade shade;
    shade.set(model, SiteSurface{});
    const Triangles slab = box({-1, -1, 9.5}, {1, 1, 10.0});
    shade.bake(slab.points, slab.corners);
    EXPECT_EQ(shade.shadeAt(0.0, 0.0), 0.0);
    const double east = -sun.x() / sun.z() * 9.75;
    const double north = -sun.y() / sun.z() * 9.75;
    EXPECT_NEAR(shade.shadeAt(east, north), 0.62, 0.01) << "the sun's share, without that of nearness";
    EXPECT_EQ(shade.shadeAt(-east, -north), 0.0);
}

TEST(GroundShade, OnATerrainHeightsCountFromTheSlope) {
    // Ground that rises 1 in 2 to the east: 10 m at x = 20.
    std::vector<double> heights;
    for (int j = 0; j < 41; ++j) {
        for (int i = 0; i < 41; ++i) {
            heights.push_back(0.5 * (i * 2.0 - 40.0));
        }
    }
    SiteSurface slope;
    slope.terrain = std::make_shared<TerrainGrid>(-40.0, -40.0, 2.0, 41, 41, heights);
    GroundShade shade;
    shade.set(model, slope);
    // It lies on the slope at x = 10.
    const Triangles block = box({9.5, -0.5, 4.7}, {10.5, 0.5, 5.6});
    shade.bake(block.points, block.corners);
    EXPECT_GT(shade.shadeAt(10.0, 0.0), 0.5);
    EXPECT_LT(shade.shadeAt(14.0, 1.5), 0.01) << "where level ground at 0 m would have its shadow";
}

TEST(GroundShade, WhatGoesAstrayBreaksNothing) {
    GroundShade shade;
    shade.set(model, SiteSurface{});
    Triangles far = box({900, 900, 0}, {901, 901, 2});
    shade.bake(far.points, far.corners);
    far.points.assign(far.points.size(), std::nanf(""));
    shade.bake(far.points, far.corners);
    for (const float each : shade.shade()) {
        ASSERT_EQ(each, 0.0F);
    }
    shade.bake({}, {});
    shade.set(Aabb(), SiteSurface{});
    EXPECT_TRUE(shade.empty());
}

}  // namespace
}  // namespace rubble::render
