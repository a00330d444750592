#include "core/evidence/surveys/survey.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {

double SurveyHeights::at(double x, double y) const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const double u = (x - x0) / dx;
    const double v = (y - y0) / dy;
    if (aboveGround) {
        const double column = std::floor(u + 0.5);
        const double row = std::floor(v + 0.5);
        const bool inside = column >= 0.0 && row >= 0.0 && column < static_cast<double>(nx) && row < static_cast<double>(ny);
        return inside ? heights[static_cast<std::size_t>(row) * nx + static_cast<std::size_t>(column)] : none;
    }
    if (nx < 2 || ny < 2 || !(u >= 0.0 && v >= 0.0 && u <= static_cast<double>(nx - 1) && v <= static_cast<double>(ny - 1))) {
        return none;
    }
    const std::size_t i = std::min(static_cast<std::size_t>(u), nx - 2);
    const std::size_t j = std::min(static_cast<std::size_t>(v), ny - 2);
    const double s = u - static_cast<double>(i);
    const double t = v - static_cast<double>(j);
    const double* low = &heights[j * nx + i];
    const double* high = low + nx;
    // A corner without weight may be a gap.
    const auto part = [](double weight, double height) { return weight > 0.0 ? weight * height : 0.0; };
    return part((1.0 - t) * (1.0 - s), low[0]) + part((1.0 - t) * s, low[1]) + part(t * (1.0 - s), high[0]) + part(t * s, high[1]);
}

std::pair<Eigen::Vector2d, Eigen::Vector2d> Survey::bounds() const {
    if (!isFootprint) {
        return {{heights.x0, heights.y0},
                {heights.x0 + heights.dx * static_cast<double>(heights.nx - 1),
                 heights.y0 + heights.dy * static_cast<double>(heights.ny - 1)}};
    }
    return footprint.bounds();
}

}  // namespace rubble
