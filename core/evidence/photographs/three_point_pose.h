#pragma once

#include <array>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// Place of a camera and the turn from world axes to its own.
struct CameraPose {
    Vec3 place = Vec3::Zero();
    Quat toCamera = Quat::Identity();
};

/// The poses, at most four, from which three points of the world are seen along three directions (Grunert 1841, as reviewed by
/// Haralick et al. 1994). None for points on a line, or directions that no pose fits.
/// @param rays  unit vectors in the axes of the camera
std::vector<CameraPose> threePointPoses(const std::array<Vec3, 3>& world, const std::array<Vec3, 3>& rays);

}  // namespace rubble
