#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/analysis/debris/debris.h"
#include "core/fe/site_surface.h"

namespace rubble {

/// A square cell of a map with cells of c [m]: it covers [i c, (i + 1) c) along x and [j c, (j + 1) c) along y.
struct MapCell {
    std::int32_t j = 0;
    std::int32_t i = 0;
    friend auto operator<=>(const MapCell&, const MapCell&) = default;
};

/// A number for each cell that holds anything, in ascending order of cells. Sparse: a fragment that flew far costs one cell.
struct CellMap {
    double cell = 1.0;  ///< m, side of a cell
    std::vector<MapCell> cells;
    std::vector<double> values;

    std::size_t size() const { return cells.size(); }
    double area() const { return static_cast<double>(size()) * cell * cell; }  ///< m2, of all cells that hold anything
    double sum() const;
    /// The value of a cell; 0 where the map holds nothing.
    double at(MapCell cell) const;
};

/// Mass by cell [kg]. The mass of a fragment is spread evenly over the outline of its box seen from above, so that a fragment that
/// moves a little changes the map a little; a fragment without an outline (upright and without thickness) goes to the cell of its
/// centre. The sum of the map is the mass of the debris.
/// Throws UsageError as checkDebris() does, and if the cells would be too many.
CellMap massMap(const Debris& debris, double cell);

/// Mean height of the debris above the ground by cell [m], of all cells that the outline of a fragment reaches into: these are the
/// footprint. The height at a place is that of the top of the highest box above it over the ground there, taken at four by four
/// points of each cell; nothing below the ground counts. Throws as massMap().
CellMap heightMap(const Debris& debris, double cell, const SiteSurface& ground);

/// Refuses debris with a number that is none or out of all range: throws UsageError naming the fragment.
void checkDebris(const Debris& debris);

}  // namespace rubble
