#pragma once

#include <array>
#include <memory>

#include "core/fe/fe_result.h"

namespace rubble {

/// An FE result with every brick split, for measuring how the program grows: no other analysis stands behind it. Nodes between
/// those of the file move by the shape functions of the brick. A piece dies with its brick, or one or two states earlier (a
/// quarter of them each), by its number; never later, as what a file says of the nodes of a dead brick is no motion.
/// @param split   pieces along the longest, the middle and the shortest side of each brick
/// @param states  of the result, from its first; at most what it has
std::shared_ptr<const FeResult> refinedResult(std::shared_ptr<const FeResult> coarse, std::array<int, 3> split, std::size_t states);

}  // namespace rubble
