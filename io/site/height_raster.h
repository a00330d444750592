#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/fe/height_grid.h"

namespace rubble::io {

/// Reverses the order of rows or columns.
void flipRows(HeightGrid& raster);
void flipColumns(HeightGrid& raster);

/// Height of the surface of two triangles a cell, as a terrain has it; not a number beside it and beside gaps.
double heightOn(const HeightGrid& raster, const Eigen::Vector2d& place);

std::int64_t countGaps(const HeightGrid& raster);

/// 1 for each node without a height where the raster has ended, as beyond its edge. Such nodes hang together with the edge by ways
/// at least eight nodes wide: narrower ones are pores between the points of a cloud, which lie within it. Empty if there is none.
std::vector<std::uint8_t> outerGaps(const HeightGrid& raster);

/// Gives every node without a height the mean of those of its eight neighbours that have one, from the rim of each gap inwards.
/// The raster has at least one height.
void fillGaps(HeightGrid& raster);

/// A height that stands out from all around it.
struct HeightSpike {
    std::size_t node = 0;
    double height = 0.0;  ///< m
};

/// Makes gaps of nodes that lie farther from the median of their neighbours than four times the range of these (their highest and
/// lowest left out), half a cell and 2 m: poles, birds, marks of no data. Edges, walls and slopes stay.
std::vector<HeightSpike> removeSpikes(HeightGrid& raster);

/// The same surface on square cells as wide as the shorter side of the raster's own, between nodes by bilinear interpolation. A
/// raster that is square to a thousandth of a cell over its whole length stays as it is.
HeightGrid withSquareCells(HeightGrid raster);

/// The surface of a raster at the nodes of a grid with square cells, whose heights are taken; beyond its edges that of the nearest
/// edge point.
void sampleAt(HeightGrid& nodes, const HeightGrid& raster);

/// Cells are square to a thousandth of a cell over the whole length.
bool squareCells(const HeightGrid& raster);

/// Nodes that withSquareCells() would give.
double squareNodeCount(double dx, double dy, std::size_t nx, std::size_t ny);

}  // namespace rubble::io
