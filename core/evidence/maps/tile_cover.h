#pragma once

#include <array>
#include <cstdint>

#include "core/analysis/debris/box_outline.h"

namespace rubble {

/// Cells along each side of a tile: what the maps are made of, so that a piece that flew far costs a tile and not a map.
inline constexpr int tileCells = 16;
/// Points along each side of a cell at which heights are taken.
inline constexpr int heightPoints = 4;

/// Which cells of a tile an outline reaches into, and by how much. Coordinates are in cells, from the tile's lower left corner.
class TileCover {
public:
    /// Takes an outline (convex, counter-clockwise), cut to the tile. Exact up to rounding: along each edge the area to its right
    /// is summed by cell (signed-area accumulation), so the cost goes with the length of the edges.
    void take(const SmallPolygon& outline);

    int firstColumn() const { return m_low[0]; }
    int lastColumn() const { return m_high[0]; }
    int firstRow() const { return m_low[1]; }
    int lastRow() const { return m_high[1]; }
    /// Area within a cell, in cells; within the columns and rows above.
    double area(int column, int row) const { return m_area[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]; }
    /// The outline does not reach into the tile.
    bool empty() const { return m_high[0] < m_low[0]; }

private:
    void addEdge(Eigen::Vector2d from, Eigen::Vector2d to);
    void addWithinRow(std::array<double, tileCells + 2>& row, double x0, double x1, double rise);

    std::array<int, 2> m_low{0, 0};
    std::array<int, 2> m_high{-1, -1};
    std::array<std::array<double, tileCells + 2>, tileCells> m_area{};
};

/// Height of the surface of debris over a tile, at heightPoints by heightPoints points of each cell.
class TileSurface {
public:
    TileSurface() { clear(); }
    void clear();
    /// Raises the surface to the top of a box wherever it is lower.
    /// @param outline  of the box, in cells from the tile's lower left corner, uncut
    /// @param corner   m, that corner
    void raise(const OrientedBox& box, const SmallPolygon& outline, const Eigen::Vector2d& corner, double cell);
    /// m; minus infinity where nothing is.
    double at(int column, int row) const { return m_height[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]; }

private:
    static constexpr int side = tileCells * heightPoints;
    std::array<std::array<double, side>, side> m_height;
};

}  // namespace rubble
