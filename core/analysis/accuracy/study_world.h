#pragma once

#include <limits>
#include <vector>

#include "core/analysis/debris/collapse_plan.h"
#include "core/analysis/debris/debris_measures.h"
#include "core/pipeline/pipeline.h"
#include "core/simulation/effects/decisions.h"

namespace rubble {

/// What all worlds of a study have in common.
struct StudySettings {
    DebrisInstant instant = DebrisInstant::AtRest;
    MeasureSettings measures;
    int repeats = 2;           ///< of the repeat floor, at least 1
    double birthShift = 1e-6;  ///< m, of the repeats
    int threads = 0;           ///< in all; 0: as many as the execution grants. No result depends on it
};

/// What a simulated world leaves behind, whatever is measured on it later: it can be kept on disk and taken up again.
struct SimulatedWorld {
    Digest trajectoryHash;
    double endTime = 0.0;                                           ///< s
    double wallSeconds = 0.0;                                       ///< of the simulation, in all processes that had a part in it
    double stepMeanMs = 0.0;                                        ///< from the first to the last birth
    double stepWorstMs = 0.0;                                       ///< likewise
    double othersShare = std::numeric_limits<double>::quiet_NaN();  ///< of the processors' time, taken by other programs
    std::int64_t breaches = 0;                                      ///< of the limits of health
    std::int64_t bodiesPeak = 0;                                    ///< of clusters, at one time
    std::int64_t moving = -1;                                       ///< of these, at the end; -1: an older build did not keep it
    Debris atRest;
    Debris atFeEnd;
    CheckpointReport checkpoints;  ///< of the process that made it; not kept

    const Debris& debris(DebrisInstant instant) const { return instant == DebrisInstant::AtRest ? atRest : atFeEnd; }
};

/// One simulated world of a study, measured.
struct StudyWorld {
    Digest trajectoryHash;
    double endTime = 0.0;       ///< s
    double wallSeconds = 0.0;   ///< of the simulation
    std::int64_t breaches = 0;  ///< of the limits of health
    DebrisField field;
};

/// What the worlds of a study start from: everything up to the clusters, and what debris is measured against.
struct StudyBase {
    Inputs inputs;
    Scenario scenario;
    Results results;
    EffectDecisions decisions;
    CollapsePlan plan{std::vector<Vec2>{}};
    SiteSurface ground;  ///< what heights are measured from, in all worlds alike
};

/// Makes the parts up to the clusters. Throws what run() throws, UsageError for settings out of range.
StudyBase beginStudy(const Inputs& inputs, const Scenario& scenario, const StudySettings& settings, const Execution& execution);

/// The scene as the effects' tests see it, under another scenario that has the same clusters.
EffectDecisions decideUnder(const StudyBase& base, const Scenario& scenario);

/// The world of the base itself.
RunDescription describeBase(const StudyBase& base);

/// A run that can be repeated. Refers to what it is made of.
struct RepeatedRun {
    const Inputs& inputs;
    const Scenario& scenario;
    const Results& results;  ///< up to the clusters
};

/// The same run with every birth shifted in a direction that depends on the seed and the element; the clusters stay, so that
/// nothing else changes. A scenario that shifts its births itself keeps its own length.
/// @param birthShift  m
/// @param repeat  1, 2, ...: added to the seed of the scenario
RunDescription describeRepeat(const RepeatedRun& run, double birthShift, int repeat, const Execution& execution);

/// Simulates a world; frames are not kept. Throws what simulate() throws.
/// @param checkpoints  null: none are kept
SimulatedWorld simulateDebris(const RunDescription& description, const Execution& execution,
                              CheckpointStore* checkpoints = nullptr);

/// Measures a world at the instant of the settings. Throws what measureDebris() throws.
StudyWorld measureWorld(const SimulatedWorld& world, const StudyBase& base, const StudySettings& settings);

/// Both of them.
StudyWorld simulateWorld(const RunDescription& description, const StudyBase& base, const StudySettings& settings,
                         const Execution& execution);

}  // namespace rubble
