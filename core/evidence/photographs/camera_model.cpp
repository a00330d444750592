#include "core/evidence/photographs/camera_model.h"

#include <cmath>

namespace rubble {

namespace {

constexpr double leastDepth = 1e-9;

}  // namespace

std::optional<Eigen::Vector2d> CameraModel::project(const Vec3& world) const {
    const Vec3 p = inCamera(world);
    if (!(p.z() > leastDepth)) {
        return std::nullopt;
    }
    const Eigen::Vector2d q = p.head<2>() / p.z();
    const double r2 = q.squaredNorm();
    return Eigen::Vector2d(principal + focal * (1.0 + r2 * (radial[0] + r2 * radial[1])) * q);
}

Vec3 rayOf(const CameraModel& camera, const Eigen::Vector2d& picture) {
    const Eigen::Vector2d distorted = (picture - camera.principal) / camera.focal;
    Eigen::Vector2d q = distorted;
    constexpr int rounds = 20;
    for (int k = 0; k < rounds; ++k) {
        const double r2 = q.squaredNorm();
        const double scale = 1.0 + r2 * (camera.radial[0] + r2 * camera.radial[1]);
        // Beyond where the distortion folds back there is no inverse; the ray stays where it was.
        if (!(scale > 0.1)) {
            break;
        }
        q = distorted / scale;
    }
    return Vec3(q.x(), q.y(), 1.0).normalized();
}

CameraJacobian jacobianOf(const CameraModel& camera, const Vec3& world) {
    const Vec3 p = camera.inCamera(world);
    const Eigen::Vector2d q = p.head<2>() / p.z();
    const double r2 = q.squaredNorm();
    const double scale = 1.0 + r2 * (camera.radial[0] + r2 * camera.radial[1]);
    Eigen::Matrix<double, 2, 3> ofPlace;
    ofPlace << 1.0 / p.z(), 0.0, -q.x() / p.z(), 0.0, 1.0 / p.z(), -q.y() / p.z();
    // d(scale q) / dq
    const Eigen::Matrix2d bent =
        scale * Eigen::Matrix2d::Identity() + 2.0 * (camera.radial[0] + 2.0 * r2 * camera.radial[1]) * (q * q.transpose());
    const Eigen::Matrix<double, 2, 3> toPicture = camera.focal * bent * ofPlace;
    Mat3 cross;
    cross << 0.0, -p.z(), p.y(), p.z(), 0.0, -p.x(), -p.y(), p.x(), 0.0;
    CameraJacobian jacobian;
    jacobian.leftCols<3>() = -toPicture * camera.toCamera.toRotationMatrix();
    jacobian.middleCols<3>(3) = -toPicture * cross;
    jacobian.col(6) = scale * q;
    jacobian.col(7) = Eigen::Vector2d::UnitX();
    jacobian.col(8) = Eigen::Vector2d::UnitY();
    jacobian.col(9) = camera.focal * r2 * q;
    jacobian.col(10) = camera.focal * r2 * r2 * q;
    return jacobian;
}

CameraModel stepped(const CameraModel& camera, const CameraStep& step) {
    CameraModel next = camera;
    next.place += step.head<3>();
    const Vec3 turn = step.segment<3>(3);
    const double angle = turn.norm();
    if (angle > 0.0) {
        next.toCamera = (Quat(Eigen::AngleAxisd(angle, turn / angle)) * camera.toCamera).normalized();
    }
    next.focal += step[6];
    next.principal += step.segment<2>(7);
    next.radial += step.segment<2>(9);
    return next;
}

}  // namespace rubble
