#pragma once

#include "core/engine/world/collider.h"
#include "core/engine/world/sleep.h"
#include "core/fe/site_surface.h"

namespace rubble {

/// Rules of the scene that hold whichever engine steps it: what a contact tells of its two bodies, how far a piece may go, and what
/// lies below ground. Any number of threads may note what contacts tell.

/// How deep a newborn lies in what is older than it, m, and in what of that it was not joined to.
void noteBirthDepth(Collider& a, Collider& b, double depth);
/// Overlap at birth that two bodies still have, m.
void noteOverlapLeft(Collider& a, Collider& b, double offset, const Sleep& sleep);
/// How deep two solids are in each other beyond their rest offset, m.
void notePenetration(Collider& a, Collider& b, double depth, const Sleep& sleep, ContactReport& report);

/// How a moving piece acts on a body that it touches.
struct PieceAction {
    bool yielding = false;  ///< it has given way and goes on into the body
    bool pressing = false;  ///< it strikes from above or from the side
};
/// @param approach  m/s, of the piece towards the body
/// @param up        upward part of the normal from the piece to the body
/// @param gaveWay   it has given way to this body before
PieceAction pieceAction(double approach, double up, bool gaveWay);
/// m/s by which a pressing piece may still change the speed of its body. @param pressed  m/s, by which it has
double pressLeft(double pressed);
/// A piece pressed by so much [m/s] more; true when it gives way for that.
bool givesWayToPress(double& pressed, double speed);
/// A carrying piece pushed; true when it gives way for having left much of the closing speed too often in a row.
/// @param pushes    such pushes in a row, this one included where it was in vain
bool givesWayToPushes(int pushes);
/// Whether a push that left a closing speed of `left` [m/s] was in vain.
bool inVain(double left, double approach);

/// How a centre that lies below ground comes up again. It has been squeezed there; contact alone may not bring it back from under a
/// pile.
struct GroundRise {
    Vec3 way = Vec3::Zero();  ///< m, to the surface
    double share = 1.0;       ///< of it that is gone in this step
    Vec3 normal = Vec3::UnitZ();
};
/// @param centre     m, below ground
/// @param bornBelow  it comes up at a bounded speed
GroundRise riseAboveGround(const SiteSurface& surface, const Vec3& centre, bool bornBelow, double dt);

}  // namespace rubble
