#pragma once

#include <cstdint>
#include <optional>
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

/// Compares the frames of a run as it is made with those that were recorded, bit by bit. Keeps nothing but the first difference.
class FrameComparison : public TrajectorySink {
public:
    /// The first place where two runs differ.
    struct Difference {
        double time = 0.0;       ///< s, of the new run
        std::int64_t body = -1;  ///< -1: the frames differ in their time or their number of bodies
        double distance = 0.0;   ///< m, between the two places of the body
    };

    explicit FrameComparison(const TrajectoryReader& recorded) : m_recorded(recorded) {}

    void begin(const RunDescription&) override {}
    void addBodies(std::span<const BodyRecord>, std::span<const Carrier>) override {}
    void commit(const TrajectoryFrame& frame) override;
    void addLedger(const LedgerRow&) override {}
    void finish(const SimulationResult&) override {}

    const std::optional<Difference>& firstDifference() const { return m_difference; }
    std::size_t frames() const { return m_frames; }

private:
    const TrajectoryReader& m_recorded;
    std::size_t m_frames = 0;
    std::optional<Difference> m_difference;
};

}  // namespace rubble::cli
