#include "core/simulation/effects/decisions.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/pipeline/pipeline.h"
#include "core/simulation/effects/box_tree.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

using scenes::Block;

/// A scene up to its clusters, and what is decided about it.
struct Scene {
    std::vector<Block> blocks;
    Scenario scenario;
    std::shared_ptr<const TerrainGrid> terrain;
    std::size_t states = 6;

    EffectDecisions decisions() const {
        const Inputs inputs{scenes::makeScene(blocks, states, 0.1), {}};
        const Results r = run(inputs, scenario, Stage::Clusters, {}, nullptr, Execution());
        return decideEffects({*inputs.fe, *r.components, *r.fragments, *r.clustering, terrain.get(), scenario});
    }
    EffectDecision of(EffectKind kind) const {
        const EffectDecision decision = decisions()[static_cast<std::size_t>(kind)];
        EXPECT_EQ(decision.kind, kind);
        EXPECT_FALSE(decision.reason.empty());
        return decision;
    }
    bool on(EffectKind kind) const { return of(kind).on; }
};

Block block(const std::string& name, const Vec3& low, const Vec3& size, std::size_t dies = scenes::never) {
    Block made;
    made.name = name;
    made.low = low;
    made.size = size;
    made.deathState = [dies](std::size_t) { return dies; };
    return made;
}

/// One cube of 1 m that stands still until it dies at state 3, its lower side 10 m above the ground.
Scene oneCube() {
    return {{block("cube", {0, 0, 10}, {1, 1, 1}, 3)}, {}, nullptr};
}

std::shared_ptr<const TerrainGrid> levelTerrain(double x0, double height) {
    return std::make_shared<TerrainGrid>(x0, -5.0, 10.0, 2, 2, std::vector<double>(4, height));
}

TEST(EffectNames, AreTheKeysOfTheirSwitches) {
    for (std::size_t i = 0; i < effectCount; ++i) {
        EXPECT_EQ(effectName(static_cast<EffectKind>(i)).find(' '), std::string_view::npos);
    }
    EXPECT_EQ(effectName(EffectKind::Ground), "ground");
    EXPECT_EQ(effectName(EffectKind::BreakUp), "break_up");
}

TEST(Decisions, AUserSetStateSaysWhatAutoWouldHaveSaid) {
    Scene scene = oneCube();
    scene.scenario.effects.of(EffectKind::AirDrag) = EffectSwitch::On;
    scene.scenario.effects.of(EffectKind::Water) = EffectSwitch::On;
    scene.scenario.effects.of(EffectKind::FragmentContact) = EffectSwitch::Off;
    const EffectDecision drag = scene.of(EffectKind::AirDrag), water = scene.of(EffectKind::Water);
    Scene bottomless = oneCube();
    bottomless.scenario.effects.of(EffectKind::Ground) = EffectSwitch::Off;
    const EffectDecision ground = bottomless.of(EffectKind::Ground);
    EXPECT_FALSE(ground.on);
    EXPECT_EQ(englishText(ground.reason).rfind("set off; auto would be on: level ground at 0 m", 0), 0u)
        << englishText(ground.reason);
    EXPECT_TRUE(drag.on);
    EXPECT_EQ(englishText(drag.reason).rfind("set on; auto would be off: no fragment weighs less than", 0), 0u)
        << englishText(drag.reason);
    EXPECT_FALSE(water.on) << "there is no water to switch on";
    EXPECT_EQ(englishText(water.reason).rfind("set on, but cannot be: ", 0), 0u) << englishText(water.reason);
    EXPECT_EQ(englishText(scene.of(EffectKind::FragmentContact).reason).rfind("set off, as auto would: ", 0), 0u);
}

TEST(Decisions, GroundIsOnUnlessTerrainTakesItsPlace) {
    Scene scene = oneCube();
    EXPECT_TRUE(scene.on(EffectKind::Ground));
    EXPECT_FALSE(scene.on(EffectKind::Terrain));
    scene.terrain = levelTerrain(-5.0, 2.0);
    EXPECT_FALSE(scene.on(EffectKind::Ground));
    EXPECT_TRUE(scene.on(EffectKind::Terrain));
    scene.scenario.effects.of(EffectKind::Ground) = EffectSwitch::On;
    EXPECT_FALSE(scene.on(EffectKind::Ground)) << "there is no place for both";
    scene.scenario.effects.of(EffectKind::Terrain) = EffectSwitch::Off;
    EXPECT_TRUE(scene.on(EffectKind::Ground));
}

TEST(Decisions, TerrainIsOnIfItLiesUnderTheReach) {
    // At rest, the cube can reach its own column only: x from 0 to 1.
    Scene scene = oneCube();
    scene.terrain = levelTerrain(0.999, 2.0);
    EXPECT_TRUE(scene.on(EffectKind::Terrain));
    scene.terrain = levelTerrain(1.001, 2.0);
    EXPECT_FALSE(scene.on(EffectKind::Terrain));
    EXPECT_NEAR(scene.of(EffectKind::Terrain).measure, 0.001, 1e-9);
    scene.terrain = levelTerrain(-5.0, 10.999);
    EXPECT_TRUE(scene.on(EffectKind::Terrain));
    scene.terrain = levelTerrain(-5.0, 11.001);
    EXPECT_FALSE(scene.on(EffectKind::Terrain));
}

TEST(Decisions, StructureContactIsOnIfActiveStructureLiesWithinReach) {
    const auto withTower = [](double x, std::size_t dies, double height = 20.0) {
        Scene scene = oneCube();
        scene.blocks.push_back(block("tower", {x, 0, 0}, {1, 1, height}, dies));
        scene.scenario.fragments.birthWindow = 0.0;
        return scene;
    };
    EXPECT_TRUE(withTower(0.99, scenes::never).on(EffectKind::StructureContact));
    EXPECT_FALSE(withTower(1.0, scenes::never).on(EffectKind::StructureContact)) << "it only touches";
    const EffectDecision apart = withTower(1.5, scenes::never).of(EffectKind::StructureContact);
    EXPECT_FALSE(apart.on);
    EXPECT_NEAR(apart.measure, 0.5, 1e-9);
    // A low wall below the cube: still there when the cube is handed over at state 2, or gone by then.
    EXPECT_TRUE(withTower(0.0, 5, 2.0).on(EffectKind::StructureContact));
    EXPECT_TRUE(withTower(0.0, 4, 2.0).on(EffectKind::StructureContact));
    EXPECT_FALSE(withTower(0.0, 3, 2.0).on(EffectKind::StructureContact)) << "handed over together";
    EXPECT_FALSE(withTower(0.0, 1, 2.0).on(EffectKind::StructureContact));
    Scene together = withTower(0.0, 4, 2.0);
    together.scenario.fragments.birthWindow = 0.1;
    EXPECT_FALSE(together.on(EffectKind::StructureContact)) << "handed over together by the window";
}

TEST(Decisions, SidewaysSpeedWidensTheReach) {
    // v / g sqrt(v^2 + 2 g h) with the centre h = 10.5 m up and v = 2 m/s.
    const double reach = 2.0 / standardGravity * std::sqrt(4.0 + 2.0 * standardGravity * 10.5);
    for (const double past : {-0.01, 0.01}) {
        Scene scene = oneCube();
        scene.scenario.effects.loose = LooseStructurePolicy::Fe;
        scene.blocks[0].velocity = {0, 2, 0};
        scene.blocks.push_back(block("tower", {1.0 + reach + past, 0, 0}, {1, 1, 20}));
        EXPECT_EQ(scene.on(EffectKind::StructureContact), past < 0.0) << past;
    }
}

TEST(Decisions, WithoutPiecesThereIsNoContactWithTheStructure) {
    Scene scene = oneCube();
    scene.blocks.push_back(block("tower", {0.5, 0, 0}, {1, 1, 9}));
    scene.scenario.simulation.pieces = PieceKind::None;
    scene.scenario.effects.of(EffectKind::StructureContact) = EffectSwitch::On;
    EXPECT_FALSE(scene.on(EffectKind::StructureContact));
}

TEST(Decisions, FragmentContactIsOffOnlyIfNoTwoColumnsOverlap) {
    const auto withSecond = [](double x) {
        Scene scene = oneCube();
        scene.blocks.push_back(block("second", {x, 0, 3}, {1, 1, 1}, 5));
        return scene;
    };
    EXPECT_FALSE(oneCube().on(EffectKind::FragmentContact)) << "alone";
    EXPECT_TRUE(withSecond(0.99).on(EffectKind::FragmentContact));
    EXPECT_FALSE(withSecond(1.01).on(EffectKind::FragmentContact));
    EXPECT_NEAR(withSecond(1.25).of(EffectKind::FragmentContact).measure, 0.25, 1e-9);
}

TEST(Decisions, WaterIsOnIfItsLevelCanBeReached) {
    Scene scene = oneCube();
    EXPECT_FALSE(scene.on(EffectKind::Water));
    scene.scenario.effects.waterLevel = 0.001;
    EXPECT_TRUE(scene.on(EffectKind::Water));
    scene.scenario.effects.waterLevel = -0.001;
    EXPECT_FALSE(scene.on(EffectKind::Water));
    scene.scenario.simulation.groundHeight = -2.0;
    const EffectDecision deep = scene.of(EffectKind::Water);
    EXPECT_TRUE(deep.on);
    EXPECT_NEAR(deep.measure, 1.999, 1e-9);
}

TEST(Decisions, OnlyTheRiverUnderTheReachCounts) {
    // Heights fall from 3 m at x = -10 to -3 m at x = 50: 1.9 m at most under the cube, at x = 1.
    std::vector<double> heights;
    for (int j = 0; j <= 60; ++j) {
        for (int i = 0; i <= 60; ++i) {
            heights.push_back(3.0 - 0.1 * i);
        }
    }
    Scene scene = oneCube();
    scene.terrain = std::make_shared<TerrainGrid>(-10.0, -30.0, 1.0, 61, 61, heights);
    scene.scenario.effects.waterLevel = 1.89;
    EXPECT_FALSE(scene.on(EffectKind::Water));
    scene.scenario.effects.waterLevel = 1.91;
    EXPECT_TRUE(scene.on(EffectKind::Water));
}

TEST(Decisions, WhatLiesBeyondTheWindowCountsAsWell) {
    // Ground at -5 m about the structure, at -50 m beyond it.
    std::vector<double> heights;
    for (int j = -20; j <= 20; ++j) {
        for (int i = -20; i <= 20; ++i) {
            heights.push_back(std::max(std::abs(i), std::abs(j)) <= 10 ? -5.0 : -50.0);
        }
    }
    TerrainExtent extent;
    extent.column = extent.row = 10;
    extent.columns = extent.rows = 21;
    extent.x0 = extent.y0 = -10.0;
    Scene scene = oneCube();
    scene.terrain = std::make_shared<TerrainGrid>(HeightGrid{-20.0, -20.0, 1.0, 1.0, 41, 41, heights}, extent);
    const double beyond = scene.of(EffectKind::AirDrag).measure;
    const auto level = [&](double height) {
        scene.terrain = std::make_shared<TerrainGrid>(-20.0, -20.0, 1.0, 41, 41, std::vector<double>(41 * 41, height));
        return scene.of(EffectKind::AirDrag).measure;
    };
    EXPECT_DOUBLE_EQ(beyond, level(-50.0));
    EXPECT_LT(beyond, level(-5.0));
}

TEST(Decisions, AirDragIsOnBelowSeventeenTimesItsWeight) {
    // A plate of thickness t falling from rest by h: R = density t / (rho C_d h).
    const double t = 0.02, density = 2400.0;
    const double critical = density * t / (1.225 * 1.05 * 17.0);
    EXPECT_NEAR(critical, 2.2, 0.1) << "PHYSICS: on from about 2.3 m for stone";
    for (const double factor : {0.999, 1.001}) {
        Scene scene;
        scene.blocks = {block("plate", {0, 0, factor * critical - 0.5 * t}, {0.5, 0.5, t}, 3)};
        scene.blocks[0].density = density;
        const EffectDecision decision = scene.of(EffectKind::AirDrag);
        EXPECT_EQ(decision.on, factor > 1.0) << englishText(decision.reason);
        EXPECT_NEAR(decision.measure, 17.0 / factor, 1e-6);
        EXPECT_EQ(decision.threshold, 17.0);
    }
}

TEST(Decisions, AirDragCountsTheSpeedAtBirth) {
    // R = density t / (rho C_d (v^2 / 2 g + h)).
    for (const double factor : {0.999, 1.001}) {
        const double speed = 20.0 * factor;
        Scene scene = oneCube();
        scene.blocks[0].velocity = {speed, 0, 0};
        scene.blocks[0].density = 17.0 * 1.225 * 1.05 * (20.0 * 20.0 / (2.0 * standardGravity) + 10.5);
        EXPECT_EQ(scene.on(EffectKind::AirDrag), factor > 1.0);
    }
}

/// Two cubes side by side that die together and fall as one cluster, or as two.
Scene pairOfCubes(double low, bool together, double density) {
    Scene scene;
    scene.blocks = {block("pair", {0, 0, low}, {2, 1, 1}, 3)};
    scene.blocks[0].cells = {2, 1, 1};
    scene.blocks[0].density = density;
    scene.scenario.grid.oneBodyPerFragment = !together;
    scene.scenario.grid.length = scene.scenario.grid.width = scene.scenario.grid.height = 5.0;
    return scene;
}

TEST(Decisions, TiesNeedAReinforcedComponentInTwoClusters) {
    Scene scene = pairOfCubes(5.0, false, 2400.0);
    EXPECT_FALSE(scene.on(EffectKind::Ties));
    scene.scenario.effects.of(EffectKind::Ties) = EffectSwitch::On;
    EXPECT_FALSE(scene.on(EffectKind::Ties)) << "nothing is reinforced";
    scene.scenario.effects.of(EffectKind::Ties) = EffectSwitch::Auto;
    scene.scenario.components["pair"].reinforced = true;
    EXPECT_TRUE(scene.on(EffectKind::Ties));
    EXPECT_EQ(scene.of(EffectKind::Ties).measure, 2.0);
    scene = pairOfCubes(5.0, true, 2400.0);
    scene.scenario.components["pair"].reinforced = true;
    EXPECT_FALSE(scene.on(EffectKind::Ties));
    EXPECT_EQ(scene.of(EffectKind::Ties).measure, 1.0);
}

TEST(Decisions, BreakUpNeedsAFastClusterOfStoneAndRoomForTheBodies) {
    // From rest, 6 m/s are reached after 36 / 2 g; the centre lies half a metre above the lower side.
    const double height = 36.0 / (2.0 * standardGravity) - 0.5;
    EXPECT_FALSE(pairOfCubes(height - 0.001, true, 2600.0).on(EffectKind::BreakUp));
    EXPECT_TRUE(pairOfCubes(height + 0.001, true, 2600.0).on(EffectKind::BreakUp));
    EXPECT_FALSE(pairOfCubes(height + 0.001, false, 2600.0).on(EffectKind::BreakUp)) << "single fragments";
    EXPECT_FALSE(pairOfCubes(height + 0.001, true, 2400.0).on(EffectKind::BreakUp)) << "concrete";
    Scene masonry = pairOfCubes(height + 0.001, true, 2400.0);
    masonry.scenario.components["pair"].material = Material::Masonry;
    EXPECT_TRUE(masonry.on(EffectKind::BreakUp));
    masonry.scenario.components["pair"].reinforced = true;
    EXPECT_FALSE(masonry.on(EffectKind::BreakUp)) << "steel holds it together";
    Scene crowded = pairOfCubes(height + 0.001, true, 2600.0);
    crowded.scenario.grid.bodiesMax = 2;
    EXPECT_TRUE(crowded.on(EffectKind::BreakUp));
    crowded.scenario.grid.bodiesMax = 1;
    const EffectDecision full = crowded.of(EffectKind::BreakUp);
    EXPECT_FALSE(full.on);
    EXPECT_EQ(full.measure, 2.0);
    EXPECT_EQ(full.threshold, 1.0);
    crowded.scenario.effects.of(EffectKind::BreakUp) = EffectSwitch::On;
    EXPECT_TRUE(crowded.on(EffectKind::BreakUp));
}

TEST(Decisions, OddScenesAreDecidedToo) {
    Scene nothingDies;
    nothingDies.blocks = {block("wall", {0, 0, 0}, {1, 1, 3})};
    for (const EffectDecision& decision : nothingDies.decisions()) {
        EXPECT_EQ(decision.on, decision.kind == EffectKind::Ground) << effectName(decision.kind);
        EXPECT_FALSE(decision.reason.empty());
    }
    for (const double gravity : {0.0, standardGravity}) {
        for (const double height : {-1e6, 0.0, 50.0}) {
            Scene scene = oneCube();
            scene.blocks[0].velocity = {1e3, 0, 1e3};
            scene.scenario.simulation.gravity = gravity;
            scene.scenario.simulation.groundHeight = height;
            scene.scenario.effects.airDensity = 0.0;
            scene.scenario.effects.of(EffectKind::Ground) = height < 0.0 ? EffectSwitch::Off : EffectSwitch::On;
            EXPECT_FALSE(scene.on(EffectKind::AirDrag));
            EXPECT_EQ(scene.on(EffectKind::Ground), height >= 0.0);
        }
    }
}

TEST(BoxTree, FindsTheSameAsLookingAtEveryBox) {
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> place(-10.0, 10.0), size(0.01, 2.0);
    const auto box = [&] {
        const Vec3 low(place(engine), place(engine), place(engine));
        return Aabb(low, low + Vec3(size(engine), size(engine), size(engine)));
    };
    std::vector<TimedBox> boxes;
    for (std::size_t i = 0; i < 300; ++i) {
        boxes.push_back({box(), static_cast<std::uint32_t>(engine() % 10), i});
    }
    const BoxTree tree(boxes);
    for (int i = 0; i < 500; ++i) {
        const Aabb asked = box();
        const std::int64_t after = static_cast<std::int64_t>(engine() % 11) - 1;
        const std::size_t except = engine() % boxes.size();
        double best = std::numeric_limits<double>::infinity();
        for (const TimedBox& other : boxes) {
            if (other.until > after && other.tag != except) {
                best = std::min(best, gapBetween(asked, other.box));
            }
        }
        EXPECT_EQ(tree.nearest(asked, after, except, 1e9, {}).gap, best);
    }
}

TEST(BoxTree, GapIsDistanceOrOverlap) {
    const Aabb unit(Vec3::Zero(), Vec3::Ones());
    EXPECT_EQ(gapBetween(unit, Aabb(Vec3(1, 0, 0), Vec3(2, 1, 1))), 0.0);
    EXPECT_DOUBLE_EQ(gapBetween(unit, Aabb(Vec3(4, 5, 0), Vec3(6, 6, 1))), 5.0);
    EXPECT_DOUBLE_EQ(gapBetween(unit, Aabb(Vec3(0.75, 0.5, 0.0), Vec3(2, 2, 2))), -0.25);
}

}  // namespace
}  // namespace rubble
