#pragma once

#include "core/engine/world/rigid_world.h"

namespace rubble {

/// Bodies collide with each other: no two may share space (unilateral contact), with Coulomb friction |f_t| <= mu f_n and Newton's
/// restitution by pair of materials. Space that two share when one of them is born is kept as the rest offset of that pair and bled
/// off slowly (rigid_world.h). Off: no pair of bodies is ever looked for.
///
/// Limits: bodies are rigid and their shapes convex parts; hits lose energy by the coefficient alone.
void setUpFragmentContact(WorldSettings& world);

}  // namespace rubble
