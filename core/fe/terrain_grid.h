#pragma once

#include <cstddef>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/hash.h"

namespace rubble {

/// Heights on a regular grid in the local frame: a continuous surface of two triangles a cell, split along the diagonal from the
/// south-west to the north-east corner (that of the lowest x and y to that of the highest). Beyond its edges the surface goes on
/// level from the nearest edge point. Immutable; any number of threads may ask.
class TerrainGrid {
public:
    /// @param x0, y0  m, place of the first node
    /// @param cell    m, distance of nodes along both axes; positive
    /// @param heights [ny * nx] m, row by row from the lowest y; all finite
    /// Throws UsageError if the counts do not match or are below 2, the cell is not positive, or a number is not finite; says
    /// where.
    TerrainGrid(double x0, double y0, double cell, std::size_t nx, std::size_t ny, std::vector<double> heights);

    /// Height of the surface at a place, m; not a number where the place is none.
    double height(double x, double y) const;
    /// Unit normal of the triangle below a point, upwards. Beyond the edges that of the level continuation.
    Vec3 normal(double x, double y) const;
    /// Highest node in or around a rectangle: no point of the surface over it lies higher, m. Costs a look at each node in it; a
    /// rectangle that is none counts as the whole terrain.
    double highestOver(double xMin, double yMin, double xMax, double yMax) const;
    double lowest() const { return m_lowest; }
    double highest() const { return m_highest; }

    double x0() const { return m_x0; }
    double y0() const { return m_y0; }
    double cell() const { return m_cell; }
    std::size_t nx() const { return m_nx; }
    std::size_t ny() const { return m_ny; }
    /// Height of the node i to the east and j to the north of the first, m.
    double node(std::size_t i, std::size_t j) const { return m_heights[j * m_nx + i]; }
    /// Names the content: equal for equal terrains.
    const Digest& digest() const { return m_digest; }

private:
    double m_x0, m_y0, m_cell;
    std::size_t m_nx, m_ny;
    std::vector<double> m_heights;
    double m_lowest = 0.0, m_highest = 0.0;
    Digest m_digest;
};

}  // namespace rubble
