#include "core/engine/soft/soft_step_world.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "core/base/elapsed.h"
#include "core/engine/soft/contact_wakes.h"
#include "core/engine/world/constants.h"
#include "core/engine/world/scene_rules.h"

namespace rubble {

namespace {

using Clock = std::chrono::steady_clock;

Quat turnedBy(const Quat& q, const Vec3& turn) {
    const Vec3 half = 0.5 * turn;
    return (Quat(1.0, half.x(), half.y(), half.z()) * q).normalized();
}

}  // namespace

SoftStepWorld::SoftStepWorld(const WorldSettings& settings)
    : SceneWorld(settings),
      m_pool(std::max(1, settings.threads)),
      m_surface{settings.ground, settings.groundHeight, settings.terrain},
      m_pairs(settings.bodyContacts, m_pool),
      m_finder(m_surface, settings.gravity, m_solids, m_pairs, m_pool),
      m_contacts(m_pool),
      m_rests(m_solids, m_finder, m_sleep, m_report),
      m_assembly({m_settings, m_solids, m_sleep, m_contacts, m_rests, m_pool}),
      m_results({m_settings, m_solids, m_sleep, m_contacts, m_rests, m_pool}, m_assembly),
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
    takeSlots(dt);
    findContacts(dt);
    takeContacts(dt);
    substeps(dt);
    writeBack(dt);
    settle(dt);
    m_costs.motion += secondsSince(from);
}

BodyMotion SoftStepWorld::motionOf(const Collider& body) const {
    const SoftBody& solid = m_solids.of(body);
    return {throughAxes(solid.pose), solid.velocity, solid.spin};
}

/// What moves in this step gets a slot, a place and a box around its way.
void SoftStepWorld::takeSlots(double dt) {
    m_solids.clearSlots();
    m_solids.listAwake(m_sleep.still());
    m_pool.loop(m_solids.standing.size(), 64, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            setOff(m_solids.pieces[m_solids.standing[i]], dt);
        }
    });
    m_solids.listMoving();
    m_pool.loop(m_solids.awake.size(), 64, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            SoftBody& body = m_solids.bodies[m_solids.awake[i]];
            // Until its first step a body is given out just as it came.
            if (body.collider->newborn) {
                body.pose = throughAxes(body.pose);
            }
            m_finder.place(body);
            m_pairs.sweep(body.collider->number, m_finder.sweep(body, dt));
            body.active = false;
            body.drivers = 0;
            body.collider->overlapping = false;
            body.collider->penetration = body.collider->overlapLeft = 0.0;
        }
    });
}

/// How a piece moves in this step, to where it was told to.
void SoftStepWorld::setOff(SoftBody& piece, double dt) {
    piece.velocity = piece.spin = Vec3::Zero();
    m_finder.stand(piece);
    if (piece.collider->moving) {
        const Pose& end = m_solids.goals[piece.collider->index];
        piece.velocity = (end.position - piece.pose.position) / dt;
        const Quat q = end.orientation * piece.pose.orientation.conjugate();
        piece.spin = (q.w() < 0.0 ? -2.0 : 2.0) / dt * q.vec();
    }
    if (piece.collider->moving || piece.collider->newborn) {
        m_finder.place(piece);
        m_pairs.sweep(piece.collider->number, m_finder.sweep(piece, dt));
    }
}

/// Takes the time of some work from that of motion to what it was for.
template <class Work>
void SoftStepWorld::timed(double& cost, Work work) {
    const auto from = Clock::now();
    work();
    const double seconds = secondsSince(from);
    cost += seconds;
    m_costs.motion -= seconds;
}

void SoftStepWorld::findContacts(double dt) {
    const auto from = Clock::now();
    m_finder.begin();
    std::vector<std::uint32_t> stirring;
    stirring.reserve(m_solids.awake.size() + m_solids.standing.size());
    for (const std::uint32_t i : m_solids.awake) {
        stirring.push_back(m_solids.bodies[i].collider->number);
    }
    for (const std::uint32_t i : m_solids.standing) {
        if (const Collider& piece = *m_solids.pieces[i].collider; piece.moving || piece.newborn) {
            stirring.push_back(piece.number);
        }
    }
    m_pairs.find(stirring);
    const NearPairs& pairs = m_pairs.pairs();
    const double broad = secondsSince(from);
    const double count = static_cast<double>(pairs.structure.size() + pairs.fragments.size());
    if (count > 0.0) {
        m_costs.structureContact += broad * static_cast<double>(pairs.structure.size()) / count;
        m_costs.fragmentContact += broad * static_cast<double>(pairs.fragments.size()) / count;
        m_costs.motion -= broad;
    }
    timed(m_costs.groundContact, [&] { m_finder.collideWithGround(m_solids.awake, dt); });
    timed(m_costs.structureContact, [&] { m_finder.collide(pairs.structure, dt); });
    timed(m_costs.fragmentContact, [&] { m_finder.collide(pairs.fragments, dt); });
    const auto woken = wokenByContacts(m_finder.parts(), m_solids, m_sleep, m_contacts.asleep(), m_pool);
    if (!woken.empty()) {
        findContactsOf(woken, dt);
    }
}

/// Bodies that woke in this step take part in it from its start.
void SoftStepWorld::findContactsOf(const std::vector<std::uint32_t>& woken, double dt) {
    std::vector<std::uint32_t> numbers;
    for (const std::uint32_t i : woken) {
        SoftBody& body = m_solids.bodies[i];
        thaw(*body.collider);
        body.active = false;
        body.drivers = 0;
        numbers.push_back(body.collider->number);
    }
    m_solids.listAwake(m_sleep.still());
    m_solids.listMoving();
    // They were swept as bodies at rest.
    const NearPairs pairs = m_pairs.ofWoken(numbers, m_settings.gravity * dt * dt, m_sleep);
    timed(m_costs.structureContact, [&] { m_finder.collide(pairs.structure, dt); });
    timed(m_costs.fragmentContact, [&] { m_finder.collide(pairs.fragments, dt); });
    timed(m_costs.groundContact, [&] { m_finder.collideWithGround(woken, dt); });
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
    m_assembly.build(m_solver, count, dt);
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

void SoftStepWorld::writeBack(double dt) {
    std::vector<double> lifting(m_solids.awake.size());  // J
    m_pool.loop(m_solids.awake.size(), 128, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            SoftBody& body = m_solids.bodies[m_solids.awake[i]];
            const SolverBody& moved = m_solver.bodies[i];
            body.pose = m_solver.poseOf(i);
            body.velocity = moved.velocity;
            body.spin = moved.spin;
            body.active = moved.active;
            body.supported = m_assembly.supported(i);
            lifting[i] = correct(i, dt) + keepAboveGround(body, dt);
        }
    });
    m_report.overlapWork = std::accumulate(lifting.begin(), lifting.end(), m_report.overlapWork);
    m_pool.loop(m_solids.moving.size(), 128, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            SoftBody& piece = m_solids.pieces[m_solids.moving[i]];
            piece.pose = m_solids.goals[m_solids.moving[i]];
            m_finder.place(piece);
        }
    });
}

/// Moves and turns what lies in others from birth or is jammed in them, without a change of its speed. Returns the work [J] that it
/// took.
double SoftStepWorld::correct(std::size_t slot, double dt) {
    if (!m_corrected) {
        return 0.0;
    }
    SoftBody& body = m_solids.bodies[m_solids.awake[slot]];
    auto [way, turned] = m_solver.correctionOf(slot);
    const double length = way.norm() + turned.norm() * body.collider->radius;
    const double most = correctionReach * m_settings.overlapSpeed * dt;
    if (length > most) {
        way *= most / length;
        turned *= most / length;
    }
    body.pose.position += way;
    body.collider->lifted += way.z();
    body.pose.orientation = turnedBy(body.pose.orientation, turned);
    m_solver.bodies[slot].moved += way;
    m_solver.bodies[slot].turned += turned;
    return m_settings.gravity * way.z() / body.inverseMass;
}

/// Returns the work [J] that it took.
double SoftStepWorld::keepAboveGround(SoftBody& body, double dt) const {
    Collider& collider = *body.collider;
    const double sunk = m_surface.depth(body.pose.position);
    collider.bornBelow = sunk > 0.0 && (collider.bornBelow || collider.newborn);
    if (sunk <= 0.0) {
        return 0.0;
    }
    const GroundRise rise = riseAboveGround(m_surface, body.pose.position, collider.bornBelow, dt);
    body.pose.position += rise.share * rise.way;
    body.velocity -= std::min(0.0, body.velocity.dot(rise.normal)) * rise.normal;
    return m_settings.gravity * rise.share * rise.way.z() / body.inverseMass;
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
