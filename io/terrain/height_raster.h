#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/fe/terrain_grid.h"

namespace rubble::io {

/// Heights of a raster in the local frame, on their way to a terrain. What has no height is not a number.
struct HeightRaster {
    double x0 = 0.0;  ///< m, first node
    double y0 = 0.0;
    double dx = 1.0;  ///< m, between nodes; positive
    double dy = 1.0;
    std::size_t nx = 0;
    std::size_t ny = 0;
    std::vector<double> heights;  ///< [ny * nx] m, row by row from the lowest y
};

/// Reverses the order of rows or columns.
void flipRows(HeightRaster& raster);
void flipColumns(HeightRaster& raster);

std::int64_t countGaps(const HeightRaster& raster);

/// Gives every node without a height the mean of those of its eight neighbours that have one, from the rim of each gap inwards.
/// The raster has at least one height.
void fillGaps(HeightRaster& raster);

/// A height that stands out from all around it.
struct HeightSpike {
    std::size_t node = 0;
    double height = 0.0;  ///< m
};

/// Makes gaps of nodes that lie farther from the median of their neighbours than four times the range of these (their highest and
/// lowest left out), half a cell and 2 m: poles, birds, marks of no data. Edges, walls and slopes stay.
std::vector<HeightSpike> removeSpikes(HeightRaster& raster);

/// The same surface on square cells as wide as the shorter side of the raster's own, between nodes by bilinear interpolation. A
/// raster that is square to a thousandth of a cell over its whole length stays as it is.
HeightRaster withSquareCells(HeightRaster raster);

/// Nodes that withSquareCells() would give.
double squareNodeCount(double dx, double dy, std::size_t nx, std::size_t ny);

}  // namespace rubble::io
