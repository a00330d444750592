#pragma once

#include <utility>

#include "core/base/standard_gravity.h"
#include "core/simulation/soft_solver.h"

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

}  // namespace rubble::scenes
