#include <algorithm>
#include <new>

#include "core/base/error.h"
#include "core/simulation/health/value_archive.h"
#include "core/simulation/run/collapse.h"
#include "core/simulation/run/sealed_checkpoint.h"

namespace rubble {

namespace {

/// A checkpoint that took a second is followed by so many seconds without one.
constexpr double secondsBetween = 60.0;

}  // namespace

/// False: the world cannot be kept.
bool Collapse::keep(Archive& archive) {
    if (!m_world->keep(archive)) {
        return false;
    }
    archive(m_structure, m_effects, m_islands, m_carried, m_recorder, m_energy, m_ledger, m_outcomes, m_health, m_clock);
    archive(m_records, m_nextCluster, m_removed, m_time, m_clockRuns, m_seconds, m_place);
    archive(m_result.bodiesPeak, m_result.awakePeak, m_result.steps, m_result.findings);
    return true;
}

bool Collapse::resume(std::string_view content) {
    try {
        Archive archive(content);
        std::string mark;
        archive(mark, m_result.checkpoints.secondsBefore);
        if (!keep(archive) || !archive.atEnd() || !m_sink.resume(m_asked, mark)) {
            return false;
        }
    } catch (const ParseError&) {
        return false;
    }
    m_result.checkpoints.resumedAt = m_time;
    m_execution.report({"simulation.resumed", "going on from a checkpoint at {0}", {Argument(m_time, "s")}}, 0.0);
    return true;
}

double Collapse::secondsSoFar() const {
    return m_result.checkpoints.secondsBefore + std::chrono::duration<double>(Clock::now() - m_began).count();
}

/// Between two steps, once it is time for one.
void Collapse::keepCheckpoint() {
    if (m_checkpoints == nullptr) {
        return;
    }
    const auto from = Clock::now();
    const double interval = m_checkpoints->interval();
    const double due = interval > 0.0 ? std::max(interval, secondsBetween * m_checkpointSeconds) : 0.0;
    if (std::chrono::duration<double>(from - m_latestCheckpoint).count() < due) {
        return;
    }
    CheckpointReport& report = m_result.checkpoints;
    const auto failed = [&](std::string_view why) {
        report.findings.add(
            {"simulation.checkpoint_not_kept",
             "A checkpoint could not be kept: a run that is stopped goes on from the one before, or begins at its start.",
             {}},
            {"simulation.checkpoint_not_kept.remedy", "Make room on the disk.", {}}, why);
    };
    try {
        std::optional<std::string> mark = m_sink.mark();
        Archive archive;
        archive.reserve(m_checkpointBytes + m_checkpointBytes / 8);
        beginCheckpoint(archive, runDigest(m_asked));
        double seconds = secondsSoFar();
        if (mark) {
            archive(*mark, seconds);
        }
        if (!mark || !keep(archive)) {
            // It is made again from the start, whenever that may be.
            m_checkpoints = nullptr;
            return;
        }
        const std::string bytes = sealCheckpoint(std::move(archive));
        m_checkpointBytes = bytes.size();
        m_checkpoints->keep(bytes);
        ++report.kept;
    } catch (const WorldError& error) {
        failed(error.what());
    } catch (const std::bad_alloc&) {
        failed("not enough memory");
    }
    m_latestCheckpoint = Clock::now();
    m_checkpointSeconds = std::chrono::duration<double>(m_latestCheckpoint - from).count();
    report.seconds += m_checkpointSeconds;
}

}  // namespace rubble
