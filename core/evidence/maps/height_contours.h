#pragma once

#include <span>
#include <vector>

#include "core/analysis/debris/cell_map.h"

namespace rubble {

/// A closed line of equal height, the higher ground to its left; the last corner is joined to the first.
struct HeightContour {
    double level = 0.0;                    ///< m
    std::vector<Eigen::Vector2d> corners;  ///< m
};

/// Lines at every multiple of `spacing` above zero, by level. Heights hold at the middles of cells and are linear between them
/// along the grid; cells that are not listed, and heights that are none, are zero: so every line closes.
/// @param cells    ascending, each once
/// @param heights  m, one for each cell
/// @param spacing  m
/// Throws UsageError for a spacing that is none, or that makes more than a thousand levels.
std::vector<HeightContour> heightContours(std::span<const MapCell> cells, std::span<const double> heights, double cell,
                                          double spacing);

}  // namespace rubble
