#include "core/simulation/run/islands.h"

#include <algorithm>
#include <iterator>

#include "core/engine/world/constants.h"
#include "core/simulation/bodies/loose_count.h"
#include "core/simulation/health/ledger.h"
#include "core/simulation/health/value_archive.h"
#include "core/simulation/run/bulking.h"

namespace rubble {

namespace {

/// Share of the released islands that must sleep for a run to end before its time.
constexpr double islandsAsleep = 0.99;

}  // namespace

Islands::Islands(const RunDescription& description, const Activity& activity, const SiteSurface& ground)
    : m_description(description), m_activity(activity), m_ground(ground) {}

void Islands::find() {
    if (!m_loose) {
        m_loose = liveIslands(*m_description.fe, m_activity, m_ground);
        std::erase_if(*m_loose, [](const LiveIsland& island) { return island.supported; });
        for (LiveIsland& island : *m_loose) {
            std::erase_if(island.elements, [this](ElementIndex e) { return m_carried && m_carried(e); });
        }
        std::erase_if(*m_loose, [](const LiveIsland& island) { return island.elements.empty(); });
        m_count = countLoose(*m_description.fe, *m_description.components, *m_loose);
    }
}

bool Islands::toRelease() {
    if (m_description.scenario.effects.islands == LiveIslandPolicy::Held) {
        return false;
    }
    find();
    return !m_loose->empty();
}

Islands::Release Islands::release(RigidWorld& world, Pieces& pieces, Findings& findings) {
    Release release;
    if (!toRelease()) {
        return release;
    }
    std::vector<IslandBody> made;
    IslandMaker maker(m_description, m_activity, *m_loose, m_description.fe->stateCount() - 1);
    for (const LiveIsland& island : *m_loose) {
        if (std::optional<IslandBody> body = maker.make(island, findings)) {
            made.push_back(std::move(*body));
        }
    }
    m_count.refused = static_cast<std::int64_t>(m_loose->size() - made.size());
    if (made.empty()) {
        return release;
    }
    m_gone.assign(m_description.fe->mesh().elementCount(), false);
    for (const IslandBody& island : made) {
        for (const ElementIndex e : island.elements) {
            m_gone[at(e)] = true;
        }
    }
    const std::size_t last = m_description.fe->stateCount() - 1;
    pieces.release(world, m_gone, last);
    release.ledger.time = m_description.fe->times()[last];
    release.ledger.state = static_cast<std::uint32_t>(last);
    for (IslandBody& island : made) {
        take(island, world, release);
        m_bodies.push_back({release.bodies.back().body, std::move(island)});
    }
    close(release.ledger);
    return release;
}

void Islands::take(const IslandBody& island, RigidWorld& world, Release& release) {
    const BodyId id = world.addBody(newBody(island, m_description));
    BodyRecord record;
    record.body = id;
    record.cluster = noCluster;
    record.from = release.ledger.time;
    record.mass = island.motion.mass;
    record.atBirth = record.inFe = island.pose;
    release.bodies.push_back(record);
    release.islands.push_back({id, release.ledger.state, island.pose, island.elements});
    const MovingMass& m = island.motion;
    release.ledger.fe += island.fe;
    release.ledger.fragments += island.rigid;
    release.ledger.clusters += rigidMomenta(m.mass, m.centre, m.inertia, m.velocity, m.angularVelocity);
    release.ledger.bodies += world.momenta(id);
    m_linear += m.mass * m.velocity.norm();
    m_angular += m.centre.norm() * m.mass * m.velocity.norm();
    ++m_count.released;
    m_count.releasedElements += static_cast<std::int64_t>(island.elements.size());
    m_count.releasedMass += m.mass;
}

void Islands::close(const LedgerRow& row) {
    LedgerErrors& errors = m_count.ledger;
    errors.mass = relativeError(std::abs(row.fragments.mass - row.fe.mass), row.fe.mass);
    errors.momentum = relativeError((row.fragments.linear - row.fe.linear).norm(), m_linear);
    errors.angularMomentum = relativeError((row.fragments.angular - row.fe.angular).norm(), m_angular);
    errors.bodyMass = relativeError(std::abs(row.bodies.mass - row.fe.mass), row.fe.mass);
    errors.bodyMomentum = relativeError((row.bodies.linear - row.fe.linear).norm(), m_linear);
    errors.bodyAngularMomentum = relativeError((row.bodies.angular - row.fe.angular).norm(), m_angular);
    m_count.droppedKineticEnergy = row.fe.kineticEnergy - row.bodies.kineticEnergy;
}

std::vector<Aabb> outlines(const IslandBody& island, const Pose& body) {
    const Pose moved = body * island.pose.inverse();
    std::vector<Aabb> outlines;
    for (const IslandElement& part : island.parts) {
        OrientedBox box = part.box;
        box.centre = moved * box.centre;
        box.orientation = moved.orientation * box.orientation;
        outlines.push_back(outline(box));
    }
    return outlines;
}

std::vector<Aabb> Islands::outlines(const RigidWorld& world) const {
    std::vector<Aabb> all;
    for (const Body& body : m_bodies) {
        if (world.state(body.id) != BodyState::Removed) {
            std::ranges::copy(rubble::outlines(body.island, world.motion(body.id).pose), std::back_inserter(all));
        }
    }
    return all;
}

std::int64_t Islands::awake(const RigidWorld& world) const {
    return std::count_if(m_bodies.begin(), m_bodies.end(),
                         [&](const Body& body) { return world.state(body.id) == BodyState::Awake; });
}

bool Islands::atRest(const RigidWorld& world) const {
    return static_cast<double>(awake(world)) <= (1.0 - islandsAsleep) * static_cast<double>(m_bodies.size());
}

void Islands::Body::keep(Archive& archive) {
    archive(id, island);
}

void Islands::keep(Archive& archive) {
    archive(m_loose, m_count, m_bodies, m_gone, m_linear, m_angular);
}

LiveIslands Islands::outcome(const RigidWorld& world, Findings& findings) {
    find();
    m_count.stillMoving = awake(world);
    m_count.occupied = std::count_if(m_bodies.begin(), m_bodies.end(),
                                     [&](const Body& body) { return world.birthDepth(body.id) > occupiedShare; });
    if (m_count.held() > 0) {
        const bool asked = m_description.scenario.effects.islands == LiveIslandPolicy::Held;
        findings.add({"simulation.live_islands",
                      "Loose structure that is alive at the end is held where it is (islands: {0}, elements: {1})",
                      {m_count.held(), m_count.elements - m_count.releasedElements}},
                     asked
                         ? Message{"simulation.live_islands.remedy.held",
                                   "read them as debris that the FE analysis did not delete, or set live_islands = released so "
                                   "that they go on as rigid bodies",
                                   {}}
                         : Message{"simulation.live_islands.remedy", "read them as debris that the FE analysis did not delete", {}},
                     "", m_count.held());
    }
    return m_count;
}

}  // namespace rubble
