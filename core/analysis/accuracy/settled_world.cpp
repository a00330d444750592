#include "core/analysis/accuracy/settled_world.h"

#include <algorithm>
#include <chrono>
#include <iterator>

#include "core/analysis/accuracy/machine_load.h"
#include "core/base/elapsed.h"
#include "core/trajectory/record_archive.h"
#include "core/trajectory/sink_relay.h"

namespace rubble {

namespace {

/// Notes the released islands and where they are in the last frame, and hands everything on.
class IslandRecorder : public SinkRelay {
public:
    using SinkRelay::SinkRelay;

    void addBodies(std::span<const BodyRecord> bodies, std::span<const Carrier> carriers) override {
        std::copy_if(bodies.begin(), bodies.end(), std::back_inserter(m_bodies),
                     [](const BodyRecord& body) { return body.isIsland(); });
        SinkRelay::addBodies(bodies, carriers);
    }
    void addIslands(std::span<const IslandRecord> islands, const LedgerRow& ledger) override {
        m_islands.insert(m_islands.end(), islands.begin(), islands.end());
        SinkRelay::addIslands(islands, ledger);
    }
    void commit(const TrajectoryFrame& frame) override {
        if (!m_islands.empty()) {
            carried = carriedIslands(m_islands, m_bodies, frame);
        }
        SinkRelay::commit(frame);
    }

    std::vector<CarriedIsland> carried;

private:
    void keep(Archive& archive) override { archive(m_bodies, m_islands, carried); }

    std::vector<BodyRecord> m_bodies;
    std::vector<IslandRecord> m_islands;
};

}  // namespace

std::vector<CarriedIsland> carriedIslands(std::span<const IslandRecord> islands, std::span<const BodyRecord> bodies,
                                          const TrajectoryFrame& frame) {
    std::vector<CarriedIsland> carried;
    for (const IslandRecord& island : islands) {
        const std::size_t b = at(island.body);
        const auto record =
            std::find_if(bodies.begin(), bodies.end(), [&](const BodyRecord& body) { return body.body == island.body; });
        if (b >= frame.bodies() || record == bodies.end()) {
            continue;
        }
        const Quat turn = frame.orientations[b].cast<double>().normalized() * record->atBirth.orientation.conjugate();
        carried.push_back({island.elements, {frame.positions[b].cast<double>() - turn * record->atBirth.position, turn}});
    }
    return carried;
}

void CarriedIsland::keep(Archive& archive) {
    archive(elements, moved);
}

SettledWorld simulateSettled(const RunDescription& description, const Execution& execution, CheckpointStore* checkpoints) {
    const auto start = std::chrono::steady_clock::now();
    const MachineLoad load;
    DebrisRecorder recorder;
    IslandRecorder islands(&recorder);
    const SimulationResult result = simulate(description, islands, execution, checkpoints);
    SettledWorld settled;
    SimulatedWorld& world = settled.world;
    world.wallSeconds = result.checkpoints.secondsBefore + secondsSince(start);
    world.othersShare = load.othersShare();
    world.trajectoryHash = result.trajectoryHash;
    world.endTime = result.endTime;
    world.stepMeanMs = result.stepTimes.meanMs;
    world.stepWorstMs = result.stepTimes.worstMs;
    world.breaches = static_cast<std::int64_t>(result.health.breaches.size());
    world.bodiesPeak = result.bodiesPeak;
    world.atRest = recorder.debris(DebrisInstant::AtRest);
    world.atFeEnd = recorder.debris(DebrisInstant::AtFeEnd);
    world.checkpoints = result.checkpoints;
    settled.islands = std::move(islands.carried);
    return settled;
}

}  // namespace rubble
