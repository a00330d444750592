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
    double finest = 0.0;           ///< m: a box whose longest side is no longer may be emptier
    double finestSlack = 0.5;      ///< largest share of such a box that no brick fills
    std::size_t boxesMax = 65536;  ///< that come out: what is finest grows until they do
};

/// Bricks joined to larger boxes wherever two that touch nearly fill a box, and where it is fine also over gaps; every box has the
/// volume of its bricks. The order of
/// the result depends on that of the bricks alone.
std::vector<OrientedBox> joinedBricks(std::span<const OrientedBox> bricks, const JoinLimits& limits);

}  // namespace rubble
