#pragma once

#include <cstddef>
#include <vector>

namespace rubble {

/// Heights at the nodes of a regular grid in the local frame, as a raster of heights gives them. A node without one is not a
/// number.
struct HeightGrid {
    double x0 = 0.0;  ///< m, first node
    double y0 = 0.0;
    double dx = 1.0;  ///< m, between nodes; positive
    double dy = 1.0;
    std::size_t nx = 0;
    std::size_t ny = 0;
    std::vector<double> heights;  ///< [ny * nx] m, row by row from the lowest y
};

}  // namespace rubble
