#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// Where places of the local frame lie among the columns and rows of a raster that is turned or projected: known at the nodes of a
/// square lattice and bilinear between them, which is exact for a raster that is only turned, scaled and shifted.
struct RasterLattice {
    double x0 = 0.0;  ///< m, first node
    double y0 = 0.0;
    double step = 1.0;   ///< m, between nodes
    double pixel = 1.0;  ///< m, shorter side of a pixel
    std::size_t nx = 0;  ///< two or more, as ny
    std::size_t ny = 0;
    std::vector<Eigen::Vector2d> pixels;  ///< [ny * nx] column and row, whole at the middle of a pixel; not a number: none there

    /// Column and row of a place; not a number beyond the lattice.
    Eigen::Vector2d pixelAt(double x, double y) const;
    /// m, local, of a column and row; not a number where that does not lie within the lattice.
    Eigen::Vector2d placeOf(const Eigen::Vector2d& at) const;
    /// Least and greatest place, m.
    std::pair<Eigen::Vector2d, Eigen::Vector2d> bounds() const;
};

}  // namespace rubble
