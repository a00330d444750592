#pragma once

#include <algorithm>
#include <vector>

#include "core/evidence/maps/debris_map.h"
#include "widgets/figures/map_picture.h"

namespace rubble::figures {

/// Cells to be shown, both ends included.
struct MapWindow {
    MapCell low{0, 0};
    MapCell high{0, 0};

    int columns() const { return high.i - low.i + 1; }
    int rows() const { return high.j - low.j + 1; }
    /// How many cells a cell lies beyond the window, 0: it lies within.
    int beyond(const MapCell& cell) const {
        return std::max({low.i - cell.i, cell.i - high.i, low.j - cell.j, cell.j - high.j, 0});
    }
    bool holds(const MapCell& cell) const { return cell.i >= low.i && cell.i <= high.i && cell.j >= low.j && cell.j <= high.j; }
};

/// What holds 99.9 % of the mass, or all if that is not much longer, and outlines of the structure. @param outlines  of the picture
MapWindow windowOf(const DebrisMap& map, const std::vector<MapOutline>& outlines);

/// What the colours of a layer run from and to, in steps that read well.
struct MapRange {
    double low = 0.0;
    double high = 1.0;
    bool cut = false;  ///< some values are higher
    double step = 0.25;

    double place(double value) const { return std::clamp((value - low) / (high - low), 0.0, 1.0); }
};

/// @param values  of a layer; NaN where there is none
MapRange rangeOf(const std::vector<double>& values, MapLayer layer);

}  // namespace rubble::figures
