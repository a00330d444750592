#include "core/engine/soft/soft_step_world.h"

#include <algorithm>
#include <atomic>

#include "core/base/elapsed.h"
#include "core/engine/world/constants.h"

namespace rubble {

namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

SoftStepWorld::SoftStepWorld(const WorldSettings& settings)
    : SceneWorld(settings),
      m_pool(std::max(1, settings.threads)),
      m_surface{settings.ground, settings.groundHeight, settings.terrain},
      m_pairs(settings.bodyContacts, m_pool),
      m_finder(m_surface, settings.gravity, settings.steadyPatches, m_solids, m_pairs, m_pool),
      m_contacts(m_pool, settings.steadyPatches),
      m_search({m_settings, m_solids, m_sleep, m_pairs, m_finder, m_contacts, m_pool}),
      m_rests(m_solids, m_finder, m_sleep, m_report),
      m_assembly(assembledScene()),
      m_results(assembledScene(), m_assembly),
      m_bodyResults(assembledScene(), m_assembly, m_surface, m_finder),
      m_solver(m_pool) {
    m_finder.ground().material = settings.groundMaterial;
}

void SoftStepWorld::bodyEntered(Collider& collider, const NewBody& body) {
    SoftBody& solid = m_solids.add(collider, body.pose);
    solid.velocity = body.velocity;
    solid.spin = body.angularVelocity;
    m_finder.enter(collider);
}

void SoftStepWorld::pieceEntered(Collider& collider, const Pose& pose) {
    m_solids.add(collider, pose);
    m_finder.enter(collider);
}

void SoftStepWorld::movePiece(PieceId piece, const Pose& atStepEnd) {
    m_solids.goals[at(piece)] = throughAxes(atStepEnd);
    pieceAt(piece).moving = true;
}

void SoftStepWorld::onThreads(std::size_t count, std::size_t grain,
                              const std::function<void(std::size_t, std::size_t)>& work) const {
    m_pool.loop(count, grain, work);
}

void SoftStepWorld::left(Collider& collider) {
    m_solids.of(collider).collider = nullptr;
    m_finder.forget(collider);
}

namespace {

/// Calls visit(a, b) with a contact's ends if they touch.
template <class Visit>
auto ifTouching(Visit visit) {
    return [visit](const SoftContact& c) {
        if (c.depth >= -contactMargin) {
            visit(*c.a, *c.b);
        }
    };
}

}  // namespace

/// Calls visit(a, b) for every pair that touches, some more than once.
template <class Visit>
void SoftStepWorld::forEachTouching(Visit visit) const {
    m_contacts.forEach(ifTouching(visit));
    m_contacts.asleep().forEachPair(ifTouching(visit));
}

/// The same of those that what just thawed is one of, and perhaps of others.
template <class Visit>
void SoftStepWorld::forEachTouchingThawed(Visit visit) const {
    m_contacts.forEach(ifTouching(visit));
    for (const Collider* body : m_sleep.justThawed()) {
        m_contacts.asleep().forEachPairOf(body->number, ifTouching(visit));
    }
}

void SoftStepWorld::aboutToLeave() {
    for (Collider* sleeper : m_sleep.neighboursOfLeaving([this](auto visit) { forEachTouching(visit); })) {
        thaw(*sleeper);
    }
    m_sleep.linkDependants([this](auto visit) { forEachTouchingThawed(visit); });
    m_contacts.dropLeaving();
}

void SoftStepWorld::thaw(Collider& body) {
    m_sleep.thaw(body, m_solids.of(body).pose.position);
}

void SoftStepWorld::freeze(Collider& body) {
    m_sleep.freeze(body);
    SoftBody& solid = m_solids.of(body);
    solid.velocity = solid.spin = Vec3::Zero();
    m_finder.place(solid);
    m_pairs.rest(body.number, m_finder.sweep(solid, 0.0));
}

void SoftStepWorld::advance(double dt) {
    const auto from = Clock::now();
    m_search.setOff(dt);
    m_search.find(dt, m_costs);
    takeContacts(dt);
    substeps(dt);
    m_bodyResults.take(m_solver, m_corrected, dt, m_report);
    settle(dt);
    m_costs.motion += secondsSince(from);
}

BodyMotion SoftStepWorld::motionOf(const Collider& body) const {
    const SoftBody& solid = m_solids.of(body);
    return {throughAxes(solid.pose), solid.velocity, solid.spin};
}

void SoftStepWorld::takeContacts(double dt) {
    const auto from = Clock::now();
    const std::vector<Found> found = m_finder.inOrder();
    m_assembly.begin(found.size());
    m_contacts.take(found, [&](std::size_t first, std::size_t last) {
        m_rests.find({&m_contacts[first], last - first}, dt);
        for (std::size_t i = first; i < last; ++i) {
            m_assembly.take(i);
        }
    });
    m_takingSeconds = secondsSince(from);
}

void SoftStepWorld::substeps(double dt) {
    const auto from = Clock::now();
    const int count = m_assembly.substepsFor(dt);
    const double h = dt / count;
    m_assembly.build(m_solver, count, dt, m_time);
    if (m_hook) {
        m_hooked.prepare(m_solids, m_solver, m_pool);
    }
    double hook = 0.0;
    double motion = 0.0;
    for (int substep = 0; substep < count; ++substep) {
        if (m_hook) {
            const auto start = Clock::now();
            m_hooked.run(m_hook, m_solids, m_solver, m_pool, h);
            hook += secondsSince(start);
        }
        m_solver.applyGravity(m_settings.gravity * h);
        m_solver.solveSoft(pushOutSpeed);
        const auto moving = Clock::now();
        m_report.speedLimits += m_solver.move(m_settings.gravity);
        motion += secondsSince(moving);
        m_solver.relax();
        m_solver.accumulateWork();
    }
    m_corrected = m_solver.correctPositions();
    m_solver.end();
    m_solver.restitute(restitutionThreshold, m_settings.bounceFriction);
    std::atomic<std::int64_t> held = 0;
    m_pool.loop(m_solids.awake.size(), 512, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            if (SpeedBound::holdBack(m_solver.bodies[i])) {
                held.fetch_add(1, std::memory_order_relaxed);
            }
        }
    });
    m_report.speedLimits += held;
    m_assembly.end();
    m_results.take(m_solver, m_corrected, m_report);
    m_costs.substepHook += hook;
    m_costs.motion -= hook;
    shareSolveTime(m_takingSeconds + secondsSince(from) - hook - motion);
}

void SoftStepWorld::shareSolveTime(double seconds) {
    const double all = m_assembly.points();
    if (all > 0.0) {
        m_costs.groundContact += seconds * m_assembly.points(ContactKind::Ground) / all;
        m_costs.structureContact += seconds * m_assembly.points(ContactKind::Structure) / all;
        m_costs.fragmentContact += seconds * m_assembly.points(ContactKind::Fragments) / all;
        m_costs.motion -= seconds;
    }
}

/// Freezes what came to rest and thaws what lost its support.
void SoftStepWorld::settle(double dt) {
    for (const std::uint32_t body : m_results.unloaded()) {
        if (m_sleep.frozen(bodyAt(idAt<BodyId>(body)))) {
            thaw(*m_bodies[body]);
        }
    }
    enum : char { GoesOn = 0, Freezes = 1, Watched = 2 };
    std::vector<char> next(m_solids.awake.size());
    m_pool.loop(next.size(), 256, [&](std::size_t first, std::size_t last) {
        for (std::size_t slot = first; slot < last; ++slot) {
            const std::uint32_t i = m_solids.awake[slot];
            const SoftBody& solid = m_solids.bodies[i];
            Collider& body = *solid.collider;
            // What a body does by position only, as overlap comes apart, is motion too.
            const SolverBody& way = m_solver.bodies[slot];
            const double moved = (way.moved.norm() + way.turned.norm() * body.radius) / dt;
            const double share = body.penetration > restingDepth * body.smallestSide ? 1.0 : settlingShare;
            const double speed = std::max(solid.speed(), share * moved);
            const bool freezes = m_sleep.clock().quiet(i, speed, dt) && solid.active && m_settings.freeze;
            next[slot] = static_cast<char>((freezes ? Freezes : GoesOn) | (m_sleep.clock().watched(i) ? Watched : GoesOn));
            body.newborn = false;
        }
    });
    std::vector<char> froze(m_bodies.size(), 0);
    for (std::size_t slot = 0; slot < next.size(); ++slot) {
        const std::uint32_t i = m_solids.awake[slot];
        if ((next[slot] & Freezes) != 0) {
            freeze(*m_bodies[i]);
            froze[i] = 1;
        }
        if ((next[slot] & Watched) != 0) {
            for (const std::uint32_t woken : m_sleep.wokenBy(*m_bodies[i], m_solids.bodies[i].pose.position)) {
                thaw(*m_bodies[woken]);
            }
        }
    }
    m_sleep.linkDependants([this](auto visit) { forEachTouchingThawed(visit); });
    m_contacts.putAside(m_sleep, froze);
}

bool SoftStepWorld::keep(Archive& archive) {
    keepScene(archive);
    m_assembly.keep(archive);
    m_solids.keep(archive, m_bodies, m_pieces);
    for (const auto* list : {&m_bodies, &m_pieces}) {
        for (const auto& collider : *list) {
            const SoftBody& solid = m_solids.of(*collider);
            if (solid.collider == nullptr) {
                continue;
            }
            if (archive.reading()) {
                m_finder.enter(*collider);
                if (!collider->newborn) {
                    m_finder.place(solid);
                }
            }
            m_pairs.keep(archive, *collider);
        }
    }
    m_contacts.keep(archive, [this](std::uint32_t number) {
        return number == m_finder.ground().number ? &m_finder.ground() : m_pairs.colliderNumbered(number);
    });
    return true;
}

}  // namespace rubble
