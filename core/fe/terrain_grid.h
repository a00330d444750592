#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/hash.h"
#include "core/fe/height_grid.h"

namespace rubble {

/// One number for each side of a rectangle: west, east, south, north.
using GridSides = std::array<std::size_t, 4>;

/// What a terrain knows of itself beside its heights.
struct TerrainExtent {
    /// Node of the grid at which the window about the structure begins, and the nodes of that window; none: it is the whole grid.
    std::size_t column = 0;
    std::size_t row = 0;
    std::size_t columns = 0;
    std::size_t rows = 0;
    /// m, place of that node. Places are counted from it, so that what is read around the window changes no bit within.
    double x0 = 0.0;
    double y0 = 0.0;
    GridSides unread{};                 ///< rows and columns of the raster beyond each edge for which there was no room
    std::vector<std::uint8_t> missing;  ///< [ny * nx] 1 where the raster has ended and the height is a guess; empty: nowhere
};

/// What a raster is too coarse to hold: a bump or hollow at every node of a finer lattice, each independent of the others, with
/// level differences between neighbours that are on average as high as obstacles are (the mean obstacle height of Rockyfor3D,
/// Dorren 2016).
struct TerrainRoughness {
    double height = 0.0;   ///< m, mean height of obstacles, that is of the difference of neighbouring nodes; 0: smooth
    double spacing = 0.0;  ///< m, of the lattice, beyond which nothing is correlated
    std::uint64_t seed = 1;
};

/// Heights on a regular grid in the local frame: a continuous surface of two triangles a cell, split along the diagonal from the
/// south-west to the north-east corner (that of the lowest x and y to that of the highest). Beyond its edges the surface goes on
/// level from the nearest edge point. Immutable; any number of threads may ask.
class TerrainGrid {
public:
    /// @param grid  square cells, all heights finite
    /// Throws UsageError if the counts do not match or are below 2, the cells are not square, or a number is not finite; says
    /// where.
    explicit TerrainGrid(HeightGrid grid, TerrainExtent extent = {});
    /// @param x0, y0  m, place of the first node
    /// @param cell    m, distance of nodes along both axes
    /// @param heights [ny * nx] m, row by row from the lowest y
    TerrainGrid(double x0, double y0, double cell, std::size_t nx, std::size_t ny, std::vector<double> heights);

    /// The same terrain with roughness on top, drawn from its seed alone: its heights are those of this one at the nodes of the
    /// lattice, with a bump or hollow of at most 3.1 times the mean height of obstacles. The mean over many nodes is unchanged.
    TerrainGrid roughened(const TerrainRoughness& roughness) const;
    const TerrainRoughness& roughness() const { return m_roughness; }

    /// Height of the surface at a place, m; not a number where the place is none.
    double height(double x, double y) const;
    /// Unit normal of the triangle below a point, upwards. Beyond the edges that of the level continuation.
    Vec3 normal(double x, double y) const;
    /// Highest node in or around a rectangle: no point of the surface over it lies higher, m. Costs a look at each node in it; a
    /// rectangle that is none counts as the whole terrain.
    double highestOver(double xMin, double yMin, double xMax, double yMax) const;
    double lowest() const { return m_lowest; }
    double highest() const { return m_highest; }

    /// Where the height at a place comes from.
    enum class Source {
        Raster,
        Ended,   ///< the raster has no heights there
        Unread,  ///< the raster goes on there, but there was no room for it
    };
    Source source(double x, double y) const;
    /// The window about the structure with its heights, m.
    const Aabb& window() const { return m_window; }
    const TerrainExtent& extent() const { return m_extent; }
    const HeightGrid& grid() const { return m_grid; }

    double x0() const { return m_grid.x0; }
    double y0() const { return m_grid.y0; }
    double cell() const { return m_grid.dx; }
    std::size_t nx() const { return m_grid.nx; }
    std::size_t ny() const { return m_grid.ny; }
    /// Height of the node i to the east and j to the north of the first, m.
    double node(std::size_t i, std::size_t j) const { return m_grid.heights[j * m_grid.nx + i]; }
    /// Names the content: equal for equal terrains.
    const Digest& digest() const { return m_digest; }

private:
    void check() const;
    void takeExtent();
    double smoothHeight(double x, double y) const;
    double roughNode(double i, double j) const;
    double mostRough() const;

    HeightGrid m_grid;
    TerrainExtent m_extent;
    Aabb m_window;
    double m_lowest = 0.0, m_highest = 0.0;
    Digest m_digest;
    TerrainRoughness m_roughness;
};

/// How many of the nodes around a window can be taken: on all sides as many as there are, or alike, so that the grid holds no more
/// than a limit. None if the window alone holds as many.
/// @param there  nodes beyond each side
/// @param nodes  how many nodes so many columns and rows make
GridSides roomAround(std::size_t columns, std::size_t rows, const GridSides& there, double nodesMax,
                     const std::function<double(std::size_t, std::size_t)>& nodes);

}  // namespace rubble
