#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/base/error.h"
#include "core/base/standard_gravity.h"
#include "core/engine/world/forwarding_world.h"
#include "core/selftest/element_scene.h"
#include "core/simulation/health/value_archive.h"
#include "core/simulation/run/acknowledgement.h"
#include "core/simulation/run/collapse_run.h"
#include "core/simulation/run/sealed_checkpoint.h"
#include "tests/core/simulation/effects/run_scene.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

/// Keeps all checkpoints and offers one of them.
class KeptCheckpoints : public CheckpointStore {
public:
    std::optional<std::string> latest() override { return offered; }
    void keep(std::string_view checkpoint) override { all.emplace_back(checkpoint); }
    double interval() const override { return seconds; }

    double seconds = 0.0;
    std::optional<std::string> offered;
    std::vector<std::string> all;
};

/// A world that heats up its bodies for a while, or gives one of them a velocity that is no number.
class TroubledWorld : public ForwardingWorld {
public:
    using ForwardingWorld::ForwardingWorld;
    double heatFrom = 1e300, heatTo = 1e300, breakAt = 1e300;

    void onSubstep(SubstepHook hook) override {
        world().onSubstep([this, hook](const SubstepBodies& bodies, double h) {
            if (hook) {
                hook(bodies, h);
            }
            for (MovingBody& body : bodies.moving) {
                body.velocity *= m_time >= heatFrom && m_time < heatTo ? 1.02 : 1.0;
            }
            if (m_time >= breakAt && !m_broken && !bodies.moving.empty()) {
                m_broken = true;
                bodies.moving.front().velocity.x() = std::numeric_limits<double>::quiet_NaN();
            }
        });
    }
    void step(double dt) override {
        ForwardingWorld::step(dt);
        m_time += dt;
    }
    bool keep(Archive& archive) override {
        archive(m_time, m_broken);
        return world().keep(archive);
    }

private:
    double m_time = 0.0;
    bool m_broken = false;
};

/// A collapse that can be made again with nothing in common with the first one.
struct Collapsing {
    std::string name;
    std::function<std::shared_ptr<const FeResult>()> fe;
    Scenario scenario;
    std::function<std::shared_ptr<const TerrainGrid>()> terrain = {};
    std::function<void(TroubledWorld&)> trouble = {};
    std::function<void(const SimulationResult&)> shows = {};  ///< that the collapse has in it what it is meant to try

    RunDescription describe() const {
        RunDescription description = test::describe(fe(), scenario);
        description.terrain = terrain ? terrain() : nullptr;
        return description;
    }
    SimulationResult run(TrajectorySink& sink, CheckpointStore* checkpoints = nullptr, int threads = 1) const {
        const RunDescription description = describe();
        const WorldFactory make = [&](const WorldSettings& settings) -> std::unique_ptr<RigidWorld> {
            std::unique_ptr<RigidWorld> world = makeWorld(scenario.simulation.solver, settings);
            if (!trouble) {
                return world;
            }
            auto troubled = std::make_unique<TroubledWorld>(std::move(world));
            trouble(*troubled);
            troubled->onSubstep({});
            return troubled;
        };
        return simulateIn(make, description, sink, Execution().withThreads(threads), checkpoints);
    }
};

/// All of a result that repeats, bit by bit.
std::string bitsOf(SimulationResult result) {
    Archive archive;
    archive(result.fragments, result.bodiesPeak, result.awakePeak, result.steps, result.firstTime, result.feEndTime, result.endTime,
            result.energy, result.ledger, result.islands, result.carried, result.penetrationMax, result.asleepAtEnd,
            result.stillMoving, result.maxSpeed, result.bulkingFactor, result.trajectoryHash.bytes, result.findings);
    archive(result.births.births, result.births.occupied, result.births.medianDepth, result.births.left, result.births.work,
            result.births.piecePushWork, result.births.piecesYielded);
    archive(result.health.remedies, result.health.penetrationSustained, result.health.penetrationShare, result.health.crowdShare,
            result.health.fastestOverLimit, result.health.farthest, result.health.asleepPeak, result.health.contactsPeak,
            result.health.bodiesLost);
    for (HealthBreach& breach : result.health.breaches) {
        archive(breach.check, breach.from, breach.to, breach.worstAt, breach.body, breach.place, breach.worst, breach.limit,
                breach.bodies, breach.what, breach.remedy);
    }
    for (EffectReport& effect : result.effects) {
        archive(effect.decision.kind, effect.decision.on, effect.work, effect.events);
    }
    return std::move(archive).take();
}

scenes::Block block(const std::string& name, const Vec3& low, const Vec3& size, std::array<int, 3> cells) {
    scenes::Block block;
    block.name = name;
    block.low = low;
    block.size = size;
    block.cells = cells;
    block.gravity = standardGravity;
    return block;
}

Scenario scenarioFor(double settleTime) {
    Scenario scenario;
    scenario.simulation.settleTime = settleTime;
    scenario.simulation.stepRate = 60.0;
    return scenario;
}

std::shared_ptr<const TerrainGrid> slope() {
    std::vector<double> heights;
    for (int j = 0; j < 41; ++j) {
        for (int i = 0; i < 41; ++i) {
            heights.push_back(-0.1 * i + 0.2 * (i % 3));
        }
    }
    return std::make_shared<const TerrainGrid>(-20.0, -20.0, 1.0, 41, 41, heights);
}

std::int64_t eventsOf(const SimulationResult& result, EffectKind kind) {
    return result.effects.at(static_cast<std::size_t>(kind)).events;
}

double workOf(const SimulationResult& result, EffectKind kind) {
    return result.effects.at(static_cast<std::size_t>(kind)).work;
}

Collapsing wallOntoMovingPieces() {
    Collapsing c{"WallOntoMovingPieces", [] { return scenes::collapsingWall(6, 4); }, scenarioFor(3.0)};
    c.scenario.effects.loose = LooseStructurePolicy::Fe;
    c.shows = [](const SimulationResult& r) {
        EXPECT_GT(r.births.piecePushWork, 0.0);
        EXPECT_GT(r.asleepAtEnd, 0.5);
    };
    return c;
}

Collapsing hullsAndSurfacePieces() {
    Collapsing c{"HullsAndSurfacePieces", [] { return scenes::collapsingWall(4, 3); }, scenarioFor(2.0)};
    c.scenario.simulation.shape = ClusterShape::Hull;
    c.scenario.simulation.pieces = PieceKind::Surface;
    return c;
}

Collapsing compoundsOnTerrain() {
    Collapsing c{"CompoundsOnTerrain", [] { return scenes::collapsingWall(5, 4); }, scenarioFor(3.0), slope};
    c.scenario.simulation.shape = ClusterShape::Compound;
    c.scenario.grid.length = c.scenario.grid.width = c.scenario.grid.height = 2.5;
    return c;
}

Collapsing waterAndAir() {
    Collapsing c{"WaterAndAir", [] { return scenes::collapsingWall(5, 3); }, scenarioFor(3.0)};
    c.scenario.effects.waterLevel = 1.2;
    c.scenario.effects.currentX = 0.5;
    c.scenario.effects.airDrag = 20.0;
    c.scenario.effects.of(EffectKind::AirDrag) = EffectSwitch::On;
    c.shows = [](const SimulationResult& r) {
        EXPECT_NE(workOf(r, EffectKind::Water), 0.0);
        EXPECT_LT(workOf(r, EffectKind::AirDrag), 0.0);
    };
    return c;
}

Collapsing carriedIslands() {
    Collapsing c{"CarriedIslands",
                 [] {
                     scenes::Block span = block("span", Vec3(0, 0, 6), Vec3(8, 2, 1), {8, 2, 1});
                     span.deathState = [](std::size_t i) { return i == 3 || i == 11 ? std::size_t{4} : 12 + i; };
                     scenes::Block under = block("under", Vec3(2, 0, 0), Vec3(2, 2, 1), {2, 2, 1});
                     under.gravity = 0.0;
                     under.deathState = [](std::size_t) { return std::size_t{1}; };
                     return scenes::makeScene({under, span}, 30, 0.1);
                 },
                 scenarioFor(2.0)};
    c.scenario.effects.loose = LooseStructurePolicy::AtOnce;
    c.shows = [](const SimulationResult& r) {
        EXPECT_GT(r.carried.bodies, 3);
        EXPECT_EQ(r.carried.born, 16);
    };
    return c;
}

Collapsing tiedDeck() {
    Collapsing c{"TiedDeck",
                 [] {
                     scenes::Block deck = block("deck", Vec3(0, 0, 4), Vec3(8, 1, 1), {8, 1, 1});
                     deck.deathState = [](std::size_t i) { return 2 + i % 3; };
                     return scenes::makeScene({deck}, 8, 0.1);
                 },
                 scenarioFor(3.0)};
    c.scenario.components["deck"].reinforced = true;
    c.scenario.effects.of(EffectKind::Ties) = EffectSwitch::On;
    c.scenario.effects.tieStrength = 20e6;
    c.scenario.grid.oneBodyPerFragment = true;
    c.shows = [](const SimulationResult& r) { EXPECT_NE(workOf(r, EffectKind::Ties), 0.0); };
    return c;
}

/// Bodies that are born inside others, some of which lie frozen by then.
Collapsing overlappingBirths() {
    Collapsing c{"OverlappingBirths",
                 [] {
                     scenes::Block first = block("first", Vec3(0, 0, 0), Vec3(3, 1, 2), {3, 1, 2});
                     first.deathState = [](std::size_t) { return std::size_t{2}; };
                     scenes::Block second = block("second", Vec3(0.3, 0.2, 0.5), Vec3(2, 1, 2), {2, 1, 2});
                     second.deathState = [](std::size_t i) { return 9 + i % 3; };
                     scenes::Block third = block("third", Vec3(0.5, 0.1, 1.0), Vec3(2, 1, 2), {2, 1, 2});
                     third.deathState = [](std::size_t i) { return 14 + i % 3; };
                     first.gravity = second.gravity = third.gravity = 0.0;
                     return scenes::makeScene({first, second, third}, 20, 0.2);
                 },
                 scenarioFor(3.0)};
    c.scenario.grid.oneBodyPerFragment = true;
    c.scenario.effects.of(EffectKind::StructureContact) = EffectSwitch::Off;
    c.shows = [](const SimulationResult& r) {
        EXPECT_GT(r.births.occupied, 0);
        EXPECT_NE(r.births.work, 0.0);
    };
    return c;
}

Collapsing breakingBlock() {
    Collapsing c{"BreakingBlock",
                 [] {
                     scenes::Block stone = block("block", Vec3(0, 0, 12), Vec3(2.0, 1.6, 1.2), {2, 2, 2});
                     stone.deathState = [](std::size_t) { return std::size_t{2}; };
                     return scenes::makeScene({stone}, 6, 0.1);
                 },
                 scenarioFor(3.0)};
    c.scenario.components["block"].material = Material::Stone;
    c.scenario.grid.length = c.scenario.grid.width = c.scenario.grid.height = 10.0;
    c.scenario.effects.of(EffectKind::BreakUp) = EffectSwitch::On;
    c.scenario.effects.of(EffectKind::AirDrag) = EffectSwitch::On;
    c.shows = [](const SimulationResult& r) { EXPECT_EQ(eventsOf(r, EffectKind::BreakUp), 1); };
    return c;
}

Collapsing releasedIslands() {
    Collapsing c{"ReleasedIslands",
                 [] {
                     scenes::Block slab = block("slab", Vec3(0, 0, 5), Vec3(6, 4, 1), {6, 4, 1});
                     scenes::Block dying = block("dying", Vec3(1, 1, 7), Vec3(2, 2, 1), {2, 2, 1});
                     dying.deathState = [](std::size_t) { return std::size_t{2}; };
                     return scenes::makeScene({slab, dying}, 6, 0.1);
                 },
                 scenarioFor(3.0)};
    c.scenario.effects.loose = LooseStructurePolicy::Fe;
    c.shows = [](const SimulationResult& r) { EXPECT_EQ(r.islands.released, 1); };
    return c;
}

Collapsing islandsAlone() {
    Collapsing c{"IslandsAlone", [] { return scenes::makeScene({block("slab", Vec3(0, 0, 2), Vec3(6, 4, 1), {6, 4, 1})}, 4, 0.1); },
                 scenarioFor(2.0)};
    c.shows = [](const SimulationResult& r) {
        EXPECT_EQ(r.islands.released, 1);
        EXPECT_TRUE(r.fragments.empty());
    };
    return c;
}

Collapsing revivedElements() {
    Collapsing c{"RevivedElements",
                 [] {
                     selftest::ElementScene scene;
                     for (int k = 0; k < 9; ++k) {
                         scene.times.push_back(0.1 * k);
                     }
                     for (int i = 0; i < 4; ++i) {
                         const Vec3 low(2.0 * i, 0.0, 3.0);
                         std::vector<Vec3> corners;
                         for (const double z : {0.0, 1.0}) {
                             for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
                                 corners.push_back(low + Vec3(x, y, z));
                             }
                         }
                         scene.element(ElementShape::Hexahedron, corners, i % 2 == 0 ? "110000000" : "110011100");
                     }
                     return scene.result();
                 },
                 scenarioFor(2.0)};
    c.scenario.fragments.revival = Revival::Follow;
    c.scenario.grid.oneBodyPerFragment = true;
    return c;
}

Collapsing halvedSteps() {
    Collapsing c{"HalvedSteps", [] { return scenes::collapsingWall(4, 3); }, scenarioFor(2.0)};
    c.scenario.simulation.autoRemedy = true;
    c.trouble = [](TroubledWorld& world) {
        world.heatFrom = 0.25;
        world.heatTo = 0.4;
    };
    c.shows = [](const SimulationResult& r) {
        EXPECT_FALSE(r.health.breaches.empty());
        EXPECT_FALSE(r.health.remedies.empty());
    };
    return c;
}

Collapsing lostBody() {
    Collapsing c{"LostBody", [] { return scenes::collapsingWall(4, 3); }, scenarioFor(2.0)};
    c.trouble = [](TroubledWorld& world) { world.breakAt = 0.3; };
    c.shows = [](const SimulationResult& r) { EXPECT_EQ(r.health.bodiesLost, 1); };
    return c;
}

/// Without freezing and with a frame for every step.
Collapsing neverFrozen() {
    Collapsing c{"NeverFrozen", [] { return scenes::collapsingWall(3, 3); }, scenarioFor(2.0)};
    c.scenario.simulation.freeze = false;
    c.scenario.simulation.frameRate = 200.0;
    c.scenario.simulation.stepRate = 100.0;
    return c;
}

class Resume : public testing::TestWithParam<Collapsing (*)()> {};

TEST_P(Resume, EndsBitForBitAsTheRunThatWasNeverStopped) {
    const Collapsing collapse = GetParam()();
    MemoryTrajectory plain;
    const SimulationResult whole = collapse.run(plain);
    ASSERT_GT(whole.steps, 50);
    if (collapse.shows) {
        collapse.shows(whole);
    }
    KeptCheckpoints kept;
    MemoryTrajectory watched;
    const SimulationResult keeping = collapse.run(watched, &kept);
    EXPECT_EQ(keeping.checkpoints.kept, static_cast<std::int64_t>(kept.all.size()));
    EXPECT_FALSE(keeping.checkpoints.resumedAt);
    EXPECT_EQ(bitsOf(keeping), bitsOf(whole)) << "keeping checkpoints changes nothing";
    EXPECT_EQ(watched.mark(), plain.mark());
    // Halved steps of one interval have one checkpoint.
    ASSERT_GE(static_cast<std::int64_t>(kept.all.size()), whole.steps / 2);

    constexpr std::size_t instants = 12;
    for (std::size_t n = 0; n <= instants; ++n) {
        const std::size_t at = n * (kept.all.size() - 1) / instants;
        SCOPED_TRACE("stopped after step " + std::to_string(at + 1) + " of " + std::to_string(kept.all.size()));
        KeptCheckpoints offering;
        offering.offered = kept.all[at];
        MemoryTrajectory trajectory;
        const SimulationResult resumed = collapse.run(trajectory, &offering, n % 2 == 0 ? 1 : 3);
        ASSERT_TRUE(resumed.checkpoints.resumedAt);
        EXPECT_EQ(offering.all.size(), kept.all.size() - at - 1) << "steps that are done are not done again";
        EXPECT_EQ(resumed.trajectoryHash, whole.trajectoryHash);
        EXPECT_EQ(bitsOf(resumed), bitsOf(whole));
        EXPECT_EQ(trajectory.mark(), plain.mark());
        EXPECT_TRUE(trajectory.complete());
        // Stopped a second time.
        if (offering.all.size() > 2) {
            KeptCheckpoints again;
            again.offered = offering.all[offering.all.size() / 2];
            again.seconds = 1e9;
            MemoryTrajectory third;
            EXPECT_EQ(bitsOf(collapse.run(third, &again)), bitsOf(whole));
            EXPECT_EQ(third.mark(), plain.mark());
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Collapses, Resume,
                         testing::Values(wallOntoMovingPieces, hullsAndSurfacePieces, compoundsOnTerrain, waterAndAir, tiedDeck,
                                         breakingBlock, overlappingBirths, releasedIslands, islandsAlone, carriedIslands,
                                         revivedElements, halvedSteps, lostBody, neverFrozen),
                         [](const auto& one) { return one.param().name; });

/// A small collapse, its result and the checkpoint half way.
class Checkpointed : public testing::Test {
protected:
    Collapsing collapse{"", [] { return scenes::collapsingWall(3, 2); }, scenarioFor(1.0)};
    SimulationResult whole;
    std::string halfWay;

    void SetUp() override {
        KeptCheckpoints kept;
        MemoryTrajectory trajectory;
        whole = collapse.run(trajectory, &kept);
        halfWay = kept.all.at(kept.all.size() / 2);
    }
    /// The collapse with a checkpoint that should not be taken.
    void expectFromTheStart(const std::string& offered, std::string_view finding) {
        KeptCheckpoints store;
        store.offered = offered;
        MemoryTrajectory trajectory;
        const SimulationResult result = collapse.run(trajectory, &store);
        EXPECT_FALSE(result.checkpoints.resumedAt);
        EXPECT_EQ(result.trajectoryHash, whole.trajectoryHash);
        EXPECT_EQ(result.checkpoints.findings.count(finding), 1);
        EXPECT_EQ(result.findings.count(finding), 1) << "it is said with the result";
        EXPECT_TRUE(trajectory.complete());
    }
};

TEST_F(Checkpointed, IsNotTakenWhenItIsCutShort) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{20}, std::size_t{51}, std::size_t{52},
                                   std::size_t{60}, halfWay.size() / 2, halfWay.size() - 1}) {
        SCOPED_TRACE(size);
        expectFromTheStart(halfWay.substr(0, size), "simulation.checkpoint_damaged");
    }
    expectFromTheStart(halfWay + '\0', "simulation.checkpoint_damaged");
}

TEST_F(Checkpointed, IsNotTakenWhenAByteIsAnother) {
    // Magic, digest, content.
    for (const std::size_t at : {std::size_t{0}, std::size_t{15}, std::size_t{36}, std::size_t{51}, std::size_t{52},
                                 halfWay.size() / 3, halfWay.size() / 2, halfWay.size() - 1}) {
        SCOPED_TRACE(at);
        std::string changed = halfWay;
        changed[at] = static_cast<char>(changed[at] ^ 4);
        expectFromTheStart(changed, "simulation.checkpoint_damaged");
    }
}

TEST_F(Checkpointed, IsNotTakenFromAnotherVersionOrRun) {
    for (const std::size_t at : {std::size_t{16}, std::size_t{20}, std::size_t{35}}) {
        SCOPED_TRACE(at);
        std::string changed = halfWay;
        changed[at] = static_cast<char>(changed[at] ^ 4);
        expectFromTheStart(changed, "simulation.checkpoint_foreign");
    }
    const auto otherwise = [&](const std::function<void(Collapsing&)>& change) {
        Collapsing other = collapse;
        change(other);
        KeptCheckpoints kept;
        MemoryTrajectory trajectory;
        other.run(trajectory, &kept);
        expectFromTheStart(kept.all.at(kept.all.size() / 2), "simulation.checkpoint_foreign");
    };
    otherwise([](Collapsing& c) { c.scenario.simulation.friction = 0.61; });
    otherwise([](Collapsing& c) { c.scenario.effects.breakUpSpeed = 7.0; });
    otherwise([](Collapsing& c) { c.fe = [] { return scenes::collapsingWall(3, 3); }; });
    otherwise([](Collapsing& c) { c.scenario.fragments.birthShift = 1e-6; });
}

TEST_F(Checkpointed, OfARepeatIsNotThatOfAnotherClustering) {
    // A repeat of a study has the scenario of a shifted run and the clusters of its base.
    const RunDescription description = collapse.describe();
    RunDescription joined = description;
    auto clustering = std::make_shared<Clustering>(*description.clustering);
    ASSERT_GT(clustering->list.size(), 1u);
    std::swap(clustering->members.front(), clustering->members.back());
    joined.clustering = clustering;
    EXPECT_NE(runDigest(joined), runDigest(description));
    EXPECT_EQ(runDigest(collapse.describe()), runDigest(description));
}

TEST_F(Checkpointed, WhoseContentDoesNotBelongTogetherIsNotTaken) {
    Findings none;
    const Digest run = runDigest(collapse.describe());
    const std::optional<std::string_view> content = openCheckpoint(halfWay, run, none);
    ASSERT_TRUE(content);
    const auto sealed = [&](std::string bytes) {
        Archive archive;
        beginCheckpoint(archive, run);
        archive.bytes(bytes.data(), bytes.size());
        return sealCheckpoint(std::move(archive));
    };
    EXPECT_EQ(sealed(std::string(*content)), halfWay);
    for (const std::size_t size : {std::size_t{0}, std::size_t{7}, content->size() / 4, content->size() / 2, content->size() - 1}) {
        SCOPED_TRACE(size);
        expectFromTheStart(sealed(std::string(content->substr(0, size))), "simulation.checkpoint_damaged");
    }
    expectFromTheStart(sealed(std::string(*content) + "more"), "simulation.checkpoint_damaged");
}

TEST_F(Checkpointed, ThatCannotBeKeptDoesNotStopTheRun) {
    struct FullDisk : CheckpointStore {
        std::optional<std::string> latest() override { return std::nullopt; }
        void keep(std::string_view) override { throw WorldError({"test.full", "No space left on device", {}}, {}); }
        double interval() const override { return 0.0; }
    } store;
    MemoryTrajectory trajectory;
    const SimulationResult result = collapse.run(trajectory, &store);
    EXPECT_EQ(result.trajectoryHash, whole.trajectoryHash);
    EXPECT_EQ(result.checkpoints.kept, 0);
    EXPECT_EQ(result.findings.count("simulation.checkpoint_not_kept"), whole.checkpoints.kept);
    EXPECT_NE(result.checkpoints.findings.list().front().example.find("No space left"), std::string::npos);
}

TEST_F(Checkpointed, ThatCannotBeReadDoesNotStopTheRun) {
    struct Unreadable : CheckpointStore {
        std::optional<std::string> latest() override { throw WorldError({"test.rights", "Permission denied", {}}, {}); }
        void keep(std::string_view) override {}
    } store;
    MemoryTrajectory trajectory;
    const SimulationResult result = collapse.run(trajectory, &store);
    EXPECT_EQ(result.trajectoryHash, whole.trajectoryHash);
    EXPECT_EQ(result.findings.count("simulation.checkpoint_damaged"), 1);
}

TEST_F(Checkpointed, IsKeptNoMoreOftenThanItsInterval) {
    KeptCheckpoints store;
    store.seconds = 3600.0;
    MemoryTrajectory trajectory;
    const SimulationResult result = collapse.run(trajectory, &store);
    EXPECT_TRUE(store.all.empty());
    EXPECT_EQ(result.checkpoints.kept, 0);
}

TEST_F(Checkpointed, CountsTheTimeOfEarlierProcesses) {
    KeptCheckpoints store;
    store.offered = halfWay;
    MemoryTrajectory trajectory;
    const SimulationResult result = collapse.run(trajectory, &store);
    EXPECT_GT(result.checkpoints.secondsBefore, 0.0);
    EXPECT_GT(result.stepTimes.meanMs, 0.0);
    ASSERT_FALSE(store.all.empty());
    KeptCheckpoints later;
    later.offered = store.all.back();
    EXPECT_GT(collapse.run(trajectory, &later).checkpoints.secondsBefore, result.checkpoints.secondsBefore);
}

TEST_F(Checkpointed, RunsOfTheStockSolverKeepNone) {
    collapse.scenario.simulation.solver = SolverKind::Bullet;
    KeptCheckpoints store;
    MemoryTrajectory trajectory, plain;
    const SimulationResult result = collapse.run(trajectory, &store);
    EXPECT_TRUE(store.all.empty());
    EXPECT_TRUE(result.checkpoints.findings.empty());
    EXPECT_EQ(result.trajectoryHash, collapse.run(plain).trajectoryHash);
}

TEST_F(Checkpointed, SinksThatCannotGoOnHaveNone) {
    struct Forgetful : MemoryTrajectory {
        std::optional<std::string> mark() override { return std::nullopt; }
    } sink;
    KeptCheckpoints store;
    EXPECT_EQ(collapse.run(sink, &store).trajectoryHash, whole.trajectoryHash);
    EXPECT_TRUE(store.all.empty());
}

TEST_F(Checkpointed, ASinkWhosePartIsGoneStartsAnew) {
    struct Emptied : MemoryTrajectory {
        bool resume(const RunDescription&, std::string_view) override { return false; }
    } sink;
    KeptCheckpoints store;
    store.offered = halfWay;
    const SimulationResult result = collapse.run(sink, &store);
    EXPECT_FALSE(result.checkpoints.resumedAt);
    EXPECT_EQ(result.trajectoryHash, whole.trajectoryHash);
    EXPECT_EQ(result.findings.count("simulation.checkpoint_damaged"), 1);
}

}  // namespace
}  // namespace rubble
