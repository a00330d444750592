#pragma once

#include <span>

#include "core/engine/soft/soft_solver.h"

namespace rubble {

/// Gives back the speed of approach of what hit faster than `threshold` [m/s], after the substeps; over the whole step a contact
/// never pulls. It also takes what the last substep left of a hit that began in it.
/// @param points    those of the contact, at most four
/// @param friction  the impulses given here rub by Coulomb's law, as those of the substeps do; else they act along the normal alone
void restituteContact(const SolverContact& contact, std::span<SolverPoint> points, SolverBody& a, SolverBody& b, double threshold,
                      bool friction);

}  // namespace rubble
