#pragma once

#include "core/base/geometry.h"
#include "core/fragments/consistent_mass.h"
#include "core/fragments/fragment_set.h"

namespace rubble {

/// The rigid body that comes nearest to a moving solid, in the metric of its consistent mass, and the momenta it stands for.
struct RigidFit {
    Vec3 centre = Vec3::Zero();           ///< m, of mass
    Mat3 inertia = Mat3::Zero();          ///< kg m2 about the centre, world axes
    Vec3 velocity = Vec3::Zero();         ///< m/s of the centre
    Vec3 angularVelocity = Vec3::Zero();  ///< rad/s
    Momenta field;                        ///< of the corner velocity field itself, by quadrature
};

/// Fits a rigid motion by least squares in the consistent mass: velocity = momentum / mass, angular velocity = I^-1 L about the
/// centre with I from the same integral, so that both momenta are kept and kinetic energy can only be lost. The second moments of
/// mass are raised to those of a box of the given least half extent; where even that leaves nothing to turn against, the
/// pseudo-inverse leaves that axis without spin.
/// @param mass             consistentMass() of the positions, kg
/// @param positions        m, as asHexahedron() gives them
/// @param velocities       m/s, likewise
/// @param leastHalfExtent  m, of the mass distribution along each principal axis; 0 for none
RigidFit fitRigidMotion(const ConsistentMass& mass, const Corners& positions, const Corners& velocities, double leastHalfExtent);

}  // namespace rubble
