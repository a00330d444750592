#include "widgets/evidence/surveys/survey_plan.h"

#include <QColor>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/unknown.h"

namespace rubble::widgets {

namespace {

constexpr QColor lowTint(0x6f, 0x8f, 0x9b);
constexpr QColor highTint(0xf4, 0xe9, 0xcd);

/// Heights that a few stand below and above, so that single trees and pits leave the tints alone.
std::pair<double, double> usualHeights(const std::vector<double>& heights) {
    constexpr std::size_t taken = 100'000;
    std::vector<double> some;
    const std::size_t stride = heights.size() / taken + 1;
    for (std::size_t k = 0; k < heights.size(); k += stride) {
        if (std::isfinite(heights[k])) {
            some.push_back(heights[k]);
        }
    }
    if (some.empty()) {
        return {0.0, 1.0};
    }
    std::sort(some.begin(), some.end());
    const double low = some[some.size() / 50];
    const double high = some[some.size() - 1 - some.size() / 50];
    return {low, std::max(high, low + 1e-6)};
}

QColor between(double share) {
    const auto mix = [share](int low, int high) { return static_cast<int>(std::lround(low + share * (high - low))); };
    return {mix(lowTint.red(), highTint.red()), mix(lowTint.green(), highTint.green()), mix(lowTint.blue(), highTint.blue())};
}

}  // namespace

SurveyPlan::SurveyPlan(SurveyHeights heights) : m_heights(std::move(heights)) {
    if (m_heights.nx < 2 || m_heights.ny < 2) {
        return;
    }
    const Eigen::Vector2d middle(0.5 * static_cast<double>(m_heights.nx - 1), 0.5 * static_cast<double>(m_heights.ny - 1));
    const Eigen::Vector2d at = m_heights.placeOf(middle.x(), middle.y());
    const Eigen::Vector2d right = m_heights.placeOf(middle.x() + 0.5, middle.y()) - at;
    const Eigen::Vector2d up = m_heights.placeOf(middle.x(), middle.y() + 0.5) - at;
    const double turn = right.x() * up.y() - right.y() * up.x();
    if (std::isfinite(turn) && turn != 0.0) {
        m_upwards = turn > 0.0;
        m_across = 2.0 * right.norm();
        m_along = 2.0 * up.norm();
    }
}

QSize SurveyPlan::size() const {
    return {static_cast<int>(m_heights.nx), static_cast<int>(m_heights.ny)};
}

std::optional<Eigen::Vector2d> SurveyPlan::planAt(const QPointF& pixel) const {
    if (m_heights.nx < 2 || m_heights.ny < 2) {
        return std::nullopt;
    }
    const double right = static_cast<double>(m_heights.nx) - 1.0;
    const double top = static_cast<double>(m_heights.ny) - 1.0;
    const double down = std::clamp(pixel.y() - 0.5, 0.0, top);
    const Eigen::Vector2d place = m_heights.placeOf(std::clamp(pixel.x() - 0.5, 0.0, right), m_upwards ? top - down : down);
    return place.allFinite() ? std::optional(place) : std::nullopt;
}

std::optional<Vec3> SurveyPlan::placeAt(const QPointF& pixel) const {
    const std::optional<Eigen::Vector2d> place = planAt(pixel);
    double height = place ? m_heights.at(place->x(), place->y()) : unknown;
    if (place && !std::isfinite(height)) {
        // Beside a gap, as on a wall that is one cell wide: that of the cell which is clicked.
        const auto column = static_cast<std::int64_t>(std::floor(pixel.x()));
        const auto row = static_cast<std::int64_t>(std::floor(pixel.y()));
        const auto columns = static_cast<std::int64_t>(m_heights.nx);
        const auto rows = static_cast<std::int64_t>(m_heights.ny);
        if (column >= 0 && column < columns && row >= 0 && row < rows) {
            height = heightAt(static_cast<std::size_t>(column), static_cast<std::size_t>(m_upwards ? rows - 1 - row : row));
        }
    }
    return std::isfinite(height) ? std::optional(Vec3(place->x(), place->y(), height)) : std::nullopt;
}

std::optional<QPointF> SurveyPlan::pixelOf(const Vec3& place) const {
    const Eigen::Vector2d at =
        m_heights.lattice ? m_heights.lattice->pixelAt(place.x(), place.y())
                          : Eigen::Vector2d((place.x() - m_heights.x0) / m_heights.dx, (place.y() - m_heights.y0) / m_heights.dy);
    if (!at.allFinite()) {
        return std::nullopt;
    }
    return QPointF(at.x() + 0.5, (m_upwards ? static_cast<double>(m_heights.ny) - 1.0 - at.y() : at.y()) + 0.5);
}

double SurveyPlan::slopeAlong(std::size_t column, std::size_t row, bool rows) const {
    const std::size_t count = rows ? m_heights.ny : m_heights.nx;
    const std::size_t here = rows ? row : column;
    const std::size_t before = here > 0 ? here - 1 : here;
    const std::size_t after = std::min(here + 1, count - 1);
    const double low = rows ? heightAt(column, before) : heightAt(before, row);
    const double high = rows ? heightAt(column, after) : heightAt(after, row);
    const double slope = (high - low) / (static_cast<double>(after - before) * (rows ? m_along : m_across));
    return std::isfinite(slope) ? slope : 0.0;
}

QImage SurveyPlan::picture(int sideMost) const {
    const std::size_t step = std::max<std::size_t>(
        1, (std::max(m_heights.nx, m_heights.ny) + static_cast<std::size_t>(sideMost) - 1) / static_cast<std::size_t>(sideMost));
    const auto [low, high] = usualHeights(m_heights.heights);
    QImage image(static_cast<int>((m_heights.nx + step - 1) / step), static_cast<int>((m_heights.ny + step - 1) / step),
                 QImage::Format_ARGB32);
    image.fill(Qt::transparent);
    const Vec3 light = Vec3(-1.0, 1.0, 1.5).normalized();
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const std::size_t column = static_cast<std::size_t>(x) * step;
            const std::size_t down = static_cast<std::size_t>(y) * step;
            const std::size_t row = m_upwards ? m_heights.ny - 1 - down : down;
            const double height = heightAt(column, row);
            if (!std::isfinite(height)) {
                continue;
            }
            const double up = slopeAlong(column, row, true) * (m_upwards ? 1.0 : -1.0);
            const Vec3 normal = Vec3(-slopeAlong(column, row, false), -up, 1.0).normalized();
            const double lit = 0.35 + 0.65 * std::clamp(1.25 * normal.dot(light), 0.0, 1.0);
            const QColor tint = between(std::clamp((height - low) / (high - low), 0.0, 1.0));
            image.setPixel(x, y,
                           qRgb(static_cast<int>(lit * tint.red()), static_cast<int>(lit * tint.green()),
                                static_cast<int>(lit * tint.blue())));
        }
    }
    return image;
}

}  // namespace rubble::widgets
