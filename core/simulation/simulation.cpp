#include "core/simulation/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/fe/ground_surface.h"
#include "core/fragments/lifetimes.h"
#include "core/simulation/bulking.h"
#include "core/simulation/collapse_run.h"
#include "core/simulation/constants.h"
#include "core/simulation/energy.h"
#include "core/simulation/frame_recorder.h"
#include "core/simulation/hand_over.h"
#include "core/simulation/ledger.h"
#include "core/simulation/live_islands.h"
#include "core/simulation/outcomes.h"
#include "core/simulation/pieces.h"
#include "core/simulation/step_clock.h"

namespace rubble {

namespace {

/// Share of the bodies that must sleep for a run to end before its time.
constexpr double asleepShare = 0.99;

WorldSettings worldSettings(const RunDescription& description, const Execution& execution) {
    const SimulationSettings& s = description.scenario.simulation;
    WorldSettings world;
    world.gravity = s.gravity;
    world.ground = s.ground;
    world.groundHeight = s.groundHeight;
    if (description.scenario.effects.of(EffectKind::Terrain) != EffectSwitch::Off) {
        world.terrain = description.terrain;
    }
    for (const Component& component : description.components->list) {
        if (!component.bounds.isEmpty() && component.bounds.sizes().allFinite()) {
            world.reach.extend(component.bounds);
        }
    }
    world.pairs = PairTable::uniform(s.friction, s.restitution);
    world.iterations = s.iterations;
    world.freeze = s.freeze;
    world.freezeSpeed = s.freezeSpeed;
    world.freezeDelay = s.freezeDelay;
    world.overlapSpeed = s.overlapSpeed;
    world.cancelled = [execution] { return execution.cancelled(); };
    return world;
}

/// One run from the first hand-over to the end.
class Collapse {
public:
    Collapse(const WorldFactory& makeWorld, const RunDescription& description, TrajectorySink& sink, const Execution& execution)
        : m_description(description),
          m_settings(description.scenario.simulation),
          m_times(description.fe->times()),
          m_sink(sink),
          m_execution(execution),
          m_activity(activityUnder(description.fe->activity(), description.scenario.fragments.revival)),
          m_worldSettings(worldSettings(description, execution)),
          m_surface{m_worldSettings.ground, m_worldSettings.groundHeight, m_worldSettings.terrain},
          m_world(makeWorld(m_worldSettings)),
          m_pieces(*description.fe, *description.components, m_activity, m_settings),
          m_recorder(sink, m_settings.frameRate),
          m_energy(m_settings.gravity, m_settings.groundHeight),
          m_ledger(description),
          m_outcomes(description, m_settings.gravity) {}

    SimulationResult run();

private:
    void followStructure();
    void settle();
    void atState(std::size_t k);
    void removeEnded(double time);
    void handOverAt(std::size_t k, LedgerRow& row);
    void step(double dt, double time);
    void addLedgerRow(LedgerRow row);
    void updateEnergy();
    double asleep() const;
    std::int64_t present() const { return static_cast<std::int64_t>(m_world->bodyCount()) - m_removed; }
    void report(double time) const;
    void measureBirths(OccupiedBirths& births) const;
    double bulking() const;
    void finish();
    void warn();

    const RunDescription& m_description;
    const SimulationSettings& m_settings;
    const std::vector<double>& m_times;
    TrajectorySink& m_sink;
    const Execution& m_execution;
    Activity m_activity;
    WorldSettings m_worldSettings;
    GroundSurface m_surface;
    std::unique_ptr<RigidWorld> m_world;
    Pieces m_pieces;
    FrameRecorder m_recorder;
    EnergyAccount m_energy;
    Ledger m_ledger;
    Outcomes m_outcomes;
    StepClock m_clock;
    std::vector<BodyRecord> m_records;  ///< [bodies]
    std::size_t m_nextCluster = 0;
    std::int64_t m_removed = 0;
    double m_time = 0.0;
    double m_lastBirth = 0.0;
    bool m_clockRuns = false;
    SimulationResult m_result;
};

void Collapse::report(double time) const {
    const double from = m_result.firstTime;
    const double to = m_result.feEndTime + m_settings.settleTime;
    m_execution.report({"simulation.progress", "simulating, {0} bodies at {1}", {m_world->bodyCount(), Argument(time, "s")}},
                       std::clamp((time - from) / std::max(to - from, 1e-9), 0.0, 0.999));
}

void Collapse::updateEnergy() {
    m_energy.update(m_outcomes.kineticEnergy(), m_outcomes.massHeight(), m_world->contacts());
}

void Collapse::removeEnded(double time) {
    for (std::size_t i = 0; i < m_records.size(); ++i) {
        const BodyId id = idAt<BodyId>(i);
        if (m_records[i].to <= time && m_world->state(id) != BodyState::Removed) {
            m_energy.leaving(m_world->momenta(id), m_world->motion(id).pose.position.z());
            m_world->removeBody(id);
            ++m_removed;
        }
    }
}

void Collapse::handOverAt(std::size_t k, LedgerRow& row) {
    const auto& clusters = m_description.clustering->list;
    std::size_t end = m_nextCluster;
    while (end < clusters.size() && clusters[end].handOverState == k) {
        ++end;
    }
    const HandOver entered = handOver(m_description, m_nextCluster, end, *m_world, m_result.findings);
    m_nextCluster = end;
    m_outcomes.entered(entered, *m_world);
    row = m_ledger.handedOver(k, m_times[k], entered, *m_world);
    for (const BodyRecord& body : entered.bodies) {
        m_records.push_back(body);
        m_energy.entered(m_world->momenta(body.body), m_world->motion(body.body).pose.position.z());
    }
    if (!entered.bodies.empty()) {
        m_sink.addBodies(entered.bodies, entered.carriers);
    }
    m_result.bodiesPeak = std::max(m_result.bodiesPeak, present());
}

void Collapse::atState(std::size_t k) {
    removeEnded(m_times[k]);
    LedgerRow row;
    handOverAt(k, row);
    m_recorder.commit(*m_world, m_times[k], FrameKind::Fe);
    addLedgerRow(row);
}

void Collapse::addLedgerRow(LedgerRow row) {
    double massHeight = 0.0;
    for (std::size_t i = 0; i < m_world->bodyCount(); ++i) {
        const BodyId id = idAt<BodyId>(i);
        if (m_world->state(id) != BodyState::Removed) {
            const Momenta body = m_world->momenta(id);
            row.all += body;
            massHeight += body.mass * (m_world->motion(id).pose.position.z() - m_settings.groundHeight);
        }
    }
    row.potentialEnergy = m_settings.gravity * massHeight;
    row.pieceWork = m_world->contacts().pieceWork;
    row.overlapWork = m_world->contacts().overlapWork;
    m_sink.addLedger(row);
}

void Collapse::step(double dt, double time) {
    const auto from = std::chrono::steady_clock::now();
    m_world->step(dt);
    m_execution.check();
    m_time = time;
    m_outcomes.stepped(*m_world, time, dt);
    updateEnergy();
    if (m_clockRuns) {
        m_clock.add(from, dt);
    }
    ++m_result.steps;
    report(time);
}

void Collapse::followStructure() {
    const std::size_t first = m_description.clustering->list.front().handOverState;
    m_clock.start();
    m_clockRuns = true;
    for (std::size_t k = first; k + 1 < m_times.size(); ++k) {
        atState(k);
        m_pieces.beginInterval(*m_world, k);
        const double span = m_times[k + 1] - m_times[k];
        const auto steps = static_cast<std::int64_t>(std::max(1.0, std::ceil(span * m_settings.stepRate - 1e-6)));
        const double dt = span / static_cast<double>(steps);
        for (std::int64_t i = 1; i <= steps; ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(steps);
            m_pieces.moveTo(*m_world, share);
            step(dt, i == steps ? m_times[k + 1] : m_times[k] + static_cast<double>(i) * dt);
            if (i < steps && m_recorder.due(m_time)) {
                m_recorder.commit(*m_world, m_time, FrameKind::Simulated);
            }
        }
        if (m_clockRuns && m_times[k + 1] >= m_lastBirth - 1e-9) {
            m_clock.stop();
            m_clockRuns = false;
        }
    }
    atState(m_times.size() - 1);
}

double Collapse::asleep() const {
    std::int64_t frozen = 0;
    for (std::size_t i = 0; i < m_world->bodyCount(); ++i) {
        frozen += m_world->state(idAt<BodyId>(i)) == BodyState::Frozen;
    }
    return present() > 0 ? static_cast<double>(frozen) / static_cast<double>(present()) : 1.0;
}

void Collapse::settle() {
    const double dt = 1.0 / m_settings.stepRate;
    const double from = m_times.back();
    double nextRow = from + 1.0;
    m_pieces.hold();
    for (std::int64_t i = 1; asleep() < asleepShare && static_cast<double>(i) * dt <= m_settings.settleTime + 1e-9; ++i) {
        step(dt, from + static_cast<double>(i) * dt);
        if (m_recorder.due(m_time)) {
            m_recorder.commit(*m_world, m_time, FrameKind::Simulated);
        }
        if (m_time >= nextRow - 1e-9) {
            LedgerRow row;
            row.time = m_time;
            row.state = static_cast<std::uint32_t>(m_times.size() - 1);
            addLedgerRow(row);
            nextRow += 1.0;
        }
    }
}

void Collapse::measureBirths(OccupiedBirths& births) const {
    std::vector<double> depths;
    for (std::size_t i = 0; i < m_world->bodyCount(); ++i) {
        const double depth = m_world->birthDepth(idAt<BodyId>(i));
        if (depth > occupiedShare) {
            depths.push_back(depth);
        }
    }
    const ContactReport& contacts = m_world->contacts();
    births.births = static_cast<std::int64_t>(m_world->bodyCount());
    births.occupied = static_cast<std::int64_t>(depths.size());
    if (!depths.empty()) {
        const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
        std::nth_element(depths.begin(), middle, depths.end());
        births.medianDepth = *middle;
    }
    births.work = contacts.overlapWork;
    births.piecePushWork = contacts.pieceWork;
    births.piecesYielded = contacts.piecesYielded;
}

double Collapse::bulking() const {
    std::vector<DebrisBox> debris;
    for (std::size_t i = 0; i < m_records.size(); ++i) {
        const Pose now = m_world->motion(idAt<BodyId>(i)).pose;
        if (m_world->state(idAt<BodyId>(i)) == BodyState::Removed) {
            continue;
        }
        const Pose& birth = m_records[i].atBirth;
        const Quat turn = now.orientation * birth.orientation.conjugate();
        for (const FragmentId f : m_description.clustering->membersOf(m_records[i].cluster)) {
            const Fragment& fragment = m_description.fragments->list[at(f)];
            OrientedBox box = fragment.box;
            box.centre = now.position + turn * (box.centre - birth.position);
            box.orientation = turn * box.orientation;
            debris.push_back({box, m_description.components->volume[at(fragment.element)]});
        }
    }
    const Mesh& mesh = m_description.fe->mesh();
    const auto last = m_description.fe->state(m_times.size() - 1);
    std::vector<Aabb> standing;
    for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
        const ElementIndex e = idAt<ElementIndex>(i);
        if (m_activity.active(m_times.size() - 1, e)) {
            Aabb box;
            for (const std::uint32_t node : mesh.cornersOf(e)) {
                box.extend(last->positions[node]);
            }
            standing.push_back(box);
        }
    }
    return bulkingFactor(debris, standing, m_surface);
}

void Collapse::warn() {
    const std::int64_t fast = m_outcomes.tooFast(*m_world);
    if (fast > 0) {
        m_result.findings.add({"simulation.too_fast", "{0} bodies were faster than gravity and their birth allow", {fast}},
                              {"simulation.too_fast.remedy", "a higher step rate makes collisions gentler", {}}, "", fast);
    }
    std::int64_t below = 0;
    for (std::size_t i = 0; m_surface.present() && i < m_world->bodyCount(); ++i) {
        const BodyId id = idAt<BodyId>(i);
        const Vec3 centre = m_world->motion(id).pose.position;
        below += m_world->state(id) != BodyState::Removed && centre.z() < m_surface.height(centre.x(), centre.y());
    }
    if (below > 0) {
        m_result.findings.add({"simulation.below_ground", "{0} bodies lie below the ground at the end", {below}},
                              {"simulation.below_ground.remedy", "raise the step rate, or set the ground to its real height", {}},
                              "", below);
    }
    if (m_result.islands.islands > 0) {
        m_result.findings.add({"simulation.live_islands",
                               "{0} loose pieces of the structure ({1} elements) are alive at the end and are held where they are",
                               {m_result.islands.islands, m_result.islands.elements}},
                              {"simulation.live_islands.remedy", "read them as debris that the FE analysis did not delete", {}}, "",
                              m_result.islands.islands);
    }
}

void Collapse::finish() {
    if (m_recorder.frames() > 0 && m_recorder.lastTime() < m_time) {
        m_recorder.commit(*m_world, m_time, FrameKind::Simulated);
    }
    m_outcomes.finish(*m_world);
    m_result.endTime = m_time;
    m_result.fragments = m_outcomes.fragments();
    m_result.stepTimes = m_clock.times();
    m_result.energy = m_energy.balance();
    m_result.ledger = m_ledger.errors();
    measureBirths(m_result.births);
    m_result.islands =
        countLiveIslands(*m_description.fe, *m_description.components, m_activity, m_settings.ground, m_settings.groundHeight);
    m_result.penetrationMax = m_world->contacts().penetrationMax;
    m_result.asleepAtEnd = asleep();
    m_result.stillMoving = present() - std::llround(m_result.asleepAtEnd * static_cast<double>(present()));
    m_result.maxSpeed = m_outcomes.maxSpeed();
    m_result.bulkingFactor = bulking();
    m_result.trajectoryHash = m_recorder.hash();
    warn();
}

SimulationResult Collapse::run() {
    m_sink.begin(m_description);
    m_result.feEndTime = m_result.firstTime = m_time = m_times.back();
    if (!m_description.clustering->list.empty()) {
        m_result.firstTime = m_time = m_times[m_description.clustering->list.front().handOverState];
        for (const Fragment& f : m_description.fragments->list) {
            m_lastBirth = std::max(m_lastBirth, m_times[f.birthState]);
        }
        report(m_time);
        followStructure();
        settle();
    }
    finish();
    m_sink.finish(m_result);
    m_execution.report({"simulation.done", "simulated", {}}, 1.0);
    return std::move(m_result);
}

}  // namespace

SimulationResult simulateIn(const WorldFactory& makeWorld, const RunDescription& description, TrajectorySink& sink,
                            const Execution& execution) {
    return Collapse(makeWorld, description, sink, execution).run();
}

SimulationResult simulate(const RunDescription& description, TrajectorySink& sink, const Execution& execution) {
    const SolverKind solver = description.scenario.simulation.solver;
    return simulateIn([solver](const WorldSettings& settings) { return makeWorld(solver, settings); }, description, sink,
                      execution);
}

}  // namespace rubble
