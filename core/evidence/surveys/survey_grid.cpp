#include "core/evidence/surveys/survey_grid.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/unknown.h"

namespace rubble {

namespace {

constexpr double cellsMax = 2e7;
constexpr int points = 4;  // along each side of a cell, at which heights are taken
constexpr int lines = 16;  // across a cell, along which an outline is followed

/// Bilinear between the nodes of a terrain, level beyond them.
double terrainBetween(const TerrainGrid& terrain, double x, double y) {
    const auto along = [](double place, std::size_t nodes) { return std::clamp(place, 0.0, static_cast<double>(nodes - 1)); };
    const double u = along((x - terrain.x0()) / terrain.cell(), terrain.nx());
    const double v = along((y - terrain.y0()) / terrain.cell(), terrain.ny());
    const std::size_t i = std::min(static_cast<std::size_t>(u), terrain.nx() - 2);
    const std::size_t j = std::min(static_cast<std::size_t>(v), terrain.ny() - 2);
    const double s = u - static_cast<double>(i);
    const double t = v - static_cast<double>(j);
    // Term by term as heights of a survey, so that equal heights give equal bits.
    const auto part = [](double weight, double height) { return weight > 1e-9 ? weight * height : 0.0; };
    return part((1.0 - t) * (1.0 - s), terrain.node(i, j)) + part((1.0 - t) * s, terrain.node(i + 1, j)) +
           part(t * (1.0 - s), terrain.node(i, j + 1)) + part(t * s, terrain.node(i + 1, j + 1));
}

/// Mean height above the ground in a cell, over the points that were surveyed. @param above  as heightsAboveGround() gives them
double heightIn(const SurveyHeights& above, const Eigen::Vector2d& corner, double cell, const Vec3& shift) {
    double sum = 0.0;
    int known = 0;
    for (int j = 0; j < points; ++j) {
        for (int i = 0; i < points; ++i) {
            const double x = corner.x() + cell * (i + 0.5) / points;
            const double y = corner.y() + cell * (j + 0.5) / points;
            const double height = above.at(x - shift.x(), y - shift.y());
            if (std::isfinite(height) || above.everywhere) {
                sum += std::isfinite(height) ? height : 0.0;
                ++known;
            }
        }
    }
    return 2 * known >= points * points ? sum / known : unknown;
}

/// The heights of a survey less the ground where each of them lies: nothing is interpolated over the edges of debris.
SurveyHeights heightsAboveGround(const Survey& survey, const SiteSurface& ground, const Vec3& shift, const Execution& execution) {
    SurveyHeights above = survey.heights;
    above.aboveGround = true;
    for (std::size_t row = 0; row < above.ny && !survey.heights.aboveGround; ++row) {
        execution.check();
        for (std::size_t column = 0; column < above.nx; ++column) {
            double& height = above.heights[row * above.nx + column];
            if (std::isfinite(height)) {
                const Eigen::Vector2d place =
                    above.placeOf(static_cast<double>(column), static_cast<double>(row)) + shift.head<2>();
                height += place.allFinite() ? shift.z() - groundBelow(survey, ground, place.x(), place.y()) : unknown;
            }
        }
    }
    return above;
}

/// Adds the share of cells along one line between two places where it enters and leaves.
void addSpan(CellGrid& grid, int row, double from, double to) {
    const double first = (from / grid.cell) - grid.low.i;
    const double last = (to / grid.cell) - grid.low.i;
    const int begin = std::max(0, static_cast<int>(std::floor(first)));
    const int end = std::min(grid.columns - 1, static_cast<int>(std::floor(last)));
    for (int column = begin; column <= end; ++column) {
        const double covered = std::min(last, column + 1.0) - std::max(first, static_cast<double>(column));
        grid.values[grid.index(column, row)] += std::max(0.0, covered) / lines;
    }
}

void layFootprint(CellGrid& grid, const Outline& footprint, const Vec3& shift, const Execution& execution) {
    grid.values.assign(grid.values.size(), 0.0);
    OutlineFill fill(footprint);
    for (int row = 0; row < grid.rows; ++row) {
        execution.check();
        for (int line = 0; line < lines; ++line) {
            const double y = grid.cell * (grid.low.j + row + (line + 0.5) / lines) - shift.y();
            for (const auto& [from, to] : fill.within(y)) {
                addSpan(grid, row, from + shift.x(), to + shift.x());
            }
        }
    }
}

}  // namespace

CellGrid gridAround(const Survey& survey, const PieceRaster& debris, double cell, int margin) {
    if (!(cell > 0.0) || !std::isfinite(cell)) {
        throw UsageError({"survey.cell", "Cells of {0} are no size", {{cell, "m"}}},
                         {"survey.cell.remedy", "Choose cells of 0.05 m or more.", {}});
    }
    auto [low, high] = survey.bounds();
    // A height stands for the cell around it.
    const double half = survey.isFootprint ? 0.0 : 0.5 * survey.heights.spacing();
    low.array() -= half;
    high.array() += half;
    for (const MapCell& each : debris.cells) {
        low = low.cwiseMin(cell * Eigen::Vector2d(each.i, each.j));
        high = high.cwiseMax(cell * Eigen::Vector2d(each.i + 1.0, each.j + 1.0));
    }
    const Eigen::Vector2d first = (low / cell).array().floor() - margin;
    const Eigen::Vector2d last = (high / cell).array().ceil() + margin;
    const Eigen::Vector2d count = last - first;
    if (!(count.x() * count.y() <= cellsMax) || !(first.cwiseAbs().maxCoeff() < 1e9)) {
        throw UsageError({"survey.too_large",
                          "Survey and debris take {0} by {1} cells of {2}",
                          {static_cast<std::int64_t>(std::min(count.x(), 1e15)),
                           static_cast<std::int64_t>(std::min(count.y(), 1e15)),
                           {cell, "m"}}},
                         {"survey.too_large.remedy", "Choose larger cells, or cut the survey to the site.", {}});
    }
    CellGrid grid;
    grid.cell = cell;
    grid.low = {static_cast<std::int32_t>(first.y()), static_cast<std::int32_t>(first.x())};
    grid.columns = static_cast<int>(count.x());
    grid.rows = static_cast<int>(count.y());
    grid.values.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows), unknown);
    return grid;
}

double groundBelow(const Survey& survey, const SiteSurface& ground, double x, double y) {
    if (!ground.terrain) {
        return ground.levelHeight;
    }
    const double own = survey.ground ? survey.ground->at(x, y) : unknown;
    return std::isfinite(own) ? own : terrainBetween(*ground.terrain, x, y);
}

std::vector<std::uint8_t> comparedOn(const CellGrid& grid, const SurveyScope& scope, const Execution& execution) {
    std::vector<std::uint8_t> compared(grid.values.size(), 1);
    const auto keep = [&](const Outline& outline, bool within) {
        CellGrid shares = grid;
        layFootprint(shares, outline, Vec3::Zero(), execution);
        for (std::size_t k = 0; k < compared.size(); ++k) {
            compared[k] &= static_cast<std::uint8_t>((shares.values[k] >= 0.5) == within);
        }
    };
    if (!scope.area.empty()) {
        keep(scope.area, true);
    }
    if (!scope.leftOut.empty()) {
        keep(scope.leftOut, false);
    }
    return compared;
}

CellGrid laidOn(const CellGrid& grid, const PieceRaster& debris) {
    CellGrid laid = grid;
    laid.values.assign(grid.values.size(), 0.0);
    for (std::size_t k = 0; k < debris.cells.size(); ++k) {
        const int column = debris.cells[k].i - grid.low.i;
        const int row = debris.cells[k].j - grid.low.j;
        laid.values[grid.index(column, row)] = debris.height[k];
    }
    return laid;
}

CellGrid surveyedOn(const CellGrid& grid, const Survey& survey, const SiteSurface& ground, const Vec3& shift,
                    const Execution& execution) {
    CellGrid laid = grid;
    if (survey.isFootprint) {
        layFootprint(laid, survey.footprint, shift, execution);
        return laid;
    }
    const SurveyHeights above = heightsAboveGround(survey, ground, shift, execution);
    for (int row = 0; row < grid.rows; ++row) {
        execution.check();
        for (int column = 0; column < grid.columns; ++column) {
            const MapCell at = grid.at(column, row);
            laid.values[grid.index(column, row)] = heightIn(above, grid.cell * Eigen::Vector2d(at.i, at.j), grid.cell, shift);
        }
    }
    return laid;
}

}  // namespace rubble
