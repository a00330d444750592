#pragma once

#include "core/trajectory/trajectory.h"

namespace rubble {

class Archive;

/// Hands a run on to another sink: what looks on overrides the calls it looks at, and calls these. What keeps something of what it
/// saw visits it in keep().
class SinkRelay : public TrajectorySink {
public:
    /// @param next  not owned; null: there is none
    explicit SinkRelay(TrajectorySink* next) : m_next(next) {}

    void begin(const RunDescription& description) override;
    void addBodies(std::span<const BodyRecord> bodies, std::span<const Carrier> carriers) override;
    void addIslands(std::span<const IslandRecord> islands, const LedgerRow& ledger) override;
    void addIslandLoss(const IslandLoss& loss) override;
    void commit(const TrajectoryFrame& frame) override;
    void addLedger(const LedgerRow& row) override;
    void addBreaches(const std::vector<HealthBreach>& breaches) override;
    void finish(const SimulationResult& result) override;
    std::optional<std::string> mark() final;
    bool resume(const RunDescription& description, std::string_view mark) final;

private:
    /// What it knows of the run, for the mark.
    virtual void keep(Archive&) {}

    TrajectorySink* m_next;
};

}  // namespace rubble
