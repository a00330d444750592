#pragma once

namespace rubble {

/// The Basic Grid: the box that decides which fragments move together, along x, y, z [m].
struct BasicGrid {
    double l = 0.0;
    double w = 0.0;
    double h = 0.0;
};

}  // namespace rubble
