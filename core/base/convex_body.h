#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// Corners of a hull at most: more make contacts slow and hardly better.
inline constexpr std::size_t hullCornersMax = 32;

/// A convex solid of even density, about its centre of mass.
struct ConvexBody {
    std::vector<Vec3> corners;                            ///< m
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of corners, against the clock seen from outside
    double volume = 0.0;                                  ///< m3
    Vec3 sides = Vec3::Zero();                            ///< m, of the box around it along its axes
    double leftOut = 0.0;                                 ///< m, by which points that it was made of lie outside, at most
};

/// The hull of any number of points. Beyond hullCornersMax corners those that stand out least are left out (`leftOut`).
/// @return nothing where the points span no volume
/// O(n) for each corner of the hull.
std::optional<ConvexBody> convexBodyOf(std::span<const Vec3> points);

/// The same body, stretched along its axes until the box around it has these sides, m.
ConvexBody stretchedTo(ConvexBody body, const Vec3& sides);

}  // namespace rubble
