#pragma once

#include "core/engine/world/contact_patch.h"

namespace rubble {

/// A box placed in the world, ready for contact: axes are the columns of `axes`.
struct PlacedBox {
    Vec3 centre = Vec3::Zero();
    Mat3 axes = Mat3::Identity();
    Vec3 halfExtents = Vec3::Zero();
    double radius = 0.0;  ///< m, of a sphere around it; contact does not ask for it
};

/// Contact between two boxes by separating axes and face clipping; points up to `margin` [m] apart are reported too (speculative).
/// Returns no points where the boxes are farther apart. Deterministic.
/// @param faces  the deeper the boxes are in each other, the more an edge must be less deep than a face to be taken
ContactPatch collideBoxes(const PlacedBox& a, const PlacedBox& b, double margin, bool faces = false);

}  // namespace rubble
