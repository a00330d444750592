#pragma once

#include <cstdint>
#include <span>

#include "core/base/geometry.h"

namespace rubble {

/// A solid that moves: what clustering needs to know of a fragment, and what a cluster is to the engine.
struct MovingMass {
    double mass = 0.0;                    ///< kg
    Vec3 centre = Vec3::Zero();           ///< m
    Mat3 inertia = Mat3::Zero();          ///< kg m2 about the centre, world axes
    Vec3 velocity = Vec3::Zero();         ///< m/s of the centre
    Vec3 angularVelocity = Vec3::Zero();  ///< rad/s
};

/// The members as one rigid body with their mass, momentum and angular momentum: velocity P / M, angular velocity I^-1 L about the
/// common centre of mass. A single member is returned as it is. Where the inertia is singular (no extent about an axis) the
/// angular velocity about that axis is zero; members without any mass count alike.
MovingMass joinRigidly(std::span<const MovingMass> all, std::span<const std::uint32_t> members);

/// How far the velocity of a member's centre departs from the motion of a body [m/s].
double velocityMisfit(const MovingMass& body, const MovingMass& member);

}  // namespace rubble
