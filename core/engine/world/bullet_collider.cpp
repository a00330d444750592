#include "core/engine/world/bullet_collider.h"

namespace rubble {

MovingBody movingBody(const BulletCollider& collider) {
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
