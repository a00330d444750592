#include "core/evidence/photographs/camera_model.h"

#include <gtest/gtest.h>

#include "core/evidence/photographs/confidence.h"
#include "core/evidence/photographs/three_point_pose.h"
#include "tests/core/evidence/camera_scene.h"

namespace rubble {
namespace {

TEST(CameraModel, LooksThroughTheMiddleOfThePicture) {
    CameraScene scene(1, 1, 0.0);
    scene.camera.place = Vec3(0.0, -10.0, 0.0);
    scene.look(Vec3::Zero(), 0.0);
    EXPECT_LT((*scene.camera.project(Vec3::Zero()) - scene.camera.principal).norm(), 1e-9);
    // East is to the right, up is up: less y.
    EXPECT_GT(scene.camera.project(Vec3(1.0, 0.0, 0.0))->x(), scene.camera.principal.x());
    EXPECT_LT(scene.camera.project(Vec3(0.0, 0.0, 1.0))->y(), scene.camera.principal.y());
    EXPECT_FALSE(scene.camera.project(Vec3(0.0, -11.0, 0.0))) << "behind it";
}

TEST(CameraModel, ARayLeadsBackToItsPoint) {
    CameraScene scene(2, 30, 0.0);
    scene.camera.radial = {-0.15, 0.04};
    scene.retake(0.0);
    for (const PointPair& pair : scene.pairs) {
        const Vec3 expected = scene.camera.inCamera(pair.model).normalized();
        EXPECT_LT((rayOf(scene.camera, pair.picture) - expected).norm(), 1e-9);
    }
}

TEST(CameraModel, TheJacobianIsThatOfDifferences) {
    CameraScene scene(4, 10, 0.0);
    scene.camera.radial = {-0.1, 0.05};
    for (const PointPair& pair : scene.pairs) {
        const CameraJacobian jacobian = jacobianOf(scene.camera, pair.model);
        for (std::size_t k = 0; k < cameraParameters; ++k) {
            const auto of = static_cast<Eigen::Index>(k);
            const double width = k >= 9 ? 1e-6 : 1e-4;
            CameraStep step = CameraStep::Zero();
            step[of] = width;
            const Eigen::Vector2d up = *stepped(scene.camera, step).project(pair.model);
            const Eigen::Vector2d down = *stepped(scene.camera, -step).project(pair.model);
            const Eigen::Vector2d expected = (up - down) / (2.0 * width);
            // Central differences in double precision: 1e-7 of the larger coordinate.
            EXPECT_LT((jacobian.col(of) - expected).norm(), 1e-5 * (1.0 + expected.norm())) << k;
        }
    }
}

TEST(ThreePointPose, TheTrueOneIsAmongThem) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const CameraScene scene(seed, 3, 0.0);
        std::array<Vec3, 3> world;
        std::array<Vec3, 3> rays;
        for (std::size_t k = 0; k < 3; ++k) {
            world[k] = scene.pairs[k].model;
            rays[k] = scene.camera.inCamera(world[k]).normalized();
        }
        double nearest = 1e300;
        const std::vector<CameraPose> poses = threePointPoses(world, rays);
        EXPECT_LE(poses.size(), 4u);
        for (const CameraPose& pose : poses) {
            nearest = std::min(nearest, (pose.place - scene.camera.place).norm());
            for (std::size_t k = 0; k < 3; ++k) {
                // Double roots of the quartic lose half the digits.
                EXPECT_GT((pose.toCamera * (world[k] - pose.place)).normalized().dot(rays[k]), 1.0 - 1e-6);
            }
        }
        EXPECT_LT(nearest, 1e-2) << seed;
    }
}

TEST(ThreePointPose, PointsOnALineGiveNone) {
    const std::array<Vec3, 3> line{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(3, 0, 0)};
    const std::array<Vec3, 3> rays{Vec3(-0.1, 0, 1).normalized(), Vec3(0, 0, 1), Vec3(0.2, 0, 1).normalized()};
    EXPECT_TRUE(threePointPoses(line, rays).empty());
}

// Printed tables of Fisher's F at 95 %, four digits.
TEST(Confidence, ANumberIsRoundedToItsSpread) {
    EXPECT_EQ(roundedToSpread(0.83061, 0.001382), std::pair(0.8306, 0.0014));
    EXPECT_EQ(roundedToSpread(-25.2034, 0.3349), std::pair(-25.2, 0.33));
    EXPECT_EQ(roundedToSpread(12345.6, 678.9), std::pair(12350.0, 680.0));
    EXPECT_EQ(roundedToSpread(1.23456, 0.0), std::pair(1.23456, 0.0));
}

TEST(Confidence, QuantilesAreThoseOfTheTables) {
    EXPECT_NEAR(fisherQuantile(0.95, 1, 1), 161.4476, 1e-3);
    EXPECT_NEAR(fisherQuantile(0.95, 3, 10), 3.7083, 1e-4);
    EXPECT_NEAR(fisherQuantile(0.95, 6, 18), 2.6613, 1e-4);
    EXPECT_NEAR(fisherQuantile(0.95, 6, 2), 19.3295, 1e-3);
    EXPECT_NEAR(fisherQuantile(0.5, 10, 10), 1.0, 1e-9);
    EXPECT_NEAR(incompleteBeta(2.0, 3.0, 0.4), 0.5248, 1e-12) << "a polynomial: x^2 (6 - 8 x + 3 x^2)";
    EXPECT_NEAR(incompleteBeta(0.5, 0.5, 0.25), 1.0 / 3.0, 1e-12) << "2 / pi asin(sqrt x)";
}

}  // namespace
}  // namespace rubble
