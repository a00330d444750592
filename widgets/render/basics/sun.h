#pragma once

#include "core/base/geometry.h"

namespace rubble::render {

/// Towards the sun of every picture: from the west-south-west, high up. A structure that is seen from the south, as pictures begin,
/// stands in the light, and its shadow falls behind it.
inline const Vec3 sun = Vec3(-0.55, -0.30, 0.78).normalized();

}  // namespace rubble::render
