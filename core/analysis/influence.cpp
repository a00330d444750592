#include "core/analysis/influence.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/analysis/world_pool.h"
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
        most = one == Standing::Undefined ? most : std::max(most, one);
    }
    return most;
}

InfluenceReport influence(const Inputs& inputs, const Scenario& scenario, std::span<const EffectKind> effects,
                          const StudySettings& settings, const Execution& execution) {
    if (settings.repeats < 2) {
        throw UsageError({"analysis.influence_repeats", "The influence of effects takes a floor of at least 2 repeats.", {}},
                         {"analysis.influence_repeats.remedy", "Ask for 2 repeats or more.", {}});
    }
    InfluenceReport report;
    report.instant = settings.instant;
    const std::size_t repeats = static_cast<std::size_t>(settings.repeats);
    StudyBase base;
    std::vector<Switched> switched;
    std::vector<std::optional<StudyWorld>> worlds;
    try {
        base = beginStudy(inputs, scenario, settings, execution);
        report.decisions = base.decisions;
        switched = planSwitches(base, effects, report);
        worlds.resize(1 + repeats + switched.size());
        const auto describe = [&](std::size_t i, const Execution& own) {
            if (i == 0) {
                return describeBase(base);
            }
            return i <= repeats ? describeRepeat(base, settings, static_cast<int>(i), own)
                                : describeRun(base.inputs, switched[i - repeats - 1].scenario, base.results);
        };
        runInParallel(worlds.size(), {settings.threads},
                      {"analysis.influence",
                       "simulating {0} worlds: the run, {1} repeats, {2} effects switched",
                       {worlds.size(), repeats, switched.size()}},
                      execution, [&](std::size_t i, const Execution& own) {
                          worlds[i] = simulateWorld(describe(i, own), base, settings, own);
                      });
        report.complete = true;
    } catch (const Cancelled&) {
        // What was simulated by now is reported.
    }
    if (worlds.empty() || !worlds.front()) {
        return report;
    }
    const StudyWorld& run = *worlds.front();
    report.floor = floorOf(run, std::span(worlds).subspan(1, repeats), scenario.fragments.seed);
    for (std::size_t k = 0; k < switched.size(); ++k) {
        if (const std::optional<StudyWorld>& other = worlds[1 + repeats + k]) {
            fill(report.effects[switched[k].row], run, *other, report.floor->largest);
        }
    }
    return report;
}

}  // namespace rubble
