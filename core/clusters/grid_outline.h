#pragma once

#include <array>
#include <vector>

#include "core/base/geometry.h"
#include "core/fragments/fragment_set.h"

namespace rubble {

/// The Basic Grid as lines over the fragments at their birth places: boxes of one size from the lowest corner of all fragments on,
/// as far as fragments have their centres in them, and of these the edges that are seen from outside. It shows how large the grid
/// is; no cluster need keep to these boxes, which know nothing of births.
/// @param size  l, w, h [m]
/// @return ends of the lines, two for each [m]; empty for sizes that are none, or so small that there is nothing to see
std::vector<Eigen::Vector3f> gridOutline(const FragmentSet& fragments, const std::array<double, 3>& size);

}  // namespace rubble
