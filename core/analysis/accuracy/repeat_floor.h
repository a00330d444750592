#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/analysis/accuracy/study_world.h"

namespace rubble {

/// One repeat of a run.
struct RepeatRow {
    std::int64_t seed = 0;  ///< of its birth shift
    Digest trajectoryHash;
    std::int64_t breaches = 0;  ///< of the limits of health
    DebrisFigures figures;
    DebrisDifference difference;  ///< against the run itself
};

/// How far a run repeats when nothing changes but every birth, by a micrometre: rigid piles are chaotic, so no difference smaller
/// than this says anything about what was changed.
struct RepeatFloor {
    Digest trajectoryHash;      ///< of the run itself
    std::int64_t breaches = 0;  ///< of the run itself
    DebrisFigures figures;      ///< of the run itself
    std::vector<RepeatRow> repeats;
    DebrisDifference largest;  ///< of all pairs among the run and its repeats; all NaN without repeats
};

/// Repeats a scenario `settings.repeats` times and measures how far its debris agrees; the worlds run in parallel and no result
/// depends on the number of threads. For the floor of an accuracy rate give the reference scenario.
/// Throws what the pipeline and measureDebris() throw, and Cancelled.
RepeatFloor repeatFloor(const Inputs& inputs, const Scenario& scenario, const StudySettings& settings, const Execution& execution);

/// The same from worlds that are there already.
/// @param seed  of the scenario; repeat r has seed + r
RepeatFloor floorOf(const StudyWorld& run, std::span<const std::optional<StudyWorld>> repeats, std::int64_t seed);

}  // namespace rubble
