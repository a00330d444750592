#include "core/evidence/ensembles/ensemble.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <new>
#include <optional>

#include "core/analysis/accuracy/world_pool.h"
#include "core/base/error.h"
#include "core/base/unknown.h"
#include "core/evidence/ensembles/member_doubts.h"

namespace rubble {

namespace {

double& figure(EnsembleMember& member, MemberMeasure measure) {
    return member.figures[static_cast<std::size_t>(measure)];
}

/// Cells of a member are kept in single precision: sums over them are good to a millionth.
constexpr double sameShare = 1e-6;

/// A sum over cells with the seven digits that it has.
double roundedSum(double sum) {
    if (!(sum > 0.0) || !std::isfinite(sum)) {
        return sum;
    }
    const double step = std::pow(10.0, 6.0 - std::floor(std::log10(sum)));
    return std::round(sum * step) / step;
}

/// Value below which a share of sorted ones lies, linear between them.
double quantile(const std::vector<double>& sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// An ensemble while it is made.
class Making {
public:
    Making(std::span<const EnsembleScene> scenes, const EnsembleSettings& settings, const EnsembleOptions& options,
           const Execution& execution)
        : m_scenes(scenes), m_options(options), m_execution(execution) {
        report.settings = settings;
        report.surface = options.surface;
        report.instant = options.instant;
    }

    void plan() {
        for (std::int64_t number = 0; number < report.settings.members; ++number) {
            EnsembleMember member;
            member.number = number;
            member.drawn = drawnValues(report.settings, number);
            member.scene = sceneOf(member.drawn);
            member.scenario = memberScenario(m_scenes[member.scene].scenario, report.settings, number);
            m_origins.push_back(originOf(m_scenes[member.scene].inputs, member.scenario, 0, 0.0, m_options.machine));
            report.members.push_back(std::move(member));
        }
        StudySettings study;
        study.instant = m_options.instant;
        m_bases.resize(m_scenes.size());
        for (std::size_t s = 0; s < m_scenes.size(); ++s) {
            const bool wanted = std::any_of(report.members.begin(), report.members.end(), [&](const EnsembleMember& member) {
                return member.scene == s && !passedOver(static_cast<std::size_t>(member.number));
            });
            if (wanted) {
                m_bases[s] = beginStudy(m_scenes[s].inputs, m_scenes[s].scenario, study, m_execution);
            }
        }
    }

    std::vector<StudyTask> tasks() const {
        std::vector<StudyTask> list;
        for (const EnsembleMember& member : report.members) {
            const std::optional<StudyBase>& base = m_bases[member.scene];
            list.push_back(studyTask(m_scenes[member.scene].inputs, member.scenario, base ? &base->results : nullptr,
                                     m_origins[static_cast<std::size_t>(member.number)],
                                     "member " + std::to_string(member.number)));
        }
        return list;
    }

    void makeAll() {
        const std::size_t count = report.members.size();
        const bool none = !m_options.choice.all() && !m_options.choice.single();
        const Message simulating{"evidence.ensemble", "simulating {0} members of the ensemble", {count}};
        const Message reading{"evidence.ensemble_kept", "reading what is kept of {0} members of the ensemble", {count}};
        runInParallel(count, {m_options.threads, m_options.jobs}, none ? reading : simulating, m_execution,
                      [&](std::size_t i, const Execution& own) { makeOne(i, own); });
    }

    bool failed() const {
        return std::any_of(report.members.begin(), report.members.end(), [](const EnsembleMember& m) { return !m.done; });
    }

    EnsembleReport report;

private:
    std::size_t sceneOf(const DrawnValues& drawn) const {
        for (const auto& [key, value] : drawn) {
            if (key == scenarioKey) {
                const auto found =
                    std::find_if(m_scenes.begin(), m_scenes.end(), [&](const EnsembleScene& scene) { return scene.id == value; });
                if (found == m_scenes.end()) {
                    throw UsageError({"ensemble.no_scenario", "There is no scenario \"{0}\" to vary.", {value}},
                                     {"ensemble.no_scenario.remedy", "Name scenarios of the case by their ids.", {}});
                }
                return static_cast<std::size_t>(found - m_scenes.begin());
            }
        }
        return 0;
    }

    /// One other world alone is to be made.
    bool passedOver(std::size_t i) const { return m_options.choice.single() && !m_options.choice.wants(m_origins[i].key); }

    void makeOne(std::size_t i, const Execution& own) {
        if (passedOver(i)) {
            return;
        }
        EnsembleMember made = report.members[i];
        try {
            simulateMember(made, own);
        } catch (const std::bad_alloc&) {
            made.failure = {"ensemble.memory", "there was not enough memory for it", {}};
        } catch (const Cancelled&) {
            throw;
        } catch (const Error& error) {
            made.failure = error.message();
        }
        const std::scoped_lock lock(m_mutex);
        report.members[i] = std::move(made);
        if (!report.members[i].failure.empty()) {
            report.findings.add({"ensemble.member_lost", "A member of the ensemble could not be simulated.", {}},
                                {"ensemble.member_lost.remedy", "Start again: what is done is kept.", {}},
                                englishText(report.members[i].failure));
        }
        if (m_options.grown) {
            m_options.grown(report);
        }
    }

    void simulateMember(EnsembleMember& member, const Execution& own) {
        const StudyBase& base = *m_bases[member.scene];
        const WorldOrigin& origin = m_origins[static_cast<std::size_t>(member.number)];
        std::optional<SettledWorld> world = taken(origin);
        Results results = run(base.inputs, member.scenario, world ? Stage::Fragments : Stage::Clusters, base.results, nullptr, own);
        if (world && world->world.atRest.fragments.size() != results.fragments->size()) {
            world.reset();
            results = run(base.inputs, member.scenario, Stage::Clusters, results, nullptr, own);
        }
        member.kept = world.has_value();
        if (!world && !m_options.choice.wants(origin.key)) {
            return;
        }
        if (!world) {
            const auto checkpoints = m_options.store != nullptr ? m_options.store->checkpoints(origin) : nullptr;
            world = simulateSettled(describeRun(base.inputs, member.scenario, results), own, checkpoints.get());
            keep(origin, *world);
        }
        if (m_options.choice.single()) {
            return;
        }
        measure(member, base, results, *world, own);
    }

    std::optional<SettledWorld> taken(const WorldOrigin& origin) {
        if (!m_options.store) {
            return {};
        }
        Findings findings;
        std::optional<SettledWorld> world = m_options.store->settled(origin, findings);
        const std::scoped_lock lock(m_mutex);
        report.findings.append(findings);
        return world;
    }

    void keep(const WorldOrigin& origin, const SettledWorld& world) {
        {
            const std::scoped_lock lock(m_mutex);
            report.findings.append(world.world.checkpoints.findings);
        }
        if (!m_options.store) {
            return;
        }
        try {
            m_options.store->keep(origin, world);
        } catch (const WorldError& error) {
            const std::scoped_lock lock(m_mutex);
            report.findings.add({"ensemble.not_kept", "A member could not be kept for a second start.", {}},
                                {"ensemble.not_kept.remedy", "Make room for the cache, or name another folder.", {}}, error.what());
        }
    }

    void measure(EnsembleMember& member, const StudyBase& base, const Results& results, const SettledWorld& settled,
                 const Execution& own) {
        const SimulatedWorld& world = settled.world;
        const Debris& debris = world.debris(m_options.instant);
        const std::vector<CarriedIsland> held;
        MemberSite site{base.inputs.fe.get(),
                        &member.scenario,
                        results.components.get(),
                        results.fragments.get(),
                        &debris,
                        m_options.instant == DebrisInstant::AtRest ? &settled.islands : &held,
                        &base.ground,
                        nullptr};
        member.surface = std::make_shared<const MemberSurface>(surfaceOf(site, m_options.surface, own));
        site.surface = member.surface.get();
        MeasureSettings measures;
        measures.footprintCell = std::max(measures.footprintCell, m_options.surface.cell);
        const DebrisFigures figures = measureDebris(debris, base.plan, base.ground, measures).figures;
        const double area = m_options.surface.cell * m_options.surface.cell;
        double volume = 0.0;
        double mass = 0.0;
        double highest = 0.0;
        for (std::size_t c = 0; c < member.surface->cells.size(); ++c) {
            volume += area * double{member.surface->heights[c]};
            mass += area * double{member.surface->masses[c]};
            highest = std::max(highest, double{member.surface->heights[c]});
        }
        figure(member, MemberMeasure::Footprint) = area * static_cast<double>(member.surface->cells.size());
        figure(member, MemberMeasure::PileVolume) = roundedSum(volume);
        figure(member, MemberMeasure::RunOut) = figures.runOut;
        figure(member, MemberMeasure::Mass) = roundedSum(mass);
        figure(member, MemberMeasure::MeanHeight) = figures.meanHeight;
        figure(member, MemberMeasure::PileHeight) = highest;
        member.arrivals = settled.arrivals;
        member.trajectoryHash = world.trajectoryHash;
        member.endTime = world.endTime;
        member.wallSeconds = world.wallSeconds;
        member.breaches = world.breaches;
        member.moving = world.moving;
        member.bodies = world.bodiesPeak;
        if (m_options.look) {
            member.looked = m_options.look(site, own);
        }
        member.done = true;
    }

    std::span<const EnsembleScene> m_scenes;
    const EnsembleOptions& m_options;
    const Execution& m_execution;
    std::vector<std::optional<StudyBase>> m_bases;
    std::vector<WorldOrigin> m_origins;  ///< of the members
    std::mutex m_mutex;                  ///< of the report while members are made
};

}  // namespace

const MemberMeasureRow& memberMeasureRow(MemberMeasure measure) {
    static constexpr std::array<MemberMeasureRow, memberMeasureCount> rows{
        {{"footprint_m2", "m2", "Covered area", "m2", 1.0},
         {"pile_volume_m3", "m3", "Volume of the pile", "m3", 1.0},
         {"run_out_m", "m", "Run-out of 95 % of the mass", "m", 1.0},
         {"mass_kg", "kg", "Mass that fell", "t", 1e-3},
         {"mean_height_m", "m", "Mean height of fragments", "m", 1.0},
         {"pile_height_m", "m", "Highest cell", "m", 1.0}}};
    return rows[static_cast<std::size_t>(measure)];
}

std::vector<const EnsembleMember*> EnsembleReport::done() const {
    std::vector<const EnsembleMember*> list;
    for (const EnsembleMember& member : members) {
        if (member.done) {
            list.push_back(&member);
        }
    }
    return list;
}

FigureSpread spreadOf(std::vector<double> values) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    FigureSpread spread{values.size(), unknown, unknown, unknown, unknown, unknown, unknown, unknown, unknown};
    if (values.empty()) {
        return spread;
    }
    const auto count = static_cast<double>(values.size());
    double sum = 0.0;
    for (const double value : values) {
        sum += value;
    }
    spread.mean = sum / count;
    if (values.size() > 1) {
        double squares = 0.0;
        for (const double value : values) {
            squares += (value - spread.mean) * (value - spread.mean);
        }
        spread.deviation = std::sqrt(squares / (count - 1.0));
        spread.standardError = spread.deviation / std::sqrt(count);
    }
    std::sort(values.begin(), values.end());
    spread.low = quantile(values, 0.05);
    spread.middle = quantile(values, 0.5);
    spread.high = quantile(values, 0.95);
    spread.least = values.front();
    spread.most = values.back();
    return spread;
}

FigureSpread spreadOf(const EnsembleReport& report, MemberMeasure measure, std::size_t first) {
    std::vector<double> values;
    for (const EnsembleMember* member : report.done()) {
        if (values.size() < first) {
            values.push_back(member->of(measure));
        }
    }
    FigureSpread spread = spreadOf(std::move(values));
    if (spread.deviation <= sameShare * std::abs(spread.mean)) {
        // What differs by the rounding of cells alone is one figure, told without a spread.
        spread.deviation = spread.standardError = 0.0;
        spread.mean = spread.low = spread.high = spread.least = spread.most = spread.middle;
    }
    return spread;
}

EnsembleReport ensembleStudy(std::span<const EnsembleScene> scenes, const EnsembleSettings& settings,
                             const EnsembleOptions& options, const Execution& execution) {
    checkEnsemble(settings);
    Making making(scenes, settings, options, execution);
    bool cancelled = false;
    try {
        making.plan();
        options.choice.check(making.tasks());
        making.makeAll();
    } catch (const Cancelled&) {
        cancelled = true;
    }
    making.report.complete = !cancelled && !making.failed();
    for (const MemberDoubt& doubt : memberDoubts(making.report)) {
        making.report.findings.add(doubt.what, doubt.remedy);
    }
    return std::move(making.report);
}

std::vector<StudyTask> ensembleTasks(std::span<const EnsembleScene> scenes, const EnsembleSettings& settings,
                                     const EnsembleOptions& options, const Execution& execution) {
    checkEnsemble(settings);
    Making making(scenes, settings, options, execution);
    making.plan();
    return making.tasks();
}

}  // namespace rubble
