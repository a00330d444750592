#include "core/evidence/photographs/three_point_pose.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace rubble {

namespace {

/// Real roots of a polynomial of fourth degree, lowest coefficient first: eigenvalues of its companion matrix.
std::vector<double> realRoots(const std::array<double, 5>& a) {
    double largest = 0.0;
    for (const double coefficient : a) {
        largest = std::max(largest, std::abs(coefficient));
    }
    std::vector<double> roots;
    if (!(std::abs(a[4]) > 1e-12 * largest) || !std::isfinite(largest)) {
        return roots;
    }
    Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
    companion.bottomLeftCorner<3, 3>() = Mat3::Identity();
    for (int k = 0; k < 4; ++k) {
        companion(k, 3) = -a[static_cast<std::size_t>(k)] / a[4];
    }
    const Eigen::Vector4cd values = companion.eigenvalues();
    for (const std::complex<double>& value : values) {
        // Double roots come apart by the square root of rounding.
        if (std::abs(value.imag()) < 1e-5 * (1.0 + std::abs(value.real()))) {
            roots.push_back(value.real());
        }
    }
    return roots;
}

/// The turn and shift that take three points of the world to where the camera has them.
CameraPose alignment(const std::array<Vec3, 3>& world, const std::array<Vec3, 3>& seen) {
    const auto axes = [](const std::array<Vec3, 3>& p) {
        Mat3 frame;
        frame.col(0) = (p[1] - p[0]).normalized();
        frame.col(2) = frame.col(0).cross(p[2] - p[0]).normalized();
        frame.col(1) = frame.col(2).cross(frame.col(0));
        return frame;
    };
    CameraPose pose;
    const Mat3 turn = axes(seen) * axes(world).transpose();
    pose.toCamera = Quat(turn).normalized();
    const Vec3 middleWorld = (world[0] + world[1] + world[2]) / 3.0;
    const Vec3 middleSeen = (seen[0] + seen[1] + seen[2]) / 3.0;
    pose.place = middleWorld - pose.toCamera.conjugate() * middleSeen;
    return pose;
}

}  // namespace

std::vector<CameraPose> threePointPoses(const std::array<Vec3, 3>& world, const std::array<Vec3, 3>& rays) {
    const double a2 = (world[1] - world[2]).squaredNorm();
    const double b2 = (world[0] - world[2]).squaredNorm();
    const double c2 = (world[0] - world[1]).squaredNorm();
    const double area = (world[1] - world[0]).cross(world[2] - world[0]).norm();
    std::vector<CameraPose> poses;
    if (!(area > 1e-6 * std::max({a2, b2, c2}))) {
        return poses;
    }
    const double alpha = rays[1].dot(rays[2]);
    const double beta = rays[0].dot(rays[2]);
    const double gamma = rays[0].dot(rays[1]);
    const double minus = (a2 - c2) / b2;
    const double plus = (a2 + c2) / b2;
    const std::array<double, 5> quartic{
        (1.0 + minus) * (1.0 + minus) - 4.0 * a2 / b2 * gamma * gamma,
        4.0 * (-minus * (1.0 + minus) * beta + 2.0 * a2 / b2 * gamma * gamma * beta - (1.0 - plus) * alpha * gamma),
        2.0 * (minus * minus - 1.0 + 2.0 * minus * minus * beta * beta + 2.0 * (b2 - c2) / b2 * alpha * alpha -
               4.0 * plus * alpha * beta * gamma + 2.0 * (b2 - a2) / b2 * gamma * gamma),
        4.0 * (minus * (1.0 - minus) * beta - (1.0 - plus) * alpha * gamma + 2.0 * c2 / b2 * alpha * alpha * beta),
        (minus - 1.0) * (minus - 1.0) - 4.0 * c2 / b2 * alpha * alpha};
    for (const double v : realRoots(quartic)) {
        const double divisor = 2.0 * (gamma - v * alpha);
        if (!(v > 0.0) || std::abs(divisor) < 1e-12) {
            continue;
        }
        const double u = ((minus - 1.0) * v * v - 2.0 * minus * beta * v + 1.0 + minus) / divisor;
        const double square = b2 / (1.0 + v * v - 2.0 * v * beta);
        if (!(u > 0.0) || !(square > 0.0) || !std::isfinite(square)) {
            continue;
        }
        const double first = std::sqrt(square);
        poses.push_back(alignment(world, {Vec3(first * rays[0]), Vec3(u * first * rays[1]), Vec3(v * first * rays[2])}));
    }
    return poses;
}

}  // namespace rubble
