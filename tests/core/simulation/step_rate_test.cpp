#include "core/simulation/run/step_rate.h"

#include <gtest/gtest.h>

#include "core/fe/loose_bodies.h"
#include "core/pipeline/pipeline.h"
#include "core/scenario/body_scenario.h"
#include "core/simulation/effects/decisions.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

/// Cubes of one side that all die at one state, under a beam that stays.
/// @param settled  as the effects settle it: nothing comes loose here, so the engine has nothing to move
StepRate chosenFor(double side, Scenario scenario, int cells, bool settled) {
    scenes::Block wall;
    wall.name = "wall";
    wall.size = Vec3::Constant(cells * side);
    wall.cells = {cells, cells, cells};
    wall.deathState = [](std::size_t) { return std::size_t{2}; };
    scenes::Block beam;
    beam.name = "beam";
    beam.low = Vec3(0, 0, 3.0 * cells * side);
    beam.size = Vec3::Constant(side);
    beam.cells = {1, 1, 1};
    const Inputs inputs{scenes::makeScene({wall, beam}, 4, 0.1), {}};
    scenario.grid.oneBodyPerFragment = true;
    const Results results = run(inputs, scenario, Stage::Clusters, {}, nullptr, Execution());
    const EffectScene scene{*inputs.fe, *results.components, *results.fragments, *results.clustering, nullptr, scenario};
    return chosenStepRate(describeRun(inputs, settled ? settledScenario(scene) : scenario, results), decideEffects(scene));
}

double rateOf(double side, const Scenario& scenario = {}, int cells = 3) {
    return chosenFor(side, scenario, cells, true).perSecond;
}

TEST(StepRate, FallsWithTheRootOfTheSize) {
    EXPECT_NEAR(rateOf(0.6), 40.0 * std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(rateOf(0.9), 40.0 / std::sqrt(3.0), 1e-9);
}

TEST(StepRate, StaysWithinWhatWasVerified) {
    EXPECT_EQ(rateOf(0.05), 40.0);
    EXPECT_EQ(rateOf(5.0), 20.0);
}

TEST(StepRate, IsHigherForPilesOfMoreLayers) {
    // 24^3 bodies: cbrt(13,824 / 10,000) times the rate of few.
    EXPECT_NEAR(rateOf(0.6, {}, 24), 40.0 * std::cbrt(1.3824) * std::sqrt(0.5), 1e-9);
}

TEST(StepRate, OfTheScenarioGoesFirst) {
    Scenario scenario;
    scenario.simulation.stepRate = 90.0;
    EXPECT_EQ(rateOf(5.0, scenario), 90.0);
}

TEST(StepRate, OfLooseStructureLastsUntilTheFeEnd) {
    Scenario scenario;
    scenario.effects.loose = LooseStructurePolicy::AtOnce;
    const StepRate loose = chosenFor(5.0, scenario, 3, false);
    EXPECT_EQ(loose.perSecond, 40.0);
    EXPECT_EQ(loose.settling, 20.0);
    EXPECT_EQ(substepsOf(scenario), 12);
    EXPECT_EQ(settlingSubstepsOf(scenario), 8);
    EXPECT_EQ(overlapTimeOf(scenario), 1.0);
    scenario.simulation.stepRate = 50.0;
    scenario.simulation.substeps = 6;
    EXPECT_EQ(chosenFor(5.0, scenario, 3, false).settling, 50.0);
    EXPECT_EQ(settlingSubstepsOf(scenario), 6);
}

TEST(StepRate, IsTheSameThroughoutWhereTheFeResultMovesWhatIsLoose) {
    Scenario scenario;
    scenario.effects.loose = LooseStructurePolicy::Fe;
    const StepRate rate = chosenFor(0.6, scenario, 3, true);
    EXPECT_EQ(rate.settling, rate.perSecond);
    EXPECT_EQ(settlingSubstepsOf(scenario), substepsOf(scenario));
    EXPECT_EQ(overlapTimeOf(scenario), 7.0);
}

TEST(StepRate, IsThatOfItsDefaultsForBullet) {
    Scenario scenario;
    scenario.simulation.solver = SolverKind::Bullet;
    EXPECT_EQ(rateOf(5.0, scenario), 60.0);
}

StepRate tableRate(double side, Scenario scenario = {}) {
    LooseBody body;
    body.id = "cube";
    body.sides = Vec3::Constant(side);
    body.mass = 2400.0 * side * side * side;
    body.pose.position = Vec3(0, 0, 2.0 * side);
    prepareForBodies(scenario, {body});
    const Inputs inputs{std::make_shared<const FeResult>(contentsOf({body})), {}};
    const Results results = run(inputs, scenario, Stage::Clusters, {}, nullptr, Execution());
    return chosenStepRate(describeRun(inputs, scenario, results), {});
}

TEST(StepRate, OfATableTurnsACubeByThreeQuartersOfADegreeInAStep) {
    // 0.788 sqrt(9.80665 / 0.4192) rad/s over 0.75 degrees; of a smaller one at most 480 steps.
    EXPECT_NEAR(tableRate(0.4192).perSecond, 291.2, 0.1);
    EXPECT_NEAR(tableRate(1.6768).perSecond, 145.6, 0.1);
    EXPECT_EQ(tableRate(0.1048).perSecond, 480.0);
    EXPECT_EQ(tableRate(0.02).perSecond, 480.0);
    EXPECT_EQ(tableRate(30.0).perSecond, 40.0);
    EXPECT_EQ(tableRate(0.1048).reason.id, "simulation.step_rate.tumbling");
    Scenario scenario;
    scenario.simulation.stepRate = 90.0;
    EXPECT_EQ(tableRate(0.1048, scenario).perSecond, 90.0);
    EXPECT_EQ(tableRate(0.1048, scenario).reason.id, "simulation.step_rate.set");
}

TEST(StepRate, AStepIsPartedByWhatRolls) {
    EXPECT_EQ(partsOfStep(0.0, 0.01), 1);
    EXPECT_EQ(partsOfStep(1.3, 0.01), 1);
    EXPECT_EQ(partsOfStep(1.35, 0.01), 2) << "0.77 degrees";
    EXPECT_EQ(partsOfStep(1e9, 0.01), 32);
}

}  // namespace
}  // namespace rubble
