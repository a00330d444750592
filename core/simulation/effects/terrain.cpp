#include "core/simulation/effects/terrain.h"

#include <cassert>

namespace rubble {

void setUpTerrain(std::shared_ptr<const TerrainGrid> terrain, const Scenario& scenario, WorldSettings& world) {
    assert(terrain);
    world.terrain = std::move(terrain);
    world.groundMaterial = scenario.effects.groundMaterial;
}

}  // namespace rubble
