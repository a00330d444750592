#include "core/engine/world/terrain_shape.h"

#include <BulletCollision/CollisionDispatch/btConvexConcaveCollisionAlgorithm.h>

#include <vector>

#include "core/engine/world/bullet_collider.h"
#include "core/engine/world/constants.h"
#include "core/engine/world/ground_contact.h"

namespace rubble {

namespace {

constexpr int terrainMark = 2;

class TerrainAlgorithm : public btActivatingCollisionAlgorithm {
public:
    TerrainAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper& a,
                     const btCollisionObjectWrapper& b)
        : btActivatingCollisionAlgorithm(info, &a, &b),
          m_manifold(info.m_dispatcher1->getNewManifold(a.getCollisionObject(), b.getCollisionObject())) {}
    ~TerrainAlgorithm() override { m_dispatcher->releaseManifold(m_manifold); }

    void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b, const btDispatcherInfo& info,
                          btManifoldResult* result) override {
        const bool groundFirst = TerrainShape::of(a->getCollisionObject()) != nullptr;
        const TerrainShape& terrain = *TerrainShape::of((groundFirst ? a : b)->getCollisionObject());
        const BulletCollider& body = colliderOf((groundFirst ? b : a)->getCollisionObject());
        const Pose pose = fromBullet(body.object->getWorldTransform());
        const Vec3 velocity = fromBullet(body.object->getLinearVelocity());
        std::vector<ContactPatch> patches;
        for (const ConvexPart& part : body.parts) {
            collideGround(terrain.surface(), part, pose, velocity, info.m_timeStep, m_manifold->getContactBreakingThreshold(),
                          patches);
        }
        result->setPersistentManifold(m_manifold);
        // All points are found anew; those of the step before are met again by their place on the body and keep their impulse.
        for (const ContactPatch& patch : patches) {
            for (int i = 0; i < patch.count; ++i) {
                const PatchPoint& point = patch.points[static_cast<std::size_t>(i)];
                const Vec3 half = 0.5 * point.separation * patch.normal;
                const Vec3 normalOnB = groundFirst ? Vec3(-patch.normal) : patch.normal;
                const Vec3 onB = groundFirst ? Vec3(point.position + half) : Vec3(point.position - half);
                result->addContactPoint(toBullet(normalOnB), toBullet(onB), point.separation);
            }
        }
        result->refreshContactPoints();
    }
    btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&, btManifoldResult*) override {
        return 1.0;
    }
    void getAllContactManifolds(btManifoldArray& manifolds) override { manifolds.push_back(m_manifold); }

private:
    btPersistentManifold* m_manifold;
};

}  // namespace

TerrainShape::TerrainShape(const SiteSurface& surface, double reach)
    : btBoxShape(btVector3(reach, reach, groundHalfThickness + 0.5 * (surface.terrain->highest() - surface.terrain->lowest()))),
      m_surface(surface) {
    setUserIndex(terrainMark);
}

double TerrainShape::middle() const {
    return m_surface.terrain->highest() - getHalfExtentsWithMargin().z();
}

const TerrainShape* TerrainShape::of(const btCollisionObject* object) {
    const btCollisionShape* shape = object->getCollisionShape();
    return shape->getUserIndex() == terrainMark ? static_cast<const TerrainShape*>(shape) : nullptr;
}

btCollisionAlgorithm* makeTerrainAlgorithm(btDispatcher& dispatcher, const btCollisionObjectWrapper& a,
                                           const btCollisionObjectWrapper& b) {
    btCollisionAlgorithmConstructionInfo info(&dispatcher, BT_CONTACT_POINT_ALGORITHMS);
    // Bullet's pool has room for the algorithms it knows; this one is no larger than they are.
    static_assert(sizeof(TerrainAlgorithm) <= sizeof(btConvexConcaveCollisionAlgorithm));
    return new (dispatcher.allocateCollisionAlgorithm(sizeof(TerrainAlgorithm))) TerrainAlgorithm(info, a, b);
}

}  // namespace rubble
