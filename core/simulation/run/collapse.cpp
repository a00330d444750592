#include "core/simulation/run/collapse.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/same_bits.h"
#include "core/engine/world/constants.h"
#include "core/fe/site_surface.h"
#include "core/fragments/birth_windows.h"
#include "core/simulation/effects/held_islands.h"
#include "core/simulation/effects/stopwatch.h"
#include "core/simulation/run/motion_findings.h"
#include "core/simulation/run/step_rate.h"
#include "core/simulation/run/terrain_ends.h"

namespace rubble {

namespace {

/// Share of the bodies that must sleep for a run to end before its time.
constexpr double asleepShare = 0.99;

EffectScene sceneOf(const RunDescription& d) {
    return {*d.fe, *d.components, *d.fragments, *d.clustering, d.terrain.get(), d.scenario};
}

RunDescription settled(const RunDescription& description) {
    RunDescription settled = description;
    settled.scenario = settledScenario(sceneOf(description));
    return settled;
}

WorldSettings worldSettings(const RunDescription& description, const EffectDecisions& decisions, const Execution& execution) {
    const SimulationSettings& s = description.scenario.simulation;
    WorldSettings world;
    world.gravity = s.gravity;
    world.groundHeight = s.groundHeight;
    setUpWorld(decisions, description, world);
    for (const Component& component : description.components->list) {
        if (!component.bounds.isEmpty() && component.bounds.sizes().allFinite()) {
            world.reach.extend(component.bounds);
        }
    }
    world.pairs = actingPairs(description.scenario);
    world.iterations = s.iterations;
    world.substeps = substepsOf(description.scenario);
    world.threads = execution.threads();
    world.freeze = s.freeze;
    world.freezeSpeed = s.freezeSpeed;
    world.freezeDelay = s.freezeDelay;
    world.overlapSpeed = s.overlapSpeed;
    world.overlapTime = overlapTimeOf(description.scenario);
    world.bounceFriction = s.bounceFriction;
    world.partsJammed = description.scenario.effects.loose != LooseStructurePolicy::Fe;
    world.splitsMass = world.partsJammed;
    world.overlapTimeFromEntry = world.partsJammed;
    world.steadyPatches = world.partsJammed;
    world.cancelled = [execution] { return execution.cancelled(); };
    return world;
}

HealthSite healthSite(const RunDescription& description, const EffectDecisions& decisions, const WorldSettings& world) {
    HealthSite site{world.gravity, {world.ground, world.groundHeight, world.terrain}, world.reach, std::nullopt, 0.0};
    site.settings = healthSettings(description.scenario.simulation);
    const EffectSettings& effects = description.scenario.effects;
    if (isOn(decisions, EffectKind::Water)) {
        site.waterLevel = effects.waterLevel;
        site.current = lengthOf(effects.currentX, effects.currentY);
    }
    return site;
}

}  // namespace

Collapse::Collapse(const WorldFactory& makeWorld, const RunDescription& description, TrajectorySink& sink,
                   const Execution& execution, CheckpointStore* checkpoints)
    : m_asked(description),
      m_description(settled(description)),
      m_settings(description.scenario.simulation),
      m_times(description.fe->times()),
      m_sink(sink),
      m_execution(execution),
      m_activity(simulatedActivity(*description.fe, description.scenario.fragments)),
      m_decisions(decideEffects(sceneOf(m_description))),
      m_stepRate(chosenStepRate(m_description, m_decisions)),
      m_worldSettings(worldSettings(m_description, m_decisions, execution)),
      m_surface{m_worldSettings.ground, m_worldSettings.groundHeight, m_worldSettings.terrain},
      m_world(makeWorld(m_worldSettings)),
      m_structure(m_description, m_activity, isOn(m_decisions, EffectKind::StructureContact)),
      m_effects(m_decisions, m_description, *m_world),
      m_islands(m_description, m_activity, m_surface),
      m_carried(m_description, m_activity, m_surface),
      m_recorder(sink, m_settings.frameRate),
      m_energy(m_settings.gravity),
      m_ledger(m_description),
      m_outcomes(m_description, m_settings.gravity),
      m_health(healthSite(m_description, m_decisions, m_worldSettings)),
      m_checkpoints(checkpoints) {
    m_islands.leaveOut([this](ElementIndex e) { return m_carried.carries(e); });
    if (const std::optional<Finding> finding = notHeld(m_description.scenario)) {
        m_result.findings.add(finding->what, finding->remedy);
    }
}

void Collapse::report(double time) const {
    const double from = m_result.firstTime;
    const double to = m_result.feEndTime + m_settings.settleTime;
    m_execution.report({std::string(simulatingStage), "simulating, {0} bodies at {1}", {present(), Argument(time, "s")}},
                       std::clamp((time - from) / std::max(to - from, 1e-9), 0.0, 0.999));
}

void Collapse::updateEnergy() {
    m_energy.update(m_outcomes.kineticEnergy(), m_outcomes.massHeight(), m_world->contacts(), m_effects.work());
}

void Collapse::removeEnded(double time) {
    for (std::size_t i = 0; i < m_records.size(); ++i) {
        const BodyId id = idAt<BodyId>(i);
        // Islands leave once what is left of them is there.
        if (!m_records[i].isIsland() && m_records[i].to <= time && m_world->state(id) != BodyState::Removed) {
            m_energy.leaving(m_world->momenta(id), m_world->motion(id).pose.position.z());
            m_effects.leaving(id);
            m_world->removeBody(id);
            ++m_removed;
        }
    }
}

void Collapse::enter(const HandOver& entered) {
    m_outcomes.entered(entered, *m_world);
    for (const BodyRecord& body : entered.bodies) {
        m_records.push_back(body);
        m_energy.entered(m_world->momenta(body.body), m_world->motion(body.body).pose.position.z());
    }
    if (!entered.bodies.empty()) {
        m_effects.entered(entered.bodies);
        m_sink.addBodies(entered.bodies, entered.carriers);
    }
}

/// What was born from islands; the row is of what the FE result handed over.
HandOver Collapse::handOverAt(std::size_t k, LedgerRow& row) {
    const auto& clusters = m_description.clustering->list;
    std::size_t end = m_nextCluster;
    while (end < clusters.size() && clusters[end].handOverState == k) {
        ++end;
    }
    Births births = handOver(m_description, m_nextCluster, end, m_carried, *m_world, m_result.findings);
    m_nextCluster = end;
    row = m_ledger.handedOver(k, m_times[k], births.fromFe, *m_world);
    enter(births.fromFe);
    enter(births.fromIslands);
    m_result.bodiesPeak = std::max(m_result.bodiesPeak, present());
    return std::move(births.fromIslands);
}

void Collapse::releaseIslands() {
    const Islands::Release release = m_islands.release(*m_world, m_structure.pieces(), m_result.findings);
    if (release.bodies.empty()) {
        return;
    }
    enter({release.bodies, {}, {}});
    m_sink.addIslands(release.islands, release.ledger);
}

void Collapse::carryIslands(std::size_t k, const HandOver& born) {
    const CarriedIslands::Change change =
        m_carried.atState(k, born, *m_world, m_structure.pieces(), m_execution, m_result.findings);
    for (const BodyId id : change.ended) {
        m_energy.leaving(m_world->momenta(id), m_world->motion(id).pose.position.z());
        m_effects.leaving(id);
        m_world->removeBody(id);
    }
    if (!change.bodies.empty()) {
        enter({change.bodies, {}, {}});
        m_sink.addIslands(change.islands, change.ledger);
    }
    if (change.loss) {
        m_sink.addIslandLoss(*change.loss);
    }
}

void Collapse::atState(std::size_t k) {
    LedgerRow row;
    {
        const Stopwatch watch(m_seconds.births);
        removeEnded(m_times[k]);
        const HandOver fromIslands = handOverAt(k, row);
        carryIslands(k, fromIslands);
        if (k + 1 == m_times.size()) {
            releaseIslands();
        }
    }
    record(FrameKind::Fe);
    addLedgerRow(row);
}

void Collapse::record(FrameKind kind) {
    const Stopwatch watch(m_seconds.recording);
    m_recorder.commit(*m_world, m_time, kind);
    m_result.awakePeak = std::max(m_result.awakePeak, awake());
}

void Collapse::addLedgerRow(LedgerRow row) {
    const Stopwatch watch(m_seconds.births);
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

void Collapse::advance(double dt, double time, const std::function<void(double)>& movePieces) {
    const Stopwatch watch(m_seconds.steps);
    // What the monitor says depends on the bodies alone, so that a run with remedies repeats bit by bit.
    const bool halved = m_settings.autoRemedy && m_health.unwell(m_time);
    if (halved) {
        m_health.remedied(time - dt, time);
    }
    const int parts = (halved ? 2 : 1) * partsOfStep(fastestRound(), dt);
    for (int i = 1; i <= parts; ++i) {
        movePieces(static_cast<double>(i) / parts);
        step(dt / parts, time - dt * static_cast<double>(parts - i) / parts);
    }
}

double Collapse::fastestRound() const {
    double fastest = 0.0;
    if (m_description.fe->contents().looseBodies) {
        const std::vector<TrackedBody>& bodies = m_outcomes.bodies();
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (bodies[i].carriers > facesOfBoxes && m_world->state(idAt<BodyId>(i)) == BodyState::Awake) {
                fastest = std::max(fastest, bodies[i].latest.angularVelocity.norm());
            }
        }
    }
    return fastest;
}

void Collapse::removeLost(double time) {
    for (const BodyId id : m_outcomes.lost()) {
        const TrackedBody& body = m_outcomes.bodies()[at(id)];
        m_energy.leaving({body.mass, Vec3::Zero(), Vec3::Zero(), body.kinetic}, body.latest.pose.position.z());
        m_effects.leaving(id);
        m_world->removeBody(id);
        m_recorder.hold(id, body.latest);
        m_health.lost(id, body.latest.pose.position, time);
        m_records[at(id)].to = time;
        m_removed += !m_records[at(id)].isIsland();
    }
}

void Collapse::keepWatch(double time) {
    const bool stirred = m_structure.pieces().moving() > 0 || !m_outcomes.lost().empty();
    m_health.stepped(*m_world, m_outcomes.bodies(), {time, m_energy.gain(), stirred});
    if (const std::vector<HealthBreach> news = m_health.news(time); !news.empty()) {
        m_sink.addBreaches(news);
    }
}

void Collapse::step(double dt, double time) {
    const auto from = std::chrono::steady_clock::now();
    m_world->step(dt);
    m_execution.check();
    m_time = time;
    {
        const Stopwatch watch(m_seconds.bookkeeping);
        m_outcomes.stepped(*m_world, time, dt);
        removeLost(time);
        updateEnergy();
    }
    {
        const Stopwatch watch(m_seconds.health);
        keepWatch(time);
    }
    m_effects.stepped(dt);
    breakUp(dt, time);
    const Stopwatch watch(m_seconds.bookkeeping);
    if (m_clockRuns) {
        m_clock.add(from, dt);
    }
    ++m_result.steps;
    report(time);
}

void Collapse::breakUp(double dt, double time) {
    for (const BodyRecord& whole : m_effects.brokenUp(dt, m_description.scenario.grid.bodiesMax - present())) {
        const Stopwatch watch(m_seconds.replacing);
        replace(whole, time);
    }
}

void Collapse::replace(const BodyRecord& whole, double time) {
    const BodyMotion motion = m_world->motion(whole.body);
    const TrackedBody& tracked = m_outcomes.bodies()[at(whole.body)];
    const std::span<const Carrier> carried(m_outcomes.carriers().data() + tracked.firstCarrier, tracked.carriers);
    const auto freed = freeFragments(m_description, whole, carried, motion);
    m_effects.replaced(freed.has_value());
    if (!freed) {
        return;
    }
    double kinetic = m_world->kineticEnergy(whole.body);
    double massHeight = whole.mass * motion.pose.position.z();
    m_effects.leaving(whole.body);
    m_world->removeBody(whole.body);
    m_records[at(whole.body)].to = time;
    ++m_removed;
    HandOver parts;
    for (const FreedFragment& part : *freed) {
        const BodyId body = m_world->addBody(part.body);
        parts.bodies.push_back({body, whole.cluster, time, whole.to, part.body.mass, part.body.pose, part.toBody.inverse(), false});
        parts.carriers.push_back({part.fragment, body, time, whole.to, part.toBody});
        kinetic -= m_world->kineticEnergy(body);
        massHeight -= part.body.mass * part.body.pose.position.z();
    }
    m_energy.replaced(kinetic, massHeight);
    m_records.insert(m_records.end(), parts.bodies.begin(), parts.bodies.end());
    m_outcomes.entered(parts, *m_world);
    m_effects.entered(parts.bodies);
    m_sink.addBodies(parts.bodies, parts.carriers);
    m_result.bodiesPeak = std::max(m_result.bodiesPeak, present());
}

void Collapse::followStructure() {
    for (; m_place.state + 1 < m_times.size(); ++m_place.state, m_place.steps = 0) {
        const std::size_t k = m_place.state;
        if (m_place.steps == 0) {
            atState(k);
            const Stopwatch watch(m_seconds.steps);
            m_structure.beginInterval(*m_world, k);
        }
        const double span = m_times[k + 1] - m_times[k];
        const auto steps = static_cast<std::int64_t>(std::max(1.0, std::ceil(span * m_stepRate.perSecond - 1e-6)));
        const double dt = span / static_cast<double>(steps);
        while (m_place.steps < steps) {
            const std::int64_t i = ++m_place.steps;
            advance(dt, i == steps ? m_times[k + 1] : m_times[k] + static_cast<double>(i) * dt, [&](double part) {
                m_structure.moveTo(*m_world, (static_cast<double>(i - 1) + part) / static_cast<double>(steps));
            });
            if (i < steps && m_recorder.due(m_time)) {
                record(FrameKind::Simulated);
            }
            keepCheckpoint();
        }
        if (m_clockRuns && m_times[k + 1] >= m_lastBirth - 1e-9) {
            m_clock.stop();
            m_clockRuns = false;
        }
    }
    atState(m_times.size() - 1);
}

std::int64_t Collapse::awake() const {
    std::int64_t awake = 0;
    for (const BodyRecord& record : m_records) {
        awake += !record.isIsland() && m_world->state(record.body) == BodyState::Awake;
    }
    return awake;
}

double Collapse::asleep() const {
    const std::int64_t bodies = present();
    return bodies > 0 ? static_cast<double>(bodies - awake()) / static_cast<double>(bodies) : 1.0;
}

void Collapse::settle() {
    const auto steps = static_cast<std::int64_t>(std::ceil(m_settings.settleTime * m_stepRate.settling - 1e-6));
    const double from = m_times.back();
    if (!m_place.settling) {
        m_place = {true, m_times.size() - 1, 0, from + 1.0};
        m_structure.hold();
    }
    const auto atRest = [this] { return asleep() >= asleepShare && m_islands.atRest(*m_world) && m_carried.atRest(*m_world); };
    while (!atRest() && m_place.steps < steps) {
        const std::int64_t i = ++m_place.steps;
        const double dt = m_settings.settleTime / static_cast<double>(steps);
        const bool falling = stillFalling(*m_world, present());
        const int parts = falling ? static_cast<int>(std::ceil(m_stepRate.perSecond / m_stepRate.settling - 1e-9)) : 1;
        m_world->setSubsteps(falling ? substepsOf(m_description.scenario) : settlingSubstepsOf(m_description.scenario));
        for (int part = 1; part <= parts; ++part) {
            advance(dt / parts, from + (static_cast<double>(i - 1) + static_cast<double>(part) / parts) * dt, [](double) {});
        }
        if (m_recorder.due(m_time)) {
            record(FrameKind::Simulated);
        }
        if (m_time >= m_place.nextRow - 1e-9) {
            LedgerRow row;
            row.time = m_time;
            row.state = static_cast<std::uint32_t>(m_times.size() - 1);
            addLedgerRow(row);
            m_place.nextRow += 1.0;
        }
        keepCheckpoint();
    }
}

void Collapse::measureBirths(OccupiedBirths& births) const {
    std::vector<double> depths;
    for (const BodyRecord& record : m_records) {
        if (!bornHere(record)) {
            continue;
        }
        ++births.births;
        births.left += m_world->overlapLeft(record.body) > occupiedShare * m_world->smallestSide(record.body);
        const double depth = m_world->birthDepth(record.body);
        if (depth > occupiedShare) {
            depths.push_back(depth);
            births.joined += m_world->birthDepthApart(record.body) <= occupiedShare;
        }
    }
    const ContactReport& contacts = m_world->contacts();
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

PileMeasure Collapse::pile() const {
    std::vector<DebrisBox> debris;
    for (const Carrier& carrier : m_outcomes.carriers()) {
        if (m_world->state(carrier.body) == BodyState::Removed) {
            continue;
        }
        const Fragment& fragment = m_description.fragments->list[at(carrier.fragment)];
        const Pose now = m_world->motion(carrier.body).pose;
        OrientedBox box = fragment.box;
        box.centre = now * (carrier.handOverToBody * box.centre);
        box.orientation = now.orientation * carrier.handOverToBody.orientation * box.orientation;
        debris.push_back({box, m_description.components->volume[at(fragment.element)]});
    }
    const Mesh& mesh = m_description.fe->mesh();
    const auto last = m_description.fe->state(m_times.size() - 1);
    std::vector<Aabb> structure = m_islands.outlines(*m_world);
    std::ranges::copy(m_carried.outlines(*m_world), std::back_inserter(structure));
    for (std::size_t i = 0; i < mesh.elementCount(); ++i) {
        const ElementIndex e = idAt<ElementIndex>(i);
        if (m_activity.active(m_times.size() - 1, e) && !m_islands.released(e) && !m_carried.carries(e)) {
            Aabb box;
            for (const std::uint32_t node : mesh.cornersOf(e)) {
                box.extend(last->positions[node]);
            }
            structure.push_back(box);
        }
    }
    return measurePile(debris, structure, m_surface);
}

void Collapse::warnOfTerrain() {
    if (!m_surface.terrain) {
        return;
    }
    std::vector<Vec3> places;
    for (const FragmentOutcome& fragment : m_result.fragments) {
        places.push_back(fragment.finalPosition);
    }
    for (const BodyRecord& record : m_records) {
        if (record.isIsland()) {
            places.push_back(m_outcomes.bodies()[at(record.body)].latest.pose.position);
        }
    }
    const auto nameOf = [this](std::size_t piece) -> std::string {
        const auto& fragments = m_description.fragments->list;
        if (piece >= fragments.size()) {
            return "loose structure";
        }
        return "element " + englishInteger(m_description.fe->mesh().elementIds[at(fragments[piece].element)]);
    };
    addTerrainEnds(*m_surface.terrain, places, nameOf, m_result.findings);
    const EffectSettings& effects = m_description.scenario.effects;
    if (effects.waterLevel && !isOn(m_decisions, EffectKind::Water) && effects.of(EffectKind::Water) == EffectSwitch::Auto) {
        addWaterMissed(*effects.waterLevel, places, nameOf, m_result.findings);
    }
}

void Collapse::warn() {
    m_result.findings.append(m_result.checkpoints.findings);
    m_health.addFindings(m_result.findings);
    warnOfTerrain();
    addTerrainRoughness(m_surface.terrain.get(), m_description.scenario.effects, m_result.findings);
    addMotionFindings({m_effects.heldTogether(), m_world->contacts().speedLimits, m_result.steps, m_result.bodiesPeak,
                       m_result.stillMoving, m_result.asleepAtEnd >= asleepShare, m_result.endTime},
                      m_result.findings);
}

void Collapse::reportCosts() {
    const StepCosts& world = m_world->costs();
    const double contact = world.groundContact + world.structureContact + world.fragmentContact;
    const double effects = m_effects.secondsInSubsteps();
    const double hook = std::max(world.substepHook, effects);
    const double perStep = 1000.0 / static_cast<double>(std::max<std::int64_t>(m_result.steps, 1));
    StepTimes& times = m_result.stepTimes;
    times.allMs = perStep * m_seconds.steps;
    times.motionMs = perStep * (world.total - contact - hook);
    times.hookMs = perStep * (hook - effects);
    times.bookkeepingMs = perStep * m_seconds.bookkeeping;
    times.healthMs = perStep * m_seconds.health;
    times.recordingMs = perStep * m_seconds.recording;
    times.birthsMs = perStep * m_seconds.births;
    m_result.effects =
        m_effects.reports(m_decisions, {m_result.steps, m_seconds.steps, m_structure.seconds(), m_seconds.replacing});
}

void Collapse::finish() {
    if (m_recorder.frames() > 0 && m_recorder.lastTime() < m_time) {
        record(FrameKind::Simulated);
    }
    m_outcomes.finish(*m_world);
    m_result.endTime = m_time;
    m_result.stepRate = m_stepRate.perSecond;
    m_result.stepRateReason = m_stepRate.reason;
    m_result.substeps = substepsOf(m_description.scenario);
    m_result.fragments = m_outcomes.fragments();
    m_result.stepTimes = m_clock.times();
    reportCosts();
    m_result.energy = m_energy.balance();
    m_result.ledger = m_ledger.errors();
    measureBirths(m_result.births);
    m_result.islands = m_islands.outcome(*m_world, m_result.findings);
    m_result.carried = m_carried.outcome(*m_world);
    m_result.penetrationMax = m_world->contacts().penetrationMax;
    m_result.asleepAtEnd = asleep();
    m_result.stillMoving = awake();
    m_result.maxSpeed = m_outcomes.maxSpeed();
    const PileMeasure debris = pile();
    m_result.bulkingFactor = debris.bulking;
    m_health.pile(debris.bulking, debris.layers, m_time);
    m_result.health = m_health.report();
    m_result.trajectoryHash = m_recorder.hash();
    warn();
}

SimulationResult Collapse::run() {
    const auto& clusters = m_description.clustering->list;
    const bool resumed = m_result.checkpoints.resumedAt.has_value();
    m_result.feEndTime = m_result.firstTime = m_times.back();
    for (const Fragment& f : m_description.fragments->list) {
        m_lastBirth = std::max(m_lastBirth, m_times[f.birthState]);
    }
    if (!clusters.empty()) {
        m_result.firstTime = m_times[clusters.front().handOverState];
    }
    if (!resumed) {
        m_sink.begin(m_asked);
        m_time = m_result.firstTime;
        m_place.state = clusters.empty() ? m_times.size() - 1 : clusters.front().handOverState;
        m_clockRuns = !clusters.empty();
        if (m_clockRuns) {
            m_clock.start();
        }
    }
    if (!clusters.empty()) {
        report(m_time);
        if (!m_place.settling) {
            followStructure();
        }
        settle();
    } else if (m_islands.toRelease()) {
        if (!m_place.settling) {
            m_structure.pieces().standAt(*m_world, m_times.size() - 1);
            atState(m_times.size() - 1);
        }
        settle();
    }
    finish();
    m_sink.finish(m_result);
    m_execution.report({"simulation.done", "simulated", {}}, 1.0);
    return std::move(m_result);
}

}  // namespace rubble
