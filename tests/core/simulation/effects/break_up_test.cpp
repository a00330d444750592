#include "core/simulation/effects/break_up.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/simulation/run/simulation.h"
#include "tests/core/simulation/effects/run_scene.h"
#include "tests/core/simulation/world_scene.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

/// A block of 2 x 2 x 2 elements that dies at state 2, falling from rest from `height` above the ground.
std::shared_ptr<const FeResult> fallingBlock(double height) {
    scenes::Block block;
    block.name = "block";
    block.low = Vec3(0, 0, height);
    block.size = Vec3(2.0, 1.6, 1.2);
    block.cells = {2, 2, 2};
    block.gravity = standardGravity;
    block.deathState = [](std::size_t) { return std::size_t{2}; };
    return scenes::makeScene({block}, 6, 0.1);
}

class BreakingUp : public testing::Test {
protected:
    Scenario scenario;
    MemoryTrajectory trajectory;

    void SetUp() override {
        scenario.simulation.settleTime = 3.0;
        scenario.simulation.restitution = 0.0;
        scenario.grid.length = scenario.grid.width = scenario.grid.height = 10.0;
        scenario.components["block"].material = Material::Stone;
        scenario.effects.of(EffectKind::BreakUp) = EffectSwitch::On;
    }
    SimulationResult simulateFrom(double height) {
        return simulate(test::describe(fallingBlock(height), scenario), trajectory, Execution());
    }
    static std::int64_t broken(const SimulationResult& result) {
        return result.effects.at(static_cast<std::size_t>(EffectKind::BreakUp)).events;
    }
};

TEST_F(BreakingUp, AClusterAndItsFragmentsHaveTheSameMomentaAndEnergy) {
    RunDescription description = test::describe(fallingBlock(20.0), scenario);
    ASSERT_EQ(description.clustering->list.size(), 1u);
    test::WorldScene scene;
    Findings findings;
    const HandOver entered = handOver(description, 0, 1, IslandBirths(), scene.world(), findings).fromFe;
    const Quat turn(Eigen::AngleAxisd(0.8, Vec3(1, -2, 0.5).normalized()));
    const BodyRecord record = entered.bodies[0];
    const BodyMotion motion{{Vec3(30, -20, 12), turn * record.atBirth.orientation}, Vec3(4, -3, -15), Vec3(2.0, -1.0, 3.0)};
    const NewBody whole = bodyOf(description, record.cluster).value();
    const auto momentaOf = [](const NewBody& body, const Pose& pose, const Vec3& velocity, const Vec3& spin) {
        const Mat3 axes = pose.orientation.toRotationMatrix();
        return rigidMomenta(body.mass, pose.position, axes * body.inertia.asDiagonal() * axes.transpose(), velocity, spin);
    };
    const Momenta before = momentaOf(whole, motion.pose, motion.velocity, motion.angularVelocity);
    const auto freed = freeFragments(description, record, entered.carriers, motion);
    ASSERT_TRUE(freed);
    ASSERT_EQ(freed->size(), 8u);
    Momenta after;
    for (const FreedFragment& part : *freed) {
        after += momentaOf(part.body, part.body.pose, part.body.velocity, part.body.angularVelocity);
        EXPECT_NEAR(part.body.volume, 0.48, 1e-12);
        EXPECT_EQ(part.body.material, Material::Stone);
        // The fragment lies where the cluster carried it.
        const Vec3& centre = description.fragments->list[at(part.fragment)].centre;
        EXPECT_LT((part.body.pose * (part.toBody * centre) - motion.pose * (entered.carriers[0].handOverToBody * centre)).norm(),
                  1e-12);
    }
    // Sums over the same elements: rounding only.
    EXPECT_NEAR(after.mass, before.mass, 1e-12 * before.mass);
    EXPECT_LT((after.linear - before.linear).norm(), 1e-12 * before.linear.norm());
    EXPECT_LT((after.angular - before.angular).norm(), 1e-12 * before.angular.norm());
    EXPECT_NEAR(after.kineticEnergy, before.kineticEnergy, 1e-12 * before.kineticEnergy);
}

TEST_F(BreakingUp, HappensAboveTheThresholdAndNotBelow) {
    // Without bouncing the impulse per mass is the speed of impact, sqrt(2 g h): 5.4 and 6.7 m/s.
    const double threshold = scenario.effects.breakUpSpeed;
    const double just = threshold * threshold / (2.0 * standardGravity);
    EXPECT_EQ(broken(simulateFrom(0.8 * just)), 0);
    EXPECT_EQ(trajectory.bodies().size(), 1u);
    const SimulationResult result = simulateFrom(1.25 * just);
    EXPECT_EQ(broken(result), 1);
    EXPECT_EQ(trajectory.bodies().size(), 9u);
    EXPECT_EQ(result.bodiesPeak, 8);
    EXPECT_EQ(result.births.births, 1);
}

TEST_F(BreakingUp, TheTrajectoryChangesCarriersAtThatInstant) {
    const RunDescription description = test::describe(fallingBlock(10.0), scenario);
    const SimulationResult result = simulate(description, trajectory, Execution());
    ASSERT_EQ(broken(result), 1);
    const std::vector<BodyRecord> bodies = trajectory.bodies();
    const std::vector<Carrier> carriers = trajectory.carriers();
    ASSERT_EQ(carriers.size(), 16u);
    const double when = bodies[0].to;
    EXPECT_GT(when, 1.0);
    for (std::size_t b = 1; b < bodies.size(); ++b) {
        EXPECT_EQ(bodies[b].from, when);
        EXPECT_EQ(bodies[b].cluster, bodies[0].cluster);
        EXPECT_EQ(bodies[b].to, std::numeric_limits<double>::infinity());
    }
    for (std::size_t c = 0; c < 8; ++c) {
        EXPECT_EQ(carriers[c].to, when);
        EXPECT_EQ(carriers[c + 8].from, when);
        // No jump: both put the fragment at the same place.
        const Vec3& centre = description.fragments->list[at(carriers[c].fragment)].centre;
        const Pose& now = bodies[at(carriers[c + 8].body)].atBirth;
        const TrajectoryFrame later = *trajectory.frame(trajectory.frameCount() - 1);
        EXPECT_EQ(later.states[0], BodyState::Removed);
        const Pose last{later.positions[0].cast<double>(), later.orientations[0].cast<double>()};
        EXPECT_LT((now * (carriers[c + 8].handOverToBody * centre) - last * (carriers[c].handOverToBody * centre)).norm(), 1e-5);
    }
    // Every fragment ends where its own body does, and remembers the hit of the whole.
    const TrajectoryFrame last = *trajectory.frame(trajectory.frameCount() - 1);
    for (std::size_t c = 8; c < 16; ++c) {
        const std::size_t b = at(carriers[c].body);
        const Pose now{last.positions[b].cast<double>(), last.orientations[b].cast<double>()};
        const FragmentOutcome& outcome = result.fragments[at(carriers[c].fragment)];
        const Vec3& centre = description.fragments->list[at(carriers[c].fragment)].centre;
        EXPECT_LT((now * (carriers[c].handOverToBody * centre) - outcome.finalPosition).norm(), 1e-4);
        EXPECT_GT(outcome.impactSpeed, 10.0);
    }
    EXPECT_LT(result.energy.drift, 1e-3);
    double mass = 0.0;
    for (const LedgerRow& row : trajectory.ledger()) {
        mass += row.fe.mass;
    }
    EXPECT_NEAR(trajectory.ledger().back().all.mass, mass, 1e-9 * mass);
}

TEST_F(BreakingUp, IsForStoneAndMasonryWithoutReinforcement) {
    scenario.components["block"].material = Material::Concrete;
    EXPECT_EQ(broken(simulateFrom(10.0)), 0);
    scenario.components["block"].material = Material::Masonry;
    EXPECT_EQ(broken(simulateFrom(10.0)), 1);
    scenario.components["block"].reinforced = true;
    EXPECT_EQ(broken(simulateFrom(10.0)), 0);
}

TEST_F(BreakingUp, NeverBringsMoreBodiesThanThereMayBe) {
    scenario.grid.bodiesMax = 7;
    const SimulationResult result = simulateFrom(10.0);
    EXPECT_EQ(broken(result), 0);
    EXPECT_GE(result.findings.count("simulation.held_together"), 1);
    EXPECT_EQ(trajectory.bodies().size(), 1u);
}

TEST_F(BreakingUp, RepeatsBitByBit) {
    const Digest first = simulateFrom(10.0).trajectoryHash;
    EXPECT_EQ(simulateFrom(10.0).trajectoryHash, first);
    scenario.effects.of(EffectKind::BreakUp) = EffectSwitch::Off;
    EXPECT_NE(simulateFrom(10.0).trajectoryHash, first);
}

TEST(ReplacedCarriers, EndWhereTheNextBegins) {
    std::vector<BodyRecord> bodies(4);
    std::vector<Carrier> carriers;
    const auto carry = [&](std::uint32_t fragment, std::uint32_t body, double from) {
        Carrier carrier;
        carrier.fragment = idAt<FragmentId>(fragment);
        carrier.body = idAt<BodyId>(body);
        carrier.from = from;
        carriers.push_back(carrier);
    };
    carry(0, 0, 1.0);
    carry(1, 0, 1.0);
    carry(2, 1, 1.0);
    carry(0, 2, 3.0);
    endReplaced(bodies, carriers);
    EXPECT_EQ(carriers[0].to, 3.0);
    EXPECT_EQ(bodies[0].to, std::numeric_limits<double>::infinity()) << "it still carries fragment 1";
    carry(1, 3, 3.0);
    endReplaced(bodies, carriers);
    EXPECT_EQ(carriers[1].to, 3.0);
    EXPECT_EQ(bodies[0].to, 3.0);
    EXPECT_EQ(bodies[1].to, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace rubble
