#include "core/engine/bullet/bullet_world.h"

#include <algorithm>

#include "core/engine/bullet/fragment_world.h"
#include "core/engine/soft/soft_step_world.h"
#include "core/engine/world/constants.h"
#include "core/engine/world/rigid_state.h"
#include "core/engine/world/terrain_shape.h"

namespace rubble {

namespace {

constexpr int groundGroup = 1;
constexpr int bodyGroup = 2;
constexpr int pieceGroup = 4;

const PairProperties& pairOf(const btCollisionObject* a, const btCollisionObject* b) {
    const BulletCollider& first = colliderOf(a);
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

BulletWorld::BulletWorld(const WorldSettings& settings) : SceneWorld(settings), m_dispatcher(&m_configuration, settings.cancelled) {
    combineByPair();
}

BulletWorld::~BulletWorld() {
    const auto takeOut = [this](const BulletCollider& collider) {
        if (collider.object && collider.object->getBroadphaseProxy() != nullptr) {
            m_world->removeRigidBody(collider.object.get());
        }
    };
    for (const auto* list : {&m_bodies, &m_pieces}) {
        for (const auto& collider : *list) {
            takeOut(bulletCollider(*collider));
        }
    }
    if (m_ground) {
        takeOut(*m_ground);
    }
}

void BulletWorld::begin(std::unique_ptr<btDiscreteDynamicsWorld> world) {
    m_world = std::move(world);
    if (m_settings.ground || m_settings.terrain) {
        addGround();
    }
}

/// The object of a body or piece.
void BulletWorld::embody(BulletCollider& collider, const Pose& place) {
    collider.shape = makeBulletShape(collider.parts);
    btRigidBody::btRigidBodyConstructionInfo info(collider.mass, nullptr, collider.shape.shape.get(), toBullet(collider.inertia));
    info.m_startWorldTransform = toBullet(place);
    collider.object = std::make_unique<btRigidBody>(info);
}

/// @param partners  groups that it collides with
void BulletWorld::insert(BulletCollider& collider, int group, int partners) {
    collider.pairs = &m_settings.pairs;
    collider.object->setUserPointer(&collider);
    collider.object->setFlags(0);
    m_world->addRigidBody(collider.object.get(), group, partners);
}

void BulletWorld::addGround() {
    const double span = m_settings.reach.isEmpty() ? 0.0 : m_settings.reach.sizes().maxCoeff();
    const Vec3 centre = m_settings.reach.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(m_settings.reach.center());
    double reach = std::max(groundMargin + span, 10.0 * span);
    if (m_settings.terrain) {
        const TerrainGrid& terrain = *m_settings.terrain;
        const double width = terrain.cell() * static_cast<double>(terrain.nx() - 1);
        const double depth = terrain.cell() * static_cast<double>(terrain.ny() - 1);
        reach = span + std::max({reach - span, centre.x() - terrain.x0(), terrain.x0() + width - centre.x(),
                                 centre.y() - terrain.y0(), terrain.y0() + depth - centre.y()});
    }
    m_ground = std::make_unique<BulletCollider>();
    BulletCollider& ground = *m_ground;
    ground.kind = ColliderKind::Ground;
    ground.material = m_settings.groundMaterial;
    ground.parts.emplace_back().box.halfExtents = Vec3(reach, reach, groundHalfThickness);
    ground.shape = makeBulletShape(ground.parts);
    double middle = m_settings.groundHeight - groundHalfThickness;
    if (m_settings.terrain) {
        auto terrain =
            std::make_unique<TerrainShape>(SiteSurface{m_settings.ground, m_settings.groundHeight, m_settings.terrain}, reach);
        middle = terrain->middle();
        ground.shape.shape = std::move(terrain);
    }
    ground.object = std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(0.0, nullptr, ground.shape.shape.get()));
    ground.object->setWorldTransform(toBullet(Pose{Vec3(centre.x(), centre.y(), middle), Quat::Identity()}));
    insert(ground, groundGroup, bodyGroup);
}

void BulletWorld::bodyEntered(Collider& collider, const NewBody& body) {
    embody(bulletCollider(collider), body.pose);
    btRigidBody& object = objectOf(collider);
    object.setLinearVelocity(toBullet(body.velocity));
    object.setAngularVelocity(toBullet(body.angularVelocity));
    insert(bulletCollider(collider), bodyGroup, groundGroup | pieceGroup | (m_settings.bodyContacts ? bodyGroup : 0));
}

void BulletWorld::pieceEntered(Collider& collider, const Pose& pose) {
    embody(bulletCollider(collider), pose);
    btRigidBody& object = objectOf(collider);
    object.setCollisionFlags(object.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    object.setActivationState(DISABLE_DEACTIVATION);
    insert(bulletCollider(collider), pieceGroup, bodyGroup);
}

void BulletWorld::left(Collider& collider) {
    m_world->removeRigidBody(&objectOf(collider));
    if (collider.kind == ColliderKind::Piece) {
        bulletCollider(collider).object.reset();
        bulletCollider(collider).shape = {};
    }
}

void BulletWorld::movePiece(PieceId piece, const Pose& atStepEnd) {
    // Bullet takes the piece's velocity from the two transforms; the interpolation transform must stay where the piece was.
    objectOf(pieceAt(piece)).forceActivationState(DISABLE_DEACTIVATION);
    objectOf(pieceAt(piece)).setWorldTransform(toBullet(atStepEnd));
    pieceAt(piece).moving = true;
}

void BulletWorld::stoodStill(Collider& piece) {
    if (objectOf(piece).getActivationState() == DISABLE_DEACTIVATION) {
        // Its velocity is zero by now, and it may be skipped until it moves again.
        objectOf(piece).forceActivationState(ISLAND_SLEEPING);
    }
}

void BulletWorld::advance(double dt) {
    m_world->stepSimulation(dt, 0);
    if (m_ground) {
        m_ground->newborn = false;
    }
}

BodyMotion BulletWorld::motionOf(const Collider& body) const {
    return rigidState(objectOf(body)).motion();
}

double BulletWorld::kineticEnergy(BodyId body) const {
    return rigidState(objectOf(bodyAt(body))).kineticEnergy();
}

Momenta BulletWorld::momenta(BodyId body) const {
    return removed(body) ? Momenta{} : rigidState(objectOf(bodyAt(body))).momenta();
}

namespace {

/// Bullet with rest offsets, freeze, limits and its stock solver.
class FreezingWorld : public BulletWorld {
public:
    explicit FreezingWorld(const WorldSettings& settings) : BulletWorld(settings) {
        auto world = std::make_unique<FragmentWorld>(dispatcher(), broadphase(), &m_solver, configuration(), m_settings,
                                                     FragmentWorld::Scene{m_sleep, m_report, m_hook});
        m_fragments = world.get();
        begin(std::move(world));
    }

private:
    void bodyEntered(Collider& collider, const NewBody& body) override {
        BulletWorld::bodyEntered(collider, body);
        m_fragments->addBody(bulletCollider(collider));
    }
    void aboutToLeave() override { m_fragments->thawNeighboursOfLeaving(); }
    void left(Collider& collider) override {
        BulletWorld::left(collider);
        if (collider.kind == ColliderKind::Body) {
            m_fragments->forget(collider.index);
        }
    }
    void thaw(Collider& body) override { m_fragments->thaw(bulletCollider(body)); }

    FragmentSolver m_solver;
    FragmentWorld* m_fragments = nullptr;
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
    void onSubstep(SubstepHook) override {}
    void wake(BodyId body) override { thaw(bodyAt(body)); }

private:
    void thaw(Collider& body) override { objectOf(body).activate(true); }

    btSequentialImpulseConstraintSolver m_solver;
};

}  // namespace

void RigidWorld::onThreads(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& work) const {
    for (std::size_t first = 0; first < count; first += grain) {
        work(first, std::min(first + grain, count));
    }
}

std::unique_ptr<RigidWorld> makeWorld(SolverKind solver, const WorldSettings& settings) {
    if (solver == SolverKind::SoftStep) {
        return std::make_unique<SoftStepWorld>(settings);
    }
    return std::make_unique<FreezingWorld>(settings);
}

std::unique_ptr<RigidWorld> makePlainBulletWorld(const WorldSettings& settings) {
    return std::make_unique<PlainWorld>(settings);
}

}  // namespace rubble
