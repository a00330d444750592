#pragma once

#include <vector>

#include "core/analysis/debris/cell_map.h"
#include "core/base/execution.h"
#include "core/evidence/maps/piece_raster.h"
#include "core/evidence/surveys/survey.h"
#include "core/fe/site_surface.h"

namespace rubble {

/// Cells over a rectangle, each with a number or none (not a number).
struct CellGrid {
    double cell = 1.0;  ///< m
    MapCell low{0, 0};  ///< the first cell
    int columns = 0;
    int rows = 0;
    std::vector<double> values;  ///< [rows * columns], rows from the lowest y

    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }
    MapCell at(int column, int row) const { return {low.j + row, low.i + column}; }
    /// Middle of a cell, m.
    Eigen::Vector2d middle(int column, int row) const { return cell * Eigen::Vector2d(low.i + column + 0.5, low.j + row + 0.5); }
};

/// The cells around a survey and debris, and a margin of cells to each side, without numbers.
/// Throws UsageError where they would be too many.
CellGrid gridAround(const Survey& survey, const PieceRaster& debris, double cell, int margin);

/// Debris laid on the grid: height above the ground where there is any, 0 elsewhere.
CellGrid laidOn(const CellGrid& grid, const PieceRaster& debris);

/// What the survey says of each cell when it is moved by a shift [m]: of heights their mean above the ground at four by four
/// points, not a number where more than half of these were not surveyed; of a footprint the share of the cell within it, by lines
/// at sixteen heights, exact along each.
CellGrid surveyedOn(const CellGrid& grid, const Survey& survey, const SiteSurface& ground, const Vec3& shift,
                    const Execution& execution);

}  // namespace rubble
