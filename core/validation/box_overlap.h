#pragma once

#include <cstdint>
#include <vector>

#include "core/base/geometry.h"
#include "core/engine/world/rigid_world.h"

namespace rubble {

/// How deep two boxes are inside each other: the least distance along any of the 15 separating axes that parts them, m; negative is
/// a gap (a lower bound of it). Takes nothing from any solver, so that a solver cannot be the judge of itself.
double overlapOf(const OrientedBox& a, const OrientedBox& b);

/// Overlap of the bodies of a world, taken as boxes.
struct OverlapMeasure {
    double deepest = 0.0;         ///< m
    double p99 = 0.0;             ///< m, 99th percentile over the bodies of the deepest overlap of each
    double deepestShare = 0.0;    ///< deepest over the smaller body's smallest side
    std::int64_t beyondFive = 0;  ///< bodies deeper than 5 % of the smaller side
};
/// @param boxes  boxes in world axes
/// @param owners  [boxes] the bodies that they are parts of, counted in place of boxes; empty: each is a body
OverlapMeasure measureOverlap(const std::vector<OrientedBox>& boxes, const std::vector<std::size_t>& owners = {});

/// Boxes of all present bodies of a world, in world axes.
/// @param sizes  [bodies] full sizes of the boxes, centred on the bodies
std::vector<OrientedBox> placedBoxes(const RigidWorld& world, const std::vector<Vec3>& sizes);

}  // namespace rubble
