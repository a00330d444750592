#include "widgets/render/site/point_sight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rubble::render {

namespace {

Aabb boxAbout(const Vec3& middle, double half) {
    return {middle - Vec3::Constant(half), middle + Vec3::Constant(half)};
}

TEST(PointSight, ALengthTakesAsManyPixelsAsWhereItsBoxIsNearest) {
    Camera camera;
    camera.position = Vec3(0.0, -100.0, 0.0);
    camera.focalPoint = Vec3::Zero();
    const double tangent = std::tan(15.0 * std::numbers::pi / 180.0);
    EXPECT_NEAR(pixelsOf(camera, 4.0 / 3.0, 600, boxAbout(Vec3::Zero(), 10.0), 0.5), 0.5 * 600.0 / (2.0 * tangent * 90.0), 1e-9);
    camera.parallel = true;
    camera.parallelScale = 30.0;
    EXPECT_NEAR(pixelsOf(camera, 4.0 / 3.0, 600, boxAbout(Vec3::Zero(), 10.0), 0.5), 0.5 * 600.0 / 60.0, 1e-9);
}

TEST(PointSight, WhatLiesBesideOrBehindTakesNone) {
    Camera camera;
    camera.position = Vec3(0.0, -100.0, 0.0);
    camera.focalPoint = Vec3::Zero();
    EXPECT_EQ(pixelsOf(camera, 4.0 / 3.0, 600, boxAbout(Vec3(0.0, -200.0, 0.0), 10.0), 1.0), 0.0);
    EXPECT_EQ(pixelsOf(camera, 4.0 / 3.0, 600, boxAbout(Vec3(80.0, 0.0, 0.0), 10.0), 1.0), 0.0);
    EXPECT_EQ(pixelsOf(camera, 4.0 / 3.0, 600, boxAbout(Vec3(0.0, 0.0, 60.0), 10.0), 1.0), 0.0);
    EXPECT_GT(pixelsOf(camera, 4.0 / 3.0, 600, boxAbout(Vec3(40.0, 0.0, 0.0), 10.0), 1.0), 0.0) << "it reaches into the picture";
    // The camera stands in it.
    EXPECT_GT(pixelsOf(camera, 4.0 / 3.0, 600, boxAbout(Vec3(0.0, -100.0, 0.0), 10.0), 1.0), 1e4);
    EXPECT_EQ(pixelsOf(camera, 4.0 / 3.0, 600, Aabb(), 1.0), 0.0);
}

}  // namespace

}  // namespace rubble::render
