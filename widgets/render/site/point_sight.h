#pragma once

#include "core/base/geometry.h"
#include "widgets/render/basics/view.h"

namespace rubble::render {

/// How many pixels of a picture a length [m] takes where a box comes nearest to its camera; 0: the box lies out of sight.
/// @param aspect  width over height of the picture; @param height  px
double pixelsOf(const Camera& camera, double aspect, int height, const Aabb& box, double length);

}  // namespace rubble::render
