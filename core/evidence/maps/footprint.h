#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/analysis/debris/cell_map.h"
#include "core/base/geometry.h"
#include "core/base/outline.h"

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

/// Adds where the level line through y crosses a ring, in the order of its edges.
void addCrossings(const OutlineRing& ring, double y, std::vector<double>& crossings);

/// Fills an outline along level lines. The outline must outlive this object.
class OutlineFill {
public:
    explicit OutlineFill(const Outline& outline);

    /// Stretches of the level line through y that lie within, ascending, none within another. Valid until the next call.
    const std::vector<std::pair<double, double>>& within(double y);

private:
    struct Reach {
        double low;
        double high;
    };

    const Outline& m_outline;
    std::vector<Reach> m_reaches;  ///< [polygons] m, along y
    std::vector<double> m_crossings;
    std::vector<std::pair<double, double>> m_spans;
};

}  // namespace rubble
