#include "app/cli/run/run_sinks.h"

#include "core/trajectory/record_archive.h"

namespace rubble::cli {

void LedgerRecorder::commit(const TrajectoryFrame& frame) {
    SinkRelay::commit(frame);
    // Counted after the sink took it: what failed to be written is not a frame.
    ++m_frames;
    m_lastTime = frame.time;
}

void LedgerRecorder::addLedger(const LedgerRow& row) {
    SinkRelay::addLedger(row);
    m_ledger.push_back(row);
}

void LedgerRecorder::addIslands(std::span<const IslandRecord> islands, const LedgerRow& ledger) {
    SinkRelay::addIslands(islands, ledger);
    if (ledger.fe.mass > 0.0) {
        m_islands.handOvers.push_back(ledger);
    }
}

void LedgerRecorder::addIslandLoss(const IslandLoss& loss) {
    SinkRelay::addIslandLoss(loss);
    m_islands.losses.push_back(loss);
}

void LedgerRecorder::keep(Archive& archive) {
    archive(m_ledger, m_islands.handOvers, m_islands.losses, m_frames, m_lastTime);
}

}  // namespace rubble::cli
