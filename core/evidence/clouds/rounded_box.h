#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/base/geometry.h"

namespace rubble {

/// A box in single precision, rounded outwards: half the memory, and met a little too often rather than missed.
struct RoundedBox {
    std::array<float, 3> low;
    std::array<float, 3> high;

    void set(const Vec3& lowest, const Vec3& highest) {
        constexpr float far = std::numeric_limits<float>::max();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::nextafter(static_cast<float>(lowest[static_cast<Eigen::Index>(axis)]), -far);
            high[axis] = std::nextafter(static_cast<float>(highest[static_cast<Eigen::Index>(axis)]), far);
        }
    }
    bool meets(const RoundedBox& other) const {
        const bool x = low[0] <= other.high[0] && other.low[0] <= high[0];
        const bool y = low[1] <= other.high[1] && other.low[1] <= high[1];
        const bool z = low[2] <= other.high[2] && other.low[2] <= high[2];
        return x && y && z;
    }
    Vec3 lowest() const { return {low[0], low[1], low[2]}; }
    Vec3 highest() const { return {high[0], high[1], high[2]}; }
};

}  // namespace rubble
