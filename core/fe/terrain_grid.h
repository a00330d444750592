#pragma once

#include <cstddef>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// Heights on a regular grid in the local frame: a continuous surface of two triangles a cell, split along the diagonal from the
/// lower to the upper corner. Beyond its edges the surface goes on level from the nearest edge point.
class TerrainGrid {
public:
    /// @param x0, y0  m, place of the first node
    /// @param cell    m, distance of nodes along both axes; positive
    /// @param heights [ny * nx] m, row by row from the lowest y; all finite
    /// Throws InputError if the counts do not match, are below 2, or a number is not finite.
    TerrainGrid(double x0, double y0, double cell, std::size_t nx, std::size_t ny, std::vector<double> heights);

    double height(double x, double y) const;
    /// Unit normal of the triangle below a point, upwards.
    Vec3 normal(double x, double y) const;
    /// Highest node in or around a rectangle: no point of the surface over it lies higher, m.
    double highestOver(double xMin, double yMin, double xMax, double yMax) const;
    double lowest() const { return m_lowest; }
    double highest() const { return m_highest; }

    double x0() const { return m_x0; }
    double y0() const { return m_y0; }
    double cell() const { return m_cell; }
    std::size_t nx() const { return m_nx; }
    std::size_t ny() const { return m_ny; }
    double node(std::size_t i, std::size_t j) const { return m_heights[j * m_nx + i]; }

private:
    double m_x0, m_y0, m_cell;
    std::size_t m_nx, m_ny;
    std::vector<double> m_heights;
    double m_lowest = 0.0, m_highest = 0.0;
};

}  // namespace rubble
