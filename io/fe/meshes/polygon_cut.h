#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace rubble::io {

/// Corners of one polygon at most. Time goes with the square of this.
inline constexpr std::size_t polygonCornersMax = 20'000;

/// Cuts a polygon in space into triangles of its corners: ears are taken off one by one in the plane of its area, in double
/// precision. Any simple outline is cut rightly, concave ones and those that a slit joins to a hole included; no corner is added.
/// @param corners    of points, each there, in order around; the last is not the first again
/// @param triangles  of points; new ones are appended, turned as the polygon is
/// @return false if the outline crosses itself, so that the triangles do not cover what it meant
bool cutPolygon(const std::vector<Vec3>& points, std::span<const std::uint32_t> corners,
                std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace rubble::io
