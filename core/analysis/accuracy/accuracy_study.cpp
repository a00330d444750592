#include "core/analysis/accuracy/accuracy_study.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <new>

#include "core/analysis/accuracy/world_pool.h"
#include "core/analysis/accuracy/world_twins.h"
#include "core/base/error.h"
#include "core/base/unknown.h"

namespace rubble {

namespace {

/// Share of the machine's time that a live run takes, next to a timed one.
constexpr double liveWeight = 1.2;

constexpr std::string_view memoryFailure = "accuracy.memory";

double middleOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// One world of a sweep: the reference, a setting, or a repeat of one of them.
struct SweepWorld {
    AccuracyPoint* point = nullptr;
    int repeat = 0;  ///< 0: the run itself
    std::string name;
    Results results;  ///< up to the clusters
    WorldOrigin origin;
    double weight = 1.0;
    std::size_t twin = 0;  ///< first world of the same bits: itself, unless a setting before differs in nothing that counts
    std::shared_ptr<const SimulatedWorld> world;
    bool simulatedAlone = false;                 ///< here and now, with the whole machine to itself
    std::vector<std::size_t> repeats;            ///< of the first of its bits: the worlds that repeat it
    std::optional<DebrisDifference> difference;  ///< of a repeat: it less the reference, once measured

    bool isRepeat() const { return repeat > 0; }
};

/// A sweep while it is made.
class Sweep {
public:
    Sweep(const Inputs& inputs, const AccuracyOptions& options, const Execution& execution)
        : m_inputs(inputs), m_options(options), m_execution(execution) {}

    /// Everything up to the clusters of all settings.
    void plan(const Scenario& scenario, std::span<const AccuracySetting> settings) {
        const Scenario reference = referenceScenario(scenario);
        m_base = beginStudy(m_inputs, reference, m_options.study, m_execution);
        report.instant = m_options.study.instant;
        report.elements = static_cast<std::int64_t>(m_inputs.fe->mesh().elementCount());
        report.span = collapseSpan(*m_base.results.fragments, m_inputs.fe->times().back());
        Scenario carried = m_base.scenario;
        carried.effects.loose = LooseStructurePolicy::AtOnce;
        report.comesLoose = settledBy(m_inputs, carried, m_base.results).effects.loose != LooseStructurePolicy::Fe;
        report.reference.setting = std::string(referenceSetting);
        report.reference.scenario = reference;
        report.points.resize(settings.size());
        add(report.reference, m_base.results);
        addRepeats(0, m_options.study.repeats);
        for (std::size_t i = 0; i < settings.size(); ++i) {
            AccuracyPoint& point = report.points[i];
            point.setting = settings[i].name;
            point.scenario = settings[i].scenario;
            if (m_options.choice.single() && !wantsAny(point.scenario)) {
                continue;
            }
            m_execution.report({"analysis.accuracy_plan", "clustering {0} settings", {settings.size()}},
                               static_cast<double>(i) / static_cast<double>(settings.size()));
            Results results = run(m_inputs, point.scenario, Stage::Clusters, m_base.results, nullptr, m_execution);
            if (comparable(*results.fragments)) {
                add(point, std::move(results));
                addRepeats(m_worlds.back().twin, m_options.settingRepeats);
            } else {
                point.failure = {
                    "accuracy.other_fragments", "an element makes a fragment here or in the reference, not in both", {}};
            }
        }
    }

    std::vector<StudyTask> tasks() const {
        std::vector<StudyTask> list;
        for (std::size_t i = 0; i < m_worlds.size(); ++i) {
            const SweepWorld& world = m_worlds[i];
            if (world.twin == i) {
                list.push_back(studyTask(m_inputs, world.point->scenario, &world.results, world.origin, world.name));
            }
        }
        return list;
    }

    /// All worlds that are chosen, in parallel; the largest first, so that none is left alone at the end.
    void simulateAll() {
        for (SweepWorld& world : m_worlds) {
            takeKept(world);
        }
        shareAmongTwins();
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < m_worlds.size(); ++i) {
            if (!m_worlds[i].world && m_worlds[i].twin == i && m_options.choice.wants(m_worlds[i].origin.key)) {
                order.push_back(i);
            }
        }
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return m_worlds[a].weight > m_worlds[b].weight; });
        tell();
        simulateTogether(order, m_options.jobs);
        // What found no memory beside others may find it alone.
        std::erase_if(order, [&](std::size_t i) { return m_worlds[i].world || !outOfMemory(m_worlds[i]); });
        for (const std::size_t i : order) {
            m_worlds[i].point->failure = {};
        }
        simulateTogether(order, 1);
    }

    /// Whoever of them has a world gives it to the others.
    void shareAmongTwins() {
        const auto give = [](const SweepWorld& from, SweepWorld& to) {
            if (from.world && !to.world) {
                to.world = from.world;
                to.point->kept = from.point->kept;
            }
        };
        for (const SweepWorld& world : m_worlds) {
            give(world, m_worlds[world.twin]);
        }
        for (SweepWorld& world : m_worlds) {
            const SweepWorld& first = m_worlds[world.twin];
            if (&first != &world) {
                give(first, world);
                world.point->failure = first.point->failure;
            }
        }
    }

    /// What the worlds that are there say.
    void measureAll() {
        shareAmongTwins();
        m_measured.resize(m_worlds.size());
        std::vector<const DebrisField*> floorFields;
        const std::size_t floorWorlds = std::min(m_worlds.size(), 1 + static_cast<std::size_t>(m_options.study.repeats));
        for (std::size_t i = 0; i < m_worlds.size(); ++i) {
            if (m_worlds[i].world && !m_measured[i] && (i == 0 || m_measured[0])) {
                m_measured[i] = measureWorld(*m_worlds[i].world, m_base, m_options.study);
            }
            if (m_measured[i] && i < floorWorlds) {
                floorFields.push_back(&m_measured[i]->field);
            }
        }
        if (m_measured.empty() || !m_measured[0]) {
            return;
        }
        report.floor = floorOf(*m_measured[0], std::span(m_measured).subspan(1, floorWorlds - 1), m_base.scenario.fragments.seed);
        report.spread = spreadOf(floorFields);
        for (std::size_t i = 0; i < m_worlds.size(); ++i) {
            SweepWorld& world = m_worlds[i];
            if (m_measured[i] && !world.isRepeat()) {
                fill(*world.point, world, *m_measured[0], *m_measured[i]);
            } else if (m_measured[i] && !world.difference) {
                world.difference = compareDebris(m_measured[0]->field, m_measured[i]->field);
            }
        }
        for (SweepWorld& world : m_worlds) {
            if (!world.isRepeat() && world.point != &report.reference) {
                fillRepeats(*world.point, m_worlds[world.twin]);
            }
        }
    }

    /// Tells who listens what there is.
    void tell() {
        if (m_options.grown) {
            const std::scoped_lock lock(m_mutex);
            measureAll();
            m_options.grown(report);
        }
    }

    /// Wall time, ms per step and live FPS, one setting at a time.
    void measureCosts() {
        double all = 0.0;
        for (const SweepWorld& world : m_worlds) {
            all += world.isRepeat() ? 0.0 : world.weight;
        }
        double before = 0.0;
        for (SweepWorld& world : m_worlds) {
            if (world.isRepeat() || !world.point->failure.empty() || (m_options.choice.single() && !world.simulatedAlone)) {
                continue;
            }
            const double from = before / all;
            before += world.weight;
            guarded(*world.point, [&] { measureCost(world, from, before / all); });
            if (world.point->cost.disturbed()) {
                report.findings.add({"accuracy.disturbed", "Other programs worked on this machine while settings were timed.", {}},
                                    {"accuracy.disturbed.remedy", "Time them again on a quiet machine (--retime).", {}},
                                    world.point->setting + ": " + englishNumber(100.0 * world.point->cost.othersShare) +
                                        " % of the processors' time");
            }
            tell();
        }
    }

    /// Something failed, or was left open because others were to make it.
    bool lacking() const {
        const auto lacks = [this](const SweepWorld& world) {
            return world.isRepeat() ? !m_options.choice.all() && world.world == nullptr
                                    : !world.point->failure.empty() || !world.point->done;
        };
        const auto failed = [](const AccuracyPoint& point) { return !point.failure.empty(); };
        return std::ranges::any_of(m_worlds, lacks) || std::ranges::any_of(report.points, failed);
    }

    AccuracyReport report;

private:
    WorldOrigin origin(const Scenario& scenario, int repeat) const {
        return originOf(m_inputs, scenario, repeat, m_options.study.birthShift, m_options.machine);
    }

    /// Fragments are held against those of the reference by their place in the set.
    bool comparable(const FragmentSet& fragments) const {
        const std::vector<Fragment>& own = fragments.list;
        return std::ranges::equal(own, m_base.results.fragments->list, {}, &Fragment::element, &Fragment::element);
    }

    /// A world of this setting is one of those chosen.
    bool wantsAny(const Scenario& scenario) const {
        bool wanted = false;
        for (int repeat = 0; repeat <= m_options.settingRepeats; ++repeat) {
            wanted = wanted || m_options.choice.wants(origin(scenario, repeat).key);
        }
        return wanted;
    }

    int threads() const { return m_options.study.threads > 0 ? m_options.study.threads : m_execution.threads(); }

    void add(AccuracyPoint& point, Results results) {
        const Sizing& sizing = *results.sizing;
        const bool single = point.scenario.grid.oneBodyPerFragment;
        const std::array<double, 3> grid{sizing.grid.l, sizing.grid.w, sizing.grid.h};
        for (std::size_t a = 0; a < 3; ++a) {
            point.multiple[a] = single ? unknown : sizing.axis[a].multiple;
            point.grid[a] = single ? unknown : grid[a];
        }
        point.fragments = static_cast<std::int64_t>(results.fragments->size());
        point.bodies = static_cast<std::int64_t>(results.clustering->list.size());
        point.origin = origin(point.scenario, 0);
        point.cost.threads = threads();
        SweepWorld world;
        world.point = &point;
        world.name = point.setting;
        world.results = std::move(results);
        world.origin = point.origin;
        // A step costs about as much as there are bodies, and something always.
        world.weight = 50.0 + static_cast<double>(point.bodies);
        world.twin = m_firstOf.emplace(worldBits(m_inputs, point.scenario, world.results), m_worlds.size()).first->second;
        m_worlds.push_back(std::move(world));
    }

    /// Repeats of a world, up to so many in all.
    void addRepeats(std::size_t of, int count) {
        for (int repeat = static_cast<int>(m_worlds[of].repeats.size()) + 1; repeat <= count; ++repeat) {
            SweepWorld world;
            world.point = m_worlds[of].point;
            world.repeat = repeat;
            world.name = (of == 0 ? "" : m_worlds[of].name + " ") + "repeat " + std::to_string(repeat);
            world.results = m_worlds[of].results;
            world.weight = m_worlds[of].weight;
            world.origin = origin(world.point->scenario, repeat);
            world.twin = m_worlds.size();
            m_worlds[of].repeats.push_back(world.twin);
            m_worlds.push_back(std::move(world));
        }
    }

    RunDescription describe(const SweepWorld& world, const Execution& execution) const {
        const Scenario& scenario = world.point->scenario;
        return world.isRepeat()
                   ? describeRepeat({m_inputs, scenario, world.results}, m_options.study.birthShift, world.repeat, execution)
                   : describeRun(m_inputs, scenario, world.results);
    }

    void simulateTogether(const std::vector<std::size_t>& order, int jobs) {
        PoolShare share{m_options.study.threads, jobs};
        for (const std::size_t i : order) {
            share.weights.push_back(m_worlds[i].weight);
        }
        const bool alone = jobs == 1 || threads() == 1 || m_options.choice.single();
        runInParallel(order.size(), share,
                      {"analysis.accuracy", "simulating {0} worlds: the reference, the settings, their repeats", {order.size()}},
                      m_execution, [&](std::size_t i, const Execution& own) {
                          SweepWorld& world = m_worlds[order[i]];
                          simulateOne(world, own);
                          world.simulatedAlone = alone;
                      });
    }

    static bool outOfMemory(const SweepWorld& world) { return !world.isRepeat() && world.point->failure.id == memoryFailure; }

    void takeKept(SweepWorld& world) {
        if (!m_options.store) {
            return;
        }
        std::optional<SimulatedWorld> kept = m_options.store->world(world.origin, report.findings);
        const std::size_t fragments = m_base.results.fragments->size();
        if (!kept || kept->atRest.fragments.size() != fragments || kept->atFeEnd.fragments.size() != fragments) {
            return;
        }
        world.world = std::make_shared<const SimulatedWorld>(std::move(*kept));
        if (!world.isRepeat()) {
            world.point->kept = true;
        }
    }

    void simulateOne(SweepWorld& world, const Execution& own) {
        const auto simulated = [&] {
            const auto checkpoints = m_options.store != nullptr ? m_options.store->checkpoints(world.origin) : nullptr;
            SimulatedWorld made = simulateDebris(describe(world, own), own, checkpoints.get());
            noteCheckpoints(made);
            keep([&](StudyStore& store) { store.keep(world.origin, made); });
            const std::scoped_lock lock(m_mutex);
            world.world = std::make_shared<const SimulatedWorld>(std::move(made));
        };
        AccuracyPoint lost;
        guarded(world.isRepeat() ? lost : *world.point, simulated);
        if (!lost.failure.empty()) {
            const std::scoped_lock lock(m_mutex);
            report.findings.add({"accuracy.repeat_lost", "A repeat could not be simulated.", {}},
                                {"accuracy.repeat_lost.remedy", "Start again: what is done is kept.", {}},
                                world.point->setting + ": " + englishText(lost.failure));
        }
        tell();
    }

    void noteCheckpoints(const SimulatedWorld& made) {
        const std::scoped_lock lock(m_mutex);
        report.findings.append(made.checkpoints.findings);
    }

    /// A setting that fails takes no other with it.
    template <class Act>
    void guarded(AccuracyPoint& point, Act act) {
        try {
            act();
        } catch (const std::bad_alloc&) {
            const std::scoped_lock lock(m_mutex);
            point.failure = {std::string(memoryFailure), "there was not enough memory for it", {}};
        } catch (const Error& error) {
            const std::scoped_lock lock(m_mutex);
            point.failure = error.message();
        }
    }

    template <class Keep>
    void keep(Keep keepIn) {
        if (!m_options.store) {
            return;
        }
        try {
            keepIn(*m_options.store);
        } catch (const WorldError& error) {
            const std::scoped_lock lock(m_mutex);
            report.findings.add({"accuracy.not_kept", "A result could not be kept for a second start.", {}},
                                {"accuracy.not_kept.remedy", "Make room for the cache, or name another folder.", {}}, error.what());
        }
    }

    void fill(AccuracyPoint& point, const SweepWorld& swept, const StudyWorld& reference, const StudyWorld& measured) {
        if (!point.done) {
            point.done = true;
            point.trajectoryHash = measured.trajectoryHash;
            point.breaches = measured.breaches;
            point.bodiesPeak = swept.world->bodiesPeak;
            point.difference = compareDebris(reference.field, measured.field);
            point.fragmentErrors = fragmentErrors(reference.field.debris, measured.field.debris);
        }
        // The floor rises while its repeats come in.
        for (std::size_t m = 0; m < measureCount; ++m) {
            const Measure measure = static_cast<Measure>(m);
            point.standings[m] = point.trajectoryHash == reference.trajectoryHash
                                     ? Standing::Identical
                                     : standingOf(point.difference.departure(measure), report.floor->largest.departure(measure));
        }
    }

    /// @param first  of the same bits as the point's own world
    void fillRepeats(AccuracyPoint& point, const SweepWorld& first) const {
        point.repeats.clear();
        const std::size_t asked = std::min(first.repeats.size(), static_cast<std::size_t>(m_options.settingRepeats));
        for (const std::size_t i : std::span(first.repeats).first(asked)) {
            if (m_worlds[i].difference) {
                point.repeats.push_back(*m_worlds[i].difference);
            }
        }
    }

    /// Does a piece of work whose progress is a part of the whole.
    template <class Act>
    auto within(const Message& stage, double from, double to, Act act) {
        const Execution own([&](const Progress& progress) {
            if (m_execution.cancelled()) {
                throw Cancelled();
            }
            m_execution.report(stage, from + (to - from) * std::clamp(progress.fraction, 0.0, 1.0));
        });
        return act(own.withThreads(threads()));
    }

    void measureCost(SweepWorld& world, double from, double to) {
        AccuracyPoint& point = *world.point;
        const Message stage{"analysis.accuracy_cost", "timing one setting at a time: {0}", {point.setting}};
        m_execution.report(stage, from);
        if (const auto kept =
                m_options.store && !m_options.retimed ? m_options.store->cost(point.origin, threads()) : std::nullopt) {
            point.cost = *kept;
        } else if (const SweepWorld& first = m_worlds[world.twin]; &first != &world) {
            // Timed just now.
            point.cost = first.point->cost;
            return;
        }
        const double middle = !m_options.timed ? from : m_options.screen ? from + (to - from) / (1.0 + liveWeight) : to;
        if (m_options.timed && m_options.choice.all() && !point.cost.timed()) {
            if (world.simulatedAlone) {
                take(point.cost, *world.world);
            } else {
                take(point.cost,
                     within(stage, from, middle, [&](const Execution& own) { return timeRun(describe(world, own), own); }));
            }
            keep([&](StudyStore& store) { store.keep(point.origin, point.cost); });
        }
        if (m_options.choice.single() && !point.cost.timed()) {
            take(point.cost, *world.world);
            // Others of the same list may have worked beside it: such figures would stand in the way of better ones.
            if (!point.cost.disturbed()) {
                keep([&](StudyStore& store) { store.keep(point.origin, point.cost); });
            }
        }
        if (m_options.screen && m_options.choice.all() && m_screenWorks && !std::isfinite(point.cost.fps)) {
            measureFps(world, stage, middle, to);
        }
    }

    void measureFps(SweepWorld& world, const Message& stage, double from, double to) {
        SettingCost& cost = world.point->cost;
        LiveRate rate;
        try {
            rate = within(stage, from, to, [&](const Execution& own) {
                return measureLive(describe(world, own), world.point->scenario.grid.fpsTarget, m_options.screen, own);
            });
        } catch (const WorldError& error) {
            // Without a display no setting has a live rate; everything else is as good as with one.
            m_screenWorks = false;
            report.findings.add({"accuracy.no_fps", "Live FPS could not be measured: nothing can be drawn here.", {}},
                                error.remedy(), error.what());
            return;
        }
        cost.fps = rate.mean;
        cost.fpsWorst = rate.worst;
        cost.othersShare = std::fmax(cost.othersShare, rate.othersShare);
        keep([&](StudyStore& store) { store.keep(world.point->origin, cost); });
    }

    template <class Timed>
    static void take(SettingCost& cost, const Timed& timed) {
        cost.wallSeconds = timed.wallSeconds;
        cost.stepMeanMs = timed.stepMeanMs;
        cost.stepWorstMs = timed.stepWorstMs;
        cost.othersShare = timed.othersShare;
    }

    const Inputs& m_inputs;
    const AccuracyOptions& m_options;
    const Execution& m_execution;
    StudyBase m_base;
    std::map<Digest, std::size_t> m_firstOf;            ///< world of its bits, among reference and settings
    std::vector<SweepWorld> m_worlds;                   ///< the reference and the settings, each before its repeats
    std::vector<std::optional<StudyWorld>> m_measured;  ///< of the same
    std::mutex m_mutex;                                 ///< of worlds, report and findings while worlds run
    bool m_screenWorks = true;
};

}  // namespace

FloorSpread spreadOf(std::span<const DebrisField* const> worlds) {
    FloorSpread spread;
    std::array<std::vector<double>, measureCount> departures;
    for (std::size_t a = 0; a < worlds.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            const DebrisDifference difference = compareDebris(*worlds[b], *worlds[a]);
            ++spread.pairs;
            for (std::size_t m = 0; m < measureCount; ++m) {
                const double departure = difference.departure(static_cast<Measure>(m));
                if (!std::isnan(departure)) {
                    departures[m].push_back(departure);
                }
            }
        }
    }
    for (std::size_t m = 0; m < measureCount; ++m) {
        const std::vector<double>& of = departures[m];
        spread.least[m] = of.empty() ? unknown : *std::min_element(of.begin(), of.end());
        spread.middle[m] = of.empty() ? unknown : middleOf(of);
        spread.largest[m] = of.empty() ? unknown : *std::max_element(of.begin(), of.end());
    }
    return spread;
}

std::vector<StudyTask> accuracyTasks(const Inputs& inputs, const Scenario& scenario, std::span<const AccuracySetting> settings,
                                     const AccuracyOptions& options, const Execution& execution) {
    Sweep sweep(inputs, options, execution);
    sweep.plan(scenario, settings);
    return sweep.tasks();
}

AccuracyReport accuracyStudy(const Inputs& inputs, const Scenario& scenario, std::span<const AccuracySetting> settings,
                             const AccuracyOptions& options, const Execution& execution) {
    Sweep sweep(inputs, options, execution);
    bool cancelled = false;
    try {
        sweep.plan(scenario, settings);
        options.choice.check(sweep.tasks());
        if (!options.simulated) {
            sweep.report.complete = true;
            return std::move(sweep.report);
        }
        sweep.simulateAll();
    } catch (const Cancelled&) {
        cancelled = true;
    }
    sweep.measureAll();
    try {
        if (!cancelled) {
            sweep.measureCosts();
        }
    } catch (const Cancelled&) {
        cancelled = true;
    }
    sweep.report.complete = !cancelled && !sweep.lacking();
    return std::move(sweep.report);
}

}  // namespace rubble
