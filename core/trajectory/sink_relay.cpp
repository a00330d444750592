#include "core/trajectory/sink_relay.h"

#include "core/base/archive.h"

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

void SinkRelay::addIslandLoss(const IslandLoss& loss) {
    if (m_next != nullptr) {
        m_next->addIslandLoss(loss);
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

std::optional<std::string> SinkRelay::mark() {
    std::optional<std::string> next = m_next != nullptr ? m_next->mark() : std::string();
    if (!next) {
        return std::nullopt;
    }
    Archive archive;
    archive(*next);
    keep(archive);
    return std::move(archive).take();
}

bool SinkRelay::resume(const RunDescription& description, std::string_view mark) {
    Archive archive(mark);
    std::string next;
    archive(next);
    // Where the next one cannot go on, nothing has been taken here either.
    if (m_next != nullptr && !m_next->resume(description, next)) {
        return false;
    }
    keep(archive);
    return archive.atEnd();
}

}  // namespace rubble
