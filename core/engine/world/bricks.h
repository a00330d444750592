#pragma once

#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/fe/mesh.h"

namespace rubble {

/// A box of the volume of a solid. Its first axis is an edge direction, the second lies in the plane of two of them: where skewed
/// elements fill a wall, their bricks lie in courses and do not overlap, as tight boxes around them would.
/// @param corners  m, as many as cornerCount(solid), in the order of its nodes
OrientedBox brickOf(ElementShape solid, std::span<const Vec3> corners);

/// How far bricks are joined.
struct JoinLimits {
    double slack = 0.02;           ///< largest share of a joined box that no brick fills
    std::size_t bricksMax = 1000;  ///< in a joined box
};

/// Bricks joined to larger boxes wherever two that touch nearly fill a box; every box has the volume of its bricks. The order of
/// the result depends on that of the bricks alone.
std::vector<OrientedBox> joinedBricks(std::span<const OrientedBox> bricks, const JoinLimits& limits);

}  // namespace rubble
