#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// A flat side of a convex body.
struct HullFace {
    Vec3 normal = Vec3::UnitZ();         ///< unit, outwards
    double distance = 0.0;               ///< m, of its plane from the origin, along the normal
    std::vector<std::uint32_t> corners;  ///< in order about the normal, against the clock seen from outside
};

/// An edge and the two faces that meet in it.
struct HullEdge {
    std::uint32_t from = 0, to = 0;     ///< corners
    std::uint32_t left = 0, right = 0;  ///< faces
};

/// A convex body by its corners, edges and faces.
struct ConvexHull {
    std::vector<Vec3> corners;  ///< m
    std::vector<HullEdge> edges;
    std::vector<HullFace> faces;
};

/// The hull of a few dozen points: every plane through three of them is tried. Points within a millionth of the size from a plane
/// lie in it; those in no corner stay in the list and in no face. Without volume it has no edges and no faces.
ConvexHull hullFaces(std::span<const Vec3> points);

}  // namespace rubble
