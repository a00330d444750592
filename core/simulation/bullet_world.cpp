#include "core/simulation/bullet_world.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <limits>

#include "core/simulation/constants.h"
#include "core/simulation/soft_step_world.h"
#include "core/simulation/terrain_shape.h"
#include "core/simulation/value_archive.h"

namespace rubble {

namespace {

constexpr int groundGroup = 1;
constexpr int bodyGroup = 2;
constexpr int pieceGroup = 4;

const PairProperties& pairOf(const btCollisionObject* a, const btCollisionObject* b) {
    const Collider& first = colliderOf(a);
    return first.pairs->of(first.material, colliderOf(b).material);
}

btScalar pairFriction(const btCollisionObject* a, const btCollisionObject* b) {
    return pairOf(a, b).friction;
}

btScalar pairRestitution(const btCollisionObject* a, const btCollisionObject* b) {
    return pairOf(a, b).restitution;
}

/// Bullet holds these two for the whole program, so they are set once; the table comes with each object.
void combineByPair() {
    static const bool once = [] {
        gCalculateCombinedFrictionCallback = pairFriction;
        gCalculateCombinedRestitutionCallback = pairRestitution;
        return true;
    }();
    (void)once;
}

}  // namespace

BulletWorld::BulletWorld(const WorldSettings& settings) : m_settings(settings), m_dispatcher(&m_configuration, settings.cancelled) {
    combineByPair();
}

BulletWorld::~BulletWorld() {
    for (const auto* list : {&m_bodies, &m_pieces, &m_ground}) {
        for (const auto& collider : *list) {
            if (m_world && collider->object && collider->object->getBroadphaseProxy() != nullptr) {
                m_world->removeRigidBody(collider->object.get());
            }
        }
    }
}

void BulletWorld::begin(std::unique_ptr<btDiscreteDynamicsWorld> world, bool holdsObjects) {
    m_world = std::move(world);
    m_holdsObjects = holdsObjects;
    if ((m_settings.ground || m_settings.terrain) && holdsObjects) {
        addGround();
    }
}

Collider& BulletWorld::makeCollider(Colliders& list, ColliderKind kind, const CollisionShape& shape) {
    auto collider = std::make_unique<Collider>();
    collider->kind = kind;
    collider->number = m_nextNumber++;
    collider->index = static_cast<std::uint32_t>(list.size());
    collider->parts = shape;
    furnish(*collider);
    list.push_back(std::move(collider));
    return *list.back();
}

/// What follows from its parts.
void BulletWorld::furnish(Collider& collider) {
    collider.radius = outerRadius(collider.parts);
    collider.shape = makeBulletShape(collider.parts);
    collider.box = boxAround(collider.parts);
    collider.pairs = &m_settings.pairs;
}

/// The object of a body or piece.
void BulletWorld::embody(Collider& collider, const btTransform& place) {
    btRigidBody::btRigidBodyConstructionInfo info(collider.mass, nullptr, collider.shape.shape.get(), toBullet(collider.inertia));
    info.m_startWorldTransform = place;
    collider.object = std::make_unique<btRigidBody>(info);
    if (collider.kind == ColliderKind::Piece) {
        collider.object->setCollisionFlags(collider.object->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
        collider.object->setActivationState(DISABLE_DEACTIVATION);
    }
}

void BulletWorld::insert(Collider& collider) {
    btRigidBody& object = *collider.object;
    object.setUserPointer(&collider);
    object.setFlags(0);
    if (!m_holdsObjects) {
        return;
    }
    switch (collider.kind) {
        case ColliderKind::Ground:
            m_world->addRigidBody(&object, groundGroup, bodyGroup);
            break;
        case ColliderKind::Piece:
            m_world->addRigidBody(&object, pieceGroup, bodyGroup);
            break;
        case ColliderKind::Body:
            m_world->addRigidBody(&object, bodyGroup, groundGroup | pieceGroup | (m_settings.bodyContacts ? bodyGroup : 0));
            break;
    }
}

void BulletWorld::addGround() {
    const double span = m_settings.reach.isEmpty() ? 0.0 : m_settings.reach.sizes().maxCoeff();
    const Vec3 centre = m_settings.reach.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(m_settings.reach.center());
    const double reach = std::max(groundMargin + span, 10.0 * span);
    ConvexPart box;
    box.box.halfExtents = Vec3(reach, reach, groundHalfThickness);
    Collider& ground = makeCollider(m_ground, ColliderKind::Ground, {box});
    ground.material = m_settings.groundMaterial;
    double middle = m_settings.groundHeight - groundHalfThickness;
    if (m_settings.terrain) {
        auto terrain =
            std::make_unique<TerrainShape>(SiteSurface{m_settings.ground, m_settings.groundHeight, m_settings.terrain}, reach);
        middle = terrain->middle();
        ground.shape.shape = std::move(terrain);
    }
    ground.object = std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(0.0, nullptr, ground.shape.shape.get()));
    ground.object->setWorldTransform(toBullet(Pose{Vec3(centre.x(), centre.y(), middle), Quat::Identity()}));
    insert(ground);
}

BodyId BulletWorld::addBody(const NewBody& body) {
    Collider& collider = makeCollider(m_bodies, ColliderKind::Body, body.shape);
    collider.mass = body.mass;
    collider.inertia = body.inertia;
    embody(collider, toBullet(body.pose));
    collider.smallestSide = body.smallestSide;
    collider.volume = body.volume;
    collider.material = body.material;
    collider.object->setLinearVelocity(toBullet(body.velocity));
    collider.object->setAngularVelocity(toBullet(body.angularVelocity));
    insert(collider);
    entered(collider);
    return idAt<BodyId>(collider.index);
}

void BulletWorld::removeBody(BodyId body) {
    Collider& collider = *m_bodies[at(body)];
    if (!collider.leaving) {
        collider.leaving = true;
        m_leaving.push_back(&collider);
    }
}

PieceId BulletWorld::addPiece(const CollisionShape& shape, const Pose& pose, Material material) {
    Collider& collider = makeCollider(m_pieces, ColliderKind::Piece, shape);
    collider.material = material;
    embody(collider, toBullet(pose));
    insert(collider);
    pieceEntered(collider);
    m_presentPieces.push_back(collider.index);
    return static_cast<PieceId>(collider.index);
}

void BulletWorld::removePiece(PieceId piece) {
    Collider& collider = *m_pieces[at(piece)];
    if (!collider.leaving) {
        collider.leaving = true;
        m_leaving.push_back(&collider);
    }
}

void BulletWorld::movePiece(PieceId piece, const Pose& atStepEnd) {
    Collider& collider = *m_pieces[at(piece)];
    // Bullet takes the piece's velocity from the two transforms; the interpolation transform must stay where the piece was.
    collider.object->forceActivationState(DISABLE_DEACTIVATION);
    collider.object->setWorldTransform(toBullet(atStepEnd));
    collider.moving = true;
}

void BulletWorld::takeOut() {
    if (m_leaving.empty()) {
        return;
    }
    aboutToLeave();
    bool pieces = false;
    for (Collider* collider : m_leaving) {
        if (m_holdsObjects) {
            m_world->removeRigidBody(collider->object.get());
        }
        left(*collider);
        if (collider->kind == ColliderKind::Piece) {
            pieces = true;
            collider->object.reset();
            collider->shape = {};
        }
    }
    if (pieces) {
        std::erase_if(m_presentPieces, [&](std::uint32_t i) { return m_pieces[i]->leaving; });
    }
    m_leaving.clear();
}

void BulletWorld::settlePieces() {
    for (const std::uint32_t i : m_presentPieces) {
        Collider& piece = *m_pieces[i];
        piece.newborn = false;
        if (piece.moving) {
            piece.moving = false;
        } else if (piece.object->getActivationState() == DISABLE_DEACTIVATION) {
            // Still for a whole step: its velocity is zero by now, and it may be skipped until it moves again.
            piece.object->forceActivationState(ISLAND_SLEEPING);
        }
    }
}

void BulletWorld::keepColliders(Archive& archive) {
    assert(!m_holdsObjects && (!archive.reading() || (m_bodies.empty() && m_pieces.empty())));
    keepColliders(archive, m_bodies, ColliderKind::Body);
    keepColliders(archive, m_pieces, ColliderKind::Piece);
    archive(m_presentPieces, m_nextNumber, m_costs);
    // What is about to leave, in that order.
    m_leaving.resize(archive.count(m_leaving.size()));
    for (Collider*& leaving : m_leaving) {
        ColliderKind kind = archive.reading() ? ColliderKind::Body : leaving->kind;
        std::uint32_t index = archive.reading() ? 0 : leaving->index;
        archive(kind, index);
        const Colliders& list = kind == ColliderKind::Piece ? m_pieces : m_bodies;
        if (index >= list.size()) {
            Archive::fail();
        }
        leaving = list[index].get();
    }
}

void BulletWorld::keepColliders(Archive& archive, Colliders& list, ColliderKind kind) {
    list.resize(archive.count(list.size()));
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (archive.reading()) {
            list[i] = std::make_unique<Collider>();
            list[i]->kind = kind;
            list[i]->index = static_cast<std::uint32_t>(i);
        }
        archive(*list[i]);
        keepObject(archive, *list[i]);
    }
}

void BulletWorld::keepObject(Archive& archive, Collider& collider) {
    bool there = collider.object != nullptr;
    archive(there);
    if (!there) {
        return;
    }
    // The axes as they stand: through a quaternion they would lose their last bits.
    std::array<btVector3, 4> place;
    std::array<btVector3, 2> motion;
    if (!archive.reading()) {
        const btTransform& at = collider.object->getWorldTransform();
        place = {at.getBasis()[0], at.getBasis()[1], at.getBasis()[2], at.getOrigin()};
        motion = {collider.object->getLinearVelocity(), collider.object->getAngularVelocity()};
    }
    const auto visit = [&](btVector3& v) { archive(v[0], v[1], v[2]); };
    std::for_each(place.begin(), place.end(), visit);
    std::for_each(motion.begin(), motion.end(), visit);
    if (archive.reading()) {
        furnish(collider);
        btTransform at;
        for (int row = 0; row < 3; ++row) {
            at.getBasis()[row] = place[static_cast<std::size_t>(row)];
        }
        at.setOrigin(place[3]);
        embody(collider, at);
        collider.object->setLinearVelocity(motion[0]);
        collider.object->setAngularVelocity(motion[1]);
        insert(collider);
    }
}

void BulletWorld::step(double dt) {
    const auto from = std::chrono::steady_clock::now();
    takeOut();
    m_world->stepSimulation(dt, 0);
    settlePieces();
    for (const auto& ground : m_ground) {
        ground->newborn = false;
    }
    m_costs.total += std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

BodyMotion BulletWorld::motion(BodyId body) const {
    const Collider& collider = *m_bodies[at(body)];
    const btRigidBody& object = *collider.object;
    BodyMotion motion{fromBullet(object.getWorldTransform()), fromBullet(object.getLinearVelocity()),
                      fromBullet(object.getAngularVelocity())};
    if (collider.broken) {
        motion.velocity.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    return motion;
}

double BulletWorld::kineticEnergy(BodyId body) const {
    const btRigidBody& object = *m_bodies[at(body)]->object;
    const btVector3 spin = object.getAngularVelocity() * object.getWorldTransform().getBasis();
    const btVector3& inverse = object.getInvInertiaDiagLocal();
    return 0.5 * (object.getMass() * object.getLinearVelocity().length2() + spin.x() * spin.x() / inverse.x() +
                  spin.y() * spin.y() / inverse.y() + spin.z() * spin.z() / inverse.z());
}

double BulletWorld::birthDepth(BodyId body) const {
    const Collider& collider = *m_bodies[at(body)];
    return collider.smallestSide > 0.0 ? collider.birthDepth / collider.smallestSide : 0.0;
}

Momenta BulletWorld::momenta(BodyId body) const {
    if (removed(body)) {
        return {};
    }
    const btRigidBody& object = *m_bodies[at(body)]->object;
    const btVector3& inverse = object.getInvInertiaDiagLocal();
    Mat3 axes;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
            axes(r, c) = object.getWorldTransform().getBasis()[r][c];
        }
    }
    const Vec3 diagonal(1.0 / inverse.x(), 1.0 / inverse.y(), 1.0 / inverse.z());
    const Mat3 inertia = axes * diagonal.asDiagonal() * axes.transpose();
    return rigidMomenta(object.getMass(), fromBullet(object.getWorldTransform().getOrigin()), inertia,
                        fromBullet(object.getLinearVelocity()), fromBullet(object.getAngularVelocity()));
}

namespace {

/// Bullet with rest offsets, freeze, limits and its stock solver.
class FreezingWorld : public BulletWorld {
public:
    explicit FreezingWorld(const WorldSettings& settings) : BulletWorld(settings) {
        auto world = std::make_unique<FragmentWorld>(dispatcher(), broadphase(), &m_solver, configuration(), settings);
        m_fragments = world.get();
        begin(std::move(world));
    }
    BodyState state(BodyId body) const override {
        if (removed(body)) {
            return BodyState::Removed;
        }
        return m_fragments->freezeClock().resting(at(body)) ? BodyState::Frozen : BodyState::Awake;
    }
    const ContactReport& contacts() const override { return m_fragments->report(); }
    void onSubstep(SubstepHook hook) override { m_fragments->onSubstep(std::move(hook)); }
    void wake(BodyId body) override {
        if (state(body) == BodyState::Frozen && m_fragments->freezeClock().frozen(at(body))) {
            m_fragments->thaw(bodyAt(body));
        }
    }

private:
    void entered(Collider& body) override { m_fragments->addBody(&body); }
    void aboutToLeave() override { m_fragments->thawNeighboursOfLeaving(); }
    void left(Collider& collider) override {
        if (collider.kind == ColliderKind::Body) {
            m_fragments->forget(collider.index);
        }
    }

    FragmentSolver m_solver;
    FragmentWorld* m_fragments = nullptr;
};

/// Soft contacts in small substeps.
class SoftWorld : public BulletWorld {
public:
    explicit SoftWorld(const WorldSettings& settings) : BulletWorld(settings) {
        auto world = std::make_unique<SoftStepWorld>(dispatcher(), broadphase(), &m_solver, configuration(), settings, m_costs);
        m_soft = world.get();
        begin(std::move(world), false);
    }
    BodyState state(BodyId body) const override {
        if (removed(body)) {
            return BodyState::Removed;
        }
        return m_soft->freezeClock().resting(at(body)) ? BodyState::Frozen : BodyState::Awake;
    }
    const ContactReport& contacts() const override { return m_soft->report(); }
    void onSubstep(SubstepHook hook) override { m_soft->onSubstep(std::move(hook)); }
    void wake(BodyId body) override {
        if (!removed(body) && m_soft->freezeClock().frozen(at(body))) {
            m_soft->thaw(bodyAt(body));
        }
    }
    void onThreads(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& work) const override {
        m_soft->onThreads(count, grain, work);
    }
    bool keep(Archive& archive) override {
        keepColliders(archive);
        m_soft->keep(archive, bodies(), pieces());
        return true;
    }

private:
    void entered(Collider& body) override { m_soft->addBody(&body); }
    void pieceEntered(Collider& piece) override { m_soft->addPiece(&piece); }
    void aboutToLeave() override { m_soft->letGoOfLeaving(); }
    void left(Collider& collider) override { m_soft->forget(collider); }

    btSequentialImpulseConstraintSolver m_solver;
    SoftStepWorld* m_soft = nullptr;
};

/// Bullet as it comes.
class PlainWorld : public BulletWorld {
public:
    explicit PlainWorld(const WorldSettings& settings) : BulletWorld(settings) {
        auto world = std::make_unique<btDiscreteDynamicsWorld>(dispatcher(), broadphase(), &m_solver, configuration());
        world->setGravity(btVector3(0.0, 0.0, -settings.gravity));
        world->getSolverInfo().m_numIterations = settings.iterations;
        begin(std::move(world));
    }

    BodyState state(BodyId body) const override { return removed(body) ? BodyState::Removed : BodyState::Awake; }
    const ContactReport& contacts() const override { return m_report; }
    void onSubstep(SubstepHook) override {}
    void wake(BodyId body) override { bodyAt(body).object->activate(true); }

private:
    btSequentialImpulseConstraintSolver m_solver;
    ContactReport m_report;
};

}  // namespace

void RigidWorld::onThreads(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& work) const {
    for (std::size_t first = 0; first < count; first += grain) {
        work(first, std::min(first + grain, count));
    }
}

std::unique_ptr<RigidWorld> makeWorld(SolverKind solver, const WorldSettings& settings) {
    if (solver == SolverKind::SoftStep) {
        return std::make_unique<SoftWorld>(settings);
    }
    return std::make_unique<FreezingWorld>(settings);
}

std::unique_ptr<RigidWorld> makePlainBulletWorld(const WorldSettings& settings) {
    return std::make_unique<PlainWorld>(settings);
}

}  // namespace rubble
