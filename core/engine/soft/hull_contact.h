#pragma once

#include <btBulletCollisionCommon.h>

#include "core/engine/world/contact_patch.h"

namespace rubble {

/// Contact between two convex shapes of which at least one is a hull: direction and depth by Bullet's GJK and EPA, the patch by
/// clipping the faces that look at each other. Shapes need polyhedral features. Safe to call from several threads.
ContactPatch collideHulls(const btPolyhedralConvexShape& a, const btTransform& placeA, const btPolyhedralConvexShape& b,
                          const btTransform& placeB, double margin);

}  // namespace rubble
