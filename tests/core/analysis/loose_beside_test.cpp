#include "core/analysis/accuracy/loose_beside.h"

#include <gtest/gtest.h>

#include "core/base/standard_gravity.h"
#include "core/pipeline/loose_scene.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

class LooseBeside : public testing::Test {
protected:
    /// A slab of 24 elements in the air, of which one dies at each state from the third on.
    void SetUp() override {
        scenes::Block slab;
        slab.low = Vec3(0, 0, 20);
        slab.size = Vec3(6, 4, 1);
        slab.cells = {6, 4, 1};
        slab.gravity = standardGravity;
        slab.deathState = [](std::size_t i) { return i < 4 ? 3 + i : scenes::never; };
        m_inputs.fe = scenes::makeScene({slab}, 8, 0.1);
        m_scenario.fragments.birthWindow = 0.0;
    }

    Inputs m_inputs;
    Scenario m_scenario;
};

TEST_F(LooseBeside, IsWhatTheEngineMovesAtOneTime) {
    const auto beside = looseBeside(m_inputs, m_scenario, Execution());
    ASSERT_TRUE(beside.has_value());
    EXPECT_EQ(beside->islands, 1);
    EXPECT_EQ(beside->elements, 24) << "before the first of them dies";
    EXPECT_LT(beside->time, 0.25);
}

TEST_F(LooseBeside, IsNothingWhereTheFeResultMovesIt) {
    m_scenario.effects.loose = LooseStructurePolicy::Fe;
    EXPECT_FALSE(looseBeside(m_inputs, m_scenario, Execution()).has_value());
}

TEST_F(LooseBeside, IsNothingWhereNothingComesLoose) {
    scenes::Block pier;
    pier.size = Vec3(1, 1, 3);
    pier.cells = {1, 1, 3};
    pier.deathState = [](std::size_t i) { return i == 2 ? std::size_t{2} : scenes::never; };
    m_inputs.fe = scenes::makeScene({pier}, 5, 0.1);
    EXPECT_FALSE(looseBeside(m_inputs, m_scenario, Execution()).has_value());
}

TEST_F(LooseBeside, SaysWhatTheFrameRateLeavesOutAndWhatToDo) {
    const Finding before = looseBesideCaution(24.0, {3.4, 2, 1}, 60660);
    EXPECT_EQ(englishText(before.what),
              "The bodies that 24 FPS allow are fragments alone. The engine moves loose structure beside them (loose_structure), "
              "1 of 60,660 elements at one time (at 3.4 s), which takes from that rate");
    EXPECT_FALSE(before.remedy.empty());
    SimulationResult run;
    EXPECT_FALSE(looseBesideCaution(24.0, run, 60660).has_value()) << "nothing was loose";
    run.carried.islands = 3;
    run.carried.elements = 45000;
    run.stepTimes.realTimeFactor = 0.35;
    const auto after = looseBesideCaution(24.0, run, 60660);
    ASSERT_TRUE(after.has_value());
    EXPECT_NE(englishText(after->what).find("45,000 of 60,660 elements in all, and simulated at 0.35 times real time"),
              std::string::npos)
        << englishText(after->what);
    EXPECT_EQ(after->remedy.id, before.remedy.id);
}

TEST_F(LooseBeside, StandsOnTheGroundThatIsNotSetOff) {
    m_inputs.terrain = std::make_shared<const TerrainGrid>(0.0, 0.0, 1.0, 2, 2, std::vector<double>(4, 1.0));
    m_scenario.simulation.groundHeight = 0.5;
    EXPECT_EQ(groundBeforeRun(m_inputs, m_scenario).terrain, m_inputs.terrain);
    EXPECT_EQ(groundBeforeRun(m_inputs, m_scenario).levelHeight, 0.5);
    m_scenario.effects.of(EffectKind::Terrain) = EffectSwitch::Off;
    EXPECT_EQ(groundBeforeRun(m_inputs, m_scenario).terrain, nullptr);
    m_scenario.effects.of(EffectKind::Ground) = EffectSwitch::Off;
    EXPECT_FALSE(groundBeforeRun(m_inputs, m_scenario).level);
}

}  // namespace
}  // namespace rubble
