#pragma once

#include <cstdint>
#include <vector>

#include "core/analysis/debris/cell_map.h"
#include "core/base/execution.h"
#include "core/evidence/maps/piece_raster.h"
#include "core/evidence/surveys/survey.h"
#include "core/fe/site_surface.h"
#include "core/scenario/survey_scope.h"

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

/// Height of the ground that a survey is held above, m: of its terrain by the rule that its own heights are read by, else bilinear
/// between the nodes of the terrain, else that of the level ground.
double groundBelow(const Survey& survey, const SiteSurface& ground, double x, double y);

/// Which cells belong to a comparison [cells], 1 or 0: half of a cell or more lies within the area, and less than half is left out.
std::vector<std::uint8_t> comparedOn(const CellGrid& grid, const SurveyScope& scope, const Execution& execution);

/// What the survey says of each cell when it is moved by a shift [m]: of heights, each less the ground where it lies and standing
/// for its pixel, their mean at four by four points, not a number where more than half of these were not surveyed; of a footprint
/// the share of the cell within it, by lines at sixteen heights, exact along each.
CellGrid surveyedOn(const CellGrid& grid, const Survey& survey, const SiteSurface& ground, const Vec3& shift,
                    const Execution& execution);

}  // namespace rubble
