#pragma once

#include <cstdint>
#include <vector>

namespace rubble {

/// Distance of every cell of a picture or map to the nearest that is marked, in cells; 1e10 where none is.
/// @param marked  [width * height], row by row
std::vector<double> distancesTo(const std::vector<std::uint8_t>& marked, int width, int height);

}  // namespace rubble
