#include "core/scenario/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/simulation/effects/decisions.h"

namespace rubble {
namespace {

std::string keyFor(const Parameter& row) {
    return row.keyFor(row.subject() == ParameterSubject::Pair ? "stone,soil" : "arch ring 1");
}

/// A legal value that differs from the current one.
ParameterValue otherValue(const Parameter& row, const ParameterValue& current) {
    switch (row.kind) {
        case ParameterKind::Switch:
            return !(std::holds_alternative<bool>(current) && std::get<bool>(current));
        case ParameterKind::Integer: {
            const std::int64_t low = static_cast<std::int64_t>(row.low);
            return std::holds_alternative<std::int64_t>(current) && std::get<std::int64_t>(current) == low ? low + 1 : low;
        }
        case ParameterKind::Number:
            return std::holds_alternative<double>(current) && std::get<double>(current) == row.low ? row.high : row.low;
        case ParameterKind::Choice:
            return std::string(current == ParameterValue(std::string(row.choices.back())) ? row.choices.front()
                                                                                          : row.choices.back());
        case ParameterKind::Text:
            return std::string("OTHER");
    }
    return {};
}

TEST(Parameters, EveryRowIsDocumentedAndUnique) {
    std::set<std::string_view> keys;
    for (const Parameter& row : parameterTable()) {
        EXPECT_TRUE(keys.insert(row.key).second) << row.key;
        EXPECT_FALSE(row.label.empty()) << row.key;
        EXPECT_TRUE(row.help.ends_with(".")) << row.key;
        EXPECT_LE(row.low, row.high) << row.key;
        EXPECT_EQ(row.kind == ParameterKind::Choice, !row.choices.empty()) << row.key;
        if (row.kind == ParameterKind::Number || row.kind == ParameterKind::Integer) {
            EXPECT_TRUE(std::isfinite(row.low) && std::isfinite(row.high)) << row.key;
        }
    }
}

TEST(Parameters, RowsStandInTheOrderOfTheStages) {
    Stage last = Stage::Import;
    for (const Parameter& row : parameterTable()) {
        EXPECT_LE(last, row.stage) << row.key;
        last = row.stage;
    }
}

TEST(Parameters, EveryRowDropsItsOwnStageFirst) {
    for (const Parameter& row : parameterTable()) {
        const Scenario before;
        Scenario after;
        setParameter(after, keyFor(row), otherValue(row, parameterValue(before, keyFor(row))));
        const auto stale = firstStale(before, after);
        // A choice of one has no other value.
        if (row.kind == ParameterKind::Choice && row.choices.size() == 1) {
            EXPECT_FALSE(stale) << row.key;
            continue;
        }
        ASSERT_TRUE(stale) << row.key;
        EXPECT_EQ(*stale, row.stage) << row.key;
        for (int i = 0; i < stageCount; ++i) {
            const Stage stage = static_cast<Stage>(i);
            EXPECT_EQ(scenarioSlice(before, stage) != scenarioSlice(after, stage), stage == row.stage) << row.key;
        }
    }
}

TEST(Parameters, EveryValueSurvivesTheWayThroughText) {
    for (const Parameter& row : parameterTable()) {
        Scenario written;
        const ParameterValue defaultValue = parameterValue(written, keyFor(row));
        setParameter(written, keyFor(row), otherValue(row, defaultValue));
        Scenario read;
        setParameterText(read, keyFor(row), valueText(parameterValue(written, keyFor(row))));
        EXPECT_EQ(read, written) << row.key;
        setParameterText(read, keyFor(row), valueText(defaultValue));
        EXPECT_EQ(read, Scenario()) << row.key;
    }
}

TEST(Parameters, DefaultsLieWithinTheirRange) {
    for (const Parameter& row : parameterTable()) {
        Scenario scenario;
        EXPECT_NO_THROW(setParameter(scenario, keyFor(row), parameterValue(scenario, keyFor(row)))) << row.key;
        EXPECT_EQ(scenario, Scenario()) << row.key;
    }
}

TEST(Parameters, RefusesWhatIsOutOfRangeAndChangesNothing) {
    for (const Parameter& row : parameterTable()) {
        if (row.kind == ParameterKind::Text) {
            continue;
        }
        for (const std::string text : {"nan", "1e999", "", "xx", "-1e300", "12abc", "inf", " 1"}) {
            Scenario scenario;
            EXPECT_THROW(setParameterText(scenario, keyFor(row), text), UsageError) << row.key << "=" << text;
            EXPECT_EQ(scenario, Scenario()) << row.key << "=" << text;
        }
    }
}

TEST(Parameters, NumbersMayBeFollowedByTheirUnit) {
    Scenario scenario;
    setParameterText(scenario, "ground_height", "2 m");
    EXPECT_EQ(scenario.simulation.groundHeight, 2.0);
    setParameterText(scenario, "ground_height", "3  m");
    EXPECT_EQ(scenario.simulation.groundHeight, 3.0);
    for (const char* text : {"2 ft", "2 ", " 2", "2 m m", "m 2"}) {
        EXPECT_THROW(setParameterText(scenario, "ground_height", text), UsageError) << text;
    }
    // A number without unit takes none.
    EXPECT_THROW(setParameterText(scenario, "multiple", "2 m"), UsageError);
    EXPECT_EQ(scenario.simulation.groundHeight, 3.0);
}

TEST(Parameters, NamesNearKeysForATypo) {
    Scenario scenario;
    try {
        setParameterText(scenario, "bodies_maxx", "5");
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("bodies_max"), std::string::npos) << error.what();
    }
    EXPECT_THROW(findParameter("component.density"), UsageError);
    EXPECT_THROW(findParameter("component[].density"), UsageError);
    EXPECT_THROW(findParameter("multiple[x]"), UsageError);
}

TEST(Parameters, KeyedRowsKeepOddNamesAndVanishWhenAutomatic) {
    Scenario scenario;
    setParameterText(scenario, "component[deck [west].1].density", "2500");
    ASSERT_EQ(scenario.components.count("deck [west].1"), 1u);
    EXPECT_EQ(valueText(parameterValue(scenario, "component[deck [west].1].density")), "2500");
    setParameterText(scenario, "component[deck [west].1].density", "auto");
    EXPECT_EQ(scenario, Scenario());
}

TEST(Parameters, PairsOfMaterialsAreKeyedInEitherOrder) {
    Scenario scenario;
    setParameterText(scenario, "pair[soil, stone].friction", "0.4");
    EXPECT_EQ(scenario.effects.pairs.of(Material::Stone, Material::Soil).friction, 0.4);
    EXPECT_EQ(valueText(parameterValue(scenario, "pair[stone,soil].friction")), "0.4");
    EXPECT_EQ(findParameter("pair[water_bed,steel].restitution").second, "steel,water_bed");
    const Parameter& row = *findParameter("pair[stone,soil].friction").first;
    EXPECT_EQ(row.subjectsIn(scenario), std::vector<std::string>{"stone,soil"});
    EXPECT_EQ(row.keyFor("stone,soil"), "pair[stone,soil].friction");
    setParameterText(scenario, "pair[stone,soil].friction", "auto");
    EXPECT_EQ(scenario, Scenario());
}

TEST(Parameters, UnknownMaterialsNameTheNearest) {
    Scenario scenario;
    try {
        setParameterText(scenario, "pair[stone,siol].friction", "0.5");
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("siol"), std::string::npos) << error.what();
        EXPECT_NE(englishText(error.remedy()).find("\"soil\""), std::string::npos) << englishText(error.remedy());
    }
    // Bodies are never of soil: such a number would do nothing.
    for (const char* key :
         {"pair[soil,water_bed].friction", "pair[stone].friction", "pair[,].friction", "pair[stone,soil,steel].friction"}) {
        EXPECT_THROW(setParameterText(scenario, key, "0.5"), UsageError) << key;
    }
    EXPECT_THROW(setParameterText(scenario, "component[a].material", "soil"), UsageError);
    EXPECT_EQ(scenario, Scenario());
}

TEST(Parameters, EffectsAreOffOnOrAutoAndUnderstandSwitches) {
    Scenario scenario;
    for (std::size_t i = 0; i < effectCount; ++i) {
        const auto kind = static_cast<EffectKind>(i);
        const std::string key(effectName(kind));
        for (const auto& [text, state] :
             {std::pair("true", EffectSwitch::On), std::pair("off", EffectSwitch::Off), std::pair("on", EffectSwitch::On),
              std::pair("no", EffectSwitch::Off), std::pair("auto", EffectSwitch::Auto)}) {
            setParameterText(scenario, key, text);
            EXPECT_EQ(scenario.effects.of(kind), state) << key << "=" << text;
        }
    }
    EXPECT_EQ(scenario, Scenario());
}

TEST(Parameters, PaperPresetIsThePublishedMethod) {
    Scenario scenario;
    scenario.simulation.friction = 0.77;
    setParameterText(scenario, "preset", "paper");
    EXPECT_EQ(scenario.fragments.birthVelocity, BirthVelocity::Rest);
    EXPECT_EQ(scenario.grid.velocityTolerance, 0.0);
    EXPECT_EQ(scenario.simulation.shape, ClusterShape::AxisBox);
    EXPECT_EQ(scenario.simulation.boxBulking, 1000.0);
    EXPECT_EQ(scenario.simulation.pieces, PieceKind::ComponentBox);
    EXPECT_FALSE(scenario.simulation.freeze);
    EXPECT_EQ(scenario.simulation.friction, 0.77);
    EXPECT_EQ(scenario.simulation.solver, SolverKind::Bullet);
    EXPECT_EQ(scenario.effects.islands, LiveIslandPolicy::Held);
    for (const EffectKind kind :
         {EffectKind::Terrain, EffectKind::Water, EffectKind::AirDrag, EffectKind::Ties, EffectKind::BreakUp}) {
        EXPECT_EQ(scenario.effects.of(kind), EffectSwitch::Off) << effectName(kind);
    }
    EXPECT_EQ(scenario.effects.of(EffectKind::FragmentContact), EffectSwitch::Auto);
    setParameterText(scenario, "preset", "reference");
    EXPECT_TRUE(scenario.grid.oneBodyPerFragment);
    EXPECT_TRUE(scenario.simulation.freeze);
    setParameterText(scenario, "preset", "default");
    scenario.simulation.friction = Scenario().simulation.friction;
    EXPECT_EQ(scenario, Scenario());
    EXPECT_THROW(setParameterText(scenario, "preset", "nobody"), UsageError);
}

TEST(Scenario, RegroupingBelongsToTheComponentsStage) {
    const std::vector<RegroupStep> steps{SplitByConnectivity{"a"},         SplitByConnectivity{"b"},
                                         SplitByBox{"a", {}, {}, "b"},     SplitByPlane{"a", {}, Vec3::UnitX(), "b"},
                                         MergeComponents{{"a", "b"}, "c"}, MergeComponents{{"a"}, "c"},
                                         RenameComponent{"a", "b"},        RenameComponent{"b", "a"}};
    std::set<Digest> digests;
    for (const RegroupStep& step : steps) {
        Scenario scenario;
        scenario.regrouping = {step};
        EXPECT_EQ(firstStale(Scenario(), scenario), Stage::Components);
        EXPECT_TRUE(digests.insert(scenarioSlice(scenario, Stage::Components)).second);
    }
}

}  // namespace
}  // namespace rubble
