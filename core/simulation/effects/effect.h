#pragma once

#include <span>
#include <vector>

#include "core/engine/world/rigid_world.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// One optional part of the physics while a run goes on. An effect that is off does not exist.
class Effect {
public:
    virtual ~Effect() = default;
    virtual EffectKind kind() const = 0;
    /// Bodies have entered the world (at a hand-over, or in the place of others).
    virtual void entered(std::span<const BodyRecord>, RigidWorld&) {}
    /// A body is about to leave the world.
    virtual void leaving(BodyId) {}
    /// Before each substep of h [s]: may change the velocities of the bodies that move.
    virtual void beforeSubstep(const SubstepBodies&, double /*h*/) {}
    /// After each step of dt [s]: may wake bodies.
    virtual void afterStep(RigidWorld&, double /*dt*/) {}
    /// J, done on bodies so far; negative where the effect takes energy.
    virtual double work() const { return 0.0; }
    /// Ties broken, clusters broken up.
    virtual std::int64_t events() const { return 0; }
    /// What it carries from step to step, out or in.
    virtual void keep(Archive& archive) = 0;
};

/// J, of a body as a substep sees it.
inline double kineticEnergy(const MovingBody& body) {
    const Vec3 spin = body.orientation.conjugate() * body.spin;
    const double turning = 0.5 * body.inertia.dot(spin.cwiseProduct(spin));
    return body.inverseMass > 0.0 ? turning + 0.5 * body.velocity.squaredNorm() / body.inverseMass : turning;
}

}  // namespace rubble
