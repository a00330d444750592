#include "core/analysis/accuracy/influence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/standard_gravity.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

const EffectInfluence& rowOf(const InfluenceReport& report, EffectKind kind) {
    const auto found = std::find_if(report.effects.begin(), report.effects.end(),
                                    [&](const EffectInfluence& row) { return row.decision.kind == kind; });
    EXPECT_NE(found, report.effects.end());
    return *found;
}

/// Sixty cubes of 1 m that die together 6 m above the ground with 4 m/s along y, each a body, over water 4 m deep.
class Influence : public testing::Test {
protected:
    void SetUp() override {
        deck.name = "deck";
        deck.low = Vec3(0, 0, 6);
        deck.size = Vec3(10, 3, 2);
        deck.cells = {10, 3, 2};
        deck.velocity = Vec3(0, 4, 0);
        deck.gravity = standardGravity;
        deck.deathState = [](std::size_t) { return std::size_t{1}; };
        inputs.fe = scenes::makeScene({deck}, 3, 0.1);
        scenario.grid.oneBodyPerFragment = true;
        scenario.simulation.settleTime = 3.0;
        scenario.effects.waterLevel = 4.0;
    }
    InfluenceReport report(const std::vector<EffectKind>& effects, int threads = 2,
                           const Execution& execution = Execution()) const {
        StudySettings settings;
        settings.threads = threads;
        settings.repeats = repeats;
        return influence(inputs, scenario, effects, settings, execution);
    }
    scenes::Block deck;
    Inputs inputs;
    Scenario scenario;
    int repeats = 2;
};

TEST_F(Influence, SaysWhatMattersAndWhatDoesNot) {
    const InfluenceReport found = report({EffectKind::Water, EffectKind::StructureContact, EffectKind::Ties, EffectKind::Terrain});
    EXPECT_TRUE(found.complete);
    ASSERT_EQ(found.effects.size(), 4u);
    ASSERT_TRUE(found.floor);
    EXPECT_EQ(found.floor->repeats.size(), 2u);

    const EffectInfluence& water = rowOf(found, EffectKind::Water);
    EXPECT_TRUE(water.decision.on);
    EXPECT_TRUE(water.done);
    // Water takes most of 4 m/s from blocks that sink 4 m: they come down half a metre from where they would, and the repeats
    // differ by centimetres.
    EXPECT_EQ(water.standing(), Standing::Above);
    EXPECT_GT(water.overFloor[static_cast<std::size_t>(Measure::MedianDistance)], 2.0);
    EXPECT_GT(water.difference.of(Measure::MassMap), 0.05);
    EXPECT_NE(water.trajectoryHash, found.floor->trajectoryHash);

    const EffectInfluence& structure = rowOf(found, EffectKind::StructureContact);
    EXPECT_FALSE(structure.decision.on) << "nothing of the structure is left";
    EXPECT_TRUE(structure.done);
    EXPECT_EQ(structure.standing(), Standing::Identical);
    EXPECT_EQ(structure.trajectoryHash, found.floor->trajectoryHash);
    EXPECT_EQ(structure.difference.of(Measure::MassMap), 0.0);

    for (const EffectKind kind : {EffectKind::Ties, EffectKind::Terrain}) {
        const EffectInfluence& none = rowOf(found, kind);
        EXPECT_FALSE(none.switchable);
        EXPECT_FALSE(none.done);
        EXPECT_FALSE(none.reason.empty());
    }
    EXPECT_NE(englishText(rowOf(found, EffectKind::Ties).reason).find("reinforced"), std::string::npos);
}

TEST_F(Influence, AnEffectThatPilesHideStaysNearTheFloor) {
    scenario.effects.waterLevel.reset();
    // Sixty cubes scatter much from repeat to repeat.
    repeats = 8;
    const InfluenceReport found = report({EffectKind::AirDrag, EffectKind::FragmentContact, EffectKind::Water});
    const EffectInfluence& drag = rowOf(found, EffectKind::AirDrag);
    EXPECT_FALSE(drag.decision.on);
    ASSERT_TRUE(drag.done);
    // Cubes of 2 t fall 8 m: drag changes their landing by 2 mm, less than blocks that hit each other differ from repeat to repeat.
    // Two draws of that chance differ by less than 3 times; contact shifts the height of the mass by 8 times as much.
    const auto overFloor = [](const EffectInfluence& row, Measure measure) {
        return row.overFloor[static_cast<std::size_t>(measure)];
    };
    EXPECT_LT(overFloor(drag, Measure::MassMap), 3.0);
    EXPECT_GT(overFloor(drag, Measure::MassMap), 0.0);
    const EffectInfluence& contact = rowOf(found, EffectKind::FragmentContact);
    ASSERT_TRUE(contact.done);
    EXPECT_EQ(contact.standing(), Standing::Above);
    EXPECT_GT(contact.difference.of(Measure::MeanHeight), 0.1) << "with contact the upper layer lies on the lower one";
    EXPECT_GT(overFloor(contact, Measure::MeanHeight), 2.0);
    EXPECT_GT(overFloor(contact, Measure::MeanHeight), overFloor(drag, Measure::MeanHeight));
    EXPECT_FALSE(rowOf(found, EffectKind::Water).switchable) << "no level is given";
}

TEST_F(Influence, DoesNotDependOnTheNumberOfThreads) {
    const std::vector<EffectKind> effects{EffectKind::Water, EffectKind::AirDrag};
    const InfluenceReport one = report(effects, 1);
    const InfluenceReport four = report(effects, 4);
    ASSERT_EQ(one.effects.size(), four.effects.size());
    EXPECT_EQ(one.floor->largest.values, four.floor->largest.values);
    for (std::size_t k = 0; k < one.effects.size(); ++k) {
        EXPECT_EQ(one.effects[k].trajectoryHash, four.effects[k].trajectoryHash);
        EXPECT_EQ(one.effects[k].difference.values, four.effects[k].difference.values);
        EXPECT_EQ(one.effects[k].standings, four.effects[k].standings);
    }
}

// What is reported is the difference of the two runs that a user would make by hand.
TEST_F(Influence, IsTheDifferenceOfTwoRuns) {
    const InfluenceReport found = report({EffectKind::Water});
    const auto fieldOf = [&](EffectSwitch water) {
        Scenario one = scenario;
        one.effects.of(EffectKind::Water) = water;
        DebrisRecorder sink;
        const Results results = run(inputs, one, Stage::Simulation, {}, &sink, Execution());
        return measureDebris(sink.debris(DebrisInstant::AtRest), CollapsePlan(*results.fragments, inputs.fe->mesh()), {}, {});
    };
    const DebrisDifference byHand = compareDebris(fieldOf(EffectSwitch::Off), fieldOf(EffectSwitch::On));
    EXPECT_EQ(byHand.values, rowOf(found, EffectKind::Water).difference.values);
}

TEST_F(Influence, WithoutNamesItListsEveryEffect) {
    scenario.simulation.settleTime = 0.1;
    const InfluenceReport found = report({});
    ASSERT_EQ(found.effects.size(), effectCount);
    for (std::size_t k = 0; k < effectCount; ++k) {
        const EffectInfluence& row = found.effects[k];
        EXPECT_EQ(static_cast<std::size_t>(row.decision.kind), k);
        EXPECT_EQ(row.done, row.switchable) << effectName(row.decision.kind);
        EXPECT_EQ(row.reason.empty(), row.switchable) << effectName(row.decision.kind);
        EXPECT_FALSE(row.decision.reason.empty());
    }
}

TEST_F(Influence, AfterACancelItReportsWhatIsDone) {
    // Five worlds, taken in order by one thread: the run, two repeats, the structure switched off, water switched on. In the first
    // four all comes to rest on the ground; in the last it floats down the river for an hour that nobody waits for, so that the
    // cancel finds four worlds done and one under way however fast the machine is and however seldom progress is told.
    deck.density = 500.0;
    inputs.fe = scenes::makeScene({deck}, 3, 0.1);
    scenario.effects.currentX = 2.0;
    scenario.effects.of(EffectKind::Water) = EffectSwitch::Off;
    scenario.simulation.settleTime = 3600.0;
    const Execution execution([&](const Progress& progress) {
        if (progress.stage.id == "analysis.influence" && progress.fraction >= 4.0 / 5.0) {
            execution.cancel();
        }
    });
    const InfluenceReport partial = report({EffectKind::StructureContact, EffectKind::Water}, 1, execution);
    EXPECT_FALSE(partial.complete);
    ASSERT_TRUE(partial.floor);
    EXPECT_EQ(partial.floor->repeats.size(), 2u);
    ASSERT_EQ(partial.effects.size(), 2u);
    EXPECT_TRUE(partial.effects[0].done);
    EXPECT_EQ(partial.effects[0].standing(), Standing::Identical);
    EXPECT_TRUE(partial.effects[1].switchable);
    EXPECT_FALSE(partial.effects[1].done);
    const Execution early;
    early.cancel();
    const InfluenceReport nothing = report({EffectKind::Water}, 1, early);
    EXPECT_FALSE(nothing.complete);
    EXPECT_FALSE(nothing.floor);
}

TEST_F(Influence, TakesTwoRepeatsAtLeast) {
    StudySettings settings;
    settings.repeats = 1;
    EXPECT_THROW(influence(inputs, scenario, {}, settings, Execution()), UsageError);
}

TEST(Standing, IsHeldAgainstTheFloor) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(standingOf(0.0, 0.0), Standing::Below);
    EXPECT_EQ(standingOf(0.1, 0.1), Standing::Below);
    EXPECT_EQ(standingOf(0.2, 0.1), Standing::Near);
    EXPECT_EQ(standingOf(0.21, 0.1), Standing::Above);
    EXPECT_EQ(standingOf(1e-9, 0.0), Standing::Above);
    EXPECT_EQ(standingOf(nan, 0.1), Standing::Undefined);
    EXPECT_EQ(standingOf(0.1, nan), Standing::Undefined);
}

TEST(Standing, OfAnEffectIsTheMostOfItsMeasures) {
    EffectInfluence row;
    EXPECT_EQ(row.standing(), Standing::Identical);
    row.standings[3] = Standing::Near;
    row.standings[4] = Standing::Below;
    row.standings[5] = Standing::Undefined;
    EXPECT_EQ(row.standing(), Standing::Near);
}

}  // namespace
}  // namespace rubble
