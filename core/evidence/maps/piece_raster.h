#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/analysis/debris/cell_map.h"
#include "core/base/execution.h"
#include "core/evidence/maps/map_piece.h"
#include "core/fe/site_surface.h"

namespace rubble {

/// What lies in each cell that an outline reaches into. All lists are as long as `cells`.
struct PieceRaster {
    std::vector<MapCell> cells;            ///< ascending
    std::vector<double> height;            ///< m, mean over the cell of the top of what lies there above the ground, never negative
    std::vector<double> covered;           ///< share of the cell that something lies in, by the points that heights are taken at
    std::vector<double> volume;            ///< m3
    std::vector<double> mass;              ///< kg
    std::vector<double> pieces;            ///< how many reach into it
    std::vector<double> largest;           ///< m3, of the largest of them
    std::vector<std::uint32_t> component;  ///< that most of the mass in the cell belongs to; the first of equals
    std::vector<double> arrival;           ///< s, of the first of them; NaN where none is known
    std::vector<double> impactEnergy;      ///< J
};

/// Lays pieces on a grid of square cells. Volume, mass and energy of a piece are spread evenly over the outline of its box seen
/// from above, by the exact area of the outline within each cell; a piece without an outline goes to the cell of its centre. The
/// sums over the cells are those over the pieces to rounding. Heights are taken at four by four points of each cell. Parallel over
/// tiles; the result does not depend on the number of threads.
/// @param cell  m, side of a cell
/// Throws UsageError for cells that are no size, pieces with numbers that are none or negative, and maps too large; Cancelled.
PieceRaster rasterOf(std::span<const MapPiece> pieces, double cell, const SiteSurface& ground, const Execution& execution);

}  // namespace rubble
