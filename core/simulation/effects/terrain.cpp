#include "core/simulation/effects/terrain.h"

#include <cassert>

namespace rubble {

std::shared_ptr<const TerrainGrid> roughTerrain(std::shared_ptr<const TerrainGrid> terrain, const EffectSettings& effects) {
    if (!terrain || !(effects.terrainRoughness > 0.0)) {
        return terrain;
    }
    return std::make_shared<const TerrainGrid>(terrain->roughened(
        {effects.terrainRoughness, effects.roughnessSpacing, static_cast<std::uint64_t>(effects.roughnessSeed)}));
}

void setUpTerrain(std::shared_ptr<const TerrainGrid> terrain, const Scenario& scenario, WorldSettings& world) {
    assert(terrain);
    world.terrain = roughTerrain(std::move(terrain), scenario.effects);
    world.groundMaterial = scenario.effects.groundMaterial;
}

}  // namespace rubble
