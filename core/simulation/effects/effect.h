#pragma once

#include <span>
#include <vector>

#include "core/simulation/rigid_world.h"
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
    /// J, done on bodies so far; negative where the effect takes energy.
    virtual double work() const { return 0.0; }
};

}  // namespace rubble
