#include "core/base/standard_gravity.h"
#include "core/simulation/run/simulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <thread>

#include "core/base/error.h"
#include "core/pipeline/pipeline.h"
#include "core/selftest/killed_trajectory.h"
#include "core/simulation/bodies/hand_over.h"
#include "tests/core/fragments/element_scene.h"
#include "tests/core/simulation/effects/run_scene.h"
#include "tests/core/simulation/world_scene.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

class Simulate : public testing::Test {
protected:
    Scenario scenario;
    MemoryTrajectory trajectory;

    void SetUp() override {
        scenario.simulation.settleTime = 3.0;
        scenario.effects.islands = LiveIslandPolicy::Held;  // they have tests of their own
    }
    SimulationResult simulateScene(std::shared_ptr<const FeResult> fe) {
        return simulate(test::describe(std::move(fe), scenario), trajectory, Execution());
    }
};

/// A block high up that dies at state 3 while it falls.
std::shared_ptr<const FeResult> fallingBlock() {
    scenes::Block block;
    block.low = Vec3(0, 0, 30);
    block.size = Vec3(2, 1, 1);
    block.cells = {2, 1, 1};
    block.velocity = Vec3(1, 0, -2);
    block.gravity = standardGravity;
    block.deathState = [](std::size_t) { return std::size_t{3}; };
    return scenes::makeScene({block}, 8, 0.1);
}

TEST_F(Simulate, TakesABodyOverFromTheFeResultAndLetsItFall) {
    scenario.simulation.stepRate = 60.0;
    const SimulationResult result = simulateScene(fallingBlock());
    EXPECT_NEAR(result.firstTime, 0.2, 1e-12);
    EXPECT_NEAR(result.feEndTime, 0.7, 1e-12);
    ASSERT_EQ(result.fragments.size(), 2u);
    // Born one state after the hand-over, on the trajectory, which is the block's own flight.
    const double t = 0.3;
    EXPECT_NEAR(result.fragments[0].birthPosition.x(), 0.5 + t, 1e-6);
    EXPECT_NEAR(result.fragments[0].birthPosition.z(), 30.5 - 2 * t - 0.5 * standardGravity * t * t, 1e-6);
    EXPECT_NEAR(result.fragments[0].birthSpeed, std::hypot(1.0, 2 + standardGravity * t), 1e-6);
    const TrajectoryFrame atFeEnd = frameAtTime(trajectory, 0.7);
    EXPECT_NEAR(atFeEnd.positions[0].z(), 30.5 - 2 * 0.7 - 0.5 * standardGravity * 0.49, 1e-5);
    // It reaches the ground 30 m below: v^2 = 2^2 + 1 + 2 g h.
    EXPECT_NEAR(result.fragments[0].impactSpeed, std::sqrt(1 + 4 + 2 * standardGravity * 30), 0.25);
    EXPECT_LT(result.fragments[0].finalPosition.z(), 1.0);
    EXPECT_GT(result.fragments[0].finalPosition.z(), 0.4);
    EXPECT_LT(result.maxSpeed, 1.05 * std::sqrt(5 + 2 * standardGravity * 30));
    // PHYSICS section 6: energy never rises by more than 0.1 % of what gravity did.
    EXPECT_LT(result.energy.drift, 1e-3);
    EXPECT_GT(result.asleepAtEnd, 0.98);
    EXPECT_EQ(result.stillMoving, 0);
}

TEST_F(Simulate, LedgerClosesAtEveryHandOver) {
    scenario.effects.loose = LooseStructurePolicy::Fe;  // fragments alone
    const SimulationResult result = simulateScene(scenes::collapsingWall());
    EXPECT_GT(result.bodiesPeak, 3);
    for (const double error : {result.ledger.mass, result.ledger.momentum, result.ledger.angularMomentum, result.ledger.bodyMass,
                               result.ledger.bodyMomentum, result.ledger.bodyAngularMomentum}) {
        EXPECT_LT(error, 1e-9);
    }
    Momenta fe;
    Momenta bodies;
    double dropped = 0.0;
    for (const LedgerRow& row : trajectory.ledger()) {
        fe += row.fe;
        bodies += row.bodies;
        dropped += row.droppedKineticEnergy;
    }
    EXPECT_NEAR(bodies.mass, fe.mass, 1e-9 * fe.mass);
    EXPECT_NEAR(fe.kineticEnergy - bodies.kineticEnergy, dropped, 1e-9 * (fe.kineticEnergy + 1.0));
    EXPECT_NEAR(result.energy.kineticIn, bodies.kineticEnergy, 1e-9 * (bodies.kineticEnergy + 1.0));
    EXPECT_NEAR(trajectory.ledger().back().all.mass, fe.mass, 1e-9 * fe.mass);
}

TEST_F(Simulate, RepeatsBitByBit) {
    const RunDescription description = test::describe(scenes::collapsingWall(8, 6), scenario);
    MemoryTrajectory other;
    const SimulationResult first = simulate(description, trajectory, Execution());
    // Memory lies elsewhere the second time.
    const std::vector<char> ballast(12345);
    const SimulationResult second = simulate(description, other, Execution());
    EXPECT_EQ(first.trajectoryHash, second.trajectoryHash);
    EXPECT_EQ(first.energy.dissipated, second.energy.dissipated);
    SimulationResult third;
    std::thread([&] { third = simulate(description, other, Execution()); }).join();
    EXPECT_EQ(first.trajectoryHash, third.trajectoryHash);
    RunDescription shifted = description;
    shifted.scenario.simulation.friction = 0.61;
    EXPECT_NE(simulate(shifted, other, Execution()).trajectoryHash, first.trajectoryHash);
}

TEST_F(Simulate, CommitsEveryFeStateAndFramesInBetween) {
    scenario.simulation.stepRate = 60.0;
    scenario.simulation.frameRate = 25.0;
    simulateScene(scenes::collapsingWall());
    const std::shared_ptr<const FeResult> fe = scenes::collapsingWall();
    std::size_t fromFe = 0;
    for (std::size_t i = 0; i < trajectory.frameCount(); ++i) {
        const auto frame = trajectory.frame(i);
        fromFe += frame->kind == FrameKind::Fe;
        if (i > 0) {
            EXPECT_GT(frame->time, trajectory.frameTime(i - 1));
            EXPECT_LT(frame->time - trajectory.frameTime(i - 1), 1.0 / 25.0 + 1.0 / 60.0 + 1e-9);
        }
        if (frame->kind == FrameKind::Fe) {
            EXPECT_EQ(std::count(fe->times().begin(), fe->times().end(), frame->time), 1);
        }
    }
    // From the first hand-over (state 1) to the last state.
    EXPECT_EQ(fromFe, fe->stateCount() - 1);
    EXPECT_TRUE(trajectory.complete());
}

TEST_F(Simulate, CarriersBringFragmentsToTheirPlaces) {
    const RunDescription description = test::describe(scenes::collapsingWall(), scenario);
    const SimulationResult result = simulate(description, trajectory, Execution());
    const auto last = trajectory.frame(trajectory.frameCount() - 1);
    ASSERT_EQ(trajectory.carriers().size(), description.fragments->size());
    for (const Carrier& carrier : trajectory.carriers()) {
        const BodyRecord body = trajectory.bodies()[at(carrier.body)];
        const Vec3& centre = description.fragments->list[at(carrier.fragment)].centre;
        EXPECT_LT((body.atBirth * (carrier.handOverToBody * centre) - centre).norm(), 1e-9);
        const Pose now{last->positions[at(carrier.body)].cast<double>(), last->orientations[at(carrier.body)].cast<double>()};
        EXPECT_LT((now * (carrier.handOverToBody * centre) - result.fragments[at(carrier.fragment)].finalPosition).norm(), 1e-4);
    }
}

TEST_F(Simulate, EveryShapeAndEveryKindOfPieceRuns) {
    for (const ClusterShape shape :
         {ClusterShape::AxisBox, ClusterShape::OrientedBox, ClusterShape::Hull, ClusterShape::Compound}) {
        for (const PieceKind pieces : {PieceKind::None, PieceKind::ComponentBox, PieceKind::GridBoxes, PieceKind::Surface}) {
            scenario.simulation.shape = shape;
            scenario.simulation.pieces = pieces;
            scenario.simulation.settleTime = 1.0;
            const SimulationResult result = simulateScene(scenes::collapsingWall());
            const std::string name = std::to_string(static_cast<int>(shape)) + " " + std::to_string(static_cast<int>(pieces));
            EXPECT_LT(result.ledger.bodyAngularMomentum, 1e-9) << name;
            EXPECT_LT(result.maxSpeed, 15.0) << name;
            EXPECT_EQ(result.findings.count("simulation.below_ground"), 0) << name;
            for (const FragmentOutcome& fragment : result.fragments) {
                EXPECT_TRUE(fragment.finalPosition.allFinite()) << name;
                EXPECT_GT(fragment.finalPosition.z(), 0.1) << name;
            }
        }
    }
}

TEST_F(Simulate, NoFragmentsIsAValidAnswer) {
    scenes::Block block;
    const SimulationResult result = simulateScene(scenes::makeScene({block}, 4, 0.1));
    EXPECT_TRUE(result.fragments.empty());
    EXPECT_EQ(result.steps, 0);
    EXPECT_EQ(result.bodiesPeak, 0);
    EXPECT_TRUE(std::isnan(result.bulkingFactor));
    EXPECT_TRUE(trajectory.complete());
}

TEST_F(Simulate, CancelKeepsWhatWasCommitted) {
    const RunDescription description = test::describe(scenes::collapsingWall(), scenario);
    const Execution execution;
    selftest::KilledTrajectory sink(execution, 3);
    EXPECT_THROW(simulate(description, sink, execution), Cancelled);
    EXPECT_FALSE(sink.complete());
    EXPECT_EQ(sink.frameCount(), 3u);
}

TEST_F(Simulate, CancelEndsAStepEarly) {
    bool asked = false;
    WorldSettings settings;
    settings.cancelled = [&] { return asked = true; };
    const std::unique_ptr<RigidWorld> world = makeWorld(SolverKind::Bullet, settings);
    for (int i = 0; i < 40; ++i) {
        world->addBody(test::boxBody({0.9 * (i % 7), 0.9 * (i / 7), 0.4}, {1, 1, 1}));
    }
    world->step(1.0 / 60.0);
    EXPECT_TRUE(asked);
    EXPECT_EQ(world->contacts().pairs, 0) << "no contact was looked for any more";
}

TEST_F(Simulate, RemovesBodiesWhoseElementsComeBack) {
    test::ElementScene scene;
    scene.element(ElementShape::Hexahedron,
                  {{0, 0, 9}, {1, 0, 9}, {1, 1, 9}, {0, 1, 9}, {0, 0, 10}, {1, 0, 10}, {1, 1, 10}, {0, 1, 10}}, "1100111");
    scene.element(ElementShape::Hexahedron,
                  {{5, 0, 9}, {6, 0, 9}, {6, 1, 9}, {5, 1, 9}, {5, 0, 10}, {6, 0, 10}, {6, 1, 10}, {5, 1, 10}}, "1100000");
    for (int k = 0; k < 7; ++k) {
        scene.times.push_back(0.1 * k);
    }
    scenario.fragments.revival = Revival::Follow;
    simulateScene(scene.result());
    ASSERT_EQ(trajectory.bodies().size(), 2u);
    const std::size_t follows = std::isfinite(trajectory.bodies()[0].to) ? 0 : 1;
    EXPECT_NEAR(trajectory.bodies()[follows].to, 0.4, 1e-12);
    EXPECT_EQ(frameAtTime(trajectory, 0.3).states[follows], BodyState::Awake);
    EXPECT_EQ(frameAtTime(trajectory, 0.4).states[follows], BodyState::Removed);
    EXPECT_NE(frameAtTime(trajectory, 0.4).states[1 - follows], BodyState::Removed);
}

TEST_F(Simulate, RefusesWhatIsNoBody) {
    scenario.effects.loose = LooseStructurePolicy::Fe;  // fragments alone
    for (int damage = 0; damage < 4; ++damage) {
        RunDescription description = test::describe(scenes::collapsingWall(), scenario);
        auto clustering = std::make_shared<Clustering>(*description.clustering);
        Cluster& broken = clustering->list.front();
        switch (damage) {
            case 0:
                broken.mass = 0.0;
                break;
            case 1:
                broken.centre.x() = std::numeric_limits<double>::quiet_NaN();
                break;
            case 2:
                broken.inertia(1, 1) = -std::abs(broken.inertia(1, 1));
                break;
            default:
                broken.velocity.z() = std::numeric_limits<double>::infinity();
        }
        description.clustering = clustering;
        MemoryTrajectory sink;
        const SimulationResult result = simulate(description, sink, Execution());
        EXPECT_EQ(result.findings.count("simulation.body_refused"), 1) << damage;
        EXPECT_EQ(sink.bodies().size() + 1, clustering->list.size()) << damage;
        for (const FragmentOutcome& fragment : result.fragments) {
            EXPECT_TRUE(fragment.finalPosition.allFinite()) << damage;
        }
    }
}

TEST_F(Simulate, RunsOnAfterTheFeResultUntilItSleeps) {
    scenario.simulation.settleTime = 10.0;
    const SimulationResult result = simulateScene(fallingBlock());
    EXPECT_GT(result.endTime, result.feEndTime + 2.0);
    EXPECT_LT(result.endTime, result.feEndTime + 10.0) << "asleep before the time is up";
    scenario.simulation.settleTime = 0.5;
    EXPECT_NEAR(simulateScene(fallingBlock()).endTime, result.feEndTime + 0.5, 0.02);
}

TEST_F(Simulate, MassPropertiesComeFromTheElements) {
    for (const ClusterShape shape :
         {ClusterShape::AxisBox, ClusterShape::OrientedBox, ClusterShape::Hull, ClusterShape::Compound}) {
        scenario.simulation.shape = shape;
        const RunDescription description = test::describe(scenes::collapsingWall(), scenario);
        Findings findings;
        for (std::size_t c = 0; c < description.clustering->list.size(); ++c) {
            const Cluster& cluster = description.clustering->list[c];
            const auto body = bodyOf(description, idAt<ClusterId>(c));
            ASSERT_TRUE(body);
            EXPECT_EQ(body->mass, cluster.mass);
            const Mat3 axes = body->pose.orientation.toRotationMatrix();
            EXPECT_LT((axes * body->inertia.asDiagonal() * axes.transpose() - cluster.inertia).norm(),
                      1e-9 * cluster.inertia.norm());
        }
        EXPECT_TRUE(findings.empty());
    }
}

TEST_F(Simulate, ABoxIsDrawnInToTheBulkingAskedFor) {
    scenario.grid.multiple = 50.0;
    scenario.grid.acrossComponents = true;
    for (const ClusterShape shape : {ClusterShape::AxisBox, ClusterShape::OrientedBox}) {
        scenario.simulation.shape = shape;
        bool drawn = false;
        for (const double bulking : {1.0, 1.5, 1000.0}) {
            scenario.simulation.boxBulking = bulking;
            const RunDescription description = test::describe(scenes::collapsingWall(), scenario);
            Findings findings;
            for (std::size_t c = 0; c < description.clustering->list.size(); ++c) {
                double material = 0.0;
                for (const FragmentId f : description.clustering->membersOf(idAt<ClusterId>(c))) {
                    material += description.fragments->list[at(f)].box.volume();
                }
                const auto body = bodyOf(description, idAt<ClusterId>(c));
                ASSERT_TRUE(body);
                ASSERT_EQ(body->shape.size(), 1u);
                const double box = body->shape.front().box.volume();
                EXPECT_LE(box, bulking * material * (1.0 + 1e-9));
                // Every second block of the wall dies at once: their common box is half empty, so the limit bites.
                drawn = drawn || (bulking == 1.0 && std::abs(box - material) < 1e-6 * material && body->mass > 2001.0);
                if (bulking == 1000.0 && description.clustering->list[c].memberCount > 1) {
                    EXPECT_GT(box, 1.2 * material);
                }
            }
        }
        EXPECT_TRUE(drawn);
    }
}

}  // namespace
}  // namespace rubble
