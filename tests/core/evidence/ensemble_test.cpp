#include "core/evidence/ensembles/ensemble.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <mutex>
#include <numeric>

#include "core/base/error.h"
#include "core/evidence/ensembles/probability_map.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

/// Keeps worlds in memory, and counts.
class MemoryStore : public SettledStore {
public:
    std::optional<SettledWorld> settled(const WorldOrigin& origin, Findings&) override {
        const std::scoped_lock lock(m_mutex);
        const auto found = worlds.find(origin.key);
        return found == worlds.end() ? std::nullopt : std::optional(found->second);
    }
    void keep(const WorldOrigin& origin, const SettledWorld& world) override {
        const std::scoped_lock lock(m_mutex);
        if (full) {
            throw WorldError({"test.full", "the disk is full", {}}, {"test.room", "make room", {}});
        }
        EXPECT_TRUE(worlds.emplace(origin.key, world).second) << "simulated twice";
        if (interrupted != nullptr && worlds.size() == interruptAfter) {
            interrupted->cancel();
        }
    }

    std::map<Digest, SettledWorld> worlds;
    const Execution* interrupted = nullptr;
    std::size_t interruptAfter = 0;
    bool full = false;

private:
    std::mutex m_mutex;
};

class EnsembleStudy : public testing::Test {
protected:
    void SetUp() override {
        scene.inputs.fe = scenes::collapsingWall(4, 3);
        scene.scenario.simulation.settleTime = 1.0;
        settings.varied = {variationFrom("friction", "uniform:0.2:1"), variationFrom("restitution", "uniform:0:0.5")};
        settings.members = 4;
        options.machine = "this one";
    }
    EnsembleReport make(const Execution& execution = Execution()) const {
        return ensembleStudy(std::vector{scene}, settings, options, execution);
    }

    EnsembleScene scene;
    EnsembleSettings settings;
    EnsembleOptions options;
};

void expectSameMember(const EnsembleMember& a, const EnsembleMember& b) {
    ASSERT_TRUE(a.done && b.done);
    EXPECT_EQ(a.drawn, b.drawn);
    EXPECT_EQ(a.trajectoryHash, b.trajectoryHash);
    EXPECT_EQ(a.figures, b.figures);
    EXPECT_EQ(a.surface->cells, b.surface->cells);
    EXPECT_EQ(a.surface->heights, b.surface->heights);
    EXPECT_EQ(a.surface->masses, b.surface->masses);
}

TEST_F(EnsembleStudy, IsTheSameHoweverManyRunAtATime) {
    options.jobs = 1;
    const EnsembleReport one = make();
    options.jobs = 3;
    options.threads = 3;
    const EnsembleReport three = make();
    EXPECT_TRUE(one.complete && three.complete);
    ASSERT_EQ(one.members.size(), 4u);
    for (std::size_t m = 0; m < 4; ++m) {
        expectSameMember(one.members[m], three.members[m]);
    }
    EXPECT_NE(one.members[0].trajectoryHash, one.members[1].trajectoryHash) << "members differ";
}

TEST_F(EnsembleStudy, MassOfAMemberIsThatOfItsDebris) {
    options.surface.withFallen = false;
    const EnsembleReport report = make();
    const FragmentSet fragments = *run(scene.inputs, scene.scenario, Stage::Fragments, {}, nullptr, Execution()).fragments;
    double mass = 0.0;
    for (const Fragment& fragment : fragments.list) {
        mass += fragment.mass;
    }
    for (const EnsembleMember& member : report.members) {
        // Masses are kept in single precision.
        EXPECT_NEAR(member.of(MemberMeasure::Mass), mass, 1e-5 * mass);
        EXPECT_GT(member.of(MemberMeasure::PileVolume), 0.0);
        EXPECT_NEAR(member.of(MemberMeasure::Footprint), 0.25 * static_cast<double>(member.surface->cells.size()), 1e-9);
    }
    // The beam lives and has fallen: with it there is more.
    options.surface.withFallen = true;
    EXPECT_GT(make().members[0].of(MemberMeasure::Mass), 1.01 * mass);
}

TEST_F(EnsembleStudy, SaysThatItReadsWhatIsKeptWhereNothingIsSimulated) {
    MemoryStore store;
    options.store = &store;
    const auto stages = [this] {
        std::map<std::string, Message> told;
        std::mutex mutex;
        const Execution execution([&](const Progress& progress) {
            const std::scoped_lock lock(mutex);
            told.emplace(progress.stage.id, progress.stage);
        });
        EXPECT_EQ(make(execution).members.size(), 4u);
        return told;
    };
    const auto making = stages();
    EXPECT_TRUE(making.contains("evidence.ensemble"));
    EXPECT_FALSE(making.contains("evidence.ensemble_kept"));
    ASSERT_EQ(store.worlds.size(), 4u);
    options.choice = WorldChoice::none();
    const auto reading = stages();
    ASSERT_TRUE(reading.contains("evidence.ensemble_kept"));
    EXPECT_EQ(englishText(reading.at("evidence.ensemble_kept")), "reading what is kept of 4 members of the ensemble");
    EXPECT_FALSE(reading.contains("evidence.ensemble")) << "nothing is simulated";
    store.worlds.clear();
    EXPECT_TRUE(stages().contains("evidence.ensemble_kept"));
    EXPECT_TRUE(store.worlds.empty());
}

TEST_F(EnsembleStudy, GoesOnFromWhatIsKept) {
    MemoryStore store;
    options.store = &store;
    options.jobs = 1;
    const Execution execution;
    store.interrupted = &execution;
    store.interruptAfter = 2;
    const EnsembleReport stopped = make(execution);
    EXPECT_FALSE(stopped.complete);
    EXPECT_GE(stopped.done().size(), 1u);
    EXPECT_LT(stopped.done().size(), 4u);
    EXPECT_NO_THROW(probabilityMap(stopped, usualThresholds)) << "what is done is of use";

    store.interrupted = nullptr;
    const EnsembleReport whole = make();
    EXPECT_TRUE(whole.complete);
    EXPECT_EQ(store.worlds.size(), 4u);
    EXPECT_TRUE(whole.members[0].kept);
    EXPECT_FALSE(whole.members[3].kept);
    options.store = nullptr;
    const EnsembleReport anew = make();
    for (std::size_t m = 0; m < 4; ++m) {
        expectSameMember(whole.members[m], anew.members[m]);
    }
    // More members: those that are there are taken.
    options.store = &store;
    settings.members = 5;
    const EnsembleReport more = make();
    EXPECT_TRUE(more.members[3].kept);
    EXPECT_FALSE(more.members[4].kept);
    expectSameMember(more.members[3], whole.members[3]);
}

TEST_F(EnsembleStudy, AFullDiskKeepsTheMembersOfThisTime) {
    MemoryStore store;
    store.full = true;
    options.store = &store;
    const EnsembleReport report = make();
    EXPECT_TRUE(report.complete);
    ASSERT_EQ(report.findings.list().size(), 1u);
    EXPECT_EQ(report.findings.list().front().what.id, "ensemble.not_kept");
    EXPECT_EQ(report.findings.list().front().count, 4);
}

TEST_F(EnsembleStudy, AMemberThatFailsTakesNoOtherWithIt) {
    options.look = [](const MemberSite& site, const Execution&) -> std::vector<double> {
        if (*site.scenario->simulation.friction < 0.5) {
            throw UsageError({"test.blind", "cannot be seen", {}}, {"test.look", "look", {}});
        }
        return {1.0};
    };
    settings.members = 6;
    const EnsembleReport report = make();
    EXPECT_FALSE(report.complete);
    const std::size_t done = report.done().size();
    EXPECT_GT(done, 0u);
    EXPECT_LT(done, 6u);
    for (const EnsembleMember& member : report.members) {
        EXPECT_EQ(member.done, member.failure.empty());
        EXPECT_EQ(member.looked.size(), member.done ? 1u : 0u);
    }
    EXPECT_EQ(report.findings.list().front().what.id, "ensemble.member_lost");
}

TEST_F(EnsembleStudy, MembersAreOfTheScenariosThatAreVaried) {
    scene.id = "whole";
    EnsembleScene other = scene;
    other.id = "low";
    other.inputs.fe = scenes::collapsingWall(4, 2);
    settings.varied.push_back(variationFrom("scenario", "choice:whole:low"));
    settings.members = 8;
    const EnsembleReport report = ensembleStudy(std::vector{scene, other}, settings, options, Execution());
    std::array<int, 2> counts{};
    for (const EnsembleMember& member : report.members) {
        ++counts[member.scene];
        EXPECT_EQ(member.drawn.back().second, member.scene == 0 ? "whole" : "low");
    }
    EXPECT_GT(counts[0], 0);
    EXPECT_GT(counts[1], 0);
    EXPECT_THROW(make(), UsageError) << "the other scenario is not there";
}

// "Mass that fell, kg: 9,000.00 ± 1.9 × 10⁻⁵": sums over cells differ by their rounding.
TEST_F(EnsembleStudy, RoundingIsNoSpread) {
    EnsembleReport report;
    for (const double mass : {9000.0, 8999.999909639359, 9000.00004, 9000.0}) {
        EnsembleMember member;
        member.done = true;
        member.figures.fill(mass);
        member.figures[static_cast<std::size_t>(MemberMeasure::RunOut)] = mass * (report.members.empty() ? 1.0 : 1.001);
        report.members.push_back(member);
    }
    const FigureSpread spread = spreadOf(report, MemberMeasure::Mass);
    EXPECT_EQ(spread.deviation, 0.0);
    EXPECT_EQ(spread.standardError, 0.0);
    EXPECT_EQ(spread.mean, 9000.0);
    EXPECT_EQ(spread.lower(), spread.upper());
    EXPECT_GT(spreadOf(report, MemberMeasure::RunOut).deviation, 1.0);
}

TEST_F(EnsembleStudy, MembersHaveNoSpreadWhereNothingVaries) {
    const FigureSpread spread = spreadOf({2.0, 4.0, 6.0, std::nan("")});
    EXPECT_EQ(spread.count, 3u);
    EXPECT_EQ(spread.mean, 4.0);
    EXPECT_EQ(spread.deviation, 2.0);
    EXPECT_NEAR(spread.standardError, 2.0 / std::sqrt(3.0), 1e-12);
    EXPECT_EQ(spread.middle, 4.0);
    EXPECT_NEAR(spread.low, 2.2, 1e-12);
    EXPECT_EQ(spread.lower(), 2.0) << "of three members the least is told, no quantile";
    EXPECT_EQ(spread.upper(), 6.0);
    std::vector<double> twenty(20);
    std::iota(twenty.begin(), twenty.end(), 0.0);
    EXPECT_NEAR(spreadOf(twenty).lower(), 0.95, 1e-12);
    EXPECT_NEAR(spreadOf(twenty).upper(), 18.05, 1e-12);
    EXPECT_EQ(spreadOf(std::vector<double>{}).count, 0u);
    EXPECT_TRUE(std::isnan(spreadOf({1.0}).deviation));
}

}  // namespace
}  // namespace rubble
