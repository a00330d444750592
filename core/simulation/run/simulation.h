#pragma once

#include <cstdint>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/base/hash.h"
#include "core/base/message.h"
#include "core/simulation/bodies/run_account.h"
#include "core/simulation/effects/decisions.h"
#include "core/simulation/health/health.h"
#include "core/simulation/run/checkpoint.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// The outcome of a simulation. Everything except the times and the report on checkpoints is bit-identical from run to run.
struct SimulationResult {
    std::vector<FragmentOutcome> fragments;  ///< [fragments]
    std::int64_t bodiesPeak = 0;             ///< of clusters, at one time
    std::int64_t awakePeak = 0;              ///< of these, awake at one recorded instant
    std::int64_t steps = 0;
    double stepRate = 0.0;   ///< 1/s, at least
    Message stepRateReason;  ///< why so many
    int substeps = 0;        ///< of a step, soft-step solver
    double firstTime = 0.0;  ///< s, first hand-over
    double feEndTime = 0.0;  ///< s, last FE state
    double endTime = 0.0;    ///< s, the end
    StepTimes stepTimes;
    EnergyBalance energy;
    LedgerErrors ledger;
    OccupiedBirths births;
    LiveIslands islands;
    CarriedStructure carried;
    double penetrationMax = 0.0;   ///< m, deepest contact of a body, overlap at birth excepted
    double asleepAtEnd = 0.0;      ///< share of the bodies of clusters
    std::int64_t stillMoving = 0;  ///< of these, awake at the end
    double maxSpeed = 0.0;         ///< m/s, fastest body ever
    double bulkingFactor = 0.0;    ///< volume under the pile's surface over volume of material, 1 m cells; NaN without fragments
    std::vector<EffectReport> effects;  ///< every effect, in the order of EffectKind
    HealthReport health;
    Digest trajectoryHash;  ///< of every committed frame, in double precision
    Findings findings;
    CheckpointReport checkpoints;
};

/// ms per step, all effects and the rest: to be held against the measured allMs, which it makes up to what nobody has on the
/// account.
double accountedMs(const SimulationResult& result);
/// How far the account is from the measured step, as a share of it; negative: time that nobody has on the account. 0 without a
/// step.
double accountError(const SimulationResult& result);

/// Simulates a clustered scene from the first hand-over to the end (DESIGN.md 2.4). Steps have equal length within an FE interval,
/// at most 1 / stepRateOf(), and meet every FE state exactly. Deterministic: the same description gives the same trajectory hash.
/// Throws Cancelled (all committed frames stay in the sink) and whatever the sink throws.
/// @param checkpoints  goes on from the latest one of the same run, if there is one; whoever keeps the result removes it. A solver
///                     or a sink that cannot go on keeps none. Null: none are kept, none is looked for
SimulationResult simulate(const RunDescription& description, TrajectorySink& sink, const Execution& execution,
                          CheckpointStore* checkpoints = nullptr);

}  // namespace rubble
