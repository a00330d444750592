#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/base/standard_gravity.h"
#include "core/pipeline/pipeline.h"
#include "core/simulation/run/simulation.h"
#include "tests/samples/arches.h"

namespace rubble {
namespace {

/// The first states of a sample, as if its analysis had ended there.
std::shared_ptr<const FeResult> beginningOf(const FeResult& fe, std::size_t states) {
    FeResult::Contents contents = fe.contents();
    contents.times.resize(states);
    contents.activity = Activity(states, fe.mesh().elementCount());
    for (std::size_t k = 0; k < states; ++k) {
        for (std::size_t i = 0; i < fe.mesh().elementCount(); ++i) {
            contents.activity.set(k, idAt<ElementIndex>(i), fe.activity().active(k, idAt<ElementIndex>(i)));
        }
    }
    return std::make_shared<FeResult>(std::move(contents));
}

SimulationResult simulateBeginning(const arches::Arch& arch, std::size_t states, MemoryTrajectory& trajectory) {
    Scenario scenario;
    scenario.grid.bodiesMax = 400;
    scenario.simulation.settleTime = 0.3;
    const Inputs inputs{beginningOf(*arch.fe, states), {}};
    return *run(inputs, scenario, Stage::Simulation, {}, &trajectory, Execution()).simulation;
}

void expectSound(const SimulationResult& result, const MemoryTrajectory& trajectory) {
    for (const double error : {result.ledger.mass, result.ledger.momentum, result.ledger.angularMomentum, result.ledger.bodyMass,
                               result.ledger.bodyMomentum, result.ledger.bodyAngularMomentum}) {
        EXPECT_LT(error, 1e-9);
    }
    // PHYSICS section 6: a gain above 0.1 % of the gravity work is unhealthy.
    EXPECT_LT(result.energy.drift, 1e-3);
    EXPECT_EQ(result.findings.count("simulation.below_ground"), 0);
    EXPECT_EQ(result.findings.count("simulation.body_refused"), 0);
    EXPECT_GT(result.births.occupied, 0);
    const auto last = trajectory.frame(trajectory.frameCount() - 1);
    EXPECT_EQ(static_cast<std::int64_t>(last->bodies()), result.births.births + result.islands.released + result.carried.bodies);
    for (const FragmentOutcome& fragment : result.fragments) {
        EXPECT_TRUE(fragment.finalPosition.allFinite());
        EXPECT_TRUE(std::isfinite(fragment.impactSpeed));
    }
}

TEST(ArchSimulation, StoneArchUntilItsFirstSpansAreDown) {
    MemoryTrajectory trajectory;
    const SimulationResult result = simulateBeginning(arches::mergedStoneArch(), 42, trajectory);
    expectSound(result, trajectory);
    // Nothing is born faster than 28.7 m/s and the bridge is 42 m high (28.7 m/s of fall).
    EXPECT_LT(result.maxSpeed, 1.05 * std::sqrt(28.7 * 28.7 + 2 * standardGravity * 42));
    EXPECT_GT(result.energy.gravityWork, 0.0);
}

TEST(ArchSimulation, OverlapThatMovesToAnotherPairIsNoLoad) {
    // Few and large clusters, each born in the place of many: where overlap moved from pair to pair and was fought by
    // impulses, 17.8 % of the bodies lay deep in others for over half a second; 9.8 % where it stays overlap.
    const arches::Arch& arch = arches::mergedStoneArch();
    Scenario scenario;
    scenario.grid.bodiesMax = 1000;
    scenario.simulation.settleTime = 1.0;
    MemoryTrajectory trajectory;
    const SimulationResult result = *run({arch.fe, {}}, scenario, Stage::Simulation, {}, &trajectory, Execution()).simulation;
    EXPECT_LT(result.health.crowdShare, 0.13);
    EXPECT_GT(result.births.left, 0);
    EXPECT_LT(result.births.left, result.births.births);
}

TEST(ArchSimulation, RcArchRepeatsBitByBit) {
    MemoryTrajectory first;
    MemoryTrajectory second;
    const SimulationResult result = simulateBeginning(arches::rcArch(), 36, first);
    expectSound(result, first);
    EXPECT_EQ(result.trajectoryHash, simulateBeginning(arches::rcArch(), 36, second).trajectoryHash);
}

}  // namespace
}  // namespace rubble
