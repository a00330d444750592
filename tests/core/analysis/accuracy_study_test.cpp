#include "core/analysis/accuracy/accuracy_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/analysis/accuracy/accuracy_front.h"
#include "core/base/error.h"
#include "core/selftest/element_scene.h"
#include "tests/scenes/fe_scenes.h"
#include "tests/scenes/memory_store.h"

namespace rubble {
namespace {

/// A store that can be full, and after which the study can be given up.
class FailingStore : public MemoryStore {
public:
    const Execution* interrupted = nullptr;
    std::size_t interruptAfter = 0;  ///< worlds
    bool full = false;

protected:
    void admit(const WorldOrigin& origin) override {
        if (full) {
            throw WorldError({"test.full", "the disk is full", {}}, {"test.room", "make room", {}});
        }
        // After a cancel a world that is under way may come to its end before it hears of it.
        if (interrupted && interrupted->cancelled()) {
            throw Cancelled();
        }
        EXPECT_FALSE(worlds.contains(origin.key)) << "simulated twice";
    }
    void kept() override {
        if (interrupted && order.size() == interruptAfter) {
            interrupted->cancel();
        }
    }
};

class AccuracyStudy : public testing::Test {
protected:
    void SetUp() override {
        scenario.simulation.settleTime = 1.0;
        // As the reference, so that multiple 1 is that.
        scenario.fragments.birthWindow = 0.0;
        inputs.fe = scenes::collapsingWall(4, 3);
        options.timed = false;
        options.machine = "this one";
    }
    AccuracyReport study(const Execution& execution = Execution()) const {
        return accuracyStudy(inputs, scenario, sweepSettings(scenario, multiples, {}), options, execution);
    }
    std::vector<std::string> multiples{"1", "2.2"};
    Inputs inputs;
    Scenario scenario;
    AccuracyOptions options;
};

void expectSamePoint(const AccuracyPoint& a, const AccuracyPoint& b) {
    EXPECT_EQ(a.setting, b.setting);
    EXPECT_EQ(a.done, b.done);
    EXPECT_EQ(a.trajectoryHash, b.trajectoryHash);
    EXPECT_EQ(a.difference.values, b.difference.values);
    EXPECT_EQ(a.difference.accuracy, b.difference.accuracy);
    EXPECT_EQ(a.standings, b.standings);
    EXPECT_EQ(a.bodies, b.bodies);
    EXPECT_EQ(a.bodiesPeak, b.bodiesPeak);
    EXPECT_EQ(a.fragmentErrors, b.fragmentErrors);
    ASSERT_EQ(a.repeats.size(), b.repeats.size());
    for (std::size_t r = 0; r < a.repeats.size(); ++r) {
        EXPECT_EQ(a.repeats[r].values, b.repeats[r].values);
    }
}

void expectSame(const AccuracyReport& a, const AccuracyReport& b) {
    ASSERT_TRUE(a.floor && b.floor);
    EXPECT_EQ(a.floor->largest.values, b.floor->largest.values);
    EXPECT_EQ(a.spread.middle, b.spread.middle);
    ASSERT_EQ(a.points.size(), b.points.size());
    expectSamePoint(a.reference, b.reference);
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        expectSamePoint(a.points[i], b.points[i]);
    }
}

TEST_F(AccuracyStudy, TellsOfPointsAsTheyAreDone) {
    std::vector<AccuracyReport> told;
    options.jobs = 2;
    options.timed = true;
    options.grown = [&told](const AccuracyReport& report) { told.push_back(report); };
    const AccuracyReport report = study();
    // The settings, three worlds of the reference, two settings (multiple 1 is the reference), and the cost of the reference and of
    // each setting.
    ASSERT_EQ(told.size(), 10u);
    EXPECT_FALSE(told.front().reference.done);
    EXPECT_EQ(told.front().points.size(), 3u) << "the settings are known before any is done";
    const auto done = [](const AccuracyReport& r) {
        return std::count_if(r.points.begin(), r.points.end(), [](const AccuracyPoint& p) { return p.done; });
    };
    for (std::size_t i = 1; i < told.size(); ++i) {
        EXPECT_GE(done(told[i]), done(told[i - 1]));
    }
    EXPECT_EQ(done(told[5]), 3);
    EXPECT_FALSE(told[5].points.back().cost.timed());
    EXPECT_TRUE(told.back().points.back().cost.timed());
    expectSame(told.back(), report);
    // Nobody listening changes nothing but the times.
    options.grown = nullptr;
    expectSame(study(), report);
}

TEST_F(AccuracyStudy, BirthsTakenTogetherAreHeldAgainstTheSameReference) {
    const std::vector<VariedParameter> varied{{"birth_window", {"0", "1000"}}};
    const auto swept = [&] {
        return accuracyStudy(inputs, scenario, sweepSettings(scenario, std::vector<std::string>{"2.2"}, varied), options,
                             Execution());
    };
    const AccuracyReport report = swept();
    ASSERT_EQ(report.points.size(), 3u);
    const AccuracyPoint& apart = report.points[0];
    const AccuracyPoint& together = report.points[1];
    ASSERT_TRUE(apart.done && together.done);
    EXPECT_EQ(together.fragments, apart.fragments);
    EXPECT_LT(together.bodies, apart.bodies);
    EXPECT_NE(together.trajectoryHash, apart.trajectoryHash);
    EXPECT_EQ(together.fragmentErrors.size(), static_cast<std::size_t>(together.fragments));
    scenario.fragments.birthWindow = 1000.0;
    const AccuracyReport other = swept();
    EXPECT_EQ(other.reference.trajectoryHash, report.reference.trajectoryHash) << "the reference takes each state by itself";
    expectSamePoint(other.points[1], together);
}

TEST_F(AccuracyStudy, FragmentsThatTheReferenceLacksAreNotComparedByChance) {
    selftest::ElementScene scene;
    const std::vector<Vec3> corners{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {0, 0, 6}};
    scene.element(ElementShape::Tetrahedron, corners, "1100000").element(ElementShape::Tetrahedron, corners, "1111000");
    scene.damage = [](std::size_t state, FeState& fields) {
        if (state == 1) {
            fields.positions[4].x() = std::numeric_limits<double>::quiet_NaN();
        }
    };
    inputs.fe = scene.result();
    const std::vector<VariedParameter> varied{{"birth_window", {"0", "1000"}}};
    const AccuracyReport report =
        accuracyStudy(inputs, scenario, sweepSettings(scenario, std::vector<std::string>{"2.2"}, varied), options, Execution());
    ASSERT_EQ(report.points.size(), 3u);
    EXPECT_TRUE(report.points[0].done);
    EXPECT_FALSE(report.points[1].done) << "the second element has no place at the state of the first hand-over";
    EXPECT_EQ(report.points[1].failure.id, "accuracy.other_fragments");
    EXPECT_FALSE(report.complete);
}

TEST_F(AccuracyStudy, ComparesEachSettingWithTheReference) {
    const AccuracyReport report = study();
    EXPECT_TRUE(report.complete);
    ASSERT_EQ(report.points.size(), 3u);
    EXPECT_EQ(report.points.back().setting, "paper");
    EXPECT_TRUE(std::isnan(report.reference.multiple[0]));
    EXPECT_EQ(report.reference.bodies, 12);
    EXPECT_EQ(report.reference.difference.of(Measure::CoreIou), 1.0);
    EXPECT_EQ(report.reference.difference.accuracy, (std::vector<double>{1.0, 1.0, 1.0}));
    EXPECT_EQ(report.spread.pairs, 3);
    // By hand: two runs of the pipeline, measured and compared.
    const auto fieldOf = [&](const Scenario& one) {
        DebrisRecorder sink;
        const Results results = run(inputs, one, Stage::Simulation, {}, &sink, Execution());
        return measureDebris(sink.debris(DebrisInstant::AtRest), CollapsePlan(*results.fragments, inputs.fe->mesh()), {}, {});
    };
    for (const AccuracyPoint& point : report.points) {
        ASSERT_TRUE(point.done);
        const DebrisField reference = fieldOf(referenceScenario(scenario));
        const DebrisField other = fieldOf(point.scenario);
        EXPECT_EQ(compareDebris(reference, other).values, point.difference.values) << point.setting;
        for (std::size_t f = 0; f < point.fragmentErrors.size(); ++f) {
            EXPECT_EQ(point.fragmentErrors[f], (other.debris.fragments[f].centre - reference.debris.fragments[f].centre).norm());
        }
    }
    // Every fragment has an error, and the rate counts them.
    const AccuracyPoint& paper = report.points.back();
    const auto within = std::count_if(paper.fragmentErrors.begin(), paper.fragmentErrors.end(), [](double e) { return e < 0.3; });
    EXPECT_EQ(static_cast<double>(within) / 12.0, paper.difference.accuracy[2]);
    EXPECT_LT(report.points[1].bodies, 12) << "2.2 mean distances take neighbours together";
}

TEST_F(AccuracyStudy, TheFloorIsThatOfTheReference) {
    options.study.repeats = 3;
    const AccuracyReport report = study();
    StudySettings settings;
    settings.repeats = 3;
    const RepeatFloor byHand = repeatFloor(inputs, referenceScenario(scenario), settings, Execution());
    EXPECT_EQ(report.floor->trajectoryHash, byHand.trajectoryHash);
    EXPECT_EQ(report.floor->largest.values, byHand.largest.values);
    EXPECT_EQ(report.spread.pairs, 6);
    for (std::size_t m = 0; m < measureCount; ++m) {
        EXPECT_EQ(report.spread.largest[m], byHand.largest.departure(static_cast<Measure>(m)));
        EXPECT_LE(report.spread.least[m], report.spread.middle[m]);
        EXPECT_LE(report.spread.middle[m], report.spread.largest[m]);
    }
}

TEST_F(AccuracyStudy, RepeatsOfASettingShowHowFarItScatters) {
    const AccuracyReport without = study();
    FailingStore store;
    options.store = &store;
    options.settingRepeats = 2;
    const AccuracyReport report = study();
    EXPECT_TRUE(report.complete);
    EXPECT_EQ(store.worlds.size(), 9u)
        << "the reference, which multiple 1 is too, multiple 2.2 and the paper, each with two repeats";
    // Of the reference they are those of the floor.
    ASSERT_EQ(report.points[0].repeats.size(), 2u);
    for (std::size_t r = 0; r < 2; ++r) {
        EXPECT_EQ(report.points[0].repeats[r].values, report.floor->repeats[r].difference.values);
    }
    // By hand.
    const StudyBase reference = beginStudy(inputs, referenceScenario(scenario), options.study, Execution());
    const DebrisField field = simulateWorld(describeBase(reference), reference, options.study, Execution()).field;
    for (std::size_t i = 1; i < report.points.size(); ++i) {
        const AccuracyPoint& point = report.points[i];
        ASSERT_EQ(point.repeats.size(), 2u) << point.setting;
        EXPECT_NE(point.repeats[0].values, point.repeats[1].values);
        const StudyBase own = beginStudy(inputs, point.scenario, options.study, Execution());
        const RunDescription second =
            describeRepeat({own.inputs, own.scenario, own.results}, options.study.birthShift, 2, Execution());
        const StudyWorld world = simulateWorld(second, reference, options.study, Execution());
        EXPECT_EQ(point.repeats[1].values, compareDebris(field, world.field).values) << point.setting;
        for (const AccuracyKind& kind : accuracyKinds(options.study.measures.tolerances)) {
            const auto range = accuracyRange(point, kind);
            ASSERT_TRUE(range);
            const double amount = accuracyOf(point.difference, kind);
            const double first = accuracyOf(point.repeats[0], kind), other = accuracyOf(point.repeats[1], kind);
            EXPECT_EQ(*range, std::pair(std::min({amount, first, other}), std::max({amount, first, other})));
        }
        EXPECT_FALSE(accuracyRange(without.points[i], {}));
    }
    // They change nothing else.
    for (std::size_t i = 0; i < report.points.size(); ++i) {
        EXPECT_EQ(report.points[i].trajectoryHash, without.points[i].trajectoryHash);
        EXPECT_EQ(report.points[i].standings, without.points[i].standings);
    }
    EXPECT_EQ(report.floor->largest.values, without.floor->largest.values);
    EXPECT_EQ(accuracyTasks(inputs, scenario, sweepSettings(scenario, multiples, {}), options, Execution()).size(), 9u);
    // More than the floor has: the setting that is the reference gets them too, and the floor stays.
    options.settingRepeats = 3;
    const AccuracyReport more = study();
    for (const AccuracyPoint& point : more.points) {
        EXPECT_EQ(point.repeats.size(), 3u) << point.setting;
    }
    EXPECT_EQ(more.floor->largest.values, without.floor->largest.values);
    EXPECT_EQ(store.worlds.size(), 12u);
    options.settingRepeats = 2;
    // One of them alone, as a task of a cluster, needs no other.
    const WorldOrigin wanted = originOf(inputs, report.points[1].scenario, 2, options.study.birthShift, options.machine);
    FailingStore empty;
    options.store = &empty;
    options.choice = WorldChoice::only(wanted.key);
    study();
    ASSERT_EQ(empty.order.size(), 1u);
    EXPECT_EQ(empty.order.front().key, wanted.key);
}

TEST_F(AccuracyStudy, DoesNotDependOnHowManyWorldsRunAtOnce) {
    options.settingRepeats = 1;
    options.jobs = 1;
    const AccuracyReport one = study();
    for (const int jobs : {2, 5}) {
        options.jobs = jobs;
        expectSame(study(), one);
    }
}

TEST_F(AccuracyStudy, AnInterruptedSweepGoesOnAndEndsTheSame) {
    const AccuracyReport whole = study();
    for (const std::size_t after : {1u, 2u, 4u}) {
        FailingStore store;
        options.store = &store;
        options.jobs = 1;
        const Execution execution;
        store.interrupted = &execution;
        store.interruptAfter = after;
        const AccuracyReport partial = study(execution);
        EXPECT_FALSE(partial.complete);
        EXPECT_EQ(store.order.size(), after);
        for (std::size_t i = 0; i < partial.points.size(); ++i) {
            if (partial.points[i].done) {
                expectSamePoint(partial.points[i], whole.points[i]);
            }
        }
        store.interrupted = nullptr;
        options.jobs = 3;
        const AccuracyReport second = study();
        EXPECT_TRUE(second.complete);
        EXPECT_EQ(store.order.size(), 5u)
            << "the reference, which multiple 1 is too, two repeats, multiple 2.2, the paper: none twice";
        expectSame(second, whole);
        EXPECT_TRUE(second.reference.kept);
        options.store = nullptr;
    }
}

TEST_F(AccuracyStudy, SettingsThatDifferInNothingThatCountsAreSimulatedOnce) {
    FailingStore store;
    options.store = &store;
    const std::vector<VariedParameter> varied{{"bodies_max", {"4500", "4000"}}, {"iterations", {"10", "20"}}};
    const auto sweep = [&] {
        return accuracyStudy(inputs, scenario, sweepSettings(scenario, std::vector<std::string>{"2.2"}, varied), options,
                             Execution());
    };
    const AccuracyReport report = sweep();
    ASSERT_TRUE(report.complete);
    ASSERT_EQ(report.points.size(), 5u);
    // The reference, its repeats, the one setting, the published method.
    EXPECT_EQ(store.worlds.size(), 1u + static_cast<std::size_t>(options.study.repeats) + 2u);
    for (std::size_t i = 1; i < 4; ++i) {
        EXPECT_TRUE(report.points[i].done);
        EXPECT_EQ(report.points[i].trajectoryHash, report.points[0].trajectoryHash);
        EXPECT_EQ(report.points[i].difference.values, report.points[0].difference.values);
        EXPECT_EQ(report.points[i].bodiesPeak, report.points[0].bodiesPeak);
    }
    // It is what each of them would have come to alone.
    options.store = nullptr;
    for (const AccuracySetting& setting : sweepSettings(scenario, std::vector<std::string>{"2.2"}, varied)) {
        const AccuracyReport alone = accuracyStudy(inputs, scenario, std::vector{setting}, options, Execution());
        const auto same = std::find_if(report.points.begin(), report.points.end(),
                                       [&](const AccuracyPoint& point) { return point.setting == setting.name; });
        ASSERT_NE(same, report.points.end());
        EXPECT_EQ(alone.points[0].trajectoryHash, same->trajectoryHash);
    }
    // What is kept of one of them serves the others on a second start.
    options.store = &store;
    const std::size_t before = store.worlds.size();
    const AccuracyReport second = sweep();
    EXPECT_TRUE(second.complete);
    EXPECT_TRUE(std::all_of(second.points.begin(), second.points.end(), [](const AccuracyPoint& point) { return point.kept; }));
    EXPECT_EQ(store.worlds.size(), before);
    // A substep counts.
    const std::vector<VariedParameter> different{{"substeps", {"4", "5"}}};
    const AccuracyReport two =
        accuracyStudy(inputs, scenario, sweepSettings(scenario, std::vector<std::string>{"2.2"}, different), options, Execution());
    EXPECT_NE(two.points[0].trajectoryHash, two.points[1].trajectoryHash);
}

TEST_F(AccuracyStudy, CostsAreMeasuredOnceAndTakenUp) {
    FailingStore store;
    options.store = &store;
    options.timed = true;
    int screens = 0;
    struct Blank : LiveScreen {
        void draw(double) override {}
    };
    options.screen = [&](const RunDescription&, const std::shared_ptr<const TrajectoryReader>&) {
        ++screens;
        return std::make_unique<Blank>();
    };
    const AccuracyReport first = study();
    EXPECT_EQ(screens, 3) << "multiple 1 is the reference";
    EXPECT_GT(first.reference.cost.wallSeconds, 0.0);
    for (const AccuracyPoint& point : first.points) {
        EXPECT_GT(point.cost.wallSeconds, 0.0) << point.setting;
        EXPECT_GT(point.cost.stepMeanMs, 0.0);
        EXPECT_GE(point.cost.stepWorstMs, point.cost.stepMeanMs);
        EXPECT_GT(point.cost.fps, 0.0);
    }
    const AccuracyReport second = study();
    EXPECT_EQ(screens, 3) << "nothing is measured twice";
    EXPECT_EQ(second.points[0].cost.wallSeconds, first.points[0].cost.wallSeconds);
    EXPECT_EQ(second.points[0].cost.fps, first.points[0].cost.fps);
    store.costs[first.points[1].origin.key].othersShare = 0.5;
    EXPECT_GE(study().findings.count("accuracy.disturbed"), 1);
    options.retimed = true;
    study();
    EXPECT_EQ(screens, 6) << "everything is measured again";
}

TEST_F(AccuracyStudy, WithoutADisplayEverythingElseIsMeasured) {
    options.timed = true;
    int asked = 0;
    options.screen = [&](const RunDescription&, const std::shared_ptr<const TrajectoryReader>&) -> std::unique_ptr<LiveScreen> {
        ++asked;
        throw WorldError({"test.no_display", "no display", {}}, {"test.remedy", "start one", {}});
    };
    const AccuracyReport report = study();
    EXPECT_TRUE(report.complete);
    EXPECT_EQ(asked, 1) << "one answer is enough";
    EXPECT_EQ(report.findings.count("accuracy.no_fps"), 1);
    EXPECT_TRUE(std::isnan(report.points[0].cost.fps));
    EXPECT_GT(report.points[2].cost.wallSeconds, 0.0);
}

TEST_F(AccuracyStudy, AFullDiskLosesNoPoint) {
    FailingStore store;
    store.full = true;
    options.store = &store;
    const AccuracyReport report = study();
    EXPECT_TRUE(report.complete);
    EXPECT_TRUE(report.points[0].done);
    EXPECT_EQ(report.findings.count("accuracy.not_kept"), 5);
}

TEST_F(AccuracyStudy, AWorldWithoutMemoryTakesNoOtherWithIt) {
    // Memory is out when the first of the settings is kept, and comes back for the second try but never for the third world.
    class Failing : public FailingStore {
    public:
        using FailingStore::keep;
        void keep(const WorldOrigin& origin, const SimulatedWorld& world) override {
            if (origin.scenario == lost) {
                throw std::bad_alloc();
            }
            if (origin.scenario == once && !m_failed) {
                m_failed = true;
                throw std::bad_alloc();
            }
            FailingStore::keep(origin, world);
        }
        Digest lost;
        Digest once;

    private:
        bool m_failed = false;
    };
    Failing store;
    options.store = &store;
    options.jobs = 2;
    const auto settings = sweepSettings(scenario, multiples, {});
    store.once = originOf(inputs, settings[0].scenario, 0, 0.0, "").scenario;
    store.lost = originOf(inputs, settings[1].scenario, 0, 0.0, "").scenario;
    const AccuracyReport report = study();
    EXPECT_FALSE(report.complete);
    EXPECT_TRUE(report.points[0].done);
    EXPECT_TRUE(report.points[0].failure.empty());
    EXPECT_FALSE(report.points[1].done);
    EXPECT_EQ(report.points[1].failure.id, "accuracy.memory");
    EXPECT_TRUE(report.points[2].done);
}

TEST_F(AccuracyStudy, OriginsTellWhatDiffers) {
    const WorldOrigin origin = originOf(inputs, scenario, 0, 0.0, "here");
    EXPECT_EQ(foreignPart(origin, origin), "");
    WorldOrigin other = origin;
    other.machine = "elsewhere";
    EXPECT_EQ(foreignPart(origin, other), "") << "another machine marks, and does not part";
    other = origin;
    other.build = "another compiler";
    EXPECT_EQ(foreignPart(origin, other), "build");
    Scenario changed = scenario;
    changed.simulation.stepRate = 61.0;
    EXPECT_EQ(foreignPart(origin, originOf(inputs, changed, 0, 0.0, "here")), "scenario");
    EXPECT_EQ(foreignPart(origin, originOf(inputs, scenario, 1, 1e-6, "here")), "repeat");
    EXPECT_NE(origin.key, originOf(inputs, scenario, 1, 1e-6, "here").key);
    EXPECT_NE(originOf(inputs, scenario, 1, 1e-6, "here").key, originOf(inputs, scenario, 1, 1e-5, "here").key);
    other = origin;
    other.feSha256 = "another file";
    EXPECT_EQ(foreignPart(origin, other), "FE result");
    other = origin;
    other.key = Digest{};
    EXPECT_NE(foreignPart(origin, other), "");
}

TEST_F(AccuracyStudy, PlansWithoutSimulating) {
    options.simulated = false;
    FailingStore store;
    options.store = &store;
    const AccuracyReport report = study();
    EXPECT_TRUE(report.complete);
    EXPECT_FALSE(report.floor);
    EXPECT_FALSE(report.points[0].done);
    EXPECT_EQ(report.points[0].fragments, 12);
    EXPECT_GT(report.points[0].bodies, 0);
    EXPECT_TRUE(store.order.empty());
}

TEST_F(AccuracyStudy, WithoutFragmentsThereIsNothingToCompare) {
    scenes::Block standing;
    inputs.fe = scenes::makeScene({standing}, 3, 0.1);
    const AccuracyReport report = study();
    EXPECT_TRUE(report.complete);
    EXPECT_EQ(report.points[0].fragments, 0);
    EXPECT_TRUE(std::isnan(report.points[0].difference.of(Measure::MedianDistance)));
    EXPECT_TRUE(report.points[0].fragmentErrors.empty());
}

}  // namespace
}  // namespace rubble
