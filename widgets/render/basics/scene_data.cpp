#include "widgets/render/basics/scene_data.h"

namespace rubble::render {

void SceneData::setSurroundings(const Scenario& scenario, std::shared_ptr<const TerrainGrid> theTerrain,
                                const SimulationResult* outcome) {
    const auto shown = [&](EffectKind kind) {
        const auto i = static_cast<std::size_t>(kind);
        if (outcome != nullptr && i < outcome->effects.size()) {
            return outcome->effects[i].decision.on;
        }
        return scenario.effects.of(kind) != EffectSwitch::Off;
    };
    givenMaterials.clear();
    for (const auto& [name, settings] : scenario.components) {
        if (settings.material) {
            givenMaterials.insert(name);
        }
    }
    groundHeight = scenario.simulation.groundHeight;
    terrain = shown(EffectKind::Terrain) ? std::move(theTerrain) : nullptr;
    waterLevel = shown(EffectKind::Water) ? scenario.effects.waterLevel : std::nullopt;
}

}  // namespace rubble::render
