#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>

#include "core/base/geometry.h"

class vtkPolyData;

namespace rubble::render {

/// Corners of every circle that ground, sky and water are made of.
inline constexpr int sectors = 64;

/// By how much ground and water step back alike, so that what lies on them wins. From far off that is a metre: a surface that steps
/// back by another measure would come before or behind the others.
inline constexpr double stepBack = 2.0;

/// Makes a level disc of coloured rings around a centre.
/// @param unit    m, the radius of ring 1
/// @param rings   radii in that unit, ascending
/// @param colour  red, green, blue and opacity at a ring; 0 is the centre
void makeDisc(vtkPolyData& disc, const Vec3& centre, double unit, std::span<const double> rings,
              const std::function<std::array<std::uint8_t, 4>(double ring)>& colour);

}  // namespace rubble::render
