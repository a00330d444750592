#pragma once

#include "core/base/geometry.h"
#include "widgets/render/basics/view.h"
#include "widgets/render/panes.h"

namespace rubble::render {

/// How many pixels of a pane a length [m] takes where a box comes nearest to its camera; 0: the box lies out of sight.
double pixelsOf(const Camera& camera, const Pane& pane, const Aabb& box, double length);

}  // namespace rubble::render
