#pragma once

#include <span>

#include "core/engine/soft/soft_solver.h"

namespace rubble {

/// A point of a contact that may bounce.
struct BouncePoint {
    Vec3 fromA = Vec3::Zero(), fromB = Vec3::Zero();  ///< m, from the centres of mass, at the start of the step
    double normalMass = 0.0;                          ///< kg
    double approachSpeed = 0.0;                       ///< m/s at the start of the step, positive when closing
    PointImpulses impulses;                           ///< of the substeps; the bounce adds to those along the normal
};

/// Gives back the speed of approach of what hit faster than `threshold` [m/s], after the substeps; over the whole step a contact
/// never pulls. It also takes what the last substep left of a hit that began in it.
/// @param points    those of the constraint
/// @param friction  the impulses given here rub by Coulomb's law, as those of the substeps do; else they act along the normal alone
void restituteContact(const ContactConstraint& contact, std::span<BouncePoint> points, SolverBody& a, SolverBody& b,
                      double threshold, bool friction);

}  // namespace rubble
