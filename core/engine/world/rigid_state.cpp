#include "core/engine/world/rigid_state.h"

#include "core/engine/world/bullet_shapes.h"

namespace rubble {

RigidState rigidState(const btRigidBody& body) {
    return {body.getWorldTransform(), body.getLinearVelocity(), body.getAngularVelocity(), body.getInvInertiaDiagLocal(),
            body.getInvMass()};
}

BodyMotion RigidState::motion() const {
    return {fromBullet(place), fromBullet(velocity), fromBullet(spin)};
}

double RigidState::kineticEnergy() const {
    const btVector3 own = spin * place.getBasis();
    return 0.5 * (mass() * velocity.length2() + own.x() * own.x() / inverseInertia.x() + own.y() * own.y() / inverseInertia.y() +
                  own.z() * own.z() / inverseInertia.z());
}

Momenta RigidState::momenta() const {
    Mat3 axes;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
            axes(r, c) = place.getBasis()[r][c];
        }
    }
    const Vec3 diagonal(1.0 / inverseInertia.x(), 1.0 / inverseInertia.y(), 1.0 / inverseInertia.z());
    const Mat3 inertia = axes * diagonal.asDiagonal() * axes.transpose();
    return rigidMomenta(mass(), fromBullet(place.getOrigin()), inertia, fromBullet(velocity), fromBullet(spin));
}

}  // namespace rubble
