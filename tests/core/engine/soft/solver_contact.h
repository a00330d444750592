#pragma once

#include <utility>

#include "core/base/standard_gravity.h"
#include "core/engine/soft/soft_solver.h"

namespace rubble::scenes {

/// The k-th contact of a heap: one to four points from `firstPoint` on, friction 0.6, no limit.
/// @param h  s, length of a substep
inline SolverContact solverContact(std::pair<std::uint32_t, std::uint32_t> ends, std::uint32_t k, std::size_t firstPoint,
                                   const Vec3& normal, double h) {
    SolverContact c;
    c.a = ends.first;
    c.b = ends.second;
    c.firstPoint = static_cast<std::uint32_t>(firstPoint);
    c.points = 1 + k % 4;
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
    p.normalImpulse = between(0.0, 0.05);
    p.tangentImpulse[0] = between(-0.01, 0.01);
    return p;
}

}  // namespace rubble::scenes
