#include "core/engine/soft/hooked_bodies.h"

namespace rubble {

void HookedBodies::prepare(const SoftBodies& bodies, const SoftSolver& solver, WorkerPool& pool) {
    m_moving.resize(bodies.awake.size());
    m_slotOf.assign(bodies.bodies.size(), -1);
    pool.loop(m_moving.size(), 128, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const SoftBody& body = bodies.bodies[bodies.awake[i]];
            m_slotOf[bodies.awake[i]] = static_cast<std::int32_t>(i);
            MovingBody& hooked = m_moving[i];
            hooked.id = idAt<BodyId>(bodies.awake[i]);
            hooked.inverseMass = solver.bodies[i].inverseMass;
            hooked.inertia = body.inertia;
            hooked.inverseInertia = solver.bodies[i].inverseInertia;
            hooked.box = body.collider->box;
            hooked.volume = body.collider->volume;
        }
    });
}

void HookedBodies::run(const SubstepHook& hook, const SoftBodies& bodies, SoftSolver& solver, WorkerPool& pool, double h) {
    pool.loop(m_moving.size(), 256, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const SolverMotion now = solver.motion(i);
            m_moving[i].position = now.pose.position;
            m_moving[i].orientation = now.pose.orientation;
            m_moving[i].velocity = now.velocity;
            m_moving[i].spin = now.spin;
        }
    });
    hook({m_moving, m_slotOf, &pool}, h);
    pool.loop(m_moving.size(), 256, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            if (!isNumber(m_moving[i])) {
                bodies.bodies[bodies.awake[i]].collider->broken = true;
                continue;
            }
            solver.setVelocity(i, m_moving[i].velocity, m_moving[i].spin);
        }
    });
}

}  // namespace rubble
