#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace rubble::io {

/// Pixels along one axis.
struct PixelRange {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// One axis of the raster in the local frame.
struct RasterAxis {
    double origin;  ///< m, first pixel
    double step;    ///< m, with its sign
    std::size_t pixels;

    double low() const { return std::min(origin, origin + step * static_cast<double>(pixels - 1)); }
    double high() const { return std::max(origin, origin + step * static_cast<double>(pixels - 1)); }
    /// Pixels that span an interval, one beyond each end where there is one, two at least if there are as many.
    PixelRange around(double from, double to) const {
        if (pixels == 1) {
            return {0, 1};
        }
        const double last = static_cast<double>(pixels - 1);
        const double a = std::clamp((from - origin) / step, 0.0, last);
        const double b = std::clamp((to - origin) / step, 0.0, last);
        auto first = static_cast<std::size_t>(std::floor(std::min(a, b)));
        auto end = static_cast<std::size_t>(std::ceil(std::max(a, b)));
        if (first == end) {
            first > 0 ? --first : ++end;
        }
        return {first, end - first + 1};
    }
    /// Groups of pixels put together around a range of them: below and above it in the local frame.
    std::pair<std::size_t, std::size_t> groupsAround(const PixelRange& range, std::size_t factor) const {
        const std::size_t before = range.first / factor;
        const std::size_t after = (pixels - range.first - range.count) / factor;
        return step > 0.0 ? std::pair(before, after) : std::pair(after, before);
    }
    /// A range with so many groups more below and above it.
    PixelRange widened(const PixelRange& range, std::size_t below, std::size_t above, std::size_t factor) const {
        const std::size_t before = step > 0.0 ? below : above;
        return {range.first - before * factor, range.count + (below + above) * factor};
    }
    /// Place of the lowest of pixels put together.
    double lowest(const PixelRange& range, std::size_t factor) const {
        const auto half = 0.5 * static_cast<double>(factor - 1);
        const std::size_t groups = range.count / factor;
        const std::size_t first = step > 0.0 ? range.first : range.first + (groups - 1) * factor;
        return origin + step * (static_cast<double>(first) + half);
    }
};

}  // namespace rubble::io
