#include "core/pipeline/pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/pipeline/stage_reports.h"
#include "core/scenario/parameters.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

std::string keyFor(const Parameter& row) {
    return row.keyFor(row.subject() == ParameterSubject::Pair ? "stone,soil" : "wall");
}

/// A legal value near the default that a run still works with.
ParameterValue changed(const Parameter& row, const Scenario& scenario) {
    const ParameterValue now = parameterValue(scenario, keyFor(row));
    switch (row.kind) {
        case ParameterKind::Switch:
            return !(std::holds_alternative<bool>(now) ? std::get<bool>(now) : true);
        case ParameterKind::Integer:
            return std::holds_alternative<std::int64_t>(now) ? std::get<std::int64_t>(now) + 1 : std::int64_t{1};
        case ParameterKind::Number: {
            const double value =
                std::holds_alternative<double>(now) ? std::get<double>(now) : std::clamp(1.9, 1.2 * row.low, row.high);
            return value * 0.9 + 0.007 >= row.low ? value * 0.9 + 0.007 : value * 1.1;
        }
        case ParameterKind::Choice:
            return std::string(now == ParameterValue(std::string(row.choices.front())) ? row.choices.back() : row.choices.front());
        case ParameterKind::Text:
            return std::string("other");
    }
    return now;
}

class Pipeline : public testing::Test {
protected:
    Inputs inputs{scenes::collapsingWall(), {}};
    Execution execution;
    Scenario scenario;

    void SetUp() override { scenario.simulation.settleTime = 0.2; }
    Results runTo(Stage last, const Results& previous = {}) {
        MemoryTrajectory sink;
        return run(inputs, scenario, last, previous, &sink, execution);
    }
};

TEST_F(Pipeline, StopsAtTheStageAskedFor) {
    for (int i = 0; i < stageCount; ++i) {
        const Results results = runTo(static_cast<Stage>(i));
        for (int j = 0; j < stageCount; ++j) {
            EXPECT_EQ(results.has(static_cast<Stage>(j)), j <= i) << i << " " << j;
        }
    }
}

TEST_F(Pipeline, ReusesEverythingWhenNothingChanged) {
    const Results first = runTo(Stage::Simulation);
    const Results second = runTo(Stage::Simulation, first);
    EXPECT_EQ(first.components, second.components);
    EXPECT_EQ(first.simulation, second.simulation);
    EXPECT_EQ(first.keys, second.keys);
    EXPECT_EQ(first.wallSeconds, second.wallSeconds);
}

TEST_F(Pipeline, EachPartIsReportedAsItIsMadeOrReused) {
    std::vector<Stage> begun;
    std::vector<Stage> made;
    StageObserver observer;
    observer.begins = [&](Stage stage) { begun.push_back(stage); };
    observer.made = [&](Stage stage, const Results& results) {
        made.push_back(stage);
        EXPECT_EQ(begun, made) << "a stage begins once the one before is made";
        for (int i = 0; i < stageCount; ++i) {
            EXPECT_EQ(results.has(static_cast<Stage>(i)), i <= static_cast<int>(stage)) << i;
        }
        EXPECT_EQ(results.keys[static_cast<std::size_t>(stage)], stageKey(inputs, scenario, stage));
    };
    const Results first = run(inputs, scenario, Stage::Clusters, {}, nullptr, execution, nullptr, observer);
    EXPECT_EQ(made, (std::vector<Stage>{Stage::Components, Stage::Fragments, Stage::Sizing, Stage::Clusters}));
    begun.clear();
    made.clear();
    MemoryTrajectory sink;
    const Results second = run(inputs, scenario, Stage::Simulation, first, &sink, execution, nullptr, observer);
    EXPECT_EQ(made.size(), 5u);
    EXPECT_EQ(second.clustering, first.clustering) << "reported, but not made again";
}

TEST_F(Pipeline, FindingsOfAllPartsStandInTheOrderDataFlows) {
    const Results results = runTo(Stage::Simulation);
    Findings expected = results.components->findings;
    expected.append(results.fragments->findings);
    expected.append(results.sizing->findings);
    expected.append(results.clustering->findings);
    expected.append(results.simulation->findings);
    const Findings found = stageFindings(results);
    ASSERT_EQ(found.list().size(), expected.list().size());
    for (std::size_t i = 0; i < expected.list().size(); ++i) {
        EXPECT_EQ(found.list()[i].what.id, expected.list()[i].what.id);
        EXPECT_EQ(found.list()[i].count, expected.list()[i].count);
    }
    EXPECT_TRUE(stageFindings(Results()).empty());
}

TEST_F(Pipeline, EveryParameterDropsItsStageAndAllLaterOnes) {
    const Results before = runTo(Stage::Clusters);
    const Scenario original = scenario;
    for (const Parameter& row : parameterTable()) {
        if (row.kind == ParameterKind::Choice && row.choices.size() == 1) {
            continue;  // has no other value
        }
        SCOPED_TRACE(row.key);
        scenario = original;
        setParameter(scenario, keyFor(row), changed(row, scenario));
        for (int i = 0; i < stageCount; ++i) {
            const Stage stage = static_cast<Stage>(i);
            EXPECT_EQ(stageKey(inputs, scenario, stage) == stageKey(inputs, original, stage), stage < row.stage);
        }
        const Results after = runTo(Stage::Clusters, before);
        EXPECT_EQ(before.components == after.components, row.stage > Stage::Components);
        EXPECT_EQ(before.fragments == after.fragments, row.stage > Stage::Fragments);
        EXPECT_EQ(before.sizing == after.sizing, row.stage > Stage::Sizing);
        EXPECT_EQ(before.clustering == after.clustering, row.stage > Stage::Clusters);
    }
}

TEST_F(Pipeline, AnotherFileDropsEverything) {
    const Results first = runTo(Stage::Clusters);
    inputs.fe = scenes::collapsingWall(5, 3);
    const Results second = runTo(Stage::Clusters, first);
    for (int i = 0; i < stageCount - 1; ++i) {
        EXPECT_NE(first.keys[static_cast<std::size_t>(i)], second.keys[static_cast<std::size_t>(i)]);
    }
    EXPECT_NE(first.fragments, second.fragments);
}

TEST_F(Pipeline, IsPure) {
    const Results a = runTo(Stage::Simulation);
    const Results b = runTo(Stage::Simulation);
    EXPECT_EQ(a.keys, b.keys);
    EXPECT_EQ(a.simulation->trajectoryHash, b.simulation->trajectoryHash);
    EXPECT_EQ(a.fragments->size(), 12u);
}

TEST_F(Pipeline, CancelLeavesByTheCancelledException) {
    execution.cancel();
    EXPECT_THROW(runTo(Stage::Components), Cancelled);
}

TEST_F(Pipeline, ATerrainDropsTheSimulationOnlyAndTakesPartInIt) {
    const Results level = runTo(Stage::Simulation);
    inputs.terrain = std::make_shared<const TerrainGrid>(-50.0, -50.0, 100.0, 2, 2, std::vector<double>(4, -2.0));
    const Results lower = runTo(Stage::Simulation, level);
    EXPECT_EQ(lower.clustering, level.clustering);
    EXPECT_NE(lower.simulation, level.simulation);
    EXPECT_NE(lower.simulation->trajectoryHash, level.simulation->trajectoryHash);
    // Heights are what counts, not the object that holds them.
    inputs.terrain = std::make_shared<const TerrainGrid>(-50.0, -50.0, 100.0, 2, 2, std::vector<double>(4, -2.0));
    EXPECT_EQ(runTo(Stage::Simulation, lower).simulation, lower.simulation);
    scenario.effects.of(EffectKind::Terrain) = EffectSwitch::Off;
    EXPECT_EQ(runTo(Stage::Simulation, lower).simulation->trajectoryHash, level.simulation->trajectoryHash);
}

}  // namespace
}  // namespace rubble
