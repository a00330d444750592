#include <cassert>
#include <mutex>

#include "core/trajectory/record_archive.h"

namespace rubble {

struct MemoryTrajectory::Store {
    mutable std::mutex mutex;
    std::vector<std::shared_ptr<const TrajectoryFrame>> frames;
    std::vector<BodyRecord> bodies;
    std::vector<Carrier> carriers;
    std::vector<LedgerRow> ledger;
    std::vector<IslandRecord> islands;
    std::vector<LedgerRow> islandLedger;
    std::vector<IslandLoss> islandLosses;
    bool complete = false;

    void keep(Archive& archive) {
        const std::size_t count = archive.count(frames.size());
        for (std::size_t i = 0; i < count; ++i) {
            TrajectoryFrame frame = archive.reading() ? TrajectoryFrame() : *frames[i];
            archive(frame);
            if (archive.reading()) {
                frames.push_back(std::make_shared<const TrajectoryFrame>(std::move(frame)));
            }
        }
        archive(bodies, carriers, ledger, islands, islandLedger, islandLosses);
    }
};

MemoryTrajectory::MemoryTrajectory() : m_store(std::make_unique<Store>()) {}
MemoryTrajectory::~MemoryTrajectory() = default;

void MemoryTrajectory::begin(const RunDescription&) {
    const std::scoped_lock lock(m_store->mutex);
    m_store->frames.clear();
    m_store->bodies.clear();
    m_store->carriers.clear();
    m_store->ledger.clear();
    m_store->islands.clear();
    m_store->islandLedger.clear();
    m_store->islandLosses.clear();
    m_store->complete = false;
}

void MemoryTrajectory::addBodies(std::span<const BodyRecord> bodies, std::span<const Carrier> carriers) {
    const std::scoped_lock lock(m_store->mutex);
    assert(!m_store->complete);
    m_store->bodies.insert(m_store->bodies.end(), bodies.begin(), bodies.end());
    m_store->carriers.insert(m_store->carriers.end(), carriers.begin(), carriers.end());
}

void MemoryTrajectory::addIslands(std::span<const IslandRecord> islands, const LedgerRow& ledger) {
    const std::scoped_lock lock(m_store->mutex);
    m_store->islands.insert(m_store->islands.end(), islands.begin(), islands.end());
    m_store->islandLedger.push_back(ledger);
}

void MemoryTrajectory::addIslandLoss(const IslandLoss& loss) {
    const std::scoped_lock lock(m_store->mutex);
    m_store->islandLosses.push_back(loss);
}

void MemoryTrajectory::commit(const TrajectoryFrame& frame) {
    assert(frame.orientations.size() == frame.bodies() && frame.speeds.size() == frame.bodies() &&
           frame.states.size() == frame.bodies());
    auto kept = std::make_shared<const TrajectoryFrame>(frame);
    const std::scoped_lock lock(m_store->mutex);
    assert(!m_store->complete && (m_store->frames.empty() || m_store->frames.back()->time <= frame.time));
    m_store->frames.push_back(std::move(kept));
}

void MemoryTrajectory::addLedger(const LedgerRow& row) {
    const std::scoped_lock lock(m_store->mutex);
    m_store->ledger.push_back(row);
}

void MemoryTrajectory::finish(const SimulationResult&) {
    const std::scoped_lock lock(m_store->mutex);
    m_store->complete = true;
}

std::optional<std::string> MemoryTrajectory::mark() {
    const std::scoped_lock lock(m_store->mutex);
    Archive archive;
    archive(*m_store);
    return std::move(archive).take();
}

bool MemoryTrajectory::resume(const RunDescription& description, std::string_view mark) {
    MemoryTrajectory::begin(description);
    const std::scoped_lock lock(m_store->mutex);
    Archive archive(mark);
    archive(*m_store);
    return archive.atEnd();
}

std::size_t MemoryTrajectory::frameCount() const {
    const std::scoped_lock lock(m_store->mutex);
    return m_store->frames.size();
}

double MemoryTrajectory::frameTime(std::size_t i) const {
    return frame(i)->time;
}

std::shared_ptr<const TrajectoryFrame> MemoryTrajectory::frame(std::size_t i) const {
    const std::scoped_lock lock(m_store->mutex);
    assert(i < m_store->frames.size());
    return m_store->frames[i];
}

std::vector<BodyRecord> MemoryTrajectory::bodies() const {
    const std::scoped_lock lock(m_store->mutex);
    std::vector<BodyRecord> bodies = m_store->bodies;
    std::vector<Carrier> carriers = m_store->carriers;
    endReplaced(bodies, carriers);
    return bodies;
}

std::vector<Carrier> MemoryTrajectory::carriers() const {
    const std::scoped_lock lock(m_store->mutex);
    std::vector<BodyRecord> bodies = m_store->bodies;
    std::vector<Carrier> carriers = m_store->carriers;
    endReplaced(bodies, carriers);
    return carriers;
}

std::vector<IslandRecord> MemoryTrajectory::islands() const {
    const std::scoped_lock lock(m_store->mutex);
    return m_store->islands;
}

bool MemoryTrajectory::complete() const {
    const std::scoped_lock lock(m_store->mutex);
    return m_store->complete;
}

std::vector<LedgerRow> MemoryTrajectory::ledger() const {
    const std::scoped_lock lock(m_store->mutex);
    return m_store->ledger;
}

std::vector<LedgerRow> MemoryTrajectory::islandLedger() const {
    const std::scoped_lock lock(m_store->mutex);
    return m_store->islandLedger;
}

std::vector<IslandLoss> MemoryTrajectory::islandLosses() const {
    const std::scoped_lock lock(m_store->mutex);
    return m_store->islandLosses;
}

}  // namespace rubble
