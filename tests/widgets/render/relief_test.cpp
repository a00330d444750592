#include "widgets/render/site/relief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace rubble::render {
namespace {

TerrainGrid hills(std::size_t nodes = 201, double cell = 1.0) {
    std::vector<double> heights;
    for (std::size_t j = 0; j < nodes; ++j) {
        for (std::size_t i = 0; i < nodes; ++i) {
            heights.push_back(3.0 * std::sin(0.1 * static_cast<double>(i)) + 2.0 * std::cos(0.07 * static_cast<double>(j)));
        }
    }
    const double reach = 0.5 * cell * static_cast<double>(nodes - 1);
    return TerrainGrid(-reach, -reach, cell, nodes, nodes, heights);
}

const Aabb model(Vec3(-10.0, -5.0, 0.0), Vec3(10.0, 5.0, 12.0));

TEST(Relief, PointsLieOnTheTerrainAndReachTheRim) {
    const TerrainGrid terrain = hills();
    const Relief relief = reliefOf(terrain, model, 350.0);
    Aabb extent;
    for (const Vec3& p : relief.points) {
        EXPECT_DOUBLE_EQ(p.z(), terrain.height(p.x(), p.y()));
        extent.extend(p);
    }
    EXPECT_NEAR(extent.min().x(), -350.0, 1e-9);
    EXPECT_NEAR(extent.max().y(), 350.0, 1e-9);
}

TEST(Relief, TrianglesCoverTheGroundOnceAndFaceUp) {
    const Relief relief = reliefOf(hills(), model, 350.0);
    double area = 0.0;
    for (const auto& t : relief.triangles) {
        const Vec3& a = relief.points[static_cast<std::size_t>(t[0])];
        const Vec3 normal =
            (relief.points[static_cast<std::size_t>(t[1])] - a).cross(relief.points[static_cast<std::size_t>(t[2])] - a);
        EXPECT_GT(normal.z(), 0.0);
        area += 0.5 * normal.z();
    }
    EXPECT_NEAR(area, 700.0 * 700.0, 1e-6 * area);
}

TEST(Relief, AHugeRasterIsThinnedOut) {
    const Relief relief = reliefOf(hills(2001, 0.5), model, 800.0);
    // Some 200 lines each way at most: a software renderer draws them in a few milliseconds.
    EXPECT_LT(relief.points.size(), 220u * 220u);
    EXPECT_EQ(relief.shade.size(), relief.points.size());
}

TEST(Relief, LevelGroundIsInFullLightAndSlopesAreNot) {
    const TerrainGrid level(-100.0, -100.0, 100.0, 3, 3, std::vector<double>(9, 1.0));
    for (const double shade : reliefOf(level, model, 300.0).shade) {
        EXPECT_NEAR(shade, 1.0, 1e-9);
    }
    // Falls to the south-east.
    const TerrainGrid away(-100.0, -100.0, 100.0, 3, 3, {0, -50, -100, 50, 0, -50, 100, 50, 0});
    const Relief relief = reliefOf(away, model, 120.0);
    double darkest = 2.0;
    for (const double shade : relief.shade) {
        darkest = std::min(darkest, shade);
    }
    EXPECT_LT(darkest, 0.6);
}

TEST(Relief, GoesOnAroundTheWindowAboutTheStructureEverCoarser) {
    const TerrainGrid all = hills(2001);
    TerrainExtent extent;
    extent.column = extent.row = 900;
    extent.columns = extent.rows = 201;
    extent.x0 = extent.y0 = -100.0;
    const TerrainGrid wide(all.grid(), extent);
    const Aabb bounds(Vec3(-20, -10, 0), Vec3(20, 10, 10));
    const Relief relief = reliefOf(wide, bounds, 5000.0);
    EXPECT_LT(relief.points.size(), 300u * 300u);
    double before = -1e300;
    double widest = 0.0;
    for (const Vec3& p : relief.points) {
        EXPECT_EQ(p.z(), wide.height(p.x(), p.y()));
        if (p.y() == relief.points.front().y()) {
            EXPECT_GT(p.x(), before) << "rows go east";
            if (std::abs(p.x()) <= 1000.0 && before >= -1000.0) {
                widest = std::max(widest, p.x() - before);
            }
            before = p.x();
        }
    }
    EXPECT_LT(widest, 110.0) << "a tenth of the way there";
    const auto edge = [&](double x) {
        return std::any_of(relief.points.begin(), relief.points.end(), [x](const Vec3& p) { return p.x() == x; });
    };
    EXPECT_TRUE(edge(-1000.0));
    EXPECT_TRUE(edge(1000.0));
    // Within the window it is drawn as if nothing lay around it.
    const std::vector<Vec3> alone = reliefOf(hills(), bounds, 100.0).points;
    for (const Vec3& p : alone) {
        EXPECT_TRUE(std::any_of(relief.points.begin(), relief.points.end(), [&p](const Vec3& q) {
            return q.head<2>() == p.head<2>();
        })) << p.transpose();
    }
}

TEST(MeetTerrain, ARayMeetsTheSurfaceWhereItFirstGoesBelow) {
    const TerrainGrid terrain = hills();
    std::mt19937 random(4);
    std::uniform_real_distribution across(-60.0, 60.0);
    for (int i = 0; i < 200; ++i) {
        const Ray ray{Vec3(across(random), across(random), 30.0), Vec3(across(random), across(random), -60.0).normalized()};
        const auto met = meetTerrain(terrain, ray, 1000.0);
        ASSERT_TRUE(met.has_value());
        const Vec3 p = ray.origin + *met * ray.direction;
        EXPECT_NEAR(p.z(), terrain.height(p.x(), p.y()), 1e-6);
    }
    EXPECT_FALSE(meetTerrain(terrain, {Vec3(0, 0, 30), Vec3::UnitZ()}, 1000.0).has_value());
    EXPECT_FALSE(meetTerrain(terrain, {Vec3(0, 0, 30), Vec3::UnitX()}, 1000.0).has_value());
}

}  // namespace
}  // namespace rubble::render
