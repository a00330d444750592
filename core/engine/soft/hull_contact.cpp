#include "core/engine/soft/hull_contact.h"

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btPolyhedralContactClipping.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <vector>

#include "core/engine/world/bullet_shapes.h"

namespace rubble {

namespace {

/// Takes what the clipping finds.
class Collector : public btDiscreteCollisionDetectorInterface::Result {
public:
    struct Point {
        btVector3 onB;
        double separation = 0.0;
    };
    void setShapeIdentifiersA(int, int) override {}
    void setShapeIdentifiersB(int, int) override {}
    void addContactPoint(const btVector3&, const btVector3& onB, btScalar separation) override {
        points.push_back({onB, separation});
    }
    std::vector<Point> points;
};

}  // namespace

ContactPatch collideHulls(const btPolyhedralConvexShape& a, const btTransform& placeA, const btPolyhedralConvexShape& b,
                          const btTransform& placeB, double margin) {
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver penetration;
    btGjkPairDetector detector(&a, &b, &simplex, &penetration);
    btDiscreteCollisionDetectorInterface::ClosestPointInput input;
    const double reach = margin + a.getMargin() + b.getMargin();
    input.m_maximumDistanceSquared = reach * reach;
    input.m_transformA = placeA;
    input.m_transformB = placeB;
    btPointCollector closest;
    detector.getClosestPoints(input, closest, nullptr);
    ContactPatch patch;
    if (!closest.m_hasResult || closest.m_distance > margin) {
        return patch;
    }
    // Bullet's normal points from B to A.
    patch.normal = -fromBullet(closest.m_normalOnBInWorld);
    patch.separation = closest.m_distance;
    Collector clipped;
    btVertexArray world1, world2;
    btPolyhedralContactClipping::clipHullAgainstHull(closest.m_normalOnBInWorld, *a.getConvexPolyhedron(), *b.getConvexPolyhedron(),
                                                     placeA, placeB, closest.m_distance - reach, margin, world1, world2, clipped);
    const Vec3 n = patch.normal;
    const Vec3 off = std::abs(n.x()) < 0.57735 ? Vec3(0.0, n.z(), -n.y()) : Vec3(n.y(), -n.x(), 0.0);
    const Vec3 u = off.normalized();
    const Vec3 v = n.cross(u);
    std::vector<PlanePoint> points;
    for (std::size_t i = 0; i < clipped.points.size(); ++i) {
        const Vec3 p = fromBullet(clipped.points[i].onB);
        points.push_back({u.dot(p), v.dot(p), clipped.points[i].separation, static_cast<std::uint32_t>(i)});
    }
    patch.count = reduceToFour(points);
    for (int i = 0; i < patch.count; ++i) {
        const PlanePoint& p = points[static_cast<std::size_t>(i)];
        const Vec3 onB = fromBullet(clipped.points[p.feature].onB);
        patch.points[static_cast<std::size_t>(i)] = {onB - 0.5 * p.height * n, p.height, p.feature};
    }
    if (patch.count == 0) {
        patch.count = 1;
        patch.points[0] = {fromBullet(closest.m_pointInWorld) - 0.5 * closest.m_distance * n, closest.m_distance, 0};
    }
    return patch;
}

}  // namespace rubble
