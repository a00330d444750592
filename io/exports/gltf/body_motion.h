#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/base/execution.h"
#include "core/trajectory/trajectory.h"

namespace rubble::io {

/// Place of a body at one instant, as an animation holds it: local frame, z up, m.
struct MotionKey {
    double time = 0.0;  ///< s, on the file's clock
    Eigen::Vector3f position = Eigen::Vector3f::Zero();
    Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
};

/// How far a place between two keys may lie from what was recorded.
struct MotionTolerance {
    double distance = 1e-3;  ///< m
    double angle = 2e-3;     ///< rad
};

/// Recorded places of the bodies [first, last): from entry on, up to the last frame, to when the body left or its place became no
/// number. Neighbouring orientations lie on the same half of the sphere, so that interpolation takes the short way.
/// @param advance  called with the share done, [0, 1]
std::vector<std::vector<MotionKey>> recordedMotion(const TrajectoryReader& run, std::span<const BodyRecord> bodies,
                                                   std::size_t first, std::size_t last, const std::function<void(double)>& advance);

/// The keys that are enough: linear interpolation of positions and spherical of orientations between those that are left stays
/// within the tolerance of every one that went. First and last stay.
std::vector<MotionKey> fewerKeys(const std::vector<MotionKey>& keys, const MotionTolerance& tolerance);

}  // namespace rubble::io
