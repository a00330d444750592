#pragma once

#include <array>
#include <memory>

#include "core/fe/fe_result.h"

namespace rubble {

/// An FE result with every brick split, for measuring how the program grows: no other analysis stands behind it. Nodes between
/// those of the file move by the shape functions of the brick. A piece dies with its brick, or one state earlier or later (a
/// quarter of them each), by its number.
/// @param split   pieces along the longest, the middle and the shortest side of each brick
/// @param states  of the result, from its first; at most what it has
std::shared_ptr<const FeResult> refinedResult(std::shared_ptr<const FeResult> coarse, std::array<int, 3> split, std::size_t states);

}  // namespace rubble
