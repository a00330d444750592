#pragma once

#include <vector>

#include "core/engine/soft/soft_bodies.h"
#include "core/engine/soft/soft_solver.h"
#include "core/engine/world/moving_body.h"

namespace rubble {

/// The bodies of a step as the caller's hook sees them in each substep.
class HookedBodies {
public:
    /// Makes them at the start of the step, but for how they move.
    void prepare(const SoftBodies& bodies, const SoftSolver& solver, WorkerPool& pool);
    /// Runs the hook on them and gives the solver their new velocities.
    /// @param h  s, length of the substep
    void run(const SubstepHook& hook, const SoftBodies& bodies, SoftSolver& solver, WorkerPool& pool, double h);

private:
    std::vector<MovingBody> m_moving;
    std::vector<std::int32_t> m_slotOf;
};

}  // namespace rubble
