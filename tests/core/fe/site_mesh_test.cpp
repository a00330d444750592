#include "core/fe/site_mesh.h"

#include <gtest/gtest.h>

namespace rubble {
namespace {

/// A slope of 1 in 4 along x.
TerrainGrid slope() {
    std::vector<double> heights;
    for (int j = 0; j <= 10; ++j) {
        for (int i = 0; i <= 10; ++i) {
            heights.push_back(0.5 * i + 0.02 * i * j);
        }
    }
    return TerrainGrid(-10.0, -10.0, 2.0, 11, 11, heights);
}

/// A roof over a rectangle, with a wall below one side.
SiteMesh roof(double x0, double y0, double x1, double y1, double z) {
    SiteMesh mesh;
    mesh.points = {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}, {x0, y0, z - 5.0}, {x1, y0, z - 5.0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 1, 5}, {0, 5, 4}};
    return mesh;
}

TEST(SiteMesh, ARoofRaisesTheTerrainBelowItAndNothingElse) {
    const TerrainGrid ground = slope();
    const auto raised = terrainUnder(ground, {roof(-3.0, -3.0, 3.0, 3.0, 12.0)}, 0.5, 1e6, Execution());
    EXPECT_EQ(raised->cell(), 0.5);
    EXPECT_EQ(raised->nx(), 41u);
    EXPECT_NEAR(raised->height(0.3, -1.2), 12.0, 1e-12);
    EXPECT_NEAR(raised->height(3.0, 3.0), 12.0, 1e-12);
    for (const double x : {-9.7, -4.1, 3.6, 8.85}) {
        for (const double y : {-9.2, -3.7, 4.4, 9.9}) {
            EXPECT_NEAR(raised->height(x, y), ground.height(x, y), 1e-12) << x << " " << y;
        }
    }
}

TEST(SiteMesh, WhatLiesBelowTheGroundChangesNothing) {
    const TerrainGrid ground = slope();
    const auto same = terrainUnder(ground, {roof(-3.0, -3.0, 3.0, 3.0, -20.0)}, 2.0, 1e6, Execution());
    EXPECT_EQ(same->digest(), ground.digest());
}

TEST(SiteMesh, CellsAreSplitOnlyAsFarAsNodesAllow) {
    const auto raised = terrainUnder(slope(), {roof(-3.0, -3.0, 3.0, 3.0, 12.0)}, 0.25, 500.0, Execution());
    EXPECT_LE(raised->nx() * raised->ny(), 500u);
    EXPECT_EQ(raised->cell(), 1.0);
}

}  // namespace
}  // namespace rubble
