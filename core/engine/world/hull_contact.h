#pragma once

#include "core/base/convex_hull.h"
#include "core/engine/world/contact_patch.h"

namespace rubble {

/// A convex body where it lies.
struct PlacedHull {
    const ConvexHull* hull = nullptr;
    Vec3 position = Vec3::Zero();  ///< m, of its origin
    Mat3 axes = Mat3::Identity();
    double leastHalf = 0.0;  ///< m, half of its smallest side
};

/// Contact of two convex bodies, at most `margin` [m] apart, by the rules of boxes (box_contact.h), which it agrees with where both
/// are boxes: the axis along which they are least deep in each other is that of a face or of two edges that cross (Gauss map,
/// Gregorius 2013); a face takes the corners of the other that lie over it, an edge the nearest place.
ContactPatch collideHulls(const PlacedHull& a, const PlacedHull& b, double margin);

}  // namespace rubble
