#include "core/simulation/run/carried_islands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/standard_gravity.h"
#include "core/pipeline/pipeline.h"
#include "core/simulation/run/simulation.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

/// 6 x 4 x 1 m of 24 elements that falls through everything, as the FE analysis of a bare site has it.
scenes::Block fallingSlab(const Vec3& low) {
    scenes::Block block;
    block.name = "slab";
    block.low = low;
    block.size = Vec3(6, 4, 1);
    block.cells = {6, 4, 1};
    block.gravity = standardGravity;
    return block;
}

/// Dies at state 1, far from the rest: the run begins at the first state.
scenes::Block farDebris(const Vec3& low = Vec3(100, 0, 0)) {
    scenes::Block block;
    block.name = "debris";
    block.low = low;
    block.deathState = [](std::size_t) { return std::size_t{1}; };
    return block;
}

class CarriedIslandsRun : public testing::Test {
protected:
    Scenario scenario;
    MemoryTrajectory trajectory;
    std::shared_ptr<const TerrainGrid> terrain;

    void SetUp() override {
        scenario.simulation.settleTime = 4.0;
        scenario.effects.loose = LooseStructurePolicy::AtOnce;
        scenario.effects.of(EffectKind::AirDrag) = EffectSwitch::Off;
        scenario.fragments.birthWindow = 0.0;
    }
    SimulationResult simulateScene(std::shared_ptr<const FeResult> fe) {
        Inputs inputs;
        inputs.fe = std::move(fe);
        inputs.terrain = terrain;
        return *run(inputs, scenario, Stage::Simulation, {}, &trajectory, Execution()).simulation;
    }
    /// Bodies of islands, in the order in which they came.
    std::vector<BodyRecord> islandBodies() const {
        std::vector<BodyRecord> bodies = trajectory.bodies();
        std::erase_if(bodies, [](const BodyRecord& body) { return !body.isIsland(); });
        return bodies;
    }
    Vec3 placeAt(double time, BodyId body) const { return frameAtTime(trajectory, time).positions.at(at(body)).cast<double>(); }
};

TEST_F(CarriedIslandsRun, WhatDiesIsBornWhereTheEngineHasIt) {
    // The FE slab is at -25 m when its elements die one after the other, from 2.4 s on; the engine's lies on the ground from 1 s
    // on.
    scenes::Block falling = fallingSlab(Vec3(0, 0, 5));
    falling.deathState = [](std::size_t i) { return 25 + i; };
    const SimulationResult result = simulateScene(scenes::makeScene({falling, farDebris()}, 60, 0.1));
    EXPECT_EQ(result.carried.islands, 1);
    EXPECT_EQ(result.carried.elements, 24);
    EXPECT_NEAR(result.carried.mass, 24 * 2000.0, 1e-6);
    EXPECT_EQ(result.carried.bodies, 24) << "the slab, and what was left of it 23 times";
    EXPECT_EQ(result.carried.born, 24);
    EXPECT_NEAR(result.carried.bornMass, 24 * 2000.0, 1e-6);
    EXPECT_NEAR(result.carried.bornAtRestMass, 24 * 2000.0, 1e-6) << "it had come to rest before the first of them died";
    EXPECT_EQ(result.carried.bornSofterMass, 0.0) << "the FE result, in which it falls on, gives it no blow";
    EXPECT_EQ(result.carried.left, 0);
    EXPECT_EQ(result.births.occupied, 0) << "what is born from an island has its room";
    ASSERT_EQ(result.fragments.size(), 25u);
    for (const FragmentOutcome& fragment : result.fragments) {
        EXPECT_NEAR(fragment.finalPosition.z(), 0.5, 0.02);
        EXPECT_NEAR(fragment.birthPosition.z(), 0.5, 0.02);
    }
    EXPECT_TRUE(result.health.breaches.empty());
}

TEST_F(CarriedIslandsRun, MassAndMomentaCloseAtEveryStep) {
    scenes::Block falling = fallingSlab(Vec3(0, 0, 30));
    falling.velocity = Vec3(3, -2, 1);
    // A row in its middle dies in the air: two parts of two columns and of three.
    falling.deathState = [](std::size_t i) { return i % 6 == 2 ? std::size_t{6} : scenes::never; };
    const SimulationResult result = simulateScene(scenes::makeScene({falling, farDebris()}, 10, 0.1));
    EXPECT_EQ(result.carried.islands, 1);
    EXPECT_EQ(result.carried.bodies, 3);
    const std::vector<BodyRecord> bodies = islandBodies();
    ASSERT_EQ(bodies.size(), 3u);
    EXPECT_NEAR(bodies[0].to, 0.5, 1e-12) << "known when it comes";
    EXPECT_NEAR(bodies[1].from, 0.5, 1e-12);
    EXPECT_NEAR(bodies[1].mass, 8 * 2000.0, 1e-6);
    EXPECT_NEAR(bodies[2].mass, 12 * 2000.0, 1e-6);
    for (const LedgerErrors& errors : {result.carried.handOvers, result.carried.losses}) {
        for (const double error : {errors.mass, errors.momentum, errors.angularMomentum, errors.bodyMass, errors.bodyMomentum,
                                   errors.bodyAngularMomentum}) {
            EXPECT_LT(error, 1e-12);
        }
    }
    ASSERT_EQ(trajectory.islandLosses().size(), 1u);
    const IslandLoss loss = trajectory.islandLosses().front();
    // Closed form: 48 t at v0 - g t.
    const Vec3 momentum = 24 * 2000.0 * (Vec3(3, -2, 1) - Vec3(0, 0, standardGravity * 0.5));
    EXPECT_LT((loss.before.linear - momentum).norm(), 1e-9 * momentum.norm());
    EXPECT_LT((loss.born.linear + loss.left.linear - momentum).norm(), 1e-9 * momentum.norm());
    EXPECT_NEAR(loss.born.mass, 4 * 2000.0, 1e-6);
    EXPECT_NEAR(loss.born.kineticEnergy + loss.left.kineticEnergy, loss.before.kineticEnergy, 1e-9 * loss.before.kineticEnergy);
    // They part with one motion and fly on side by side; what touches something is integrated with an error of g h t / 2 in a step
    // of a 40th of a second in 8 parts.
    const auto apart = [&](double time) { return Vec3(placeAt(time, bodies[2].body) - placeAt(time, bodies[1].body)); };
    EXPECT_LT((apart(0.9) - apart(0.5)).norm(), 0.5 * standardGravity * 0.4 / 320.0);
}

TEST_F(CarriedIslandsRun, WithoutDebrisTheyAreWhereTheFeResultHasThem) {
    scenario.effects.of(EffectKind::FragmentContact) = EffectSwitch::Off;
    scenes::Block falling = fallingSlab(Vec3(0, 0, 60));
    falling.velocity = Vec3(2, 0, 0);
    falling.deathState = [](std::size_t i) { return 5 + i; };
    const auto fe = scenes::makeScene({falling, farDebris()}, 32, 0.1);
    const SimulationResult result = simulateScene(fe);
    ASSERT_EQ(result.carried.born, 24);
    for (const BodyRecord& body : islandBodies()) {
        const double t = body.from;
        EXPECT_NEAR(body.atBirth.position.z() - body.inFe.position.z(), -0.5 * standardGravity * t * t, 1e-3) << t;
        EXPECT_NEAR(body.atBirth.position.x() - body.inFe.position.x(), 2.0 * t, 1e-9) << t;
    }
}

TEST_F(CarriedIslandsRun, OneThatNeverDiesGoesOnWhenTheFeResultEnds) {
    const SimulationResult result = simulateScene(scenes::makeScene({fallingSlab(Vec3(0, 0, 20)), farDebris()}, 8, 0.1));
    EXPECT_EQ(result.carried.islands, 1);
    EXPECT_EQ(result.carried.left, 1);
    EXPECT_NEAR(result.carried.leftMass, 24 * 2000.0, 1e-6);
    EXPECT_EQ(result.carried.stillMoving, 0);
    EXPECT_EQ(result.islands.released, 0) << "it is carried already";
    EXPECT_EQ(result.findings.count("simulation.live_islands"), 0);
    ASSERT_EQ(trajectory.islands().size(), 1u);
    EXPECT_NEAR(placeAt(result.endTime, trajectory.islands().front().body).z(), 0.5, 0.02);
    EXPECT_TRUE(std::isinf(islandBodies().front().to));
}

TEST_F(CarriedIslandsRun, LandOnDebrisThatTheFeResultDoesNotKnow) {
    // 10,000 times as heavy as what it falls on.
    scenes::Block under = farDebris(Vec3(2, 1, 0));
    under.density = 48.0;
    scenes::Block falling = fallingSlab(Vec3(0, 0, 4));
    falling.density = 20000.0;
    falling.deathState = [](std::size_t) { return std::size_t{40}; };
    const SimulationResult result = simulateScene(scenes::makeScene({under, falling}, 50, 0.1));
    ASSERT_EQ(result.carried.islands, 1);
    EXPECT_EQ(result.carried.born, 24);
    EXPECT_EQ(result.health.bodiesLost, 0);
    EXPECT_LT(result.maxSpeed, 1.05 * std::sqrt(2.0 * standardGravity * 4.0)) << "nothing is shot out";
    for (const FragmentOutcome& fragment : result.fragments) {
        EXPECT_GT(fragment.finalPosition.z(), 0.3) << "on the ground, not in it";
        EXPECT_LT(fragment.finalPosition.z(), 2.5);
    }
}

TEST_F(CarriedIslandsRun, AllOfTheStructureMayBeLoose) {
    scenes::Block falling = fallingSlab(Vec3(0, 0, 10));
    falling.deathState = [](std::size_t i) { return i < 2 ? std::size_t{1} : scenes::never; };
    const SimulationResult result = simulateScene(scenes::makeScene({falling}, 12, 0.1));
    EXPECT_EQ(result.carried.islands, 1);
    EXPECT_EQ(result.carried.elements, 22) << "two had died before";
    EXPECT_EQ(result.carried.left, 1);
    EXPECT_EQ(result.carried.stillMoving, 0);
}

TEST_F(CarriedIslandsRun, FloatAndSlideAsBodiesDo) {
    scenario.effects.waterLevel = 3.0;
    scenario.effects.of(EffectKind::Water) = EffectSwitch::On;
    scenario.simulation.settleTime = 15.0;
    scenes::Block falling = fallingSlab(Vec3(0, 0, 4));
    falling.density = 500.0;
    const SimulationResult result = simulateScene(scenes::makeScene({falling, farDebris()}, 6, 0.1));
    ASSERT_EQ(result.carried.left, 1);
    // Half of it is under water.
    EXPECT_NEAR(placeAt(result.endTime, trajectory.islands().front().body).z(), 3.0, 0.1);
}

TEST_F(CarriedIslandsRun, LieOnASlopeWhereTheFeResultHasNone) {
    std::vector<double> heights;
    for (int j = 0; j < 41; ++j) {
        for (int i = 0; i < 41; ++i) {
            heights.push_back(0.2 * (i - 20));
        }
    }
    terrain = std::make_shared<const TerrainGrid>(-20.0, -20.0, 1.0, 41, 41, heights);
    scenes::Block falling = fallingSlab(Vec3(0, 0, 3));
    falling.deathState = [](std::size_t i) { return 25 + i % 3; };
    const SimulationResult result = simulateScene(scenes::makeScene({falling, farDebris(Vec3(15, 15, 4))}, 30, 0.1));
    ASSERT_EQ(result.carried.islands, 1);
    for (const FragmentOutcome& fragment : result.fragments) {
        const Vec3& end = fragment.finalPosition;
        EXPECT_GT(end.z(), 0.2 * end.x() + 0.3) << "above the slope";
        EXPECT_LT(end.z(), 0.2 * end.x() + 2.0);
    }
}

TEST_F(CarriedIslandsRun, RepeatBitByBitOnAnyNumberOfThreads) {
    const auto fe = scenes::collapsingWall(6, 4);
    const SimulationResult first = simulateScene(fe);
    EXPECT_GT(first.carried.islands, 0);
    Inputs inputs;
    inputs.fe = fe;
    const auto again = run(inputs, scenario, Stage::Simulation, {}, &trajectory, Execution().withThreads(3));
    EXPECT_EQ(again.simulation->trajectoryHash, first.trajectoryHash);
}

/// A row of cubes on the ground, of which some die where they stand.
std::shared_ptr<const FeResult> standingRow() {
    scenes::Block row;
    row.name = "row";
    row.size = Vec3(6, 1, 1);
    row.cells = {6, 1, 1};
    row.deathState = [](std::size_t i) { return i % 2 == 0 ? std::size_t{2} : scenes::never; };
    return scenes::makeScene({row}, 6, 0.1);
}

TEST_F(CarriedIslandsRun, WhereNothingComesLooseARunIsAsByTheFeResult) {
    const auto fe = standingRow();
    const SimulationResult asked = simulateScene(fe);
    EXPECT_EQ(asked.carried.islands, 0);
    scenario.effects.loose = LooseStructurePolicy::Fe;
    MemoryTrajectory other;
    Inputs inputs;
    inputs.fe = fe;
    const auto byFe = run(inputs, scenario, Stage::Simulation, {}, &other, Execution());
    EXPECT_EQ(asked.trajectoryHash, byFe.simulation->trajectoryHash);
    EXPECT_EQ(asked.steps, byFe.simulation->steps);
}

TEST_F(CarriedIslandsRun, HeldIsSaidNotToHoldThem) {
    scenario.effects.islands = LiveIslandPolicy::Held;
    const auto fe = scenes::makeScene({fallingSlab(Vec3(0, 0, 20)), farDebris()}, 8, 0.1);
    const SimulationResult carried = simulateScene(fe);
    EXPECT_EQ(carried.carried.left, 1) << "it is not held";
    EXPECT_EQ(carried.findings.count("effect.not_held"), 1);
    EXPECT_FALSE(carried.findings.list().front().remedy.empty());
    EXPECT_EQ(simulateScene(standingRow()).findings.count("effect.not_held"), 0) << "nothing comes loose";
    scenario.effects.loose = LooseStructurePolicy::Fe;
    EXPECT_EQ(simulateScene(fe).findings.count("effect.not_held"), 0);
    scenario.effects.loose = LooseStructurePolicy::AtOnce;
    scenario.effects.islands = LiveIslandPolicy::Released;
    EXPECT_EQ(simulateScene(fe).findings.count("effect.not_held"), 0);
}

TEST_F(CarriedIslandsRun, ByTheFeResultNothingIsCarried) {
    scenario.effects.loose = LooseStructurePolicy::Fe;
    scenes::Block falling = fallingSlab(Vec3(0, 0, 5));
    falling.deathState = [](std::size_t i) { return 5 + i; };
    const SimulationResult result = simulateScene(scenes::makeScene({falling, farDebris()}, 40, 0.1));
    EXPECT_EQ(result.carried.islands, 0);
    EXPECT_EQ(result.carried.bodies, 0);
    EXPECT_TRUE(trajectory.islandLosses().empty());
}

}  // namespace
}  // namespace rubble
