#include "core/fe/raster_lattice.h"

#include <Eigen/LU>

#include <algorithm>

#include "core/base/unknown.h"

namespace rubble {

Eigen::Vector2d RasterLattice::pixelAt(double x, double y) const {
    const double u = (x - x0) / step;
    const double v = (y - y0) / step;
    if (nx < 2 || ny < 2 || !(u >= 0.0 && v >= 0.0 && u <= static_cast<double>(nx - 1) && v <= static_cast<double>(ny - 1))) {
        return {unknown, unknown};
    }
    const std::size_t i = std::min(static_cast<std::size_t>(u), nx - 2);
    const std::size_t j = std::min(static_cast<std::size_t>(v), ny - 2);
    const double s = u - static_cast<double>(i);
    const double t = v - static_cast<double>(j);
    const Eigen::Vector2d* low = &pixels[j * nx + i];
    const Eigen::Vector2d* high = low + nx;
    return (1.0 - t) * ((1.0 - s) * low[0] + s * low[1]) + t * ((1.0 - s) * high[0] + s * high[1]);
}

Eigen::Vector2d RasterLattice::placeOf(const Eigen::Vector2d& at) const {
    constexpr int steps = 4;  // projections of a site are all but linear
    const auto [low, high] = bounds();
    const Eigen::Vector2d middle = 0.5 * (low + high);
    const Eigen::Vector2d size = high - low;
    const double reach = 0.25;
    const Eigen::Vector2d alongX =
        pixelAt(middle.x() + reach * size.x(), middle.y()) - pixelAt(middle.x() - reach * size.x(), middle.y());
    const Eigen::Vector2d alongY =
        pixelAt(middle.x(), middle.y() + reach * size.y()) - pixelAt(middle.x(), middle.y() - reach * size.y());
    Eigen::Matrix2d change;
    change << alongX / (2.0 * reach * size.x()), alongY / (2.0 * reach * size.y());
    const Eigen::Matrix2d back = change.inverse();
    Eigen::Vector2d place = middle;
    for (int k = 0; k < steps; ++k) {
        const Eigen::Vector2d next = place + back * (at - pixelAt(place.x(), place.y()));
        if (!next.allFinite()) {
            return {unknown, unknown};
        }
        place = next.cwiseMax(low).cwiseMin(high);
    }
    const bool there = (pixelAt(place.x(), place.y()) - at).norm() < 0.01;
    return there ? place : Eigen::Vector2d(unknown, unknown);
}

std::pair<Eigen::Vector2d, Eigen::Vector2d> RasterLattice::bounds() const {
    const Eigen::Vector2d low(x0, y0);
    return {low, low + step * Eigen::Vector2d(static_cast<double>(nx - 1), static_cast<double>(ny - 1))};
}

}  // namespace rubble
