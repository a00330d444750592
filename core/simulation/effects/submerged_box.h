#pragma once

#include "core/base/geometry.h"

namespace rubble {

/// What lies below a level plane of a box.
struct SubmergedBox {
    double volume = 0.0;           ///< m3
    Vec3 centroid = Vec3::Zero();  ///< m, of that volume; the centre of the box where nothing is below
    double waterplane = 0.0;       ///< m2, area of the cut
    double momentX = 0.0;          ///< m4, integral of (y - yc)^2 over the cut: what rights a turn about x
    double momentY = 0.0;          ///< m4, integral of (x - xc)^2 over the cut: what rights a turn about y
};

/// Cuts a box with the plane z = level. Exact: the faces below the plane are clipped to polygons and the volume integrals taken by
/// the divergence theorem from a point in the plane, where the cut itself contributes nothing. Moments of the cut are about the
/// centre of the box seen from above.
SubmergedBox submerge(const OrientedBox& box, double level);

/// Area of a box seen along a direction, m2: the sum over its axes of |n . d| times the area of the face (unit direction).
double projectedArea(const OrientedBox& box, const Vec3& direction);

}  // namespace rubble
