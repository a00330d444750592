#include "core/simulation/run/islands.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/pipeline/pipeline.h"
#include "core/simulation/run/simulation.h"
#include "tests/core/fragments/element_scene.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

scenes::Block slab(const std::string& name, const Vec3& low) {
    scenes::Block block;
    block.name = name;
    block.low = low;
    block.size = Vec3(6, 4, 1);
    block.cells = {6, 4, 1};
    block.gravity = standardGravity;
    return block;
}

/// Stands on the ground; nothing moves it.
scenes::Block pier(const Vec3& low, double height) {
    scenes::Block block;
    block.name = "pier";
    block.low = low;
    block.size = Vec3(4, 4, height);
    block.cells = {2, 2, 4};
    return block;
}

/// Dies at state 2, far from the rest.
scenes::Block debris() {
    scenes::Block block;
    block.name = "debris";
    block.low = Vec3(100, 0, 3);
    block.deathState = [](std::size_t) { return std::size_t{2}; };
    return block;
}

class ReleasedIslands : public testing::Test {
protected:
    Scenario scenario;
    MemoryTrajectory trajectory;

    void SetUp() override {
        scenario.simulation.settleTime = 6.0;
        // The FE result moves what is loose until it ends; islands that the engine moves earlier: carried_islands_test.cpp.
        scenario.effects.loose = LooseStructurePolicy::Fe;
    }
    SimulationResult simulateScene(std::shared_ptr<const FeResult> fe) {
        return *run({std::move(fe), {}}, scenario, Stage::Simulation, {}, &trajectory, Execution()).simulation;
    }
    /// m, height of the centre of a body at a time.
    double heightAt(double time, std::size_t body) const {
        const TrajectoryFrame frame = frameAtTime(trajectory, time);
        return body < frame.bodies() ? static_cast<double>(frame.positions[body].z()) : std::nan("");
    }
    std::size_t bodyOf(std::size_t island) const { return at(trajectory.islands().at(island).body); }
};

TEST_F(ReleasedIslands, ASlabInTheAirGoesOnFalling) {
    const SimulationResult result = simulateScene(scenes::makeScene({slab("slab", Vec3(0, 0, 20)), debris()}, 8, 0.1));
    ASSERT_EQ(result.islands.released, 1);
    EXPECT_EQ(result.islands.held(), 0);
    EXPECT_EQ(result.islands.releasedElements, 24);
    EXPECT_NEAR(result.islands.releasedMass, 24 * 2000.0, 1e-6);
    ASSERT_EQ(trajectory.islands().size(), 1u);
    EXPECT_EQ(trajectory.islands().front().elements.size(), 24u);
    const BodyRecord record = trajectory.bodies()[bodyOf(0)];
    EXPECT_TRUE(record.isIsland());
    EXPECT_NEAR(record.from, 0.7, 1e-12);
    // It reaches the ground sqrt(2 h / g) after the first state, and stays on its parabola until then. PHYSICS section 4 asks for
    // 1e-3 m of free fall; frames hold positions in single precision, 2e-6 m at 20 m.
    const double landing = std::sqrt(2.0 * 20.0 / standardGravity);
    for (std::size_t i = 0; i < trajectory.frameCount(); ++i) {
        const double t = trajectory.frameTime(i);
        const auto frame = trajectory.frame(i);
        if (t >= 0.7 && t < landing - 0.02) {
            EXPECT_NEAR(frame->positions[bodyOf(0)].z(), 20.5 - 0.5 * standardGravity * t * t, 1e-3) << t;
        } else if (t >= landing + 0.1) {
            EXPECT_LT(frame->positions[bodyOf(0)].z(), 0.8) << t;
        } else if (t < 0.7) {
            EXPECT_LE(frame->bodies(), 1u) << "before the FE end it is structure";
        }
    }
    EXPECT_NEAR(heightAt(result.endTime, bodyOf(0)), 0.5, 0.05);
    EXPECT_EQ(result.islands.stillMoving, 0);
    EXPECT_LT(result.energy.drift, 1e-3);
    EXPECT_EQ(result.findings.count("simulation.live_islands"), 0);
}

TEST_F(ReleasedIslands, FallWithTheStockSolverToo) {
    scenario.simulation.solver = SolverKind::Bullet;
    const SimulationResult result = simulateScene(scenes::makeScene({slab("slab", Vec3(0, 0, 20)), debris()}, 8, 0.1));
    ASSERT_EQ(result.islands.released, 1);
    // A step of Euler's is off by g t dt / 2 at most.
    EXPECT_NEAR(heightAt(1.5, bodyOf(0)), 20.5 - 0.5 * standardGravity * 1.5 * 1.5, 0.5 * standardGravity * 0.8 / 60.0);
    EXPECT_NEAR(heightAt(result.endTime, bodyOf(0)), 0.5, 0.05);
}

TEST_F(ReleasedIslands, HangsWhenHeld) {
    const auto fe = scenes::makeScene({slab("slab", Vec3(0, 0, 20)), debris()}, 8, 0.1);
    scenario.effects.islands = LiveIslandPolicy::Held;
    const SimulationResult result = simulateScene(fe);
    EXPECT_EQ(result.islands.islands, 1);
    EXPECT_EQ(result.islands.released, 0);
    EXPECT_EQ(result.islands.held(), 1);
    EXPECT_EQ(result.findings.count("simulation.live_islands"), 1);
    EXPECT_TRUE(trajectory.islands().empty());
    EXPECT_EQ(trajectory.bodies().size(), 1u);
}

TEST_F(ReleasedIslands, CloseTheLedger) {
    scenes::Block thrown = slab("thrown", Vec3(30, 0, 25));
    thrown.velocity = Vec3(3, -2, 1);
    const SimulationResult result =
        simulateScene(scenes::makeScene({slab("slab", Vec3(0, 0, 20)), thrown, pier(Vec3(-10, 0, 0), 8), debris()}, 8, 0.1));
    EXPECT_EQ(result.islands.islands, 2) << "the pier stands";
    ASSERT_EQ(result.islands.released, 2);
    const LedgerRow row = trajectory.islandLedger().front();
    EXPECT_NEAR(row.time, 0.7, 1e-12);
    // Closed form: two slabs of 24 x 2000 kg at v0 - g t.
    const double mass = 24 * 2000.0;
    const Vec3 momentum = mass * (Vec3(3, -2, 1) + 2.0 * Vec3(0, 0, -standardGravity * 0.7));
    EXPECT_NEAR(row.bodies.mass, 2 * mass, 1e-9 * mass);
    EXPECT_LT((row.bodies.linear - momentum).norm(), 1e-9 * momentum.norm());
    // Sums over 48 elements of quadratures of rounding 1e-16 each.
    for (const double error :
         {result.islands.ledger.mass, result.islands.ledger.momentum, result.islands.ledger.angularMomentum,
          result.islands.ledger.bodyMass, result.islands.ledger.bodyMomentum, result.islands.ledger.bodyAngularMomentum}) {
        EXPECT_LT(error, 1e-12);
    }
    EXPECT_NEAR(result.islands.droppedKineticEnergy, 0.0, 1e-6 * row.fe.kineticEnergy) << "they move rigidly";
    // The ledger of the fragments knows nothing of them but in the sum over all bodies.
    Momenta fragments;
    for (const LedgerRow& entry : trajectory.ledger()) {
        fragments += entry.bodies;
    }
    EXPECT_NEAR(fragments.mass, 2000.0, 1e-6);
    EXPECT_NEAR(trajectory.ledger().back().all.mass, 2000.0 + 2 * mass, 1e-6);
    EXPECT_NEAR(result.energy.kineticIn, fragments.kineticEnergy + row.bodies.kineticEnergy, 1e-9 * result.energy.kineticIn);
}

TEST_F(ReleasedIslands, AreCountedApartFromBodiesOfFragments) {
    const SimulationResult result = simulateScene(scenes::makeScene({slab("slab", Vec3(0, 0, 20)), debris()}, 8, 0.1));
    EXPECT_EQ(result.bodiesPeak, 1);
    EXPECT_EQ(result.births.births, 1);
    EXPECT_EQ(result.fragments.size(), 1u);
    EXPECT_EQ(result.asleepAtEnd, 1.0);
    // The lone fragment sleeps long before the slab lands, and the run goes on until that sleeps as well.
    EXPECT_GT(result.endTime, std::sqrt(2.0 * 20.0 / standardGravity));
    EXPECT_EQ(trajectory.carriers().size(), 1u);
}

TEST_F(ReleasedIslands, StillMoveWhereTheTimeIsTooShort) {
    scenario.simulation.settleTime = 1.0;
    const SimulationResult result = simulateScene(scenes::makeScene({slab("slab", Vec3(0, 0, 200)), debris()}, 8, 0.1));
    EXPECT_NEAR(result.endTime, 1.7, 1e-9);
    EXPECT_EQ(result.islands.stillMoving, 1);
}

TEST_F(ReleasedIslands, ComeToRestOnWhatIsLeftOfTheirOwnPieces) {
    // Pier and slab are one component in one cell of the pieces: only the slab's share of the piece goes.
    scenes::Block above = slab("slab", Vec3(-1, 0, 10));
    scenario.regrouping.push_back(MergeComponents{{"pier", "slab"}, "bridge"});
    scenario.simulation.pieceSize = 40.0;
    const SimulationResult result = simulateScene(scenes::makeScene({pier(Vec3(0, 0, 0), 6), above, debris()}, 4, 0.1));
    ASSERT_EQ(result.islands.released, 1);
    EXPECT_NEAR(heightAt(result.endTime, bodyOf(0)), 6.5, 0.05);
}

TEST_F(ReleasedIslands, FallWhereNoFragmentEverWas) {
    const SimulationResult result =
        simulateScene(scenes::makeScene({slab("slab", Vec3(0, 0, 5)), pier(Vec3(20, 0, 0), 6)}, 4, 0.1));
    EXPECT_EQ(result.bodiesPeak, 0);
    ASSERT_EQ(result.islands.released, 1);
    EXPECT_NEAR(result.firstTime, 0.3, 1e-12);
    EXPECT_NEAR(trajectory.frameTime(0), 0.3, 1e-12);
    EXPECT_NEAR(heightAt(result.endTime, bodyOf(0)), 0.5, 0.05);
    EXPECT_EQ(result.asleepAtEnd, 1.0);
}

TEST_F(ReleasedIslands, NothingLooseNothingReleased) {
    const auto fe = scenes::makeScene({pier(Vec3(0, 0, 0), 6), debris()}, 4, 0.1);
    const Digest released = simulateScene(fe).trajectoryHash;
    EXPECT_TRUE(trajectory.islands().empty());
    scenario.effects.islands = LiveIslandPolicy::Held;
    EXPECT_EQ(simulateScene(fe).trajectoryHash, released) << "the setting alone changes no bit";
    // And with nothing that dies there is no run at all.
    const SimulationResult empty = simulateScene(scenes::makeScene({pier(Vec3(0, 0, 0), 6)}, 4, 0.1));
    EXPECT_EQ(empty.steps, 0);
    EXPECT_EQ(trajectory.frameCount(), 0u);
}

TEST_F(ReleasedIslands, LandOnDebrisThatLiesThere) {
    // The FE slab has sunk into a block that died under it: overlap at birth, resolved without a launch.
    scenes::Block under;
    under.name = "under";
    under.low = Vec3(1, 1, 0);
    under.size = Vec3(2, 2, 1);
    under.deathState = [](std::size_t) { return std::size_t{2}; };
    scenes::Block low = slab("slab", Vec3(0, 0, 0.5 * standardGravity * 0.49 + 0.6));
    const SimulationResult result = simulateScene(scenes::makeScene({under, low}, 8, 0.1));
    ASSERT_EQ(result.islands.released, 1);
    EXPECT_EQ(result.islands.occupied, 1);
    EXPECT_GT(result.energy.dissipated, 0.0);
    EXPECT_LT(result.maxSpeed, 1.05 * std::sqrt(standardGravity * standardGravity * 0.49 + 2 * standardGravity * 0.6))
        << "nothing is shot out";
    EXPECT_GT(heightAt(result.endTime, bodyOf(0)), 0.5);
}

TEST_F(ReleasedIslands, RefusedOnesAreHeldAndSaid) {
    test::ElementScene scene;
    scene.times = {0.0, 0.1, 0.2};
    std::vector<Vec3> corners;
    for (const auto& c :
         {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)}) {
        corners.push_back(Vec3(0, 0, 9) + c);
    }
    scene.element(ElementShape::Hexahedron, corners, "111");
    scene.position = [](const Vec3& x, double t) { return Vec3(x - 5.0 * t * Vec3::UnitZ()); };
    scene.damage = [](std::size_t k, FeState& state) {
        if (k == 2) {
            state.positions[3].y() = std::nan("");
        }
    };
    const SimulationResult result = simulateScene(scene.result());
    EXPECT_EQ(result.islands.islands, 1);
    EXPECT_EQ(result.islands.refused, 1);
    EXPECT_EQ(result.islands.held(), 1);
    EXPECT_EQ(result.findings.count("simulation.island_refused"), 1);
    EXPECT_EQ(result.findings.count("simulation.live_islands"), 1);
}

TEST_F(ReleasedIslands, RepeatBitByBit) {
    const auto fe = scenes::collapsingWall(6, 4);
    const SimulationResult first = simulateScene(fe);
    EXPECT_EQ(first.islands.released, 1) << "the beam";
    EXPECT_EQ(simulateScene(fe).trajectoryHash, first.trajectoryHash);
}

}  // namespace
}  // namespace rubble
