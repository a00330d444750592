#pragma once

#include <memory>

#include "core/engine/world/rigid_world.h"
#include "core/fe/terrain_grid.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// @param terrain  null: none
/// Returns it with the roughness of the settings on top, itself where that is zero.
std::shared_ptr<const TerrainGrid> roughTerrain(std::shared_ptr<const TerrainGrid> terrain, const EffectSettings& effects);

/// Ground of given heights: everything below the surface z = f(x, y) of the grid is solid and immovable, of the ground's material,
/// level beyond its edges (terrain_grid.h). Contact as with the level ground, along the normal of the triangle below each point.
///
/// Limits: one height for each place, so no overhangs; what is finer than its cells is there as roughness only, which corners of
/// bodies meet and faces do not; rigid, nothing digs in.
/// @param terrain  not null
void setUpTerrain(std::shared_ptr<const TerrainGrid> terrain, const Scenario& scenario, WorldSettings& world);

}  // namespace rubble
