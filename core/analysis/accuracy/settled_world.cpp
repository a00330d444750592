#include "core/analysis/accuracy/settled_world.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <unordered_map>

#include "core/analysis/accuracy/machine_load.h"
#include "core/base/elapsed.h"
#include "core/simulation/health/passed_limits.h"
#include "core/trajectory/record_archive.h"
#include "core/trajectory/sink_relay.h"

namespace rubble {

namespace {

/// Notes the islands and the last frame, and hands everything on.
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
            m_last = frame;
        }
        SinkRelay::commit(frame);
    }
    /// In the last frame.
    std::vector<CarriedIsland> carried() const { return carriedIslands(m_islands, m_bodies, m_last); }

private:
    void keep(Archive& archive) override { archive(m_bodies, m_islands, m_last); }

    std::vector<BodyRecord> m_bodies;
    std::vector<IslandRecord> m_islands;
    TrajectoryFrame m_last;
};

}  // namespace

std::vector<CarriedIsland> carriedIslands(std::span<const IslandRecord> islands, std::span<const BodyRecord> bodies,
                                          const TrajectoryFrame& frame) {
    std::unordered_map<std::size_t, const BodyRecord*> there;
    for (const BodyRecord& body : bodies) {
        if (body.isIsland() && at(body.body) < frame.bodies() && body.from <= frame.time && frame.time < body.to) {
            there.emplace(at(body.body), &body);
        }
    }
    std::vector<CarriedIsland> carried;
    for (const IslandRecord& island : islands) {
        const std::size_t b = at(island.body);
        if (there.contains(b)) {
            const Quat turn = frame.orientations[b].cast<double>().normalized() * island.inFe.orientation.conjugate();
            carried.push_back(
                {island.elements, island.state, {frame.positions[b].cast<double>() - turn * island.inFe.position, turn}});
        }
    }
    return carried;
}

std::vector<CarriedIsland> leftIslands(const FragmentSet& fragments, std::span<const IslandRecord> islands,
                                       std::span<const Carrier> carriers, const TrajectoryFrame& frame) {
    std::vector<const Carrier*> latest(islands.empty() ? 0 : fragments.size(), nullptr);
    for (const Carrier& carrier : carriers) {
        if (at(carrier.fragment) < latest.size() && carrier.from <= frame.time && frame.time < carrier.to) {
            latest[at(carrier.fragment)] = &carrier;
        }
    }
    std::unordered_map<std::size_t, FragmentId> onTheWay;
    for (std::size_t f = 0; f < latest.size(); ++f) {
        const Fragment& fragment = fragments.list[f];
        const bool there =
            latest[f] != nullptr && at(latest[f]->body) < frame.bodies() && frame.states[at(latest[f]->body)] != BodyState::Removed;
        if (there && fragment.handOverTime <= frame.time && frame.time < fragment.birthTime) {
            onTheWay.emplace(at(fragment.element), idAt<FragmentId>(f));
        }
    }
    std::vector<CarriedIsland> left;
    for (std::size_t i = 0; i < islands.size() && !onTheWay.empty(); ++i) {
        for (const ElementIndex e : islands[i].elements) {
            const auto found = onTheWay.find(at(e));
            if (found == onTheWay.end()) {
                continue;
            }
            const Carrier& carrier = *latest[at(found->second)];
            const std::size_t b = at(carrier.body);
            const Pose body{frame.positions[b].cast<double>(), frame.orientations[b].cast<double>().normalized()};
            left.push_back({{e}, fragments.list[at(found->second)].handOverState, body * carrier.handOverToBody});
            onTheWay.erase(found);
        }
    }
    return left;
}

void CarriedIsland::keep(Archive& archive) {
    archive(elements, state, moved);
}

SettledWorld simulateSettled(const RunDescription& description, const Execution& execution, CheckpointStore* checkpoints) {
    const auto start = std::chrono::steady_clock::now();
    const MachineLoad load;
    DebrisRecorder recorder;
    ArrivalRecorder arrivals(description, &recorder);
    IslandRecorder islands(&arrivals);
    const SimulationResult result = simulate(description, islands, execution, checkpoints);
    SettledWorld settled;
    SimulatedWorld& world = settled.world;
    world.wallSeconds = result.checkpoints.secondsBefore + secondsSince(start);
    world.othersShare = load.othersShare();
    world.trajectoryHash = result.trajectoryHash;
    world.endTime = result.endTime;
    world.stepMeanMs = result.stepTimes.meanMs;
    world.stepWorstMs = result.stepTimes.worstMs;
    world.breaches = static_cast<std::int64_t>(passedLimits(result.health.breaches).size());
    world.bodiesPeak = result.bodiesPeak;
    world.moving = result.stillMoving;
    world.atRest = recorder.debris(DebrisInstant::AtRest);
    world.atFeEnd = recorder.debris(DebrisInstant::AtFeEnd);
    world.checkpoints = result.checkpoints;
    settled.islands = islands.carried();
    settled.arrivals = arrivals.arrivals();
    return settled;
}

}  // namespace rubble
