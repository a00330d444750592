#include "widgets/figures/camera_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "widgets/render/basics/camera.h"

namespace rubble::figures {
namespace {

render::Camera cameraAt(const Vec3& position, const Vec3& focal = Vec3::Zero()) {
    render::Camera camera;
    camera.position = position;
    camera.focalPoint = focal;
    return camera;
}

/// Half a turn around the model in two steps, nearer in the middle.
std::vector<CameraKey> halfTurn() {
    return {keyOf(cameraAt({100, 0, 20}), 1.0), keyOf(cameraAt({0, 50, 10}), 2.0), keyOf(cameraAt({-100, 0, 20}), 4.0)};
}

TEST(CameraPath, KeysAreMetAndHeldBeforeAndAfter) {
    const std::vector<CameraKey> keys = halfTurn();
    EXPECT_TRUE(cameraAlong(keys, 0.0) == cameraOf(keys[0]));
    EXPECT_TRUE(cameraAlong(keys, 2.0) == cameraOf(keys[1]));
    EXPECT_TRUE(cameraAlong(keys, 9.0) == cameraOf(keys[2]));
    for (const double time : {1.0 + 1e-7, 2.0 - 1e-7, 2.0 + 1e-7, 4.0 - 1e-7}) {
        const render::Camera camera = cameraAlong(keys, time);
        const render::Camera near = cameraAlong(keys, std::round(time));
        EXPECT_LT((camera.position - near.position).norm(), 1e-3) << time;
    }
}

TEST(CameraPath, ItGoesAroundTheModelAndDoesNotCutThroughIt) {
    const std::vector<CameraKey> keys = halfTurn();
    double before = 200.0;
    for (double time = 1.0; time <= 4.0; time += 0.01) {
        const render::Camera camera = cameraAlong(keys, time);
        const double distance = (camera.position - camera.focalPoint).norm();
        EXPECT_GE(distance, cameraOf(keys[1]).position.norm() - 1e-6) << time;
        EXPECT_LE(distance, cameraOf(keys[0]).position.norm() + 1e-6) << time;
        EXPECT_GE(camera.position.y(), -1e-6) << "it takes the shorter way, over y";
        EXPECT_LE(camera.position.x(), before + 1e-9) << "it never turns back";
        before = camera.position.x();
        const Vec3 right = (camera.focalPoint - camera.position).cross(camera.up);
        EXPECT_NEAR(right.z(), 0.0, 1e-6) << "the horizon is level";
    }
}

TEST(CameraPath, ItMovesSmoothly) {
    const std::vector<CameraKey> keys = halfTurn();
    Vec3 speed = Vec3::Zero();
    constexpr double step = 1e-3;
    for (double time = 1.0; time < 4.0; time += step) {
        const Vec3 now = (cameraAlong(keys, time + step).position - cameraAlong(keys, time).position) / step;
        EXPECT_LT((now - speed).norm(), 3.0) << "no jump of the speed at " << time;
        speed = now;
    }
    EXPECT_LT(speed.norm(), 1.0) << "it comes to rest at the last key";
}

TEST(CameraPath, TheShorterWayIsTakenOverTheSeam) {
    const double before = 175.0 * M_PI / 180.0;
    const std::vector<CameraKey> keys{keyOf(cameraAt({100 * std::cos(before), 100 * std::sin(before), 0}), 0.0),
                                      keyOf(cameraAt({100 * std::cos(before), -100 * std::sin(before), 0}), 1.0)};
    EXPECT_NEAR(cameraAlong(keys, 0.5).position.x(), -100.0, 1e-9);
}

TEST(CameraPath, FromStraightAboveItComesDown) {
    render::Camera above = cameraAt({0, 0, 100});
    above.up = Vec3::UnitY();
    const std::vector<CameraKey> keys{keyOf(above, 0.0), keyOf(cameraAt({0, -100, 0}), 1.0)};
    const render::Camera middle = cameraAlong(keys, 0.5);
    EXPECT_NEAR(middle.position.x(), 0.0, 1e-6) << "it does not turn on the way";
    EXPECT_NEAR(middle.position.y(), -100.0 * std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(middle.position.norm(), 100.0, 1e-6);
}

TEST(CameraPath, AllPanesButThePlanLookAlong) {
    render::View view;
    view.cameras[3] = cameraAt({1, 2, 3});
    const render::View before = view;
    lookAlong(view, {}, 2.0);
    EXPECT_TRUE(view == before) << "without keys nothing moves";
    const std::vector<CameraKey> keys = halfTurn();
    view.camerasLinked = false;
    lookAlong(view, keys, 2.0);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(view.cameras[i] == cameraOf(keys[1])) << i;
    }
    EXPECT_TRUE(view.cameras[3] == before.cameras[3]);
}

}  // namespace
}  // namespace rubble::figures
