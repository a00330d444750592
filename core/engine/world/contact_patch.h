#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/base/geometry.h"

namespace rubble {

/// One point of contact between two solids.
struct PatchPoint {
    Vec3 position = Vec3::Zero();  ///< m, world, midway between the two surfaces
    double separation = 0.0;       ///< m, negative when they overlap
    std::uint32_t feature = 0;     ///< the same from step to step while the same features touch
};

/// Up to four points of contact with one normal.
struct ContactPatch {
    Vec3 normal = Vec3::UnitZ();  ///< unit vector from the first solid to the second
    double separation = 0.0;      ///< m, of the two solids along the normal; the points may lie less deep
    std::array<PatchPoint, 4> points;
    int count = 0;
};

/// Candidate for a patch in the plane of contact.
struct PlanePoint {
    double u = 0.0, v = 0.0;  ///< m, in the plane
    double height = 0.0;      ///< m above it
    std::uint32_t feature = 0;
};

/// Moves the four points that span the patch to the front: the deepest, the one farthest from it, and the farthest on either side
/// of their line. Returns how many points remain.
int reduceToFour(std::span<PlanePoint> points);

}  // namespace rubble
