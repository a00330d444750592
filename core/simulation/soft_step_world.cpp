#include "core/simulation/soft_step_world.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "core/base/elapsed.h"
#include "core/simulation/constants.h"

namespace rubble {

namespace {

using Clock = std::chrono::steady_clock;

Quat turnedBy(const Quat& q, const Vec3& spin, double time) {
    const Vec3 half = 0.5 * time * spin;
    const Quat turn = Quat(1.0, half.x(), half.y(), half.z()) * q;
    return turn.normalized();
}

}  // namespace

SoftStepWorld::SoftStepWorld(btDispatcher* dispatcher, btBroadphaseInterface* broadphase, btConstraintSolver* solver,
                             btCollisionConfiguration* configuration, const WorldSettings& settings, StepCosts& costs)
    : btDiscreteDynamicsWorld(dispatcher, broadphase, solver, configuration),
      m_settings(settings),
      m_costs(costs),
      m_pool(std::max(1, settings.threads)),
      m_surface{settings.ground, settings.groundHeight, settings.terrain},
      m_freeze(settings.freezeSpeed, settings.freezeDelay),
      m_solver(m_pool) {
    m_ground.kind = ColliderKind::Ground;
    m_ground.number = 0;
    m_ground.newborn = false;
    m_ground.material = settings.groundMaterial;
    m_ground.pairs = &m_settings.pairs;
}

void SoftStepWorld::addBody(Collider* body) {
    Solid solid;
    solid.collider = body;
    solid.pose = fromBullet(body->object->getWorldTransform());
    solid.velocity = fromBullet(body->object->getLinearVelocity());
    solid.spin = fromBullet(body->object->getAngularVelocity());
    solid.inertia = fromBullet(body->object->getInvInertiaDiagLocal()).cwiseInverse();
    solid.inverseMass = body->object->getInvMass();
    m_bodies.push_back(std::move(solid));
    enter(*body);
    m_freeze.addBody();
    m_still.push_back(0);
}

void SoftStepWorld::addPiece(Collider* piece) {
    Solid solid;
    solid.collider = piece;
    solid.pose = fromBullet(piece->object->getWorldTransform());
    m_standing.push_back(static_cast<std::uint32_t>(m_pieces.size()));
    m_pieces.push_back(std::move(solid));
    enter(*piece);
}

void SoftStepWorld::enter(Collider& collider) {
    m_entries.resize(std::max<std::size_t>(m_entries.size(), collider.number + 1));
    m_paces.resize(m_entries.size());
    BroadPhaseEntry& entered = m_entries[collider.number];
    entered.collider = &collider;
    entered.kind = collider.kind;
    entered.hull = std::ranges::any_of(collider.parts, [](const ConvexPart& p) { return !p.points.empty(); });
    entered.part = static_cast<std::uint32_t>(m_placed.size());
    m_placed.resize(m_placed.size() + collider.parts.size());
}

void SoftStepWorld::forget(Collider& collider) {
    Solid& solid = solidOf(collider);
    solid.collider = nullptr;
    m_entries[collider.number].collider = nullptr;
    if (collider.kind == ColliderKind::Body) {
        m_still[collider.index] = 1;
    }
    m_boxes.remove(collider.number);
    solid.hulls.clear();
}

void SoftStepWorld::internalSingleStepSimulation(btScalar dt) {
    const auto from = Clock::now();
    takeSlots(dt);
    collideAll(dt);
    substeps(dt);
    writeBack(dt);
    settle(dt);
    const double rest = secondsSince(from);
    m_costs.motion += rest;
}

void SoftStepWorld::takeSlots(double dt) {
    for (const std::uint32_t i : m_awake) {
        m_bodies[i].slot = -1;
    }
    listAwake();
    listMoving(dt);
    m_stillSlot = static_cast<std::uint32_t>(m_awake.size() + m_moving.size());
    m_pool.loop(m_awake.size(), 64, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            Solid& body = m_bodies[m_awake[i]];
            place(body);
            sweep(body, dt);
            body.active = false;
            body.drivers = 0;
            body.collider->overlapping = false;
            body.collider->penetration = body.collider->overlapLeft = 0.0;
        }
    });
}

/// Pieces that move in this step, in the order of entry, and how; places and sweeps those and the new ones.
void SoftStepWorld::listMoving(double dt) {
    std::erase_if(m_standing, [&](std::uint32_t i) { return m_pieces[i].collider == nullptr; });
    m_pool.loop(m_standing.size(), 64, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            Solid& piece = m_pieces[m_standing[i]];
            piece.slot = -1;
            piece.velocity = piece.spin = Vec3::Zero();
            m_paces[piece.collider->number] = {};
            if (piece.collider->moving) {
                const Pose end = fromBullet(piece.collider->object->getWorldTransform());
                piece.velocity = (end.position - piece.pose.position) / dt;
                const Quat q = end.orientation * piece.pose.orientation.conjugate();
                piece.spin = (q.w() < 0.0 ? -2.0 : 2.0) / dt * q.vec();
            }
            if (piece.collider->moving || piece.collider->newborn) {
                place(piece);
                sweep(piece, dt);
            }
        }
    });
    m_moving.clear();
    for (const std::uint32_t i : m_standing) {
        if (m_pieces[i].collider->moving) {
            m_pieces[i].slot = static_cast<std::int32_t>(m_awake.size() + m_moving.size());
            m_moving.push_back(i);
        }
    }
}

/// Bodies that move, in the order of entry, whoever woke late.
void SoftStepWorld::listAwake() {
    m_awake.clear();
    for (std::uint32_t i = 0; i < m_still.size(); ++i) {
        if (m_still[i] == 0) {
            m_bodies[i].slot = static_cast<std::int32_t>(m_awake.size());
            m_awake.push_back(i);
        }
    }
}

void SoftStepWorld::place(Solid& solid) {
    const std::span<PlacedBox> placed = placedOf(*solid.collider);
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const OrientedBox& box = solid.collider->parts[i].box;
        placed[i].centre = solid.pose * box.centre;
        placed[i].axes = (solid.pose.orientation * box.orientation).toRotationMatrix();
        placed[i].halfExtents = box.halfExtents;
    }
}

void SoftStepWorld::sweep(Solid& solid, double dt) {
    Aabb box;
    for (const PlacedBox& part : placedOf(*solid.collider)) {
        const Vec3 reach = part.axes.cwiseAbs() * part.halfExtents;
        box.extend(part.centre - reach);
        box.extend(part.centre + reach);
    }
    const Vec3 travel = solid.velocity * dt;
    const double rim = solid.spin.norm() * solid.collider->radius;
    m_paces[solid.collider->number] = {solid.velocity, rim};
    const double slack = contactMargin + rim * dt + m_settings.gravity * dt * dt;
    box.min() += travel.cwiseMin(0.0) - Vec3::Constant(slack);
    box.max() += travel.cwiseMax(0.0) + Vec3::Constant(slack);
    solid.swept = box;
}

double SoftStepWorld::marginOf(std::uint32_t a, std::uint32_t b, double dt) const {
    const double speed = (m_paces[b].velocity - m_paces[a].velocity).norm() + m_paces[a].rim + m_paces[b].rim;
    return contactMargin + speed * dt + m_settings.gravity * dt * dt;
}

void SoftStepWorld::substeps(double dt) {
    const auto from = Clock::now();
    m_substeps = substepsFor(dt);

    const double h = dt / m_substeps;
    buildSolver(h);
    boundSpeeds(dt);

    if (m_hook) {
        prepareHook();
    }
    double hook = 0.0;
    double motion = 0.0;
    for (int substep = 0; substep < m_substeps; ++substep) {
        const auto start = Clock::now();
        runHook(h);
        hook += m_hook ? secondsSince(start) : 0.0;
        m_solver.applyGravity(m_settings.gravity * h);
        m_solver.solveSoft(pushOutSpeed);
        const auto moving = Clock::now();
        m_report.speedLimits += m_solver.move(m_settings.gravity);
        motion += secondsSince(moving);
        m_solver.relax();
        m_solver.accumulateWork();
    }
    m_correcting = m_solver.correctPositions();
    m_solver.end();
    m_solver.restitute(restitutionThreshold);
    m_pool.loop(m_awake.size(), 512, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            holdBack(m_solver.bodies[i]);
        }
    });
    m_substepLength = h;
    takeResults();
    m_costs.substepHook += hook;
    m_costs.motion -= hook;
    shareSolveTime(m_takingSeconds + secondsSince(from) - hook - motion);
}

/// (rad/s)^2 that a thin contact takes to carry its load; zero: it is not thin.
double SoftStepWorld::thinLoad(const SoftContact& contact) const {
    const double thickness = std::min(thicknessOf(*contact.a), thicknessOf(*contact.b));
    if (m_substepLength <= 0.0 || thickness >= thinSide) {
        return 0.0;
    }
    double load = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(contact.count); ++k) {
        load += contact.points[k].impulse / m_substepLength;
    }
    const double inverse =
        (awake(*contact.a) ? solidOf(*contact.a).inverseMass : 0.0) + (awake(*contact.b) ? solidOf(*contact.b).inverseMass : 0.0);
    return pointShare * load * inverse / sinkAllowed(thickness);
}

int SoftStepWorld::substepsFor(double dt) const {
    int substeps = m_settings.substeps;
    for (int doublings = 0; doublings < mostDoublings; ++doublings) {
        const double most = stiffestContact * substeps / dt;
        const auto tooSoft = std::count_if(m_thinLoads.begin(), m_thinLoads.end(), [&](double x) { return x > most * most; });
        if (static_cast<double>(tooSoft) <= softShare * static_cast<double>(m_contacts.size())) {
            break;
        }
        substeps *= 2;
    }
    return substeps;
}

/// m, for the thinner of the two.
double SoftStepWorld::sinkAllowed(double thickness) {
    return std::max(1e-5, sinkShare * thickness);
}

/// The bodies as the hook sees them, but for how they move.
void SoftStepWorld::prepareHook() {
    m_hooked.resize(m_awake.size());
    m_slotOf.assign(m_bodies.size(), -1);
    m_pool.loop(m_awake.size(), 128, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const Solid& solid = m_bodies[m_awake[i]];
            m_slotOf[m_awake[i]] = static_cast<std::int32_t>(i);
            MovingBody& hooked = m_hooked[i];
            hooked.id = idAt<BodyId>(m_awake[i]);
            hooked.inverseMass = m_solver.bodies[i].inverseMass;
            hooked.inertia = solid.inertia;
            hooked.inverseInertia = m_solver.bodies[i].inverseInertia;
            hooked.box = solid.collider->box;
            hooked.volume = solid.collider->volume;
        }
    });
}

void SoftStepWorld::runHook(double h) {
    if (!m_hook) {
        return;
    }
    m_pool.loop(m_awake.size(), 256, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const SolverMotion now = m_solver.motion(i);
            m_hooked[i].position = now.pose.position;
            m_hooked[i].orientation = now.pose.orientation;
            m_hooked[i].velocity = now.velocity;
            m_hooked[i].spin = now.spin;
        }
    });
    m_hook({m_hooked, m_slotOf, &m_pool}, h);
    m_pool.loop(m_awake.size(), 256, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            if (!isNumber(m_hooked[i])) {
                m_bodies[m_awake[i]].collider->broken = true;
                continue;
            }
            m_solver.setVelocity(i, m_hooked[i].velocity, m_hooked[i].spin);
        }
    });
}

void SoftStepWorld::writeBack(double dt) {
    std::vector<double> lifting(m_awake.size());  // J
    m_pool.loop(m_awake.size(), 128, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            Solid& solid = m_bodies[m_awake[i]];
            const SolverBody& moved = m_solver.bodies[i];
            solid.pose = moved.pose;
            solid.velocity = moved.velocity;
            solid.spin = moved.spin;
            solid.active = moved.active;
            solid.supported = m_supportedNow[i] != 0;
            lifting[i] = applyCorrection(i, dt) + keepAboveGround(solid, dt);
            btRigidBody& object = *solid.collider->object;
            object.setWorldTransform(toBullet(solid.pose));
            object.setLinearVelocity(toBullet(solid.velocity));
            object.setAngularVelocity(toBullet(solid.spin));
        }
    });
    m_report.overlapWork = std::accumulate(lifting.begin(), lifting.end(), m_report.overlapWork);
    m_pool.loop(m_moving.size(), 128, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            Solid& piece = m_pieces[m_moving[i]];
            piece.pose = fromBullet(piece.collider->object->getWorldTransform());
            place(piece);
        }
    });
}

/// Moves and turns what lies in others from birth or is jammed in them, without a change of its speed. Returns the work [J] that it
/// took.
double SoftStepWorld::applyCorrection(std::size_t slot, double dt) {
    if (!m_correcting) {
        return 0.0;
    }
    Solid& solid = m_bodies[m_awake[slot]];
    auto [way, turned] = m_solver.correctionOf(slot);
    const double length = way.norm() + turned.norm() * solid.collider->radius;
    const double most = correctionReach * m_settings.overlapSpeed * dt;
    if (length > most) {
        way *= most / length;
        turned *= most / length;
    }
    solid.pose.position += way;
    solid.collider->lifted += way.z();
    solid.pose.orientation = turnedBy(solid.pose.orientation, turned, 1.0);
    m_solver.bodies[slot].moved += way;
    m_solver.bodies[slot].turned += turned;
    return m_settings.gravity * way.z() / solid.inverseMass;
}

/// Returns the work [J] that it took.
double SoftStepWorld::keepAboveGround(Solid& solid, double dt) const {
    Collider& collider = *solid.collider;
    const double sunk = m_surface.depth(solid.pose.position);
    collider.bornBelow = sunk > 0.0 && (collider.bornBelow || collider.newborn);
    if (sunk <= 0.0) {
        return 0.0;
    }
    // A centre below ground has been squeezed there; contact alone may not bring it back from under a pile.
    const Vec3 before = solid.pose.position;
    const Vec3 way = m_surface.above(before) - before;
    const double most = separationSpeed * dt;
    const double share = collider.bornBelow && way.norm() > most ? most / way.norm() : 1.0;
    solid.pose.position += share * way;
    const Vec3 normal = m_surface.normal(before.x(), before.y());
    solid.velocity -= std::min(0.0, solid.velocity.dot(normal)) * normal;
    return m_settings.gravity * share * way.z() / solid.inverseMass;
}

void SoftStepWorld::settle(double dt) {
    for (const std::uint32_t body : m_unloaded) {
        if (m_freeze.frozen(body)) {
            thaw(*m_bodies[body].collider);
        }
    }
    m_unloaded.clear();
    enum : char { GoesOn = 0, Freezes = 1, Watched = 2 };
    std::vector<char> next(m_awake.size());
    m_pool.loop(m_awake.size(), 256, [&](std::size_t first, std::size_t last) {
        for (std::size_t slot = first; slot < last; ++slot) {
            const std::uint32_t i = m_awake[slot];
            const Solid& solid = m_bodies[i];
            Collider& body = *solid.collider;
            // What a body does by position only, as overlap comes apart, is motion too.
            const SolverBody& way = m_solver.bodies[slot];
            const double moved = (way.moved.norm() + way.turned.norm() * body.radius) / dt;
            const double speed = std::max(solid.velocity.norm() + solid.spin.norm() * body.radius,
                                          (body.penetration > restingDepth * body.smallestSide ? 1.0 : settlingShare) * moved);
            const bool freezes = m_freeze.quiet(i, speed, dt) && solid.active && m_settings.freeze;
            next[slot] = static_cast<char>((freezes ? Freezes : GoesOn) | (m_freeze.watched(i) ? Watched : GoesOn));
            body.newborn = false;
        }
    });
    std::vector<char> froze(m_bodies.size(), 0);
    for (std::size_t slot = 0; slot < next.size(); ++slot) {
        const std::uint32_t i = m_awake[slot];
        if ((next[slot] & Freezes) != 0) {
            freeze(*m_bodies[i].collider);
            froze[i] = 1;
        }
        if ((next[slot] & Watched) != 0) {
            for (const std::uint32_t dependant : m_freeze.takeDependants(i, m_bodies[i].pose.position)) {
                if (m_bodies[dependant].collider != nullptr && m_freeze.frozen(dependant)) {
                    thaw(*m_bodies[dependant].collider);
                }
            }
        }
    }
    linkDependants();
    putAsideWhatRests(froze);
}

/// What no longer stirs keeps its contacts apart from those that are looked at in every step.
/// @param froze  [bodies] in this step: their contacts keep the loads that they came to rest under
void SoftStepWorld::putAsideWhatRests(const std::vector<char>& froze) {
    const auto frozeNow = [&](const Collider& c) { return c.kind == ColliderKind::Body && froze[c.index] != 0; };
    m_pool.loop(m_contacts.size(), 512, [&](std::size_t first, std::size_t last) {
        for (SoftContact& contact : std::span(m_contacts).subspan(first, last - first)) {
            if (frozeNow(*contact.a) || frozeNow(*contact.b)) {
                contact.restLoad = contact.load;
            }
            contact.aside = !stirs(*contact.a) && !stirs(*contact.b);
        }
    });
    for (const SoftContact& contact : m_contacts) {
        if (contact.aside) {
            m_asleep.put(contact);
        }
    }
}

void SoftStepWorld::freeze(Collider& body) {
    m_freeze.freeze(body.index);
    m_still[body.index] = 1;
    Solid& solid = m_bodies[body.index];
    solid.velocity = solid.spin = Vec3::Zero();
    body.object->setLinearVelocity(btVector3(0, 0, 0));
    body.object->setAngularVelocity(btVector3(0, 0, 0));
    place(solid);
    sweep(solid, 0.0);
    m_entries[body.number].swept = solid.swept;
    m_boxes.set(body.number, solid.swept);
}

void SoftStepWorld::thaw(Collider& body) {
    m_freeze.thaw(body.index, m_bodies[body.index].pose.position);
    m_still[body.index] = 0;
    body.justThawed = true;
    m_justThawed.push_back(body.index);
}

void SoftStepWorld::linkDependants() {
    if (m_justThawed.empty()) {
        return;
    }
    const auto links = [](const SoftContact& c) { return c.a->justThawed != c.b->justThawed && c.depth >= -contactMargin; };
    const auto link = [&](const SoftContact& c) {
        const Collider& thawed = c.a->justThawed ? *c.a : *c.b;
        const Collider& other = c.a->justThawed ? *c.b : *c.a;
        if (links(c) && other.kind == ColliderKind::Body && m_freeze.frozen(other.index)) {
            m_freeze.addDependant(thawed.index, other.index);
        }
    };
    forEachContact(link);
    for (const std::uint32_t body : m_justThawed) {
        m_asleep.forEachPairOf(m_bodies[body].collider->number, link);
    }
    for (const std::uint32_t body : m_justThawed) {
        m_freeze.sortDependants(body);
        m_bodies[body].collider->justThawed = false;
    }
    m_justThawed.clear();
}

void SoftStepWorld::letGoOfLeaving() {
    std::vector<Collider*> sleepers;
    const auto look = [&](const SoftContact& c) {
        if (c.a->leaving == c.b->leaving || c.depth < -contactMargin) {
            return;
        }
        Collider& left = c.a->leaving ? *c.b : *c.a;
        if (left.kind == ColliderKind::Body && m_freeze.frozen(left.index)) {
            sleepers.push_back(&left);
        }
    };
    forEachContact(look);
    m_asleep.forEachPair(look);
    std::sort(sleepers.begin(), sleepers.end(), [](const Collider* x, const Collider* y) { return x->number < y->number; });
    for (Collider* sleeper : sleepers) {
        if (m_freeze.frozen(sleeper->index)) {
            thaw(*sleeper);
        }
    }
    linkDependants();
    const auto gone = [](const SoftContact& c) { return c.a->leaving || c.b->leaving; };
    std::erase_if(m_contacts, gone);
    m_asleep.removeIf(gone);
}

}  // namespace rubble
