#include "core/analysis/accuracy/accuracy_settings.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/scenario/parameters.h"

namespace rubble {
namespace {

std::vector<AccuracySetting> sweep(const std::vector<std::string>& multiples, const std::vector<VariedParameter>& varied,
                                   const Scenario& scenario = {}) {
    return sweepSettings(scenario, multiples, varied);
}

TEST(AccuracySettings, AreAllCombinationsAndThePaper) {
    const auto settings = sweep({"1", "auto"}, {{"cluster_shape", {"hull", "compound"}}, {"step_rate", {"60", "120"}}});
    ASSERT_EQ(settings.size(), 9u);
    EXPECT_EQ(settings[0].name, "multiple=1 cluster_shape=hull step_rate=60");
    EXPECT_EQ(settings[1].name, "multiple=1 cluster_shape=hull step_rate=120");
    EXPECT_EQ(settings[7].name, "multiple=auto cluster_shape=compound step_rate=120");
    EXPECT_EQ(settings[8].name, "paper");
    EXPECT_EQ(settings[0].scenario.grid.multiple, 1.0);
    EXPECT_FALSE(settings[7].scenario.grid.multiple);
    EXPECT_EQ(settings[1].scenario.simulation.stepRate, 120.0);
    EXPECT_EQ(settings[0].scenario.simulation.shape, ClusterShape::Hull);
    EXPECT_EQ(settings[8].scenario.simulation.solver, SolverKind::Bullet);
}

TEST(AccuracySettings, AMultipleTakesThePlaceOfWhatWasSetByHand) {
    Scenario scenario;
    scenario.grid.length = 4.0;
    scenario.grid.oneBodyPerFragment = true;
    const auto settings = sweep({"2"}, {}, scenario);
    EXPECT_FALSE(settings[0].scenario.grid.length);
    EXPECT_FALSE(settings[0].scenario.grid.oneBodyPerFragment);
    EXPECT_EQ(settings[0].scenario.grid.multiple, 2.0);
}

TEST(AccuracySettings, WithoutAnythingToVaryItIsTheScenarioItself) {
    Scenario scenario;
    scenario.grid.length = 4.0;
    const auto settings = sweep({}, {}, scenario);
    ASSERT_EQ(settings.size(), 2u);
    EXPECT_EQ(settings[0].name, "as set");
    EXPECT_EQ(settings[0].scenario, scenario);
}

TEST(AccuracySettings, TheReferenceDoesNotDependOnGridOrMethod) {
    Scenario a;
    a.simulation.settleTime = 3.0;
    Scenario b = a;
    b.grid.multiple = 2.0;
    b.grid.bodiesMax = 100;
    b.simulation.shape = ClusterShape::Compound;
    applyPreset(b, "paper");
    b.fragments.birthWindow = 0.1;
    EXPECT_EQ(referenceScenario(b).effects.loose, LooseStructurePolicy::Fe) << "both sides of an error have the same scene";
    b.effects.loose = a.effects.loose;
    EXPECT_EQ(referenceScenario(a), referenceScenario(b));
    EXPECT_TRUE(referenceScenario(a).grid.oneBodyPerFragment);
    EXPECT_EQ(referenceScenario(a).simulation.settleTime, 3.0) << "what describes the scene stays";
    EXPECT_EQ(referenceScenario(a).effects.loose, LooseStructurePolicy::AtOnce);
    EXPECT_EQ(shapeOfClusters(referenceScenario(a)), ClusterShape::Bricks);
    a.effects.loose = LooseStructurePolicy::Fe;
    EXPECT_EQ(shapeOfClusters(referenceScenario(a)), ClusterShape::OrientedBox);
}

TEST(AccuracySettings, BirthsTakenTogetherAreAMatterOfMethod) {
    Scenario scenario;
    scenario.fragments.birthWindow = 0.2;
    const auto settings = sweep({}, {{"birth_window", {"0", "0.1"}}}, scenario);
    ASSERT_EQ(settings.size(), 3u);
    EXPECT_EQ(settings[0].scenario.fragments.birthWindow, 0.0);
    EXPECT_EQ(settings[1].scenario.fragments.birthWindow, 0.1);
    EXPECT_EQ(settings[2].scenario.fragments.birthWindow, 0.0) << "the paper takes each state by itself";
}

TEST(AccuracySettings, RefusesWhatNoReferenceHoldsForAndWhatIsNoValue) {
    for (const char* key : {"gravity", "density", "settle_time", "seed", "status_variable", "nonsense"}) {
        EXPECT_THROW(sweep({}, {{key, {"1", "2"}}}), UsageError) << key;
    }
    EXPECT_THROW(sweep({"-1"}, {}), UsageError);
    EXPECT_THROW(sweep({"2", "2"}, {}), UsageError) << "a value twice";
    EXPECT_THROW(sweep({}, {{"step_rate", {"60"}}, {"step_rate", {"120"}}}), UsageError) << "a key twice";
    EXPECT_THROW(sweep({}, {{"step_rate", {}}}), UsageError);
    EXPECT_THROW(sweep({}, {{"step_rate", {""}}}), UsageError);
    std::vector<std::string> many;
    for (int i = 0; i < 1001; ++i) {
        many.push_back(std::to_string(60 + i));
    }
    EXPECT_THROW(sweep({}, {{"step_rate", many}}), UsageError);
}

}  // namespace
}  // namespace rubble
