#pragma once

#include <btBulletCollisionCommon.h>

#include "core/fe/site_surface.h"

namespace rubble {

/// A terrain in Bullet's world: a box around all that may touch it, for the broad phase alone. Contacts are made against the height
/// function itself, solid below: Bullet's own height field is a skin that fast bodies pass through (PHYSICS.md section 4), and it
/// ends at its edge.
class TerrainShape : public btBoxShape {
public:
    /// @param reach  m, half the side of the box; it hangs from the highest point of the terrain down below the lowest
    TerrainShape(const SiteSurface& surface, double reach);
    const SiteSurface& surface() const { return m_surface; }
    /// m, height of the middle of the box.
    double middle() const;
    static const TerrainShape* of(const btCollisionObject* object);

private:
    SiteSurface m_surface;
};

/// The narrow phase between a terrain and a body: its corners against the surface below them.
btCollisionAlgorithm* makeTerrainAlgorithm(btDispatcher& dispatcher, const btCollisionObjectWrapper& a,
                                           const btCollisionObjectWrapper& b);

}  // namespace rubble
