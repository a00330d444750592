#pragma once

#include <span>
#include <vector>

#include "core/analysis/cell_map.h"

namespace rubble {

/// A ring of a footprint: corners at (i, j) times the side of a cell, the last joined to the first. Outer rings run
/// counter-clockwise, holes clockwise.
using FootprintRing = std::vector<MapCell>;

/// Cells that hang together by their sides, as a polygon.
struct FootprintPolygon {
    FootprintRing outer;
    std::vector<FootprintRing> holes;
};

/// The outline of a set of cells, one polygon for each part that hangs together by sides, in the order of their first cells. Rings
/// have no corner on a straight stretch, do not cross and meet no corner of their own twice; rings of one polygon may touch in a
/// corner, where cells meet by one.
/// @param cells  ascending, each once
std::vector<FootprintPolygon> footprintOf(std::span<const MapCell> cells);

/// Area of a ring, in cells: negative for a hole.
double signedArea(const FootprintRing& ring);

}  // namespace rubble
