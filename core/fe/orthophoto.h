#pragma once

#include <cstdint>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// A picture of the ground from above in the local frame, rows from the south. What it does not cover has no opacity.
struct Orthophoto {
    double x0 = 0.0;  ///< m, south-west corner of the first pixel
    double y0 = 0.0;
    double pixel = 1.0;  ///< m, side
    int width = 0;       ///< px
    int height = 0;
    std::vector<std::uint8_t> rgba;  ///< [height * width * 4]

    double right() const { return x0 + pixel * width; }
    double top() const { return y0 + pixel * height; }
};

}  // namespace rubble
