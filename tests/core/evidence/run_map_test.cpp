#include "core/evidence/maps/run_map.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/accuracy/settled_world.h"
#include "core/analysis/debris/debris.h"
#include "core/base/error.h"
#include "core/evidence/maps/map_cell.h"
#include "core/evidence/photographs/site_picture.h"
#include "core/evidence/surveys/survey_comparison.h"
#include "core/pipeline/pipeline.h"
#include "tests/scenes/fe_scenes.h"
#include "tests/support/error_id.h"

namespace rubble {
namespace {

double sumOf(const DebrisMap& map, MapLayer layer) {
    double sum = 0.0;
    for (const double value : map.layer(layer)) {
        sum += std::isnan(value) ? 0.0 : value;
    }
    return sum * map.cell * map.cell;
}

/// A wall that falls to pieces under a beam that lives: 12 fragments and 4 live elements, each of 1 m3 and 2 t.
class MapOfARun : public testing::Test {
protected:
    void SetUp() override {
        scenario.simulation.settleTime = 1.0;
        results = rubble::run(inputs, scenario, Stage::Simulation, {}, &trajectory, Execution());
        mapped = {inputs.fe.get(), &trajectory, results.fragments, results.simulation, nullptr, scenario};
    }
    RunMap mapAt(std::optional<double> time, bool live = true) { return mapOfRun(mapped, time, settings, live, Execution()); }

    Inputs inputs{scenes::collapsingWall(), {}};
    Scenario scenario;
    MemoryTrajectory trajectory;
    Results results;
    MappedRun mapped;
    MapSettings settings;
};

TEST_F(MapOfARun, AgreesWithTheLedger) {
    for (const double cell : {0.25, 1.0, 3.0}) {
        settings.cell = cell;
        const RunMap made = mapAt(std::nullopt);
        EXPECT_EQ(made.map.time, results.simulation->endTime);
        EXPECT_EQ(made.map.ledger.fragments, 12);
        EXPECT_NEAR(made.map.ledger.mass, 24000.0, 1e-6);
        EXPECT_NEAR(sumOf(made.map, MapLayer::Mass), made.map.ledger.mass, 1e-9 * 24000.0);
        EXPECT_NEAR(sumOf(made.map, MapLayer::Volume), 12.0, 1e-9);
        double energy = 0.0;
        for (std::size_t f = 0; f < 12; ++f) {
            energy += 0.5 * 2000.0 * std::pow(results.simulation->fragments[f].impactSpeed, 2);
        }
        EXPECT_GT(energy, 0.0);
        EXPECT_NEAR(made.map.ledger.impactEnergy, energy, 1e-9 * energy);
        EXPECT_NEAR(sumOf(made.map, MapLayer::ImpactEnergy), energy, 1e-9 * energy);
    }
}

TEST_F(MapOfARun, WhatStandsHasAnOutline) {
    const std::vector<PlanBox> boxes{PlanBox(Eigen::Vector2f(0.1F, 0.1F), Eigen::Vector2f(1.9F, 0.9F)),
                                     PlanBox(Eigen::Vector2f(0.1F, 0.1F), Eigen::Vector2f(0.9F, 0.9F))};
    const std::vector<OutlineRing> rings = standingOutline(boxes, 1.0, Execution());
    ASSERT_EQ(rings.size(), 1U);
    EXPECT_EQ(rings[0].size(), 4U) << "two by one cells";
    // What ends where cells end reaches no farther.
    const std::vector<PlanBox> exact{PlanBox(Eigen::Vector2f(0.0F, 0.0F), Eigen::Vector2f(1.5F, 0.5F))};
    const std::vector<OutlineRing> around = standingOutline(exact, 0.1, Execution());
    ASSERT_EQ(around.size(), 1U);
    for (const Eigen::Vector2d& corner : around[0]) {
        EXPECT_TRUE((corner.array() > -1e-6).all() && corner.x() < 1.5 + 1e-6 && corner.y() < 0.5 + 1e-6) << corner.transpose();
    }
    EXPECT_TRUE(standingOutline({}, 1.0, Execution()).empty());
    // What lives and has not moved far, whether or not its layers were asked for.
    const RunMap with = mapAt(std::nullopt, true);
    const RunMap without = mapAt(std::nullopt, false);
    ASSERT_TRUE(with.live);
    EXPECT_FALSE(without.live);
    EXPECT_EQ(standingAtTime(mapped, without, Execution()).size(), with.live->standing.size());
    EXPECT_EQ(with.live->standing.size() + with.live->pieces.size(), 4U);
}

TEST_F(MapOfARun, CellsThatNobodyChoseFitTheFragments) {
    EXPECT_EQ(mapAt(std::nullopt).map.cell, 0.25) << "fragments of a metre";
    EXPECT_NEAR(mapAt(std::nullopt).cellFrom, 1.0, 1e-9);
    settings.cell = 0.5;
    EXPECT_EQ(mapAt(std::nullopt).map.cell, 0.5);
    EXPECT_EQ(mapAt(std::nullopt).cellFrom, 0.0) << "the side was given";
    FragmentSet set;
    set.list.resize(3);
    const auto sideOf = [&](double size, double length) {
        for (Fragment& fragment : set.list) {
            fragment.box.halfExtents = Vec3::Constant(0.5 * size);
        }
        return usualMapCell(set, length).side;
    };
    for (const auto& [size, side] : {std::pair(0.24, 0.1), {0.1, 0.1}, {0.099, 0.05}, {0.03, 0.025}, {0.002, 0.001}, {7.0, 0.25}}) {
        EXPECT_NEAR(sideOf(size, 1.0), side, 1e-12) << size;
        EXPECT_LE(sideOf(size, 1.0), size) << "a fragment is not lost in its cell";
    }
    EXPECT_NEAR(sideOf(0.002, 100.0), 0.005, 1e-12) << "no more than 20,000 cells along";
    set.list.clear();
    EXPECT_EQ(usualMapCell(set, 10.0).side, 0.25);
    EXPECT_EQ(usualMapCell(set, 10.0).fragment, 0.0);
}

TEST_F(MapOfARun, APhotographOfNoInstantOfTheRunIsRefused) {
    const auto refusal = [&](std::optional<double> time) {
        return idOfError([&] { siteOfRun(mapped, time, 1.0, Vec3::Zero(), Execution()); });
    };
    EXPECT_EQ(refusal(std::nullopt), "");
    EXPECT_EQ(refusal(1e9), "site.time_outside");
    mapped.fragments = nullptr;
    EXPECT_EQ(refusal(std::nullopt), "site.nothing_simulated");
}

TEST_F(MapOfARun, ABoxHoldsAllDebrisAndIsNoWiderThanItsPieces) {
    const Aabb bounds = debrisBounds(mapped, std::nullopt);
    const RunMap made = mapAt(std::nullopt, false);
    Aabb centres;
    for (const DebrisFragment& fragment : made.debris.fragments) {
        ASSERT_TRUE(fragment.present);
        centres.extend(fragment.centre);
    }
    const double reach = std::sqrt(3.0) * 0.5;  // of a cube of 1 m
    EXPECT_LE((bounds.min() - Vec3(centres.min().array() - reach)).norm(), 1e-6);
    EXPECT_LE((bounds.max() - Vec3(centres.max().array() + reach)).norm(), 1e-6);
    EXPECT_EQ(debrisBounds(mapped, 1e9).max(), bounds.max()) << "later than its end is its end";
    mapped.fragments = nullptr;
    EXPECT_TRUE(debrisBounds(mapped, std::nullopt).isEmpty());
}

TEST_F(MapOfARun, LiveStructureThatFellHasLayersAndALedgerLineOfItsOwn) {
    const RunMap with = mapAt(std::nullopt);
    ASSERT_TRUE(with.live);
    EXPECT_EQ(with.map.ledger.liveElements, 4);
    EXPECT_NEAR(with.map.ledger.liveMass, 8000.0, 1e-6);
    EXPECT_NEAR(sumOf(with.map, MapLayer::LiveMass), 8000.0, 1e-5);
    EXPECT_NEAR(sumOf(with.map, MapLayer::LiveVolume), 4.0, 1e-9);
    const RunMap without = mapAt(std::nullopt, false);
    EXPECT_FALSE(without.live);
    EXPECT_FALSE(without.map.has(MapLayer::LiveMass));
    EXPECT_EQ(sumOf(without.map, MapLayer::Mass), sumOf(with.map, MapLayer::Mass)) << "never among the fragments";
    settings.liveThreshold = 100.0;
    EXPECT_EQ(mapAt(std::nullopt).map.ledger.liveElements, 0) << "nothing moved that far";
    EXPECT_TRUE(mapAt(std::nullopt).map.has(MapLayer::LiveMass)) << "that nothing fell is said, not left out";
}

/// A survey of heights shows a pier that stands, and takes it for debris.
TEST_F(MapOfARun, StandingStructureWithinTheSurveyedDebrisIsTold) {
    scenario.effects.loose = LooseStructurePolicy::Fe;
    results = rubble::run(inputs, scenario, Stage::Simulation, {}, &trajectory, Execution());
    mapped = {inputs.fe.get(), &trajectory, results.fragments, results.simulation, nullptr, scenario};
    Survey survey;
    survey.name = "flat";
    survey.heights.nx = 81;
    survey.heights.ny = 61;
    survey.heights.x0 = -20.0;
    survey.heights.y0 = -15.0;
    survey.heights.dx = survey.heights.dy = 0.5;
    survey.heights.heights.assign(81 * 61, 2.0);
    survey.heights.aboveGround = true;
    SurveySettings asked;
    const auto told = [](const SurveyComparison& made) {
        return std::ranges::any_of(made.findings.list(), [](const Finding& each) { return each.what.id == "survey.standing"; });
    };
    const SurveyComparison fell = compareRunWithSurvey(mapped, std::nullopt, survey, asked, Execution());
    ASSERT_EQ(fell.fallen.elements, 4);
    EXPECT_EQ(fell.standing.area, 0.0);
    EXPECT_FALSE(told(fell));
    // Nothing moved that far: it stands, in cubes of a metre.
    asked.liveThreshold = 100.0;
    const SurveyComparison stands = compareRunWithSurvey(mapped, std::nullopt, survey, asked, Execution());
    ASSERT_EQ(stands.fallen.elements, 0);
    EXPECT_NEAR(stands.standing.area, 4.0, 1.0) << "to a row of cells";
    EXPECT_NEAR(stands.standing.volume, 2.0 * stands.standing.area, 1e-9);
    EXPECT_FALSE(told(stands)) << "it is next to nothing of this survey";
    settings.liveThreshold = 100.0;
    PlanBox about;
    const RunMap map = mapAt(std::nullopt);
    for (const PlanBox& each : map.live->standing) {
        about.extend(each);
    }
    for (std::size_t k = 0; k < survey.heights.heights.size(); ++k) {
        const Eigen::Vector2d place = survey.heights.placeOf(static_cast<double>(k % 81), static_cast<double>(k / 81));
        survey.heights.heights[k] = about.exteriorDistance(Eigen::Vector2f(place.cast<float>())) < 0.6F ? 2.0 : 0.0;
    }
    EXPECT_TRUE(told(compareRunWithSurvey(mapped, std::nullopt, survey, asked, Execution())));
    survey.heights.everywhere = true;
    EXPECT_FALSE(told(compareRunWithSurvey(mapped, std::nullopt, survey, asked, Execution())))
        << "a debris map tells debris from what stands";
}

// Of a bridge only the height of what lay on its abutments was told.
TEST(MapLedger, TellsTheHighestOfThePileFromWhatLiesOnStructure) {
    const auto boxAt = [](const Vec3& centre) {
        MapPiece piece;
        piece.box.centre = piece.centre = centre;
        piece.box.halfExtents = Vec3(0.5, 0.5, 0.5);
        piece.mass = 2400.0;
        piece.volume = 1.0;
        return piece;
    };
    // The second juts out beyond what it lies on.
    const std::vector<MapPiece> pieces{boxAt({0.5, 0.5, 41.5}), boxAt({2.4, 0.5, 40.5}), boxAt({10.5, -7.5, 4.5}),
                                       boxAt({20.5, 3.5, 0.5})};
    LiveStructure live;
    live.standing.push_back(PlanBox(Eigen::Vector2f(-2.0F, -2.0F), Eigen::Vector2f(2.0F, 2.0F)));
    const auto ledgerWith = [&](const LiveStructure* structure) {
        return makeDebrisMap(9.0, pieces, false, structure, {"all"}, SiteSurface{}, {}, Execution()).ledger;
    };
    EXPECT_TRUE(ledgerWith(&live).highestStands);
    EXPECT_NEAR(ledgerWith(&live).pileHeight, 5.0, 1e-6);
    EXPECT_FALSE(ledgerWith(nullptr).highestStands);
    EXPECT_NEAR(ledgerWith(nullptr).pileHeight, 42.0, 1e-6);
    live.standing.push_back(PlanBox(Eigen::Vector2f(9.0F, -9.0F), Eigen::Vector2f(12.0F, -6.0F)));
    EXPECT_NEAR(ledgerWith(&live).pileHeight, 1.0, 1e-6);
}

TEST_F(MapOfARun, LiveStructureIsWhereItsBodiesAre) {
    scenario.effects.loose = LooseStructurePolicy::Fe;
    results = rubble::run(inputs, scenario, Stage::Simulation, {}, &trajectory, Execution());
    mapped = {inputs.fe.get(), &trajectory, results.fragments, results.simulation, nullptr, scenario};
    const RunMap end = mapAt(std::nullopt);
    ASSERT_EQ(trajectory.islands().size(), 1u);
    const TrajectoryFrame frame = frameAtTime(trajectory, end.map.time);
    const Vec3 body = frame.positions[at(trajectory.islands()[0].body)].cast<double>();
    Vec3 centre = Vec3::Zero();
    for (const MapPiece& piece : end.live->pieces) {
        centre += piece.centre / 4.0;
    }
    // Equal elements: their mean is the centre of mass; frames hold single precision.
    EXPECT_LT((centre - body).norm(), 1e-5);
    // Before the FE end it is where the file says: it has fallen 0.5 g t^2 from its place at rest, 4.5 m.
    settings.liveThreshold = 0.1;
    const RunMap early = mapAt(0.35);
    ASSERT_EQ(early.live->pieces.size(), 4u);
    const double between = 0.5 * (0.5 * standardGravity * (0.3 * 0.3 + 0.4 * 0.4));
    EXPECT_NEAR(early.live->pieces[0].centre.z(), 4.5 - between, 1e-9) << "linear between the states";
    EXPECT_EQ(early.shown, FrameKind::Interpolated);
    // At a state of the FE result the debris is simulated as well: no map of it is one of the FE result.
    for (const double state : inputs.fe->contents().times) {
        if (state > trajectory.frame(0)->time) {
            EXPECT_EQ(mapAt(state).shown, FrameKind::Simulated) << state;
        }
    }
}

TEST_F(MapOfARun, AnIslandIsWhereTheEngineHasItBeforeTheFeResultEnds) {
    scenario.effects.loose = LooseStructurePolicy::AtOnce;
    results = rubble::run(inputs, scenario, Stage::Simulation, {}, &trajectory, Execution());
    mapped = {inputs.fe.get(), &trajectory, results.fragments, results.simulation, nullptr, scenario};
    ASSERT_EQ(trajectory.islands().size(), 1u) << "the beam";
    const BodyId beam = trajectory.islands()[0].body;
    settings.liveThreshold = 0.1;
    ASSERT_LE(trajectory.bodies()[at(beam)].from, 0.35);
    for (const double time : {0.35, 0.4, 0.8}) {
        const RunMap made = mapAt(time);
        ASSERT_EQ(made.live->pieces.size(), 4u) << time;
        Vec3 centre = Vec3::Zero();
        for (const MapPiece& piece : made.live->pieces) {
            centre += piece.centre / 4.0;
        }
        const Vec3 body = frameAtTime(trajectory, time).positions[at(beam)].cast<double>();
        EXPECT_LT((centre - body).norm(), 1e-5) << time;
    }
}

/// What an island has lost is where its body has it from the hand-over on, and not where the FE result has it until it is born.
TEST_F(MapOfARun, WhatLeftAnIslandIsNotBackAtItsFePlace) {
    FragmentSet fragments;
    Fragment& fragment = fragments.list.emplace_back();
    fragment.element = ElementIndex{7};
    fragment.handOverState = 3;
    fragment.handOverTime = 0.3;
    fragment.birthTime = 0.4;
    const Pose handOverToBody{Vec3(1, 2, 3), Quat(Eigen::AngleAxisd(0.5, Vec3::UnitX()))};
    const std::vector<Carrier> carriers{{FragmentId{0}, BodyId{1}, 0.3, std::numeric_limits<double>::infinity(), handOverToBody}};
    const std::vector<IslandRecord> islands{{BodyId{0}, 2, {}, {ElementIndex{6}, ElementIndex{7}}}};
    TrajectoryFrame frame;
    frame.positions = {{0, 0, 0}, {4, 5, 6}};
    frame.orientations.assign(2, Eigen::Quaternionf::Identity());
    frame.speeds.assign(2, 0.0f);
    frame.states.assign(2, BodyState::Awake);
    frame.time = 0.35;
    const std::vector<CarriedIsland> left = leftIslands(fragments, islands, carriers, frame);
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0].elements, std::vector<ElementIndex>{ElementIndex{7}});
    EXPECT_EQ(left[0].state, 3u);
    EXPECT_LT((left[0].moved * Vec3(0, 0, 1) - (Vec3(4, 5, 6) + handOverToBody * Vec3(0, 0, 1))).norm(), 1e-6);
    EXPECT_TRUE(leftIslands(fragments, {}, carriers, frame).empty()) << "it was in no island";
    for (const double time : {0.25, 0.4}) {
        frame.time = time;
        EXPECT_TRUE(leftIslands(fragments, islands, carriers, frame).empty()) << time;
    }
    frame.time = 0.35;
    frame.states[1] = BodyState::Removed;
    EXPECT_TRUE(leftIslands(fragments, islands, carriers, frame).empty()) << "its body has left";
}

TEST_F(MapOfARun, GrowsWithTime) {
    EXPECT_EQ(mapAt(0.1).map.ledger.fragments, 0);
    EXPECT_TRUE(mapAt(0.1, false).map.cells.empty());
    EXPECT_TRUE(mapAt(0.1, false).map.has(MapLayer::Height)) << "an empty map has its layers all the same";
    EXPECT_EQ(mapAt(0.2).map.ledger.fragments, 6) << "every second element of the wall dies at 0.2 s";
    EXPECT_EQ(mapAt(0.4).map.ledger.fragments, 12);
    double before = 0.0;
    for (const double time : {0.4, 0.6, 0.9, results.simulation->endTime}) {
        const double energy = mapAt(time).map.ledger.impactEnergy;
        EXPECT_GE(energy, before) << "a hit brings its energy once, at its time";
        before = energy;
    }
}

TEST_F(MapOfARun, ArrivalIsBetweenBirthAndNow) {
    const RunMap made = mapAt(std::nullopt);
    for (std::size_t f = 0; f < made.arrivals.size(); ++f) {
        EXPECT_GE(made.arrivals[f], results.fragments->list[f].birthTime);
        EXPECT_LE(made.arrivals[f], made.map.time);
    }
    for (std::size_t c = 0; c < made.map.cells.size(); ++c) {
        const double arrival = made.map.layer(MapLayer::Arrival)[c];
        EXPECT_EQ(std::isnan(arrival), std::isnan(made.map.layer(MapLayer::Mass)[c]));
    }
}

TEST_F(MapOfARun, WithoutAResultThereIsNoImpactEnergy) {
    mapped.result = nullptr;
    const RunMap made = mapAt(std::nullopt);
    EXPECT_FALSE(made.map.has(MapLayer::ImpactEnergy));
    EXPECT_EQ(made.findings.count("map.no_impacts"), 1);
    const std::vector<MapLayer> present = made.map.present();
    EXPECT_EQ(present.size(), 10u) << "seven of fragments, three of live structure";
}

TEST_F(MapOfARun, RefusesATimeOutsideAndARunOfAnotherFile) {
    for (const double time : {-0.1, 99.0, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(mapAt(time), UsageError) << time;
    }
    const std::shared_ptr<const FeResult> smaller = scenes::collapsingWall(1, 1);
    mapped.fe = smaller.get();
    EXPECT_THROW(mapAt(std::nullopt), UsageError);
    mapped.fe = inputs.fe.get();
    const MemoryTrajectory nothing;
    mapped.trajectory = &nothing;
    EXPECT_THROW(mapAt(std::nullopt), UsageError);
}

}  // namespace
}  // namespace rubble
