#include "app/cli/run/run_sinks.h"

#include <algorithm>
#include <cstring>

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

namespace {

template <class T>
bool sameBits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}

}  // namespace

void FrameComparison::commit(const TrajectoryFrame& frame) {
    const std::size_t i = m_frames++;
    if (m_difference || i >= m_recorded.frameCount()) {
        return;
    }
    const auto recorded = m_recorded.frame(i);
    if (!sameBits(recorded->time, frame.time) || recorded->bodies() != frame.bodies()) {
        m_difference = Difference{frame.time, -1, 0.0};
        return;
    }
    for (std::size_t b = 0; b < frame.bodies(); ++b) {
        const bool same = std::equal(frame.positions[b].data(), frame.positions[b].data() + 3, recorded->positions[b].data()) &&
                          std::equal(frame.orientations[b].coeffs().data(), frame.orientations[b].coeffs().data() + 4,
                                     recorded->orientations[b].coeffs().data());
        if (!same) {
            m_difference = Difference{frame.time, static_cast<std::int64_t>(b),
                                      static_cast<double>((frame.positions[b] - recorded->positions[b]).norm())};
            return;
        }
    }
}

}  // namespace rubble::cli
