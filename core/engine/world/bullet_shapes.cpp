// Bullet's box hands out planes through a vector that the compiler cannot see being filled.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

#include "core/engine/world/bullet_shapes.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <LinearMath/btConvexHullComputer.h>

#include <algorithm>
#include <utility>

#include "core/engine/world/terrain_shape.h"

namespace rubble {

namespace {

/// User index that marks an OffsetBox among the shapes.
constexpr int offsetBoxMark = 1;
/// Pairs between two questions whether to stop.
constexpr int pairsPerQuestion = 1024;

std::unique_ptr<btCollisionShape> makeHull(const std::vector<Vec3>& points, double margin) {
    // The margin lies around what is drawn in by it.
    const std::vector<Vec3> drawnIn = margin > 0.0 ? hullVertices(points, margin) : points;
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Vec3& p : drawnIn.empty() ? points : drawnIn) {
        hull->addPoint(toBullet(p), false);
    }
    hull->setMargin(margin);
    hull->recalcLocalAabb();
    return hull;
}

}  // namespace

btTransform toBullet(const Pose& pose) {
    const Quat& q = pose.orientation;
    return btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), toBullet(pose.position));
}

Pose fromBullet(const btTransform& transform) {
    const btQuaternion q = transform.getRotation();
    return {fromBullet(transform.getOrigin()), Quat(q.w(), q.x(), q.y(), q.z()).normalized()};
}

std::vector<Vec3> hullVertices(std::span<const Vec3> points, double shrink) {
    std::vector<double> coordinates;
    for (const Vec3& p : points) {
        coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
    }
    btConvexHullComputer hull;
    const btScalar done = hull.compute(coordinates.data(), 3 * sizeof(double), static_cast<int>(points.size()), shrink, 0.5);
    std::vector<Vec3> vertices;
    if (done >= 0.0) {
        for (int i = 0; i < hull.vertices.size(); ++i) {
            vertices.emplace_back(hull.vertices[i].x(), hull.vertices[i].y(), hull.vertices[i].z());
        }
    }
    return vertices;
}

OffsetBox::OffsetBox(const OrientedBox& box)
    : btBoxShape(toBullet(box.halfExtents)),
      m_box(toBullet(box.halfExtents)),
      m_offset(toBullet(Pose{box.centre, box.orientation})) {
    setUserIndex(offsetBoxMark);
}

void OffsetBox::getAabb(const btTransform& body, btVector3& low, btVector3& high) const {
    m_box.getAabb(body * m_offset, low, high);
}

OwnedShape makeBulletShape(const CollisionShape& parts) {
    OwnedShape made;
    if (parts.size() == 1) {
        const ConvexPart& part = parts.front();
        made.shape = part.points.empty() ? std::make_unique<OffsetBox>(part.box) : makeHull(part.points, part.margin);
        return made;
    }
    auto compound = std::make_unique<btCompoundShape>(true, static_cast<int>(parts.size()));
    for (const ConvexPart& part : parts) {
        if (part.points.empty()) {
            made.parts.push_back(std::make_unique<btBoxShape>(toBullet(part.box.halfExtents)));
            compound->addChildShape(toBullet(Pose{part.box.centre, part.box.orientation}), made.parts.back().get());
        } else {
            made.parts.push_back(makeHull(part.points, part.margin));
            compound->addChildShape(btTransform::getIdentity(), made.parts.back().get());
        }
    }
    made.shape = std::move(compound);
    return made;
}

FragmentDispatcher::FragmentDispatcher(btCollisionConfiguration* configuration, std::function<bool()> cancelled)
    : btCollisionDispatcher(configuration), m_cancelled(std::move(cancelled)) {
    setNearCallback(collide);
}

void FragmentDispatcher::collide(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
    auto& self = static_cast<FragmentDispatcher&>(dispatcher);
    if (--self.m_untilAsked < 0) {
        self.m_untilAsked = pairsPerQuestion;
        self.m_stopped = self.m_stopped || (self.m_cancelled && self.m_cancelled());
    }
    const auto* a = static_cast<const btCollisionObject*>(pair.m_pProxy0->m_clientObject);
    const auto* b = static_cast<const btCollisionObject*>(pair.m_pProxy1->m_clientObject);
    if (self.m_stopped || !dispatcher.needsCollision(a, b)) {
        return;
    }
    const auto place = [](const btCollisionObject* object) {
        const btCollisionShape* shape = object->getCollisionShape();
        if (shape->getUserIndex() != offsetBoxMark) {
            return std::pair{shape, object->getWorldTransform()};
        }
        const auto* box = static_cast<const OffsetBox*>(shape);
        return std::pair{static_cast<const btCollisionShape*>(&box->box()), object->getWorldTransform() * box->offset()};
    };
    const auto [shapeA, transformA] = place(a);
    const auto [shapeB, transformB] = place(b);
    const btCollisionObjectWrapper wrapA(nullptr, shapeA, a, transformA, -1, -1);
    const btCollisionObjectWrapper wrapB(nullptr, shapeB, b, transformB, -1, -1);
    if (pair.m_algorithm == nullptr) {
        const bool terrain = TerrainShape::of(a) != nullptr || TerrainShape::of(b) != nullptr;
        pair.m_algorithm = terrain ? makeTerrainAlgorithm(dispatcher, wrapA, wrapB)
                                   : dispatcher.findAlgorithm(&wrapA, &wrapB, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    }
    if (pair.m_algorithm != nullptr) {
        btManifoldResult result(&wrapA, &wrapB);
        pair.m_algorithm->processCollision(&wrapA, &wrapB, info, &result);
    }
}

}  // namespace rubble
