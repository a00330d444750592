#pragma once

#include <cstddef>
#include <optional>

#include "core/base/geometry.h"

namespace rubble {

/// A pinhole camera with radial distortion (Brown 1966, two terms). Pictures have x to the right and y down, in pixels from the
/// upper left corner.
struct CameraModel {
    Vec3 place = Vec3::Zero();            ///< m, centre of projection
    Quat toCamera = Quat::Identity();     ///< turns world axes to those of the camera: x right, y down, z ahead
    double focal = 1000.0;                ///< px
    Eigen::Vector2d principal{0.0, 0.0};  ///< px
    Eigen::Vector2d radial{0.0, 0.0};     ///< of the squared and fourth power of the distance from the axis over the focal length

    Vec3 inCamera(const Vec3& world) const { return toCamera * (world - place); }
    /// px; nothing for a point that is not ahead of the camera.
    std::optional<Eigen::Vector2d> project(const Vec3& world) const;
};

/// Direction ahead of the camera to a picture point, in its axes, unit length: the inverse of the projection, distortion taken out
/// by iteration.
Vec3 rayOf(const CameraModel& camera, const Eigen::Vector2d& picture);

/// Numbers of a camera that a match may change, in this order in every matrix: place (3, m), a turn about the axes of the camera
/// (3, rad), focal length (px), principal point (2, px), radial terms (2).
inline constexpr std::size_t cameraParameters = 11;
using CameraJacobian = Eigen::Matrix<double, 2, static_cast<int>(cameraParameters)>;
using CameraStep = Eigen::Matrix<double, static_cast<int>(cameraParameters), 1>;

/// How the picture of a point that is ahead of the camera moves with each number.
CameraJacobian jacobianOf(const CameraModel& camera, const Vec3& world);

/// The camera after a step of its numbers.
CameraModel stepped(const CameraModel& camera, const CameraStep& step);

}  // namespace rubble
