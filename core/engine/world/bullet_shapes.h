#pragma once

#include <btBulletCollisionCommon.h>

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/engine/world/rigid_world.h"

namespace rubble {

inline btVector3 toBullet(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}
inline Vec3 fromBullet(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}
btTransform toBullet(const Pose& pose);
Pose fromBullet(const btTransform& transform);

/// Vertices of the hull of points, each face drawn in by `shrink` [m]; none where it has no volume.
std::vector<Vec3> hullVertices(std::span<const Vec3> points, double shrink);

/// A box that does not lie about the origin of its body. Bullet knows such a box only as a compound, which costs several times as
/// much; here the near callback hands the detector a plain box at the place where it lies.
class OffsetBox : public btBoxShape {
public:
    explicit OffsetBox(const OrientedBox& box);
    void getAabb(const btTransform& body, btVector3& low, btVector3& high) const override;
    const btBoxShape& box() const { return m_box; }
    const btTransform& offset() const { return m_offset; }

private:
    btBoxShape m_box;
    btTransform m_offset;
};

/// A collision shape and the parts that it does not own itself.
struct OwnedShape {
    std::vector<std::unique_ptr<btCollisionShape>> parts;
    std::unique_ptr<btCollisionShape> shape;
};
OwnedShape makeBulletShape(const CollisionShape& parts);

/// Runs the narrow phase pair by pair, offset boxes included, and stops early when told to.
class FragmentDispatcher : public btCollisionDispatcher {
public:
    FragmentDispatcher(btCollisionConfiguration* configuration, std::function<bool()> cancelled);
    bool stopped() const { return m_stopped; }

private:
    static void collide(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info);
    std::function<bool()> m_cancelled;
    int m_untilAsked = 0;
    bool m_stopped = false;
};

}  // namespace rubble
