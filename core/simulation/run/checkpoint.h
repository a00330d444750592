#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/finding.h"

namespace rubble {

/// s of wall time between two checkpoints of a run. Shorter: the disk is busier; longer: more is lost with a run that is killed.
inline constexpr double checkpointInterval = 60.0;

/// Id of the stage that a run reports while it simulates: of several stages of a world the one that takes its time.
inline constexpr std::string_view simulatingStage = "simulation.progress";
/// Id of the stage that a run reports when it goes on from a checkpoint; its first argument is where, s of the collapse.
inline constexpr std::string_view resumedStage = "simulation.resumed";
/// The same of several worlds at once.
inline constexpr std::string_view worldsResumedStage = "analysis.resumed";

/// Where a run keeps its latest checkpoint: everything that decides how it goes on, between two of its steps. A run that was
/// stopped at any instant goes on from there and ends bit for bit as one that was not. Members are called from the thread of the
/// run.
class CheckpointStore {
public:
    virtual ~CheckpointStore() = default;
    /// What keep() was given last, by this or an earlier process; nothing if there is none. Throws WorldError if it cannot be read.
    virtual std::optional<std::string> latest() = 0;
    /// Takes the place of the one before, which stays if this fails. Throws WorldError when there is no room.
    virtual void keep(std::string_view checkpoint) = 0;
    /// s of wall time between two, or more: they take less than 2 % of it. 0: after every step.
    virtual double interval() const { return checkpointInterval; }
};

/// What checkpoints did for a run. No part of what repeats.
struct CheckpointReport {
    std::optional<double> resumedAt;  ///< s, of the collapse: where the run went on; unset: it was simulated from the start
    double secondsBefore = 0.0;       ///< of wall time, that earlier processes spent up to there
    std::int64_t kept = 0;            ///< by this process
    double seconds = 0.0;             ///< of wall time, that it took to keep them
    Findings findings;                ///< what was not whole or of another run and was not taken, and what could not be kept
};

}  // namespace rubble
