#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/trajectory/sink_relay.h"

namespace rubble::cli {

/// What the ledger says of islands of live structure.
struct IslandRows {
    std::vector<LedgerRow> handOvers;  ///< those with anything that the FE result handed over
    std::vector<IslandLoss> losses;
};

/// Keeps the ledger and counts the frames of a run, and hands everything on to another sink, if there is one.
class LedgerRecorder : public SinkRelay {
public:
    using SinkRelay::SinkRelay;

    void commit(const TrajectoryFrame& frame) override;
    void addLedger(const LedgerRow& row) override;
    void addIslands(std::span<const IslandRecord> islands, const LedgerRow& ledger) override;
    void addIslandLoss(const IslandLoss& loss) override;

    const std::vector<LedgerRow>& ledger() const { return m_ledger; }
    const IslandRows& islands() const { return m_islands; }
    std::int64_t frames() const { return m_frames; }
    double lastTime() const { return m_lastTime; }  ///< s, of the last frame

private:
    void keep(Archive& archive) override;

    std::vector<LedgerRow> m_ledger;
    IslandRows m_islands;
    std::int64_t m_frames = 0;
    double m_lastTime = 0.0;
};

}  // namespace rubble::cli
