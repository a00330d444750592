#include "core/fe/control_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/error.h"
#include "core/fe/north.h"

namespace rubble {
namespace {

std::vector<ControlPoint> turned(double scale, double angle) {
    std::vector<ControlPoint> points;
    for (const Vec3& local : {Vec3(0, 0, 0), Vec3(40, 5, 2), Vec3(-12, 30, 7), Vec3(25, -18, -3)}) {
        const double x = scale * (std::cos(angle) * local.x() - std::sin(angle) * local.y());
        const double y = scale * (std::sin(angle) * local.x() + std::cos(angle) * local.y());
        points.push_back({"p", local, Vec3(451000.0 + x, 5311000.0 + y, 512.0 + local.z()), true});
    }
    return points;
}

TEST(ControlPoints, WhatSpeaksAgainstThemIsTold) {
    EXPECT_TRUE(checkControlPoints(turned(0.9996, 0.7)).empty());
    EXPECT_EQ(checkControlPoints(turned(3.2808, 0.7)).count("site.scale"), 1);
    const Findings twice = checkControlPoints(turned(0.5, 0.7));
    ASSERT_FALSE(twice.empty());
    EXPECT_NEAR(std::get<double>(twice.list().front().what.arguments.front().value), 2.0, 1e-9) << "80 m of it stand for 40 m";
    EXPECT_TRUE(checkControlPoints(turned(1.6, 0.7), 1.6).empty()) << "the system stretches as much";
    std::vector<ControlPoint> points = turned(1.0, 0.7);
    for (ControlPoint& point : points) {
        point.local.x() = -point.local.x();
    }
    const Findings mirrored = checkControlPoints(points);
    EXPECT_EQ(mirrored.count("site.mirrored"), 1);
    EXPECT_EQ(mirrored.list().size(), 1u) << "scale and residuals only follow from it";
    points = turned(1.0, 0.7);
    points[2].world.x() += 2.0;
    EXPECT_EQ(checkControlPoints(points).count("site.residual"), 1);
    points[2].used = false;
    EXPECT_TRUE(checkControlPoints(points).empty()) << "a point that is left out says nothing";
    points[1].used = points[0].used = false;
    EXPECT_EQ(checkControlPoints(points).count("site.one_point"), 1);
    EXPECT_TRUE(checkControlPoints({}).empty());
}

TEST(ControlPoints, ASimilarityIsFoundExactly) {
    const SiteFit fit = fitControlPoints(turned(0.9996, 0.7));
    EXPECT_NEAR(fit.scale, 0.9996, 1e-9);
    EXPECT_NEAR(fit.angle, 0.7, 1e-9);
    EXPECT_NEAR(fit.height, 512.0, 1e-9);
    EXPECT_LT(fit.rmsPlan, 1e-6);
    const Vec3 local(3.0, -7.0, 1.5);
    EXPECT_LT((fit.toLocal(fit.toWorld(local)) - local).norm(), 1e-6);
}

TEST(ControlPoints, AWrongPointShowsAndCanBeLeftOut) {
    std::vector<ControlPoint> points = turned(1.0, -0.2);
    points[1].world += Vec3(3.0, 0.0, 0.5);
    const SiteFit with = fitControlPoints(points);
    EXPECT_GT(with.rmsPlan, 0.5);
    points[1].used = false;
    const SiteFit without = fitControlPoints(points);
    EXPECT_LT(without.rmsPlan, 1e-6);
    EXPECT_EQ(without.used, 3u);
    EXPECT_NEAR(without.residuals[1].x(), 3.0, 1e-6);
    EXPECT_NEAR(without.residuals[1].z(), 0.5, 1e-6);
}

TEST(ControlPoints, TooFewOrOnePlaceAreRefused) {
    std::vector<ControlPoint> points = turned(1.0, 0.0);
    points.resize(1);
    EXPECT_THROW(fitControlPoints(points), UsageError);
    points.push_back(points.front());
    EXPECT_THROW(fitControlPoints(points), UsageError);
    points.back().world.x() = NAN;
    EXPECT_THROW(fitControlPoints(points), UsageError);
}

TEST(ControlPoints, NorthIsKnownFromASystemOrATurn) {
    SiteFit place;
    EXPECT_EQ(northOf(place, ""), std::nullopt);
    EXPECT_EQ(northOf(place, "EPSG:25832"), std::nullopt) << "a system that is only named says nothing of the model";
    EXPECT_EQ(placedSystem(place, "EPSG:25832"), "");
    place.height = 100.0;
    EXPECT_FALSE(hasPlace(place)) << "a height is no place in plan";
    place.shift = {356500.0, 5699500.0};
    EXPECT_EQ(northOf(place, "EPSG:25832"), 0.0);
    EXPECT_EQ(placedSystem(place, "EPSG:25832"), "EPSG:25832");
    EXPECT_EQ(northOf(place, ""), std::nullopt) << "an origin in no system";
    // A quarter turn counter-clockwise takes local x to north.
    place = fitControlPoints(turned(1.0, 0.5 * std::numbers::pi));
    const double north = northOf(place, "").value();
    const Vec3 way = place.toWorld(Vec3(std::sin(north), std::cos(north), 0.0)) - place.toWorld(Vec3::Zero());
    EXPECT_NEAR(way.x(), 0.0, 1e-9);
    EXPECT_GT(way.y(), 0.9);
}

}  // namespace
}  // namespace rubble
