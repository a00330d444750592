#include "core/analysis/accuracy/influence.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <mutex>

#include "core/analysis/accuracy/world_pool.h"
#include "core/base/error.h"

namespace rubble {

namespace {

/// A change up to this many times the floor may be chance: the floor is the largest of a few pairs only.
constexpr double nearFloor = 2.0;

/// The scenario with one effect in its other state and all others as they were decided.
Scenario flipped(const StudyBase& base, EffectKind kind) {
    Scenario scenario = base.scenario;
    for (const EffectDecision& decision : base.decisions) {
        // Ground gives way to terrain: without terrain it is what its own switch says.
        const bool follows = kind == EffectKind::Terrain && decision.kind == EffectKind::Ground;
        if (!follows) {
            const bool on = (decision.kind == kind) != decision.on;
            scenario.effects.of(decision.kind) = on ? EffectSwitch::On : EffectSwitch::Off;
        }
    }
    return scenario;
}

/// An effect that is to be switched, with the scenario in which it is.
struct Switched {
    std::size_t row;
    Scenario scenario;
};

std::vector<Switched> planSwitches(const StudyBase& base, std::span<const EffectKind> effects, InfluenceReport& report) {
    std::vector<Switched> switched;
    for (const EffectDecision& decision : base.decisions) {
        if (!effects.empty() && std::find(effects.begin(), effects.end(), decision.kind) == effects.end()) {
            continue;
        }
        EffectInfluence row;
        row.decision = decision;
        Scenario scenario = flipped(base, decision.kind);
        const EffectDecision other = decideUnder(base, scenario)[static_cast<std::size_t>(decision.kind)];
        row.switchable = other.on != decision.on;
        if (row.switchable) {
            switched.push_back({report.effects.size(), std::move(scenario)});
        } else {
            row.reason = decision.asked == EffectSwitch::Auto ? decision.reason : other.reason;
        }
        report.effects.push_back(std::move(row));
    }
    return switched;
}

void fill(EffectInfluence& row, const StudyWorld& base, const StudyWorld& other, const DebrisDifference& floor) {
    row.done = true;
    row.trajectoryHash = other.trajectoryHash;
    row.wallSeconds = other.wallSeconds;
    row.breaches = other.breaches;
    row.figures = other.field.figures;
    row.difference = row.decision.on ? compareDebris(other.field, base.field) : compareDebris(base.field, other.field);
    const bool identical = base.trajectoryHash == other.trajectoryHash;
    for (std::size_t m = 0; m < measureCount; ++m) {
        const double departure = row.difference.departure(static_cast<Measure>(m));
        const double least = floor.departure(static_cast<Measure>(m));
        row.overFloor[m] = departure == 0.0 ? 0.0 : departure / least;
        row.standings[m] = identical ? Standing::Identical : standingOf(departure, least);
    }
}

/// The influence of effects while it is made.
class Switching {
public:
    Switching(const Inputs& inputs, const Scenario& scenario, std::span<const EffectKind> effects, const StudySettings& settings,
              const Execution& execution, InfluenceReport& report)
        : m_settings(settings), m_repeats(static_cast<std::size_t>(std::max(0, settings.repeats))), m_report(report) {
        if (settings.repeats < 2) {
            throw UsageError({"analysis.influence_repeats", "The influence of effects takes a floor of at least 2 repeats.", {}},
                             {"analysis.influence_repeats.remedy", "Ask for 2 repeats or more.", {}});
        }
        report.instant = settings.instant;
        m_base = beginStudy(inputs, scenario, settings, execution);
        report.decisions = m_base.decisions;
        m_switched = planSwitches(m_base, effects, report);
        m_worlds.resize(1 + m_repeats + m_switched.size());
    }

    std::vector<StudyTask> tasks(const std::string& machine) const {
        std::vector<StudyTask> list;
        for (std::size_t i = 0; i < m_worlds.size(); ++i) {
            const bool repeat = i > 0 && i <= m_repeats;
            const Scenario& scenario = i <= m_repeats ? m_base.scenario : m_switched[i - m_repeats - 1].scenario;
            const std::string name = i == 0   ? "as it is"
                                     : repeat ? "repeat " + std::to_string(i)
                                              : std::string(effectName(kindOf(i))) + " switched";
            list.push_back(studyTask(
                m_base.inputs, scenario, &m_base.results,
                originOf(m_base.inputs, scenario, repeat ? static_cast<std::int64_t>(i) : 0, m_settings.birthShift, machine),
                name));
        }
        return list;
    }

    void simulateAll(const InfluenceKeeping& keeping, const Execution& execution) {
        const std::vector<StudyTask> all = tasks(keeping.machine);
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!takeKept(i, all[i].origin, keeping) && keeping.choice.wants(all[i].origin.key)) {
                open.push_back(i);
            }
        }
        runInParallel(open.size(), {m_settings.threads},
                      {"analysis.influence",
                       "simulating {0} worlds: the run, {1} repeats, {2} effects switched",
                       {m_worlds.size(), m_repeats, m_switched.size()}},
                      execution, [&](std::size_t o, const Execution& own) {
                          const std::size_t i = open[o];
                          const auto checkpoints = keeping.store != nullptr ? keeping.store->checkpoints(all[i].origin) : nullptr;
                          const SimulatedWorld world = simulateDebris(describe(i, own), own, checkpoints.get());
                          keep(all[i].origin, world, keeping);
                          m_worlds[i] = measureWorld(world, m_base, m_settings);
                      });
    }

    /// What the worlds that are there say.
    void report(std::int64_t seed) {
        if (!m_worlds.front()) {
            return;
        }
        const StudyWorld& run = *m_worlds.front();
        m_report.floor = floorOf(run, std::span(m_worlds).subspan(1, m_repeats), seed);
        for (std::size_t k = 0; k < m_switched.size(); ++k) {
            if (const std::optional<StudyWorld>& other = m_worlds[1 + m_repeats + k]) {
                fill(m_report.effects[m_switched[k].row], run, *other, m_report.floor->largest);
            }
        }
    }

    bool whole() const {
        return std::all_of(m_worlds.begin(), m_worlds.end(), [](const auto& world) { return world.has_value(); });
    }

private:
    EffectKind kindOf(std::size_t i) const { return m_report.effects[m_switched[i - m_repeats - 1].row].decision.kind; }

    RunDescription describe(std::size_t i, const Execution& own) const {
        if (i == 0) {
            return describeBase(m_base);
        }
        return i <= m_repeats ? describeRepeat({m_base.inputs, m_base.scenario, m_base.results}, m_settings.birthShift,
                                               static_cast<int>(i), own)
                              : describeRun(m_base.inputs, m_switched[i - m_repeats - 1].scenario, m_base.results);
    }

    bool takeKept(std::size_t i, const WorldOrigin& origin, const InfluenceKeeping& keeping) {
        const std::optional<SimulatedWorld> kept = keeping.store ? keeping.store->world(origin, m_report.findings) : std::nullopt;
        const std::size_t fragments = m_base.results.fragments->size();
        if (kept && kept->atRest.fragments.size() == fragments && kept->atFeEnd.fragments.size() == fragments) {
            m_worlds[i] = measureWorld(*kept, m_base, m_settings);
        }
        return m_worlds[i].has_value();
    }

    void keep(const WorldOrigin& origin, const SimulatedWorld& world, const InfluenceKeeping& keeping) {
        {
            const std::scoped_lock lock(m_mutex);
            m_report.findings.append(world.checkpoints.findings);
        }
        try {
            if (keeping.store) {
                keeping.store->keep(origin, world);
            }
        } catch (const WorldError& error) {
            const std::scoped_lock lock(m_mutex);
            m_report.findings.add({"analysis.not_kept", "A world could not be kept for a second start.", {}},
                                  {"analysis.not_kept.remedy", "Make room for the cache, or name another folder.", {}},
                                  error.what());
        }
    }

    const StudySettings m_settings;
    const std::size_t m_repeats;
    InfluenceReport& m_report;
    StudyBase m_base;
    std::vector<Switched> m_switched;
    std::vector<std::optional<StudyWorld>> m_worlds;  ///< the run, its repeats, the effects switched
    std::mutex m_mutex;                               ///< of the findings while worlds run
};

}  // namespace

std::string_view standingName(Standing standing) {
    static constexpr std::array<std::string_view, 5> names{"identical", "below", "near", "above", "undefined"};
    return names[static_cast<std::size_t>(standing)];
}

Standing standingOf(double departure, double floor) {
    if (std::isnan(departure) || std::isnan(floor)) {
        return Standing::Undefined;
    }
    if (departure <= floor) {
        return Standing::Below;
    }
    return departure <= nearFloor * floor ? Standing::Near : Standing::Above;
}

Standing EffectInfluence::standing() const {
    Standing most = Standing::Identical;
    for (const Standing one : standings) {
        if (one != Standing::Undefined) {
            most = std::max(most, one);
        }
    }
    return most;
}

std::vector<StudyTask> influenceTasks(const Inputs& inputs, const Scenario& scenario, std::span<const EffectKind> effects,
                                      const StudySettings& settings, const Execution& execution) {
    InfluenceReport report;
    return Switching(inputs, scenario, effects, settings, execution, report).tasks({});
}

InfluenceReport influence(const Inputs& inputs, const Scenario& scenario, std::span<const EffectKind> effects,
                          const StudySettings& settings, const Execution& execution, const InfluenceKeeping& keeping) {
    InfluenceReport report;
    std::optional<Switching> switching;
    try {
        switching.emplace(inputs, scenario, effects, settings, execution, report);
        keeping.choice.check(switching->tasks(keeping.machine));
        switching->simulateAll(keeping, execution);
    } catch (const Cancelled&) {
        // What was simulated by now is reported.
    }
    if (switching) {
        switching->report(scenario.fragments.seed);
        report.complete = !execution.cancelled() && switching->whole();
    }
    return report;
}

}  // namespace rubble
