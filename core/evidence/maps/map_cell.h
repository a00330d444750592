#pragma once

#include "core/fragments/fragment_set.h"

namespace rubble {

/// The cells of a map for which nobody gave a side.
struct UsualCell {
    double side = 0.25;     ///< m
    double fragment = 0.0;  ///< m, edge of a cube as large as the box of the median fragment; 0: there is none
};

/// No larger than a typical fragment, so that its place can be seen: 0.25 m, or of smaller fragments the next lower of 1, 2.5 and 5
/// times a power of ten. The structure is at most 20,000 cells long. Of all fragments of a run, whether they are there yet or not:
/// the maps of all its instants have the same cells.
/// @param length  m, of the structure in plan, the longer side
UsualCell usualMapCell(const FragmentSet& fragments, double length);

}  // namespace rubble
