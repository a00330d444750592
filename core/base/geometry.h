#pragma once

#include <Eigen/Dense>
#include <Eigen/Geometry>

namespace rubble {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;
using Aabb = Eigen::AlignedBox3d;

/// z of the cross product of two vectors of the plane.
inline double planeCross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Rigid placement: a point p of the body frame lies at position + orientation * p.
struct Pose {
    Vec3 position = Vec3::Zero();
    Quat orientation = Quat::Identity();

    Vec3 operator*(const Vec3& p) const { return position + orientation * p; }
    Pose operator*(const Pose& inner) const { return {*this * inner.position, (orientation * inner.orientation).normalized()}; }
    Pose inverse() const { return {-(orientation.conjugate() * position), orientation.conjugate()}; }
};

/// Box with its own axes: corners at centre + orientation * (+-halfExtents) [m].
struct OrientedBox {
    Vec3 centre = Vec3::Zero();
    Quat orientation = Quat::Identity();
    Vec3 halfExtents = Vec3::Zero();

    double volume() const { return 8.0 * halfExtents.prod(); }
};

}  // namespace rubble
