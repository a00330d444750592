#pragma once

#include <vector>

#include "core/engine/world/contact_patch.h"
#include "core/engine/world/rigid_world.h"
#include "core/fe/site_surface.h"

namespace rubble {

/// Patches between the ground (first solid) and one convex part of a body: corners against the surface below them. On level ground
/// one patch, on terrain one for each corner, since each has its own normal.
/// @param velocity  m/s, of the body; corners that cross the surface within dt [s] are held at the place where they cross
void collideGround(const SiteSurface& ground, const ConvexPart& part, const Pose& body, const Vec3& velocity, double dt,
                   double margin, std::vector<ContactPatch>& patches);

}  // namespace rubble
