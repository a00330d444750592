#pragma once

#include <cstddef>
#include <vector>

#include "core/base/outline.h"

namespace rubble {

/// Closed lines made of lines that were measured piece by piece.
struct EdgeRings {
    std::vector<OutlineRing> rings;  ///< m, each of three corners or more
    std::size_t closed = 0;          ///< rings whose ends were joined by a straight line
    double longest = 0.0;            ///< m, of these lines
    std::size_t leftOut = 0;         ///< lines of fewer than three corners, joined to no other
};

/// Joins lines whose ends lie within a reach of each other, and closes what is left open from its last corner to its first.
/// @param lines  m; a corner that follows an equal one counts once; @param reach  m
EdgeRings joinedRings(std::vector<OutlineRing> lines, double reach);

/// Whether two sides of a closed line that are no neighbours cross. Takes a time that grows with the square of its corners.
bool crossesItself(const OutlineRing& ring);

}  // namespace rubble
