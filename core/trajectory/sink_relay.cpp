#include "core/trajectory/sink_relay.h"

namespace rubble {

void SinkRelay::begin(const RunDescription& description) {
    if (m_next != nullptr) {
        m_next->begin(description);
    }
}

void SinkRelay::addBodies(std::span<const BodyRecord> bodies, std::span<const Carrier> carriers) {
    if (m_next != nullptr) {
        m_next->addBodies(bodies, carriers);
    }
}

void SinkRelay::addIslands(std::span<const IslandRecord> islands, const LedgerRow& ledger) {
    if (m_next != nullptr) {
        m_next->addIslands(islands, ledger);
    }
}

void SinkRelay::commit(const TrajectoryFrame& frame) {
    if (m_next != nullptr) {
        m_next->commit(frame);
    }
}

void SinkRelay::addLedger(const LedgerRow& row) {
    if (m_next != nullptr) {
        m_next->addLedger(row);
    }
}

void SinkRelay::addBreaches(const std::vector<HealthBreach>& breaches) {
    if (m_next != nullptr) {
        m_next->addBreaches(breaches);
    }
}

void SinkRelay::finish(const SimulationResult& result) {
    if (m_next != nullptr) {
        m_next->finish(result);
    }
}

}  // namespace rubble
