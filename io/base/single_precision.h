#pragma once

#include <algorithm>
#include <vector>

#include "core/base/geometry.h"

namespace rubble::io {

/// Whether all values are what they are in single precision: most codes write them so, and then half the bytes lose nothing.
inline bool fitsSinglePrecision(const std::vector<Vec3>& values) {
    return std::all_of(values.begin(), values.end(), [](const Vec3& value) { return value == value.cast<float>().cast<double>(); });
}

}  // namespace rubble::io
