#pragma once

#include <btBulletDynamicsCommon.h>

#include "core/engine/world/rigid_world.h"

namespace rubble {

/// A body as both engines account for it: with its axes as a matrix, so that every engine gives results the same bits.
struct RigidState {
    btTransform place;
    btVector3 velocity, spin;  ///< m/s, rad/s, world axes
    btVector3 inverseInertia;  ///< 1/(kg m2), principal
    double inverseMass = 0.0;  ///< 1/kg

    double mass() const { return inverseMass == 0.0 ? 0.0 : 1.0 / inverseMass; }
    BodyMotion motion() const;
    double kineticEnergy() const;
    Momenta momenta() const;
};

RigidState rigidState(const btRigidBody& body);

}  // namespace rubble
