#include "core/engine/bullet/fragment_world.h"

#include <algorithm>
#include <cmath>

#include "core/engine/world/constants.h"

namespace rubble {

namespace {

btVector3 pointVelocity(const BulletCollider& collider, const btVector3& at) {
    return collider.object->getVelocityInLocalPoint(at - collider.object->getWorldTransform().getOrigin());
}

double relativeAlong(const BulletCollider& a, const BulletCollider& b, const btManifoldPoint& point) {
    const btVector3& where = point.getPositionWorldOnB();
    return point.m_normalWorldOnB.dot(pointVelocity(a, where) - pointVelocity(b, where));
}

/// m/s at which the solver opens an overlap by velocity; deeper ones it opens by position only.
double partingSpeed(double distance, const btContactSolverInfo& info) {
    return distance > info.m_splitImpulsePenetrationThreshold ? -distance * info.m_erp / info.m_timeStep : 0.0;
}

double inverseMass(const BulletCollider& c, bool awake) {
    return awake ? c.object->getInvMass() : 0.0;
}

}  // namespace

FragmentWorld::FragmentWorld(btDispatcher* dispatcher, btBroadphaseInterface* broadphase, FragmentSolver* solver,
                             btCollisionConfiguration* configuration, const WorldSettings& settings, const Scene& scene)
    : btDiscreteDynamicsWorld(dispatcher, broadphase, solver, configuration),
      m_settings(settings),
      m_surface{settings.ground, settings.groundHeight, settings.terrain},
      m_sleep(scene.sleep),
      m_report(scene.report),
      m_hook(scene.hook) {
    setGravity(btVector3(0.0, 0.0, -settings.gravity));
    getSolverInfo().m_numIterations = settings.iterations;
    setForceUpdateAllAabbs(false);
    // Swept boxes are for Bullet's continuous collision, which no body here uses.
    getDispatchInfo().m_useContinuous = false;
}

void FragmentWorld::solveConstraints(btContactSolverInfo& info) {
    const double dt = info.m_timeStep;
    runHook(dt);
    m_overlaps.beginStep();
    collectContacts();
    wakeByContacts();
    offsetContacts(dt);

    m_solved.clear();
    for (BulletCollider* body : m_bodies) {
        if (body != nullptr && awake(*body)) {
            m_solved.push_back(body->object.get());
        }
    }
    m_manifolds.clear();
    for (const Contact& contact : m_contacts) {
        if (!contact.yielding) {
            m_manifolds.push_back(contact.manifold);
        }
    }
    m_heights.clear();
    for (const btCollisionObject* body : m_solved) {
        m_heights.push_back(body->getWorldTransform().getOrigin().z());
    }
    m_constraintSolver->prepareSolve(static_cast<int>(m_solved.size()), static_cast<int>(m_manifolds.size()));
    m_constraintSolver->solveGroup(m_solved.data(), static_cast<int>(m_solved.size()), m_manifolds.data(),
                                   static_cast<int>(m_manifolds.size()), nullptr, 0, info, m_debugDrawer, m_dispatcher1);
    m_constraintSolver->allSolved(info, m_debugDrawer);

    // The solver parts what overlaps deeply by position only; what that lifts is no work of gravity.
    for (std::size_t i = 0; i < m_solved.size(); ++i) {
        const btRigidBody& body = *btRigidBody::upcast(m_solved[i]);
        const double lift = body.getWorldTransform().getOrigin().z() - m_heights[i];
        m_report.overlapWork += m_settings.gravity * lift / body.getInvMass();
    }
    accumulateWork();
    restoreContacts(dt);
    bleedOverlaps(dt);
    m_overlaps.endStep();
}

void FragmentWorld::runHook(double dt) {
    if (!m_hook) {
        return;
    }
    m_moving.clear();
    m_slotOf.assign(m_bodies.size(), -1);
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        if (m_bodies[i] != nullptr && awake(*m_bodies[i])) {
            m_slotOf[i] = static_cast<std::int32_t>(m_moving.size());
            m_moving.push_back(movingBody(*m_bodies[i]));
        }
    }
    m_hook({m_moving, m_slotOf}, dt);
    for (const MovingBody& body : m_moving) {
        if (!isNumber(body)) {
            m_bodies[at(body.id)]->broken = true;
            continue;
        }
        m_bodies[at(body.id)]->object->setLinearVelocity(toBullet(body.velocity));
        m_bodies[at(body.id)]->object->setAngularVelocity(toBullet(body.spin));
    }
}

void FragmentWorld::collectContacts() {
    m_contacts.clear();
    m_report.points = 0;
    for (int i = 0; i < m_dispatcher1->getNumManifolds(); ++i) {
        btPersistentManifold* manifold = m_dispatcher1->getManifoldByIndexInternal(i);
        if (manifold->getNumContacts() == 0) {
            continue;
        }
        BulletCollider& a = colliderOf(manifold->getBody0());
        BulletCollider& b = colliderOf(manifold->getBody1());
        // A frozen body takes part only where something awake or moving touches it.
        if (!m_sleep.stirs(a) && !m_sleep.stirs(b)) {
            continue;
        }
        Contact contact{colliderPair(a.number, b.number), manifold, &a, &b};
        contact.depth = -manifold->getContactPoint(0).getDistance();
        for (int j = 1; j < manifold->getNumContacts(); ++j) {
            const double depth = -manifold->getContactPoint(j).getDistance();
            if (depth > contact.depth) {
                contact.depth = depth;
                contact.deepest = j;
            }
        }
        m_report.points += manifold->getNumContacts();
        m_contacts.push_back(contact);
    }
    m_report.pairs = static_cast<std::int64_t>(m_contacts.size());
    std::sort(m_contacts.begin(), m_contacts.end(), [](const Contact& x, const Contact& y) { return x.pair < y.pair; });
}

void FragmentWorld::wakeByContacts() {
    for (const Contact& contact : m_contacts) {
        for (auto [sleeper, other] : {std::pair{contact.a, contact.b}, std::pair{contact.b, contact.a}}) {
            if (!m_sleep.frozen(*sleeper) || other->kind == ColliderKind::Ground) {
                continue;
            }
            const btManifoldPoint& point = contact.manifold->getContactPoint(contact.deepest);
            const double along = point.m_normalWorldOnB.dot(pointVelocity(*other, point.getPositionWorldOnB()));
            const double approach = other == contact.a ? -along : along;
            if (m_sleep.wakes(*other, approach, true)) {
                thaw(*sleeper);
            }
        }
    }
    m_sleep.linkDependants([this](auto visit) { forEachTouching(visit); });
}

void FragmentWorld::offsetContacts(double dt) {
    const double deepestSeen = separationSpeed * dt / m_solverInfo.m_erp2;
    m_stock.clear();
    for (BulletCollider* body : m_bodies) {
        if (body != nullptr && awake(*body)) {
            body->penetration = body->overlapLeft = 0.0;
        }
    }
    for (Contact& contact : m_contacts) {
        const bool newborn = contact.a->newborn || contact.b->newborn;
        noteBirthDepth(*contact.a, *contact.b, contact.depth);
        contact.offset = m_overlaps.offset(contact.pair, contact.depth, newborn);
        limitPiece(contact, dt);
        noteOverlapLeft(*contact.a, *contact.b, contact.offset, m_sleep);
        if (!contact.yielding) {
            notePenetration(*contact.a, *contact.b, contact.depth - contact.offset, m_sleep, m_report);
        }
        if (contact.offset > 0.0) {
            dropInertPoints(contact, dt);
        }
        for (int j = 0; j < contact.manifold->getNumContacts(); ++j) {
            btManifoldPoint& point = contact.manifold->getContactPoint(j);
            m_stock.push_back({point.getDistance(), point.m_combinedRestitution, point.m_appliedImpulse, 0.0, 0.0});
            point.setDistance(std::max(point.getDistance() + contact.offset, -deepestSeen));
            if (point.getDistance() < 0.0 && !contact.yielding) {
                m_stock.back().opening = relativeAlong(*contact.a, *contact.b, point);
                m_stock.back().bias = partingSpeed(point.getDistance(), m_solverInfo);
            }
            if (contact.offset > 0.0) {
                point.m_combinedRestitution = 0.0;
            }
        }
    }
}

void FragmentWorld::dropInertPoints(Contact& contact, double dt) {
    for (int j = contact.manifold->getNumContacts() - 1; j >= 0; --j) {
        const btManifoldPoint& point = contact.manifold->getContactPoint(j);
        if (j == contact.deepest) {
            continue;
        }
        const double gap = point.getDistance() + contact.offset - inertGap;
        if (gap > 0.0 && gap + relativeAlong(*contact.a, *contact.b, point) * dt > 0.0) {
            // Bullet puts the last point in the place of the one taken out.
            if (contact.deepest == contact.manifold->getNumContacts() - 1) {
                contact.deepest = j;
            }
            contact.manifold->removeContactPoint(j);
        }
    }
}

void FragmentWorld::limitPiece(Contact& contact, double dt) {
    const bool pieceIsA = contact.a->kind == ColliderKind::Piece;
    const BulletCollider& piece = pieceIsA ? *contact.a : *contact.b;
    const BulletCollider& body = pieceIsA ? *contact.b : *contact.a;
    const int points = contact.manifold->getNumContacts();
    if (piece.kind != ColliderKind::Piece || !piece.moving) {
        for (int j = 0; j < points; ++j) {
            FragmentSolver::unlimit(contact.manifold->getContactPoint(j));
        }
        return;
    }
    const double mass = 1.0 / body.object->getInvMass();
    const bool gaveWay = m_overlaps.yielded(contact.pair);
    for (int j = 0; j < points; ++j) {
        btManifoldPoint& point = contact.manifold->getContactPoint(j);
        // Bullet's normal points from B to A.
        const btVector3 toBody = pieceIsA ? btVector3(-point.m_normalWorldOnB) : btVector3(point.m_normalWorldOnB);
        const btVector3& where = point.getPositionWorldOnB();
        const double approach = toBody.dot(pointVelocity(piece, where) - pointVelocity(body, where));
        contact.approach = std::max(contact.approach, approach);
    }
    const double up = (pieceIsA ? -1.0 : 1.0) * contact.manifold->getContactPoint(contact.deepest).m_normalWorldOnB.z();
    const PieceAction action = pieceAction(contact.approach, up, gaveWay);
    contact.yielding = action.yielding;
    contact.pressing = action.pressing;
    const double most = mass * (contact.pressing ? m_overlaps.pressLeft(contact.pair)
                                                 : pieceCarryFactor * std::max(0.0, contact.approach) + carryAcceleration * dt);
    for (int j = 0; j < points; ++j) {
        FragmentSolver::limit(contact.manifold->getContactPoint(j), most / points);
    }
    if (contact.yielding) {
        m_overlaps.follow(contact.pair, contact.depth);
        contact.offset = std::max(contact.offset, contact.depth);
    }
}

void FragmentWorld::accumulateWork() {
    for (Contact& contact : m_contacts) {
        if (contact.yielding) {
            continue;
        }
        bool acted = false;
        double left = 0.0;
        double impulseSum = 0.0;
        const bool pieceIsA = contact.a->kind == ColliderKind::Piece;
        BulletCollider& piece = pieceIsA ? *contact.a : *contact.b;
        BulletCollider& body = pieceIsA ? *contact.b : *contact.a;
        const bool driven = piece.kind == ColliderKind::Piece && piece.moving;
        for (int j = 0; j < contact.manifold->getNumContacts(); ++j) {
            const btManifoldPoint& point = contact.manifold->getContactPoint(j);
            acted = acted || point.m_appliedImpulse > 0.0;
            if (driven && point.m_appliedImpulse > 0.0) {
                const btVector3 impulseOnA =
                    point.m_normalWorldOnB * point.m_appliedImpulse + point.m_lateralFrictionDir1 * point.m_appliedImpulseLateral1;
                const btVector3 impulse = pieceIsA ? btVector3(-impulseOnA) : impulseOnA;
                m_report.pieceWork += impulse.dot(pointVelocity(piece, point.getPositionWorldOnB()));
                const btVector3 relative =
                    pointVelocity(piece, point.getPositionWorldOnB()) - pointVelocity(body, point.getPositionWorldOnB());
                impulseSum += point.m_appliedImpulse;
                left = std::max(left, (pieceIsA ? -1.0 : 1.0) * point.m_normalWorldOnB.dot(relative));
                body.pushed = true;
            }
        }
        contact.a->touched = contact.a->touched || acted;
        contact.b->touched = contact.b->touched || acted;
        if (!driven || contact.approach <= pieceYieldSpeed || impulseSum <= 0.0) {
            continue;
        }
        const bool gaveWay = contact.pressing
                                 ? m_overlaps.pressed(contact.pair, contact.depth, impulseSum * body.object->getInvMass())
                                 : inVain(left, contact.approach) && m_overlaps.pushedInVain(contact.pair, contact.depth);
        m_report.piecesYielded += gaveWay;
    }
}

void FragmentWorld::restoreContacts(double dt) {
    std::size_t next = 0;
    for (const Contact& contact : m_contacts) {
        const bool driven = contact.a->moving || contact.b->moving;
        double parting = 0.0;
        const double heavier = std::max(inverseMass(*contact.a, awake(*contact.a)), inverseMass(*contact.b, awake(*contact.b)));
        const double weight = heavier > 0.0 ? m_settings.gravity * dt / heavier : 0.0;
        for (int j = 0; j < contact.manifold->getNumContacts(); ++j) {
            btManifoldPoint& point = contact.manifold->getContactPoint(j);
            const Stock& stock = m_stock[next++];
            // A contact takes energy, but for the part of it that pushes overlapping solids apart.
            if (point.getDistance() < 0.0 && point.m_appliedImpulse > 0.0 && !driven) {
                const double mean = 0.5 * (stock.opening + relativeAlong(*contact.a, *contact.b, point));
                parting += point.m_appliedImpulse * std::min(mean, 0.5 * stock.bias);
            }
            point.setDistance(stock.distance);
            point.m_combinedRestitution = stock.restitution;
            // The next step starts from this impulse. That of a blow would have to be taken back within the few iterations there
            // are, and what is left of it spins and launches bodies.
            point.m_appliedImpulse = std::min<double>(point.m_appliedImpulse, 2.0 * std::max(stock.impulse, weight));
        }
        m_report.overlapWork += std::max(0.0, parting);
    }
}

void FragmentWorld::bleedOverlaps(double dt) {
    if (m_overlaps.empty()) {
        return;
    }
    const double most = m_settings.overlapSpeed * dt;
    struct Push {
        const Contact* contact;
        Vec3 onA, onB, normal;
    };
    std::vector<Push> pushes;
    for (const Contact& contact : m_contacts) {
        if (contact.offset <= 0.0 || contact.yielding) {
            continue;
        }
        const double a = inverseMass(*contact.a, awake(*contact.a));
        const double b = inverseMass(*contact.b, awake(*contact.b));
        if (a + b <= 0.0) {
            continue;
        }
        const Vec3 normal = fromBullet(contact.manifold->getContactPoint(contact.deepest).m_normalWorldOnB);
        const double distance = std::min(most, contact.offset);
        pushes.push_back({&contact, normal * (distance * a / (a + b)), -normal * (distance * b / (a + b)), normal});
        contact.a->shift += pushes.back().onA;
        contact.b->shift += pushes.back().onB;
        contact.a->overlapping = contact.b->overlapping = true;
    }
    // A body among many overlaps still moves no faster than one pair would move it.
    const auto share = [&](const BulletCollider& c) {
        const double length = c.shift.norm();
        return length > most ? most / length : 1.0;
    };
    for (const Push& push : pushes) {
        const BulletCollider& a = *push.contact->a;
        const BulletCollider& b = *push.contact->b;
        double& work = a.kind == ColliderKind::Piece || b.kind == ColliderKind::Piece ? m_report.pieceWork : m_report.overlapWork;
        for (const auto& [c, part] : {std::pair{&a, &push.onA}, std::pair{&b, &push.onB}}) {
            if (awake(*c)) {
                work += m_settings.gravity * part->z() * share(*c) / c->object->getInvMass();
            }
        }
        const double opened = push.normal.dot(a.shift * share(a) - b.shift * share(b));
        m_overlaps.bleed(push.contact->pair, std::max(0.0, opened));
    }
    for (BulletCollider* body : m_bodies) {
        if (body != nullptr && body->overlapping) {
            btTransform transform = body->object->getWorldTransform();
            transform.setOrigin(transform.getOrigin() + toBullet(body->shift * share(*body)));
            body->object->setWorldTransform(transform);
        }
    }
    for (const Push& push : pushes) {
        push.contact->a->shift = push.contact->b->shift = Vec3::Zero();
    }
}

void FragmentWorld::integrateTransforms(btScalar dt) {
    const auto inertia = [](const btRigidBody& body) {
        const btVector3& inverse = body.getInvInertiaDiagLocal();
        return btVector3(1.0 / inverse.x(), 1.0 / inverse.y(), 1.0 / inverse.z());
    };
    for (BulletCollider* collider : m_bodies) {
        if (collider == nullptr || !awake(*collider)) {
            continue;
        }
        btRigidBody& body = *collider->object;
        const btVector3 spin = body.getAngularVelocity();
        const btMatrix3x3& axes = body.getWorldTransform().getBasis();
        const btVector3 momentum = axes * (inertia(body) * (spin * axes));
        // Spin of half a step later: turning with it keeps energy to second order.
        btTransform half;
        btTransformUtil::integrateTransform(body.getWorldTransform(), btVector3(0, 0, 0), spin, 0.5 * dt, half);
        body.setAngularVelocity(half.getBasis() * (body.getInvInertiaDiagLocal() * (momentum * half.getBasis())));
        btTransform next;
        body.predictIntegratedTransform(dt, next);
        if (!collider->touched) {
            // The stock step moves with the new velocity; free flight moves with the mean of old and new.
            next.setOrigin(next.getOrigin() - 0.5 * dt * dt * body.getGravity());
        }
        if (collider->newborn) {
            collider->bornBelow = m_surface.depth(fromBullet(body.getWorldTransform().getOrigin())) > 0.0;
        }
        const Vec3 reached = fromBullet(next.getOrigin());
        if (m_surface.depth(reached) > 0.0) {
            const GroundRise rise = riseAboveGround(m_surface, reached, collider->bornBelow, dt);
            next.setOrigin(next.getOrigin() + toBullet(Vec3(rise.share * rise.way)));
            m_report.overlapWork += m_settings.gravity * rise.share * rise.way.z() / body.getInvMass();
            const btVector3 up = toBullet(rise.normal);
            const btScalar falling = std::min<btScalar>(0.0, body.getLinearVelocity().dot(up));
            body.setLinearVelocity(body.getLinearVelocity() - falling * up);
        }
        body.proceedToTransform(next);
        body.setAngularVelocity(next.getBasis() * (body.getInvInertiaDiagLocal() * (momentum * next.getBasis())));
    }
}

void FragmentWorld::updateActivationState(btScalar dt) {
    for (std::uint32_t i = 0; i < m_bodies.size(); ++i) {
        BulletCollider* body = m_bodies[i];
        if (body == nullptr) {
            continue;
        }
        if (awake(*body)) {
            const double speed =
                body->object->getLinearVelocity().length() + body->object->getAngularVelocity().length() * body->radius;
            if (body->overlapping) {
                m_sleep.clock().restart(i);
            } else if (m_sleep.clock().quiet(i, speed, dt) && m_settings.freeze) {
                freeze(*body);
            }
            const Vec3 place = fromBullet(body->object->getWorldTransform().getOrigin());
            for (const std::uint32_t woken : m_sleep.wokenBy(*body, place)) {
                thaw(*m_bodies[woken]);
            }
        }
        body->newborn = body->overlapping = body->touched = false;
    }
    m_sleep.linkDependants([this](auto visit) { forEachTouching(visit); });
}

void FragmentWorld::freeze(BulletCollider& body) {
    m_sleep.freeze(body);
    body.object->setLinearVelocity(btVector3(0, 0, 0));
    body.object->setAngularVelocity(btVector3(0, 0, 0));
    body.object->clearForces();
    body.object->setLinearFactor(btVector3(0, 0, 0));
    body.object->setAngularFactor(btVector3(0, 0, 0));
    body.object->forceActivationState(DISABLE_SIMULATION);
}

void FragmentWorld::thaw(BulletCollider& body) {
    body.object->setLinearFactor(btVector3(1, 1, 1));
    body.object->setAngularFactor(btVector3(1, 1, 1));
    body.object->forceActivationState(ACTIVE_TAG);
    m_sleep.thaw(body, fromBullet(body.object->getWorldTransform().getOrigin()));
}

template <class Visit>
void FragmentWorld::forEachTouching(Visit visit) const {
    for (int i = 0; i < m_dispatcher1->getNumManifolds(); ++i) {
        const btPersistentManifold* manifold = m_dispatcher1->getManifoldByIndexInternal(i);
        if (manifold->getNumContacts() > 0) {
            visit(colliderOf(manifold->getBody0()), colliderOf(manifold->getBody1()));
        }
    }
}

void FragmentWorld::thawNeighboursOfLeaving() {
    const auto touching = [this](auto visit) { forEachTouching(visit); };
    for (Collider* sleeper : m_sleep.neighboursOfLeaving(touching)) {
        thaw(bulletCollider(*sleeper));
    }
    m_sleep.linkDependants(touching);
}

}  // namespace rubble
