#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/clusters/axis_order.h"
#include "core/fragments/fragment_set.h"

namespace rubble {

/// Where fragments stand in the order of DESIGN.md 2.2: the mean of the corners of each solid [fragments] m. Not the centre of
/// mass, which distortion moves, nor the middle of the box.
std::vector<Vec3> orderingCentres(const FragmentSet& fragments);

/// The order of some fragments along an axis (0 x, 1 y, 2 z), by the outer faces of their solids. @param members  fragment indices
AxisOrder orderFragments(const FragmentSet& fragments, const Mesh& mesh, std::span<const Vec3> centres,
                         std::span<const std::uint32_t> members, int axis);

}  // namespace rubble
