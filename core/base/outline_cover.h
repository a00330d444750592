#pragma once

#include "core/base/outline.h"

namespace rubble {

/// Whether a place lies in any of the polygons of an outline.
bool covers(const Outline& outline, const Eigen::Vector2d& place);

}  // namespace rubble
