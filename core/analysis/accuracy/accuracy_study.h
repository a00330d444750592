#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/accuracy/accuracy_settings.h"
#include "core/analysis/accuracy/influence.h"
#include "core/analysis/accuracy/live_cost.h"
#include "core/analysis/accuracy/repeat_floor.h"
#include "core/analysis/accuracy/study_tasks.h"

namespace rubble {

struct AccuracyReport;

/// How a sweep is made.
struct AccuracyOptions {
    StudySettings study;
    int settingRepeats = 0;       ///< of every setting, births shifted as the reference's are; 0: none
    int jobs = 0;                 ///< worlds at a time for the accuracy columns; 0: one for each thread
    bool simulated = true;        ///< false: only clusters are made, and the report holds nothing that is measured
    bool retimed = false;         ///< figures of time that are kept do not count
    bool timed = true;            ///< measure wall time and ms per step, one setting at a time
    ScreenMaker screen;           ///< for live FPS; null: not measured
    std::string machine;          ///< in words: what figures of time hold for
    StudyStore* store = nullptr;  ///< keeps worlds and costs; null: nothing is kept. Not owned
    /// What is not simulated here is not timed here either.
    WorldChoice choice;
    /// Called when the settings are known and whenever a world or a cost is done, with what there is by then: by one thread at a
    /// time, but not always the same. Null: nobody listens.
    std::function<void(const AccuracyReport&)> grown;
};

/// What one setting costs and how far its debris is from the reference.
struct AccuracyPoint {
    std::string setting;
    Scenario scenario;                 ///< whose adoption makes it the current setting
    WorldOrigin origin;                ///< names the world in the store
    std::array<double, 3> multiple{};  ///< x, y, z; NaN with a body per fragment
    std::array<double, 3> grid{};      ///< l, w, h, m; likewise
    std::int64_t fragments = 0;
    std::int64_t bodies = 0;  ///< clusters: each is moved by one rigid body
    Message failure;          ///< why it was not simulated, if it could not be

    bool done = false;  ///< the rest, but for the cost, only where true
    bool kept = false;  ///< its world was there from an earlier start
    Digest trajectoryHash;
    std::int64_t breaches = 0;                       ///< of the limits of health
    std::int64_t bodiesPeak = 0;                     ///< at one time
    DebrisDifference difference;                     ///< this less the reference
    std::array<Standing, measureCount> standings{};  ///< of each measure against the floor
    std::vector<DebrisDifference> repeats;           ///< likewise, of its own repeats that are done, in their order
    std::vector<double> fragmentErrors;              ///< m, from the place in the reference; NaN where absent [fragments]
    SettingCost cost;
};

/// Least, middle and largest departure of each measure over all pairs of the reference and its repeats.
struct FloorSpread {
    std::int64_t pairs = 0;
    std::array<double, measureCount> least{};
    std::array<double, measureCount> middle{};
    std::array<double, measureCount> largest{};
};

/// A sweep: what accuracy costs in time.
struct AccuracyReport {
    DebrisInstant instant = DebrisInstant::AtRest;
    std::int64_t elements = 0;
    double span = 0.0;                 ///< s, from the first birth to the last FE state
    bool comesLoose = false;           ///< structure does, before the FE result ends
    AccuracyPoint reference;           ///< its difference is that from itself
    std::optional<RepeatFloor> floor;  ///< of the repeats that are done; unset without the reference
    FloorSpread spread;
    std::vector<AccuracyPoint> points;  ///< in the order of the settings
    Findings findings;
    bool complete = false;  ///< false after a cancel or a failure: what is done is there
};

/// Simulates the reference of a scenario and every setting, each with its repeats, and compares each with the reference; then times
/// each setting with nothing beside it, and measures its live FPS. Whole worlds run in parallel for the accuracy; no figure but
/// those of time depends on how many at a time, nor on whether a sweep was interrupted. What the store keeps is not simulated
/// again. A setting that fails (memory, disk) is reported as failed and the others go on; a store that is full is a finding.
/// Returns what there is when cancelled. Throws UsageError for settings out of range, and what the pipeline throws for the
/// reference.
AccuracyReport accuracyStudy(const Inputs& inputs, const Scenario& scenario, std::span<const AccuracySetting> settings,
                             const AccuracyOptions& options, const Execution& execution);

/// The worlds of such a sweep: the reference, the settings, their repeats. Throws what accuracyStudy() throws, and Cancelled.
std::vector<StudyTask> accuracyTasks(const Inputs& inputs, const Scenario& scenario, std::span<const AccuracySetting> settings,
                                     const AccuracyOptions& options, const Execution& execution);

/// Spread of a floor over all pairs of worlds. @param worlds  the run and its repeats, those that are there
FloorSpread spreadOf(std::span<const DebrisField* const> worlds);

}  // namespace rubble
