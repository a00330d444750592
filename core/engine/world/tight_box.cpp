#include "core/engine/world/tight_box.h"

#include <Eigen/Eigenvalues>
#include <cassert>
#include <numbers>

#include "core/base/same_bits.h"

namespace rubble {

namespace {

double volumeWithAxes(std::span<const Vec3> points, const Mat3& axes) {
    const Mat3 inverse = axes.transpose();
    Vec3 low = inverse * points[0];
    Vec3 high = low;
    for (const Vec3& p : points.subspan(1)) {
        const Vec3 q = inverse * p;
        low = low.cwiseMin(q);
        high = high.cwiseMax(q);
    }
    return (high - low).prod();
}

Mat3 principalAxes(std::span<const Vec3> points) {
    Vec3 mean = Vec3::Zero();
    for (const Vec3& p : points) {
        mean += p;
    }
    mean /= static_cast<double>(points.size());
    Mat3 covariance = Mat3::Zero();
    for (const Vec3& p : points) {
        covariance += (p - mean) * (p - mean).transpose();
    }
    Mat3 axes = Eigen::SelfAdjointEigenSolver<Mat3>(covariance).eigenvectors();
    if (axes.determinant() < 0.0) {
        axes.col(2) = -axes.col(2);
    }
    return axes;
}

}  // namespace

OrientedBox boxWithAxes(std::span<const Vec3> points, const Mat3& axes) {
    assert(!points.empty());
    const Mat3 inverse = axes.transpose();
    Aabb extent;
    for (const Vec3& p : points) {
        extent.extend(inverse * p);
    }
    return {axes * extent.center(), Quat(axes).normalized(), 0.5 * extent.sizes()};
}

OrientedBox tightBox(std::span<const Vec3> points, std::span<const Mat3> candidates, bool refine) {
    assert(!points.empty());
    Mat3 best = Mat3::Identity();
    double volume = volumeWithAxes(points, best);
    const auto consider = [&](const Mat3& axes) {
        const double candidate = volumeWithAxes(points, axes);
        if (candidate < volume) {
            volume = candidate;
            best = axes;
            return true;
        }
        return false;
    };
    for (const Mat3& axes : candidates) {
        consider(axes);
    }
    consider(principalAxes(points));
    for (double degrees = refine ? 8.0 : 0.0; degrees > 0.4; degrees *= 0.5) {
        bool better = true;
        for (int round = 0; better && round < 4; ++round) {
            better = false;
            for (int axis = 0; axis < 3; ++axis) {
                for (const double sign : {1.0, -1.0}) {
                    const double angle = sign * degrees * std::numbers::pi / 180.0;
                    better = consider(Mat3(best * axesTurned(Vec3::Unit(axis), angle))) || better;
                }
            }
        }
    }
    return boxWithAxes(points, best);
}

}  // namespace rubble
