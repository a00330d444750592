#pragma once

#include <cstdint>

#include "core/base/geometry.h"

namespace rubble {

/// A vector of the given length in a direction that is even over the sphere and depends on seed and element number alone, bit for
/// bit on every machine.
Vec3 birthShift(double length, std::int64_t seed, std::int64_t elementNumber);

}  // namespace rubble
