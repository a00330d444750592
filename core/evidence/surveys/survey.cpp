#include "core/evidence/surveys/survey.h"

#include <algorithm>
#include <cmath>

#include "core/base/unknown.h"

namespace rubble {

namespace {

/// The height of the cell around a fractional column and row.
double cellHeight(const SurveyHeights& heights, const Eigen::Vector2d& pixel) {
    const double column = std::floor(pixel.x() + 0.5);
    const double row = std::floor(pixel.y() + 0.5);
    const bool inside =
        column >= 0.0 && row >= 0.0 && column < static_cast<double>(heights.nx) && row < static_cast<double>(heights.ny);
    return inside ? heights.heights[static_cast<std::size_t>(row) * heights.nx + static_cast<std::size_t>(column)] : unknown;
}

/// Bilinear between four heights.
double heightBetween(const SurveyHeights& heights, const Eigen::Vector2d& pixel) {
    constexpr double rounding = 1e-6;  // that the rim may be missed by
    const double right = static_cast<double>(heights.nx) - 1.0;
    const double top = static_cast<double>(heights.ny) - 1.0;
    if (heights.nx < 2 || heights.ny < 2 || !(pixel.x() >= -rounding && pixel.y() >= -rounding) ||
        !(pixel.x() <= right + rounding && pixel.y() <= top + rounding)) {
        return unknown;
    }
    const double u = std::clamp(pixel.x(), 0.0, right);
    const double v = std::clamp(pixel.y(), 0.0, top);
    const std::size_t i = std::min(static_cast<std::size_t>(u), heights.nx - 2);
    const std::size_t j = std::min(static_cast<std::size_t>(v), heights.ny - 2);
    const double s = u - static_cast<double>(i);
    const double t = v - static_cast<double>(j);
    const double* low = &heights.heights[j * heights.nx + i];
    const double* high = low + heights.nx;
    // A corner without weight may be a gap.
    const auto part = [](double weight, double height) { return weight > 1e-9 ? weight * height : 0.0; };
    return part((1.0 - t) * (1.0 - s), low[0]) + part((1.0 - t) * s, low[1]) + part(t * (1.0 - s), high[0]) + part(t * s, high[1]);
}

}  // namespace

double SurveyHeights::at(double x, double y) const {
    const Eigen::Vector2d pixel = lattice ? lattice->pixelAt(x, y) : Eigen::Vector2d((x - x0) / dx, (y - y0) / dy);
    return aboveGround ? cellHeight(*this, pixel) : heightBetween(*this, pixel);
}

Eigen::Vector2d SurveyHeights::placeOf(double column, double row) const {
    return lattice ? lattice->placeOf({column, row}) : Eigen::Vector2d(x0 + dx * column, y0 + dy * row);
}

std::pair<Eigen::Vector2d, Eigen::Vector2d> SurveyHeights::bounds() const {
    const Eigen::Vector2d low(x0, y0);
    return lattice ? lattice->bounds() : std::pair(low, placeOf(static_cast<double>(nx) - 1.0, static_cast<double>(ny) - 1.0));
}

std::pair<Eigen::Vector2d, Eigen::Vector2d> Survey::bounds() const {
    return isFootprint ? footprint.bounds() : heights.bounds();
}

}  // namespace rubble
