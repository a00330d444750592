#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "core/base/hash.h"
#include "core/simulation/health/health.h"

namespace rubble {

/// One run of a case as its history keeps it: what was run, when, and what came of it.
struct RunEntry {
    std::string when;        ///< UTC of its end, or of its begin while nobody knows the end, "2024-05-31T08:15:30Z"
    std::string scenarioId;  ///< of the case
    std::string scenarioName;
    Digest fingerprint;  ///< of inputs, settings and build
    std::string feSha256;
    std::string build;
    bool live = false;         ///< at the pace of the collapse
    bool complete = false;     ///< false: cancelled, failed or interrupted; figures below are then those known
    bool interrupted = false;  ///< its program ended before the run did
    double wallSeconds = 0.0;
    std::int64_t fragments = 0;
    std::int64_t bodies = 0;  ///< most at one time
    double endTime = 0.0;     ///< s, of the collapse
    // Not a number: not known of a run that is not complete.
    double asleepAtEnd = std::numeric_limits<double>::quiet_NaN();  ///< share of the bodies
    double msPerStep = std::numeric_limits<double>::quiet_NaN();    ///< mean
    double maxSpeed = std::numeric_limits<double>::quiet_NaN();     ///< m/s
    double bulkingFactor = std::numeric_limits<double>::quiet_NaN();
    double energyDrift = std::numeric_limits<double>::quiet_NaN();  ///< share of the work of gravity
    std::int64_t breaches = 0;                                      ///< limits of health that were passed
    std::optional<HealthGrade> grade = {};  ///< the gravest of them; unset: a history of an earlier version does not say
    bool acknowledged = false;              ///< someone vouches for it in spite of them
    Digest trajectoryHash;                  ///< of a complete run
    std::string file;                       ///< where its run file was kept, absolute; empty if it was not

    /// It was written down at its begin, and nobody has said since what came of it.
    bool hasOnlyBegun() const { return interrupted && endTime == 0.0; }
    /// Its figures should not be relied on until someone vouches for them.
    bool tainted() const { return grade == HealthGrade::Tainted && !acknowledged; }

    /// Every figure; one that is NaN differs from itself.
    friend bool operator==(const RunEntry&, const RunEntry&) = default;
};

/// Whether two entries tell of the same simulation, whatever has been added to one of them since.
inline bool sameRun(const RunEntry& a, const RunEntry& b) {
    return a.when == b.when && a.scenarioId == b.scenarioId && a.fingerprint == b.fingerprint && a.wallSeconds == b.wallSeconds;
}

}  // namespace rubble
