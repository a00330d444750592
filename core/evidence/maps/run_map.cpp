#include "core/evidence/maps/run_map.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/evidence/maps/fragment_history.h"
#include "core/evidence/maps/map_cell.h"

namespace rubble {

namespace {

/// Impact energies up to a time; nothing where they are not known.
std::vector<double> energiesUpTo(const MappedRun& run, double time, double end, const Execution& execution, Findings& findings) {
    if (!run.result || run.result->fragments.size() != run.fragments->size()) {
        findings.add({"map.no_impacts",
                      "The run is not complete, so it does not say how hard fragments hit: there is no impact energy.",
                      {}},
                     {"map.no_impacts.remedy", "Simulate it to its end.", {}});
        return {};
    }
    std::vector<double> energies = impactEnergies(*run.fragments, run.result->fragments);
    if (time < end) {
        const std::vector<double> hits =
            hardestHitTimes(*run.fragments, *run.trajectory, run.scenario.simulation.gravity, execution);
        for (std::size_t f = 0; f < energies.size(); ++f) {
            if (!(hits[f] <= time)) {
                energies[f] = 0.0;
            }
        }
    }
    return energies;
}

std::vector<std::string> namesOf(const Components& components) {
    std::vector<std::string> names;
    for (const Component& component : components.list) {
        names.push_back(component.name);
    }
    return names;
}

}  // namespace

SiteSurface groundOf(const MappedRun& run) {
    const auto on = [&](EffectKind kind) {
        const auto i = static_cast<std::size_t>(kind);
        if (run.result && i < run.result->effects.size()) {
            return run.result->effects[i].decision.on;
        }
        return run.scenario.effects.of(kind) != EffectSwitch::Off;
    };
    return {true, run.scenario.simulation.groundHeight, on(EffectKind::Terrain) ? run.terrain : nullptr};
}

MapSpan mapSpan(const MappedRun& run) {
    const std::vector<double>& times = run.fe->times();
    const std::size_t frames = run.trajectory->frameCount();
    return {times.front(), frames > 0 ? std::max(run.trajectory->frameTime(frames - 1), times.front()) : times.front()};
}

Aabb debrisBounds(const MappedRun& run, std::optional<double> time) {
    Aabb bounds;
    if (!run.fragments || run.trajectory->frameCount() == 0) {
        return bounds;
    }
    const MapSpan span = mapSpan(run);
    const Components components =
        groupComponents(run.fe->mesh(), run.scenario.regrouping, run.scenario.components, run.scenario.assumptions);
    const Debris debris =
        debrisAt(*run.fragments, components, *run.trajectory, std::clamp(time.value_or(span.last), span.first, span.last));
    for (const DebrisFragment& fragment : debris.fragments) {
        if (fragment.present && fragment.centre.allFinite()) {
            // However it is turned, it reaches no farther than its corners.
            const double reach = fragment.box.halfExtents.norm();
            bounds.extend(Vec3(fragment.centre.array() - reach));
            bounds.extend(Vec3(fragment.centre.array() + reach));
        }
    }
    return bounds;
}

RunMap mapOfRun(const MappedRun& run, std::optional<double> time, const MapSettings& settings, bool withLive,
                const Execution& execution) {
    const MapSpan span = mapSpan(run);
    if (!run.fragments || run.trajectory->frameCount() == 0) {
        if (run.fe->activity().activeCount(run.fe->stateCount() - 1) == run.fe->mesh().elementCount()) {
            throw UsageError(
                {"map.nothing_died", "No element dies in this result: there is no debris to map.", {}},
                {"map.nothing_died.remedy",
                 "If elements died, put a list of deaths beside the FE result or name its active flag (status_variable).",
                 {}});
        }
        throw UsageError(
            {"map.nothing_simulated", "The run was stopped before anything was simulated: there is nothing to map.", {}},
            {"map.nothing_simulated.remedy", "Run the case again to the end.", {}});
    }
    const double when = time.value_or(span.last);
    if (!(when >= span.first && when <= span.last)) {
        throw UsageError({"map.time_outside",
                          "There is no map at {0}: the run goes from {1} to {2}.",
                          {{when, "s"}, {span.first, "s"}, {span.last, "s"}}},
                         {"map.time_outside.remedy", "Give a time within the run.", {}});
    }
    const Components components =
        groupComponents(run.fe->mesh(), run.scenario.regrouping, run.scenario.components, run.scenario.assumptions);
    for (const Fragment& fragment : run.fragments->list) {
        if (at(fragment.element) >= run.fe->mesh().elementCount()) {
            throw UsageError({"map.other_fe", "The run was not made from {0}: it has fewer elements.", {run.fe->contents().path}},
                             {"map.other_fe.remedy", "Give the FE file that the run names.", {}});
        }
    }
    RunMap made;
    made.debris = debrisAt(*run.fragments, components, *run.trajectory, when);
    made.debris.time = when;
    // A frame at a state of the FE result holds simulated debris as well.
    const bool between = frameAtTime(*run.trajectory, when).kind == FrameKind::Interpolated;
    made.shown = between ? FrameKind::Interpolated : FrameKind::Simulated;
    made.arrivals = arrivalTimes(*run.fragments, *run.trajectory, made.debris, settings.arrivalDistance, execution);
    made.energies = energiesUpTo(run, when, span.last, execution, made.findings);
    if (withLive) {
        made.live = displacedStructure(*run.fe, components, run.scenario.fragments, *run.fragments, made.debris, *run.trajectory,
                                       settings.liveThreshold, execution);
    }
    MapSettings sized = settings;
    if (!settings.cell) {
        Aabb structure;
        for (const Vec3& node : run.fe->mesh().nodes) {
            structure.extend(node);
        }
        const UsualCell usual = usualMapCell(*run.fragments, structure.sizes().head<2>().maxCoeff());
        sized.cell = usual.side;
        made.cellFrom = usual.fragment;
    }
    const std::vector<MapPiece> pieces = mapPieces(*run.fragments, made.debris, made.arrivals, made.energies);
    made.map = makeDebrisMap(when, pieces, !made.energies.empty(), made.live ? &*made.live : nullptr, namesOf(components),
                             groundOf(run), sized, execution);
    return made;
}

std::vector<PlanBox> standingAtTime(const MappedRun& run, const RunMap& made, const Execution& execution) {
    const Components components =
        groupComponents(run.fe->mesh(), run.scenario.regrouping, run.scenario.components, run.scenario.assumptions);
    return displacedStructure(*run.fe, components, run.scenario.fragments, *run.fragments, made.debris, *run.trajectory,
                              MapSettings{}.liveThreshold, execution)
        .standing;
}

}  // namespace rubble
