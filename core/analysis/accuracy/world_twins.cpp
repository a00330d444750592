#include "core/analysis/accuracy/world_twins.h"

#include "core/scenario/parameters.h"
#include "core/simulation/effects/decisions.h"
#include "core/simulation/effects/effect_run.h"

namespace rubble {

namespace {

/// The scenario with what its simulation never looks at as by default.
Scenario readPart(const Scenario& scenario, const EffectDecisions& decisions) {
    const Scenario defaults;
    Scenario read = scenario;
    // The grid is in the clusters; but for the room that breaking up has, and the rate that live FPS are paced by.
    read.grid = defaults.grid;
    read.grid.fpsTarget = scenario.grid.fpsTarget;
    if (isOn(decisions, EffectKind::BreakUp)) {
        read.grid.bodiesMax = scenario.grid.bodiesMax;
    } else {
        read.effects.breakUpSpeed = defaults.effects.breakUpSpeed;
    }
    for (const EffectDecision& decision : decisions) {
        read.effects.of(decision.kind) = decision.on ? EffectSwitch::On : EffectSwitch::Off;
    }
    SimulationSettings& simulation = read.simulation;
    if (simulation.solver == SolverKind::SoftStep) {
        simulation.iterations = defaults.simulation.iterations;
    } else {
        simulation.substeps = defaults.simulation.substeps;
        simulation.overlapTime = defaults.simulation.overlapTime;
        simulation.bounceFriction = defaults.simulation.bounceFriction;
    }
    if (!isOn(decisions, EffectKind::StructureContact)) {
        simulation.pieces = defaults.simulation.pieces;
    }
    if (simulation.pieces != PieceKind::GridBoxes || !isOn(decisions, EffectKind::StructureContact)) {
        simulation.pieceSize = defaults.simulation.pieceSize;
    }
    if (!isOn(decisions, EffectKind::Terrain) || !(read.effects.terrainRoughness > 0.0)) {
        read.effects.terrainRoughness = defaults.effects.terrainRoughness;
        read.effects.roughnessSpacing = defaults.effects.roughnessSpacing;
        read.effects.roughnessSeed = defaults.effects.roughnessSeed;
    }
    if (!simulation.freeze) {
        simulation.freezeSpeed = defaults.simulation.freezeSpeed;
        simulation.freezeDelay = defaults.simulation.freezeDelay;
    }
    if (!isOn(decisions, EffectKind::Water)) {
        read.effects.waterDensity = defaults.effects.waterDensity;
        read.effects.waterDrag = defaults.effects.waterDrag;
        read.effects.waterLinearDrag = defaults.effects.waterLinearDrag;
        read.effects.addedMass = defaults.effects.addedMass;
    }
    if (!isOn(decisions, EffectKind::AirDrag)) {
        read.effects.airDensity = defaults.effects.airDensity;
        read.effects.airDrag = defaults.effects.airDrag;
    }
    if (!isOn(decisions, EffectKind::Ties)) {
        read.effects.tieRatio = defaults.effects.tieRatio;
        read.effects.tieStrength = defaults.effects.tieStrength;
        read.effects.tieElongation = defaults.effects.tieElongation;
    }
    return read;
}

}  // namespace

Digest worldBits(const Inputs& inputs, const Scenario& scenario, const Results& results) {
    const Clustering& clustering = *results.clustering;
    const Scenario read = readPart(
        scenario, decideEffects({*inputs.fe, *results.components, *results.fragments, clustering, inputs.terrain.get(), scenario}));
    Hasher hasher;
    hasher.values(std::span<const FragmentId>(clustering.members));
    for (const Cluster& cluster : clustering.list) {
        hasher.value(cluster.memberCount).value(cluster.handOverState);
    }
    for (int stage = 0; stage < stageCount; ++stage) {
        hasher.digest(scenarioSlice(read, static_cast<Stage>(stage)));
    }
    return hasher.finish();
}

}  // namespace rubble
