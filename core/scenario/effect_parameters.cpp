#include "core/scenario/parameter_rows.h"

namespace rubble {

namespace {

template <EffectKind kind>
constexpr auto effectSwitch = [](auto& s) -> decltype(auto) { return s.effects.of(kind); };

void addSwitches(ParameterRows& table) {
    const std::vector<std::string_view> states{"off", "on", "auto"};
    table
        .choice("ground", states, effectSwitch<EffectKind::Ground>, "Ground",
                "A level ground that carries the debris. auto: on unless terrain covers the site.")
        .choice("terrain", states, effectSwitch<EffectKind::Terrain>, "Terrain",
                "The terrain of the case carries the debris. auto: on if the case has one and debris can reach it.")
        .choice("structure_contact", states, effectSwitch<EffectKind::StructureContact>, "Contact with the structure",
                "Fragments hit the structure that still stands or falls. auto: on if any of it lies within the reach of a fragment "
                "while it is active. Costs the most where the structure is large.")
        .choice("fragment_contact", states, effectSwitch<EffectKind::FragmentContact>, "Contact of fragments",
                "Fragments hit each other. auto: on unless no two can meet. Most of the cost of a pile.")
        .choice("water", states, effectSwitch<EffectKind::Water>, "Water",
                "Buoyancy, drag, current and added mass below the level of the water. auto: on if a level is given and a body can "
                "reach it.")
        .choice("air_drag", states, effectSwitch<EffectKind::AirDrag>, "Air drag",
                "Resistance of the air. auto: on if weight is less than 17 times the drag at the highest possible speed of some "
                "body, which is 1 % of its travel.")
        .choice(
            "ties", states, effectSwitch<EffectKind::Ties>, "Reinforcement ties",
            "Steel between neighbouring clusters of reinforced components, until it breaks. auto: on if such a component has two "
            "or more clusters.")
        .choice("break_up", states, effectSwitch<EffectKind::BreakUp>, "Break-up",
                "A cluster of stone or masonry falls apart into its fragments on a hard hit. auto: on if one can be hit that hard "
                "and the bodies so freed stay within bodies_max.");
}

void addTerrainRoughness(ParameterRows& table) {
    table
        .number("terrain_roughness", "m", 0, 10, RUBBLE_AT(effects.terrainRoughness), "Roughness of the terrain",
                "Mean height of obstacles that the raster of the terrain is too coarse to hold: stones, tufts, ruts; what "
                "Rockyfor3D calls "
                "the mean obstacle height (Dorren 2016). Bumps and hollows are drawn at random on a lattice. 0: as smooth as the "
                "raster.")
        .number("terrain_roughness_spacing", "m", 0.01, 1000, RUBBLE_AT(effects.roughnessSpacing), "Spacing of the roughness",
                "Distance of neighbouring bumps and hollows, beyond which they are independent of each other.")
        .integer("terrain_roughness_seed", 0, 2147483647, RUBBLE_AT(effects.roughnessSeed), "Seed of the roughness",
                 "Another seed gives other bumps and hollows of the same height and spacing. Repeats count on from it.");
}

void addWaterAndAir(ParameterRows& table) {
    table
        .number("water_level", "m", -1e6, 1e6, RUBBLE_AT(effects.waterLevel), "Level of the water",
                "z of the still surface. Automatic: there is no water.")
        .number("water_density", "kg/m3", 1, 20000, RUBBLE_AT(effects.waterDensity), "Density of the water",
                "Buoyancy, drag and added mass are proportional to it.")
        .number("water_current_x", "m/s", -100, 100, RUBBLE_AT(effects.currentX), "Current along x", "Velocity of the water.")
        .number("water_current_y", "m/s", -100, 100, RUBBLE_AT(effects.currentY), "Current along y", "Velocity of the water.")
        .number("water_drag", "", 0, 10, RUBBLE_AT(effects.waterDrag), "Drag in water",
                "Coefficient of drag of a box in water, with its projected area.")
        .number("water_linear_drag", "1/s", 0, 1000, RUBBLE_AT(effects.waterLinearDrag), "Linear drag in water",
                "Drag proportional to speed, on the mass of the displaced water: brings floating bodies to rest.")
        .number("water_added_mass", "", 0, 2, RUBBLE_AT(effects.addedMass), "Added mass",
                "Share of the displaced water that has to be accelerated with a body: 0.5 for a sphere, about 0.7 for a cube.")
        .number("air_density", "kg/m3", 0, 10, RUBBLE_AT(effects.airDensity), "Density of the air", "At sea level and 15 °C 1.225.")
        .number("air_drag_coefficient", "", 0, 10, RUBBLE_AT(effects.airDrag), "Drag in air",
                "Coefficient of drag of a box in air, with its projected area: 1.05 for a cube.");
}

void addSteelAndStone(ParameterRows& table) {
    table
        .number("tie_ratio", "", 0, 1, RUBBLE_AT(effects.tieRatio), "Steel ratio",
                "Area of steel over the area of the face that two clusters of a reinforced component share.")
        .number("tie_strength", "Pa", 0, 1e10, RUBBLE_AT(effects.tieStrength), "Strength of the steel",
                "Stress at which a tie yields; its force never passes stress times area.")
        .number("tie_elongation", "", 0, 10, RUBBLE_AT(effects.tieElongation), "Elongation at break",
                "Share of its length by which a tie stretches before it breaks.")
        .number("break_up_speed", "m/s", 0, 1000, RUBBLE_AT(effects.breakUpSpeed), "Break-up speed",
                "Impulse over mass of a hit above which a cluster of stone or masonry falls apart. An assumption.")
        .choice("live_islands", {"released", "held"}, RUBBLE_AT(effects.islands), "Fallen live structure",
                "Parts alive at the end of the FE result without a path to a support, which the engine does not carry yet "
                "(loose_structure). released: they go on as rigid bodies. held: they stay where they are.")
        .choice("loose_structure", {"fe", "at_once"}, RUBBLE_AT(effects.loose), "Loose structure",
                "Who moves live structure without a path to a support. at_once: the engine, from when it comes loose; what the FE "
                "result kills is born where the engine has it. fe: the FE result, until its elements die or it ends; quicker, but "
                "debris is born inside debris.");
}

void addMaterials(ParameterRows& table) {
    std::vector<std::string_view> materials;
    for (std::size_t i = 0; i < materialCount; ++i) {
        materials.push_back(materialName(static_cast<Material>(i)));
    }
    table
        .choice("ground_material", materials, RUBBLE_AT(effects.groundMaterial), "Ground is made of",
                "Material of ground and terrain: decides friction and restitution of hits on it.")
        .pair(
            "pair[*].friction", 10.0, &PairProperties::friction, "Friction",
            "Coulomb coefficient of two materials, such as pair[stone,soil].friction. Automatic: the sourced table in the manual.")
        .pair("pair[*].restitution", 1.0, &PairProperties::restitution, "Restitution",
              "Normal restitution of two materials. Automatic: the sourced table in the manual.");
}

}  // namespace

std::vector<Parameter> effectRows() {
    ParameterRows table(Stage::Simulation);
    addSwitches(table);
    addTerrainRoughness(table);
    addWaterAndAir(table);
    addSteelAndStone(table);
    addMaterials(table);
    return std::move(table.rows);
}

}  // namespace rubble
