#include "core/simulation/effects/effect_run.h"
#include "core/base/standard_gravity.h"
#include "core/engine/world/forwarding_world.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "core/simulation/run/collapse_run.h"
#include "tests/core/simulation/effects/run_scene.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

/// One heavy block of one element, 6 m above the ground, that dies at state 2.
std::shared_ptr<const FeResult> oneBlock() {
    scenes::Block block;
    block.name = "block";
    block.low = Vec3(0, 0, 6);
    block.gravity = standardGravity;
    block.deathState = [](std::size_t) { return std::size_t{2}; };
    return scenes::makeScene({block}, 6, 0.1);
}

std::shared_ptr<const TerrainGrid> slope() {
    std::vector<double> heights;
    for (int j = 0; j < 21; ++j) {
        for (int i = 0; i < 21; ++i) {
            heights.push_back(-0.1 * i);
        }
    }
    return std::make_shared<const TerrainGrid>(-10.0, -10.0, 1.0, 21, 21, heights);
}

Digest hashOf(const RunDescription& description) {
    MemoryTrajectory sink;
    return simulate(description, sink, Execution()).trajectoryHash;
}

/// Hash of a run with everything auto, and of one in which an effect is off by hand.
std::pair<Digest, Digest> hashes(std::shared_ptr<const FeResult> fe, EffectKind kind,
                                 std::shared_ptr<const TerrainGrid> terrain = {}) {
    Scenario scenario;
    scenario.simulation.settleTime = 2.0;
    RunDescription description = test::describe(std::move(fe), scenario);
    description.terrain = std::move(terrain);
    const EffectDecisions decisions = decideEffects({*description.fe, *description.components, *description.fragments,
                                                     *description.clustering, description.terrain.get(), scenario});
    EXPECT_FALSE(isOn(decisions, kind)) << effectName(kind);
    const Digest absent = hashOf(description);
    description.scenario.effects.of(kind) = EffectSwitch::Off;
    return {absent, hashOf(description)};
}

TEST(OffIsFree, ForEveryEffect) {
    for (const EffectKind kind : {EffectKind::Terrain, EffectKind::StructureContact, EffectKind::FragmentContact, EffectKind::Water,
                                  EffectKind::AirDrag, EffectKind::Ties, EffectKind::BreakUp}) {
        const auto [absent, off] = hashes(oneBlock(), kind);
        EXPECT_EQ(absent, off) << effectName(kind);
    }
    const auto [absent, off] = hashes(oneBlock(), EffectKind::Ground, slope());
    EXPECT_EQ(absent, off);
}

TEST(OffIsFree, AndOnIsNot) {
    Scenario scenario;
    scenario.simulation.settleTime = 1.0;
    scenario.effects.waterLevel = 1.0;
    scenario.components["wall"].reinforced = true;
    scenario.effects.breakUpSpeed = 0.5;
    scenario.effects.airDrag = 20.0;
    scenario.grid.length = scenario.grid.width = scenario.grid.height = 2.5;
    RunDescription description = test::describe(scenes::collapsingWall(6, 4), scenario);
    description.terrain = slope();
    for (std::size_t i = 0; i < effectCount; ++i) {
        description.scenario.effects.switches[i] = EffectSwitch::Off;
    }
    const Digest none = hashOf(description);
    description.scenario.effects.of(EffectKind::Ground) = EffectSwitch::On;
    const Digest ground = hashOf(description);
    EXPECT_NE(ground, none);
    // What falls freely side by side pulls at no tie, so each is tried on bodies that hit the ground.
    for (const EffectKind kind : {EffectKind::Terrain, EffectKind::StructureContact, EffectKind::FragmentContact, EffectKind::Water,
                                  EffectKind::AirDrag, EffectKind::Ties}) {
        description.scenario.effects.of(kind) = EffectSwitch::On;
        EXPECT_NE(hashOf(description), ground) << effectName(kind);
        description.scenario.effects.of(kind) = EffectSwitch::Off;
    }
}

/// Counts what is made.
class CountingWorld : public ForwardingWorld {
public:
    struct Counts {
        int hooks = 0;
        int pieces = 0;
        WorldSettings settings;
    };
    CountingWorld(std::unique_ptr<RigidWorld> world, Counts& counts) : ForwardingWorld(std::move(world)), m_counts(counts) {}

    PieceId addPiece(const CollisionShape& shape, const Pose& pose, Material material,
                     std::span<const std::uint32_t> nodes) override {
        ++m_counts.pieces;
        return ForwardingWorld::addPiece(shape, pose, material, nodes);
    }
    void onSubstep(SubstepHook hook) override {
        ++m_counts.hooks;
        ForwardingWorld::onSubstep(std::move(hook));
    }

private:
    Counts& m_counts;
};

CountingWorld::Counts countsOf(const Scenario& scenario) {
    CountingWorld::Counts counts;
    MemoryTrajectory sink;
    simulateIn(
        [&](const WorldSettings& settings) {
            counts.settings = settings;
            return std::make_unique<CountingWorld>(makeWorld(SolverKind::Bullet, settings), counts);
        },
        test::describe(scenes::collapsingWall(), scenario), sink, Execution());
    return counts;
}

TEST(OffIsFree, CreatesNothing) {
    Scenario scenario;
    scenario.simulation.settleTime = 0.5;
    for (std::size_t i = 0; i < effectCount; ++i) {
        scenario.effects.switches[i] = EffectSwitch::Off;
    }
    const CountingWorld::Counts none = countsOf(scenario);
    EXPECT_EQ(none.hooks, 0);
    EXPECT_EQ(none.pieces, 0);
    EXPECT_FALSE(none.settings.ground);
    EXPECT_FALSE(none.settings.bodyContacts);
    EXPECT_EQ(none.settings.terrain, nullptr);
    scenario.effects.of(EffectKind::BreakUp) = EffectSwitch::On;
    EXPECT_EQ(countsOf(scenario).hooks, 0) << "break-up looks at steps, not at substeps";
    scenario.effects.of(EffectKind::AirDrag) = EffectSwitch::On;
    EXPECT_EQ(countsOf(scenario).hooks, 1);
    scenario.effects.of(EffectKind::StructureContact) = EffectSwitch::On;
    EXPECT_GT(countsOf(scenario).pieces, 0);
}

TEST(EffectReports, ListEveryEffectWithItsShareOfTheStep) {
    Scenario scenario;
    scenario.simulation.settleTime = 1.0;
    scenario.effects.of(EffectKind::AirDrag) = EffectSwitch::On;
    scenario.effects.of(EffectKind::BreakUp) = EffectSwitch::Off;
    MemoryTrajectory sink;
    const SimulationResult result = simulate(test::describe(scenes::collapsingWall(), scenario), sink, Execution());
    ASSERT_EQ(result.effects.size(), effectCount);
    for (std::size_t i = 0; i < effectCount; ++i) {
        const EffectReport& report = result.effects[i];
        EXPECT_EQ(static_cast<std::size_t>(report.decision.kind), i);
        EXPECT_FALSE(report.decision.reason.pattern.empty());
        EXPECT_GE(report.msPerStep, 0.0);
        if (!report.decision.on) {
            EXPECT_EQ(report.msPerStep, 0.0);
            EXPECT_EQ(report.work, 0.0);
        }
    }
    const EffectReport& drag = result.effects[static_cast<std::size_t>(EffectKind::AirDrag)];
    EXPECT_GT(drag.msPerStep, 0.0);
    EXPECT_LT(drag.work, 0.0);
    EXPECT_NEAR(result.energy.effectWork, drag.work, 1e-9 * std::abs(drag.work));
}

// The step has a clock of its own: the account of effects and the rest makes it up within 5 %, whatever the solver.
TEST(EffectReports, TheAccountMakesUpTheMeasuredStep) {
    Scenario scenario;
    scenario.simulation.settleTime = 2.0;
    scenario.effects.waterLevel = 1.0;
    for (const EffectKind kind : {EffectKind::AirDrag, EffectKind::BreakUp, EffectKind::Water}) {
        scenario.effects.of(kind) = EffectSwitch::On;
    }
    for (const SolverKind solver : {SolverKind::SoftStep, SolverKind::Bullet}) {
        scenario.simulation.solver = solver;
        MemoryTrajectory sink;
        const SimulationResult result = simulate(test::describe(scenes::collapsingWall(12, 8), scenario), sink, Execution());
        const StepTimes& times = result.stepTimes;
        EXPECT_NEAR(accountedMs(result), times.allMs, 0.05 * times.allMs) << static_cast<int>(solver);
        for (const double part :
             {times.motionMs, times.hookMs, times.bookkeepingMs, times.healthMs, times.recordingMs, times.birthsMs}) {
            EXPECT_GE(part, 0.0);
        }
        EXPECT_GT(times.bookkeepingMs, 0.0);
        EXPECT_GT(times.healthMs, 0.0);
        EXPECT_GT(times.recordingMs, 0.0);
        EXPECT_GT(times.birthsMs, 0.0);
    }
}

/// Takes a while after each step and says nothing of it.
class SecretiveWorld : public ForwardingWorld {
public:
    using ForwardingWorld::ForwardingWorld;
    void step(double dt) override {
        ForwardingWorld::step(dt);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
};

TEST(EffectReports, TimeThatNobodyAccountsForShows) {
    Scenario scenario;
    scenario.simulation.settleTime = 0.1;
    MemoryTrajectory sink;
    const SimulationResult result = simulateIn(
        [](const WorldSettings& settings) { return std::make_unique<SecretiveWorld>(makeWorld(SolverKind::SoftStep, settings)); },
        test::describe(scenes::collapsingWall(), scenario), sink, Execution());
    EXPECT_GE(result.stepTimes.allMs, accountedMs(result) + 2.0);
    EXPECT_LT(accountError(result), 0.0);
}

TEST(EffectReports, EnergyAccountKnowsWater) {
    Scenario scenario;
    scenario.simulation.settleTime = 5.0;
    scenario.effects.waterLevel = 4.0;
    MemoryTrajectory sink;
    const SimulationResult result = simulate(test::describe(oneBlock(), scenario), sink, Execution());
    EXPECT_TRUE(result.effects[static_cast<std::size_t>(EffectKind::Water)].decision.on);
    // Water takes some three fifths of what gravity does, and none of it is a gain or a loss in contacts.
    EXPECT_LT(result.energy.effectWork, -0.3 * result.energy.gravityWork);
    EXPECT_LT(result.energy.drift, 1e-3);
}

}  // namespace
}  // namespace rubble
