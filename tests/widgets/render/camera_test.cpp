#include "widgets/render/basics/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace rubble::render {
namespace {

/// Place of a point in the pane, [0, 1] from left and top: the inverse of rayThrough(), written independently of it.
Eigen::Vector2d placeOf(const Camera& camera, const Vec3& p, double aspect) {
    const Vec3 forward = (camera.focalPoint - camera.position).normalized();
    const Vec3 right = forward.cross(camera.up).normalized();
    const Vec3 up = right.cross(forward);
    const Vec3 d = p - camera.position;
    const double half =
        camera.parallel ? camera.parallelScale : std::tan(camera.viewAngle * std::numbers::pi / 360.0) * d.dot(forward);
    return {0.5 + 0.5 * d.dot(right) / (half * aspect), 0.5 - 0.5 * d.dot(up) / half};
}

class RandomCameras : public testing::Test {
protected:
    double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(m_engine); }
    Vec3 point(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
    Camera camera() {
        Camera c;
        c.focalPoint = point(50);
        do {
            c.position = c.focalPoint + point(200);
        } while (std::hypot(c.position.x() - c.focalPoint.x(), c.position.y() - c.focalPoint.y()) < 10.0);
        c.viewAngle = number(10, 60);
        c.parallel = number(0, 1) < 0.3;
        c.parallelScale = number(5, 50);
        return c;
    }

private:
    std::mt19937 m_engine{7};
};

using CameraFit = RandomCameras;
using CameraMoves = RandomCameras;

TEST_F(CameraFit, ShowsEveryCornerAndFillsThePane) {
    for (int i = 0; i < 300; ++i) {
        const Vec3 low = point(100);
        const Aabb box(low, low + Vec3(number(0.1, 300), number(0.1, 60), number(0.1, 60)));
        const double aspect = number(0.3, 4.0);
        Camera c = fitCamera(box, aspect, static_cast<Preset>(i % 3));
        if (i % 2 == 0) {
            c.parallel = true;
            c = refit(c, box, aspect);
        }
        double widest = 0.0;
        for (int k = 0; k < 8; ++k) {
            const Eigen::Vector2d p = placeOf(c, box.corner(static_cast<Aabb::CornerType>(k)), aspect);
            EXPECT_GE(p.minCoeff(), -1e-9);
            EXPECT_LE(p.maxCoeff(), 1.0 + 1e-9);
            widest = std::max({widest, std::abs(p.x() - 0.5), std::abs(p.y() - 0.5)});
        }
        EXPECT_GT(widest, 0.4);  // the margin takes 6 %, the rest of the pane is used along one side
    }
}

TEST_F(CameraFit, EmptyOrBrokenBoundsKeepASoundCamera) {
    EXPECT_EQ(fitCamera(Aabb(), 1.0), Camera{});
    const Camera c = fitCamera(Aabb(Vec3::Zero(), Vec3::Zero()), 1.5);
    EXPECT_TRUE(c.position.allFinite());
    EXPECT_GT((c.position - c.focalPoint).norm(), 0.0);
    const Camera start;
    EXPECT_EQ(refit(start, Aabb(Vec3::Zero(), Vec3::Constant(std::nan(""))), 1.0), start);
}

TEST_F(CameraMoves, RayRunsThroughThePlaceItCameFrom) {
    for (int i = 0; i < 200; ++i) {
        const Camera c = camera();
        const double u = number(0, 1), v = number(0, 1), aspect = number(0.5, 3);
        const Ray ray = rayThrough(c, u, v, aspect);
        EXPECT_NEAR(ray.direction.norm(), 1.0, 1e-12);
        const Eigen::Vector2d back = placeOf(c, ray.origin + number(1, 100) * ray.direction, aspect);
        EXPECT_NEAR(back.x(), u, 1e-9);
        EXPECT_NEAR(back.y(), v, 1e-9);
    }
}

TEST_F(CameraMoves, ZoomKeepsThePointUnderTheCursor) {
    for (int i = 0; i < 200; ++i) {
        const Camera c = camera();
        const double u = number(0, 1), v = number(0, 1), aspect = number(0.5, 3), factor = number(0.3, 4);
        const Ray ray = rayThrough(c, u, v, aspect);
        const Vec3 forward = (c.focalPoint - c.position).normalized();
        const Vec3 under = ray.origin + ray.direction * ((c.focalPoint - ray.origin).dot(forward) / ray.direction.dot(forward));
        const Camera z = zoom(c, factor, u, v, aspect);
        const Eigen::Vector2d p = placeOf(z, under, aspect);
        EXPECT_NEAR(p.x(), u, 1e-9);
        EXPECT_NEAR(p.y(), v, 1e-9);
        EXPECT_NEAR(metresPerPixel(z, 400) * factor, metresPerPixel(c, 400), 1e-9 * metresPerPixel(c, 400) * factor);
    }
    const Camera c = camera();
    EXPECT_EQ(zoom(c, 0.0, 0.5, 0.5, 1.0), c);
    EXPECT_EQ(zoom(c, std::nan(""), 0.5, 0.5, 1.0), c);
}

TEST_F(CameraMoves, PanMovesTheFocalPlaneWithTheMouse) {
    for (int i = 0; i < 200; ++i) {
        const Camera c = camera();
        const double aspect = 1.6, height = 500;
        const Camera moved = pan(c, 80, -30, height);
        const Eigen::Vector2d p = placeOf(moved, c.focalPoint, aspect);
        EXPECT_NEAR(p.x(), 0.5 + 80 / (height * aspect), 1e-9);
        EXPECT_NEAR(p.y(), 0.5 - 30 / height, 1e-9);
    }
}

TEST_F(CameraMoves, OrbitKeepsDistanceAndComesBackAfterAFullTurn) {
    for (int i = 0; i < 200; ++i) {
        const Camera c = camera();
        const double distance = (c.position - c.focalPoint).norm();
        Camera turned = c;
        for (int k = 0; k < 8; ++k) {
            turned = orbit(turned, std::numbers::pi / 4.0, 0.0);
            EXPECT_NEAR((turned.position - turned.focalPoint).norm(), distance, 1e-9 * distance);
        }
        const double elevation = std::asin((c.position.z() - c.focalPoint.z()) / distance);
        if (std::abs(elevation) < 1.5) {
            EXPECT_NEAR((turned.position - c.position).norm(), 0.0, 1e-6 * distance);
        }
        const Camera above = orbit(c, 0.3, 10.0);
        EXPECT_LT(above.position.z() - above.focalPoint.z(), distance);  // never over the pole
    }
}

TEST_F(CameraMoves, OrbitLeavesTheTopViewWithoutATurn) {
    const Camera top = fitCamera(Aabb(Vec3(-50, -5, 0), Vec3(50, 5, 20)), 2.0, Preset::Top);
    const Camera tilted = orbit(top, 0.0, -0.5);
    EXPECT_LT(tilted.position.y(), top.position.y() - 1.0);  // what was up on the picture stays ahead
    EXPECT_NEAR(tilted.position.x(), top.position.x(), 1e-6);
}

TEST_F(CameraMoves, FittingOnceMoreShowsAlikeAndAnotherPaneDoesNot) {
    const Aabb box(Vec3(-50, -5, 0), Vec3(50, 5, 20));
    for (int i = 0; i < 50; ++i) {
        const Camera fitted = refit(camera(), box, 1.3);
        EXPECT_TRUE(showsAlike(refit(fitted, box, 1.3), fitted));
        EXPECT_FALSE(showsAlike(zoom(fitted, 1.001, 0.5, 0.5, 1.3), fitted));
        EXPECT_FALSE(showsAlike(withProjection(fitted, !fitted.parallel), fitted));
    }
}

TEST_F(CameraMoves, BetweenStartsAndEndsAtItsCameras) {
    for (int i = 0; i < 50; ++i) {
        const Camera a = camera(), b = camera();
        EXPECT_EQ(between(a, b, 0.0), a);
        EXPECT_EQ(between(a, b, 1.0), b);
        const double d = (between(a, b, 0.5).position - between(a, b, 0.5).focalPoint).norm();
        EXPECT_NEAR(d, 0.5 * ((a.position - a.focalPoint).norm() + (b.position - b.focalPoint).norm()), 1e-9 * d);
    }
}

TEST(Camera, ProjectingUndoesTheRayThroughAPixel) {
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int i = 0; i < 200; ++i) {
        Camera camera = fitCamera(Aabb(Vec3(-20, -5, 0), Vec3(30, 8, 12)), 1.6, static_cast<Preset>(i % 8));
        camera = withProjection(orbit(camera, share(engine), 0.3 * share(engine)), i % 2 == 1);
        const double u = share(engine), v = share(engine);
        const Ray ray = rayThrough(camera, u, v, 1.6);
        const auto place = project(camera, ray.origin + (5.0 + 100.0 * share(engine)) * ray.direction, 1.6);
        ASSERT_TRUE(place);
        EXPECT_NEAR(place->u, u, 1e-9);
        EXPECT_NEAR(place->v, v, 1e-9);
    }
    const Camera camera = fitCamera(Aabb(Vec3(-20, -5, 0), Vec3(30, 8, 12)), 1.6);
    EXPECT_FALSE(project(camera, 2.0 * camera.position - camera.focalPoint, 1.6)) << "behind the eye";
}

TEST(Camera, ParallelAndBackIsTheSamePicture) {
    const Camera camera = orbit(fitCamera(Aabb(Vec3(-20, -5, 0), Vec3(30, 8, 12)), 1.6), 0.4, 0.2);
    const Camera parallel = withProjection(camera, true);
    EXPECT_TRUE(parallel.parallel);
    EXPECT_NEAR(metresPerPixel(parallel, 700), metresPerPixel(camera, 700), 1e-12) << "the middle keeps its size";
    const Camera back = withProjection(parallel, false);
    EXPECT_NEAR((back.position - camera.position).norm(), 0.0, 1e-9);
    EXPECT_EQ(back.viewAngle, camera.viewAngle);
    // What was zoomed meanwhile stays as large.
    const Camera nearer = withProjection(zoom(parallel, 2.0, 0.5, 0.5, 1.6), false);
    EXPECT_NEAR(metresPerPixel(nearer, 700), 0.5 * metresPerPixel(camera, 700), 1e-12);
}

}  // namespace
}  // namespace rubble::render
