#pragma once

#include "core/engine/world/rigid_world.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// Level ground: the half space below z = ground_height is solid and immovable, of the ground's material. Contact is unilateral (no
/// pull), with Coulomb friction and Newton's restitution of the pair of materials (materials.h names their sources).
///
/// Limits: rigid, so that nothing digs in or leaves a crater; no end. Where there is a terrain, that takes its place.
void setUpGroundPlane(const Scenario& scenario, WorldSettings& world);

}  // namespace rubble
