#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/evidence/maps/debris_map.h"
#include "core/evidence/maps/live_structure.h"
#include "core/simulation/run/simulation.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// A run to be mapped, complete or not. Pointers must outlive the call.
struct MappedRun {
    const FeResult* fe = nullptr;
    const TrajectoryReader* trajectory = nullptr;
    std::shared_ptr<const FragmentSet> fragments;
    std::shared_ptr<const SimulationResult> result;  ///< null: not complete, so impact energies are not known
    std::shared_ptr<const TerrainGrid> terrain;      ///< of the case; null: none
    Scenario scenario;
};

/// A map of a run and what it was made from.
struct RunMap {
    DebrisMap map;
    Debris debris;
    std::vector<double> arrivals;       ///< s, [fragments]; NaN of those that are not there
    std::vector<double> energies;       ///< J, [fragments]; empty: not known
    std::optional<LiveStructure> live;  ///< unset: left out
    FrameKind shown = FrameKind::Simulated;
    double cellFrom = 0.0;  ///< m, size of a typical fragment that the cells were derived from; 0: their side was given
    Findings findings;
};

/// The ground that a run fell on, as heights of its maps count from it: its terrain where that effect was on, else the level
/// ground.
SiteSurface groundOf(const MappedRun& run);

/// First and last instant of a run that can be mapped, s.
struct MapSpan {
    double first = 0.0;
    double last = 0.0;
};
MapSpan mapSpan(const MappedRun& run);

/// Box around the debris of a run, m: to read evidence as far as debris went. Empty where no fragment is there.
/// @param time  s, brought into the span of the run; unset means its end
Aabb debrisBounds(const MappedRun& run, std::optional<double> time);

/// What of the structure stands at the time of a map, seen from above: as `LiveStructure::standing`.
std::vector<PlanBox> standingAtTime(const MappedRun& run, const RunMap& made, const Execution& execution);

/// Maps a run at any time within its span; unset means its end. A hit that comes later than the time brings no energy yet.
/// @param withLive  whether fallen live structure gets its layers
/// Throws UsageError (a time outside the run; a run without fragments or frames; as makeDebrisMap()), Cancelled, and what reading
/// throws.
RunMap mapOfRun(const MappedRun& run, std::optional<double> time, const MapSettings& settings, bool withLive,
                const Execution& execution);

}  // namespace rubble
