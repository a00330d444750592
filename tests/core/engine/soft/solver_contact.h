#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/standard_gravity.h"
#include "core/engine/soft/soft_solver.h"

namespace rubble::scenes {

/// The k-th contact of a heap: one to four points.
inline SolverContact solverContact(std::pair<std::uint32_t, std::uint32_t> ends, std::uint32_t k) {
    SolverContact c;
    c.a = ends.first;
    c.b = ends.second;
    c.points = 1 + k % 4;
    return c;
}

/// What it asks of its bodies but for its points: friction 0.6, no limit.
/// @param h  s, length of a substep
inline ContactConstraint contactConstraint(const Vec3& normal, double h) {
    ContactConstraint c;
    c.normal = normal.normalized();
    c.tangent[0] = c.normal.unitOrthogonal();
    c.tangent[1] = c.normal.cross(c.tangent[0]);
    c.friction = 0.6;
    c.frequency = 30.0;
    c.sinkAllowed = 0.03;
    c.weight = standardGravity * h;
    c.impulseLimit = -1.0;
    return c;
}

/// A point of it anywhere on faces half a metre from both centres, a little open or in overlap, that carries something.
/// @param between  a random number between two
template <class Between>
SolverPoint solverPoint(const Between& between) {
    SolverPoint p;
    p.fromA = Vec3(between(-0.5, 0.5), between(-0.5, 0.5), 0.5);
    p.fromB = Vec3(between(-0.5, 0.5), between(-0.5, 0.5), -0.5);
    p.separation = between(-0.02, 0.005);
    p.impulses.normal = between(0.0, 0.05);
    p.impulses.tangent[0] = between(-0.01, 0.01);
    return p;
}

/// The constraints of a solver's contacts, from step to step.
struct SolverConstraints {
    std::vector<ContactConstraint> made;   ///< [contacts]
    std::vector<ContactOutcome> outcomes;  ///< likewise, of the latest step

    SoftSolver::Source source() {
        return {.make = [this](std::uint32_t k, ContactConstraint& c) { c = made[k]; }};
    }
    /// What the step left becomes what the next one begins with.
    void takeBack(const SoftSolver& solver) {
        outcomes.resize(made.size());
        solver.takeBack([&](std::uint32_t k, const ContactOutcome& outcome) {
            outcomes[k] = outcome;
            for (std::uint32_t n = 0; n < solver.contacts[k].points; ++n) {
                made[k].points[n].impulses = outcome.points[n];
            }
        });
    }
};

}  // namespace rubble::scenes
