#include "core/evidence/surveys/seen_debris.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/unknown.h"

namespace rubble {

namespace {

/// Finds heights of fine cells, and where they lie.
class FineHeights {
public:
    explicit FineHeights(const FineDebris& debris) : m_debris(debris) {
        for (const MapCell& cell : debris.raster.cells) {
            const Eigen::Vector2d corner = debris.cell * Eigen::Vector2d(cell.i, cell.j);
            m_low = m_low.cwiseMin(corner);
            m_high = m_high.cwiseMax(Eigen::Vector2d(corner.array() + debris.cell));
        }
    }

    /// m above the ground; 0 where nothing lies.
    double at(const Eigen::Vector2d& place) const {
        if (!(place.x() >= m_low.x() && place.y() >= m_low.y() && place.x() < m_high.x() && place.y() < m_high.y())) {
            return 0.0;
        }
        const std::vector<MapCell>& cells = m_debris.raster.cells;
        const MapCell wanted{static_cast<std::int32_t>(std::floor(place.y() / m_debris.cell)),
                             static_cast<std::int32_t>(std::floor(place.x() / m_debris.cell))};
        const auto found = std::lower_bound(cells.begin(), cells.end(), wanted);
        const bool there = found != cells.end() && *found == wanted;
        return there ? m_debris.raster.height[static_cast<std::size_t>(found - cells.begin())] : 0.0;
    }

private:
    const FineDebris& m_debris;
    Eigen::Vector2d m_low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector2d m_high = -m_low;
};

CellGrid coverSeen(const CellGrid& grid, const FineDebris& debris, double leastHeight) {
    CellGrid seen = grid;
    seen.values.assign(grid.values.size(), 0.0);
    const double share = debris.cell * debris.cell / (grid.cell * grid.cell);
    for (std::size_t k = 0; k < debris.raster.cells.size(); ++k) {
        const MapCell& cell = debris.raster.cells[k];
        const auto column = static_cast<int>(std::floor((cell.i + 0.5) * debris.cell / grid.cell)) - grid.low.i;
        const auto row = static_cast<int>(std::floor((cell.j + 0.5) * debris.cell / grid.cell)) - grid.low.j;
        if (debris.raster.height[k] >= std::max(leastHeight, 1e-9) && column >= 0 && row >= 0 && column < grid.columns &&
            row < grid.rows) {
            seen.values[seen.index(column, row)] += share;
        }
    }
    return seen;
}

}  // namespace

double fineCellFor(const Survey& survey, double cell, double area) {
    constexpr double parts = 5.0;  // an odd number: the middle of a surveyed cell is that of a fine one
    constexpr double cellsMost = 2e6;
    const double coarse = survey.isFootprint ? cell : survey.heights.spacing();
    return std::max(coarse / parts, std::sqrt(area / cellsMost));
}

CellGrid seenOn(const CellGrid& grid, const Survey& survey, const FineDebris& debris, double leastHeight, const Vec3& shift,
                const Execution& execution) {
    if (survey.isFootprint) {
        return coverSeen(grid, debris, leastHeight);
    }
    const FineHeights fine(debris);
    Survey seen;
    seen.heights = survey.heights;
    SurveyHeights& heights = seen.heights;
    for (std::size_t row = 0; row < heights.ny; ++row) {
        execution.check();
        for (std::size_t column = 0; column < heights.nx; ++column) {
            double& height = heights.heights[row * heights.nx + column];
            if (std::isfinite(height)) {
                const Eigen::Vector2d place = heights.placeOf(static_cast<double>(column), static_cast<double>(row));
                height = fine.at(place + shift.head<2>());
            }
        }
    }
    // Heights above the ground already: level ground takes nothing off.
    return surveyedOn(grid, seen, SiteSurface{}, {shift.x(), shift.y(), 0.0}, execution);
}

}  // namespace rubble
