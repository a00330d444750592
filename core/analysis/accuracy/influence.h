#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/analysis/accuracy/repeat_floor.h"
#include "core/analysis/accuracy/study_tasks.h"
#include "core/simulation/effects/decisions.h"

namespace rubble {

/// How a change stands against the repeat floor.
enum class Standing : std::uint8_t {
    Identical,  ///< the two runs are the same, bit for bit
    Below,      ///< no larger than the floor: says nothing
    Near,       ///< up to twice the floor: with few repeats still within chance
    Above,      ///< more than twice the floor
    Undefined,  ///< the measure does not exist for these runs
};
/// "identical", "below", "near", "above", "undefined"
std::string_view standingName(Standing standing);

/// What one effect changes in the debris.
struct EffectInfluence {
    EffectDecision decision;  ///< in the run itself
    bool switchable = false;  ///< the scene allows both states
    Message reason;           ///< why it cannot be switched, if it cannot
    bool done = false;        ///< simulated in its other state too

    // The rest only where done.
    Digest trajectoryHash;        ///< of the run in the other state
    double wallSeconds = 0.0;     ///< it took
    std::int64_t breaches = 0;    ///< of the limits of health, in the other state
    DebrisFigures figures;        ///< in the other state
    DebrisDifference difference;  ///< with the effect less without it
    std::array<double, measureCount>
        overFloor{};  ///< departure of each measure over that of the floor; infinite above a floor of 0
    std::array<Standing, measureCount> standings{};
    /// The most that any measure says.
    Standing standing() const;
};

/// What the effects of a scene change.
struct InfluenceReport {
    EffectDecisions decisions;
    DebrisInstant instant = DebrisInstant::AtRest;
    std::optional<RepeatFloor> floor;      ///< of the repeats that were simulated; unset if the run itself was not
    std::vector<EffectInfluence> effects;  ///< in the order of EffectKind
    Findings findings;                     ///< of what was kept
    bool complete = false;                 ///< false after a cancel: what was simulated by then is there
};

/// Where the worlds of the influence of effects are kept, and which are simulated.
struct InfluenceKeeping {
    StudyStore* store = nullptr;  ///< null: nothing is kept. Not owned
    std::string machine;          ///< in words
    WorldChoice choice;
};

/// Simulates a scenario as it is, its repeats for the floor, and once for each effect with that effect in its other state and all
/// others as they were decided; reports the differences of the debris. With terrain off the level ground takes its place where its
/// switch allows. Whole worlds run in parallel; no result depends on the number of threads. Keeps no frames.
/// @param effects  those to report on; empty: all
/// @param keeping  worlds that are kept are not simulated again; a store that is full is a finding
/// Returns what there is when cancelled. Throws UsageError for settings out of range (2 repeats at least), and what the pipeline
/// and measureDebris() throw.
InfluenceReport influence(const Inputs& inputs, const Scenario& scenario, std::span<const EffectKind> effects,
                          const StudySettings& settings, const Execution& execution, const InfluenceKeeping& keeping = {});

/// The worlds that it is made from. Throws what influence() throws, and Cancelled.
std::vector<StudyTask> influenceTasks(const Inputs& inputs, const Scenario& scenario, std::span<const EffectKind> effects,
                                      const StudySettings& settings, const Execution& execution);

/// How a departure stands against that of the floor. @param departure, floor  never negative; NaN: undefined
Standing standingOf(double departure, double floor);

}  // namespace rubble
