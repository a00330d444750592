#include "core/simulation/collider.h"

#include "core/simulation/value_archive.h"

namespace rubble {

void Collider::keep(Archive& archive) {
    archive(number, newborn, moving, pushed, bornBelow, leaving, overlapping, justThawed, broken, touched, material, birthDepth,
            penetration, overlapLeft, lifted, smallestSide, volume, mass, inertia, parts);
}

OrientedBox boxAround(const CollisionShape& parts) {
    if (parts.size() == 1) {
        return parts.front().box;
    }
    Aabb bounds;
    for (const ConvexPart& part : parts) {
        const Mat3 axes = part.box.orientation.toRotationMatrix();
        const Vec3 reach = axes.cwiseAbs() * part.box.halfExtents;
        bounds.extend(part.box.centre - reach);
        bounds.extend(part.box.centre + reach);
    }
    OrientedBox box;
    if (!bounds.isEmpty()) {
        box.centre = bounds.center();
        box.halfExtents = 0.5 * bounds.sizes();
    }
    return box;
}

MovingBody movingBody(const Collider& collider) {
    const btRigidBody& object = *collider.object;
    MovingBody body;
    body.id = idAt<BodyId>(collider.index);
    const Pose pose = fromBullet(object.getWorldTransform());
    body.position = pose.position;
    body.orientation = pose.orientation;
    body.velocity = fromBullet(object.getLinearVelocity());
    body.spin = fromBullet(object.getAngularVelocity());
    body.inverseMass = object.getInvMass();
    const Vec3 inverse = fromBullet(object.getInvInertiaDiagLocal());
    body.inertia = inverse.cwiseInverse();
    const Mat3 axes = pose.orientation.toRotationMatrix();
    body.inverseInertia = axes * inverse.asDiagonal() * axes.transpose();
    body.box = collider.box;
    body.volume = collider.volume;
    return body;
}

}  // namespace rubble
