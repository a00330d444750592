#pragma once

#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// The box with the given axes around points, m. The points must not be empty.
OrientedBox boxWithAxes(std::span<const Vec3> points, const Mat3& axes);

/// The tightest box that a search finds: from the given axes, the principal axes of the points and the coordinate axes, the best is
/// turned about its own axes in ever smaller steps as long as the volume falls. Deterministic.
/// @param refine  false: only the candidates are compared
OrientedBox tightBox(std::span<const Vec3> points, std::span<const Mat3> candidates, bool refine = true);

}  // namespace rubble
