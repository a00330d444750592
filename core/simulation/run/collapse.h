#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "core/base/archive.h"
#include "core/simulation/bodies/hand_over.h"
#include "core/simulation/effects/effect_run.h"
#include "core/simulation/effects/structure_contact.h"
#include "core/simulation/health/energy.h"
#include "core/simulation/health/health_monitor.h"
#include "core/simulation/health/ledger.h"
#include "core/simulation/health/outcomes.h"
#include "core/simulation/run/bulking.h"
#include "core/simulation/run/carried_islands.h"
#include "core/simulation/run/collapse_run.h"
#include "core/simulation/run/frame_recorder.h"
#include "core/simulation/run/islands.h"
#include "core/simulation/run/step_clock.h"
#include "core/simulation/run/step_rate.h"

namespace rubble {

/// Wall time so far, s. Steps have a clock of their own, around them, so that it is found out and not arranged whether the parts
/// make up the whole.
struct StepSeconds {
    double steps = 0.0;      ///< whole steps, with what the pieces take to begin an interval
    double replacing = 0.0;  ///< fragments put in the place of clusters that break up
    double bookkeeping = 0.0;
    double health = 0.0;
    double recording = 0.0;  ///< between the steps
    double births = 0.0;     ///< between the steps

    void keep(Archive& archive) { archive(steps, replacing, bookkeeping, health, recording, births); }
};

/// One run from the first hand-over to the end, or from a checkpoint.
class Collapse {
public:
    /// All arguments must outlive this object.
    /// @param checkpoints  null: none are kept
    Collapse(const WorldFactory& makeWorld, const RunDescription& description, TrajectorySink& sink, const Execution& execution,
             CheckpointStore* checkpoints);

    /// Goes back to where a checkpoint was taken, before run(). False: nothing there is of use, and this object is not to be run.
    bool resume(std::string_view content);
    /// What was found about checkpoints so far.
    void note(const Findings& findings) { m_result.checkpoints.findings.append(findings); }
    SimulationResult run();

private:
    void followStructure();
    void settle();
    void atState(std::size_t k);
    void record(FrameKind kind);
    void releaseIslands();
    void enter(const HandOver& entered);
    void carryIslands(std::size_t k, const HandOver& born);
    void removeEnded(double time);
    HandOver handOverAt(std::size_t k, LedgerRow& row);
    void advance(double dt, double time, const std::function<void(double)>& movePieces);
    void step(double dt, double time);
    /// rad/s, of the bodies of a table that roll, awake ones.
    double fastestRound() const;
    void removeLost(double time);
    void keepWatch(double time);
    void breakUp(double dt, double time);
    void replace(const BodyRecord& whole, double time);
    void addLedgerRow(LedgerRow row);
    void updateEnergy();
    std::int64_t awake() const;
    double asleep() const;
    /// Bodies of clusters; islands are counted apart.
    std::int64_t present() const {
        return static_cast<std::int64_t>(m_records.size()) - m_removed - m_islands.bodies() - m_carried.bodies();
    }
    void report(double time) const;
    /// Handed over by the FE result: neither an island nor freed by breaking up.
    bool bornHere(const BodyRecord& record) const {
        return !record.isIsland() && record.from <= m_description.clustering->list[at(record.cluster)].handOverTime;
    }
    void measureBirths(OccupiedBirths& births) const;
    PileMeasure pile() const;
    void reportCosts();
    void finish();
    void warn();
    /// Of debris that lies where the terrain has no heights.
    void warnOfTerrain();
    bool keep(Archive& archive);
    void keepCheckpoint();
    double secondsSoFar() const;

    /// Where the run is between two steps.
    struct Place {
        bool settling = false;   ///< after the last FE state
        std::size_t state = 0;   ///< of the FE result, the interval after which is being simulated
        std::int64_t steps = 0;  ///< that are done, of this interval or of settling
        double nextRow = 0.0;    ///< s, of the ledger while settling

        void keep(Archive& archive) { archive(settling, state, steps, nextRow); }
    };
    using Clock = std::chrono::steady_clock;

    const RunDescription& m_asked;       ///< as it is kept beside the run
    const RunDescription m_description;  ///< the same with what is left to the program settled
    const SimulationSettings& m_settings;
    const std::vector<double>& m_times;
    TrajectorySink& m_sink;
    const Execution& m_execution;
    Activity m_activity;
    EffectDecisions m_decisions;
    const StepRate m_stepRate;
    WorldSettings m_worldSettings;
    SiteSurface m_surface;
    std::unique_ptr<RigidWorld> m_world;
    StructureContact m_structure;
    EffectRun m_effects;
    Islands m_islands;
    CarriedIslands m_carried;
    FrameRecorder m_recorder;
    EnergyAccount m_energy;
    Ledger m_ledger;
    Outcomes m_outcomes;
    HealthMonitor m_health;
    StepClock m_clock;
    std::vector<BodyRecord> m_records;  ///< [bodies]
    std::size_t m_nextCluster = 0;
    std::int64_t m_removed = 0;
    double m_time = 0.0;
    double m_lastBirth = 0.0;
    bool m_clockRuns = false;
    StepSeconds m_seconds;
    Place m_place;
    SimulationResult m_result;
    CheckpointStore* m_checkpoints;  ///< null: none are kept
    const Clock::time_point m_began = Clock::now();
    Clock::time_point m_latestCheckpoint = m_began;
    double m_checkpointSeconds = 0.0;  ///< that the latest one took
    std::size_t m_checkpointBytes = 0;
};

}  // namespace rubble
