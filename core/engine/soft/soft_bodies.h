#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engine/world/collider.h"
#include "core/engine/world/sleep.h"

namespace rubble {

struct RigidState;

/// A body or piece of the soft-step world: where it is and how it moves. While substeps run, the solver has it.
struct SoftBody {
    Collider* collider = nullptr;  ///< null once gone
    Pose pose;
    Vec3 velocity = Vec3::Zero();  ///< m/s
    Vec3 spin = Vec3::Zero();      ///< rad/s, world axes
    Vec3 inertia = Vec3::Ones();   ///< kg m2, principal
    double inverseMass = 0.0;      ///< 1/kg
    std::int32_t slot = -1;        ///< among the solver's bodies in this step; -1: immovable and still
    int drivers = 0;               ///< moving pieces that press on it in this step
    bool active = false;           ///< a contact acted on it in this step
    bool supported = false;        ///< it stood, in the step before, on something immovable or supported

    /// m/s that its farthest corner moves at, at most.
    double speed() const { return velocity.norm() + spin.norm() * collider->radius; }
    RigidState state(const Collider& of) const;
    /// What outlasts a step and does not follow from the collider.
    void keep(Archive& archive) { archive(pose, velocity, spin, inertia, inverseMass, active, supported); }
};

/// Bodies and pieces, and the slots that the solver has for those that move in this step: awake bodies, then moving pieces, then
/// one for all that is still.
struct SoftBodies {
    std::vector<SoftBody> bodies;         ///< [bodies]
    std::vector<SoftBody> pieces;         ///< [pieces]
    std::vector<Pose> goals;              ///< [pieces] where each is at the end of the step in which it moves
    std::vector<std::uint32_t> standing;  ///< pieces that are there, in order of entry
    std::vector<std::uint32_t> awake;     ///< body of each slot, in order of entry
    std::vector<std::uint32_t> moving;    ///< piece of each slot behind the bodies
    std::uint32_t stillSlot = 0;

    SoftBody& of(const Collider& c) { return c.kind == ColliderKind::Piece ? pieces[c.index] : bodies[c.index]; }
    const SoftBody& of(const Collider& c) const { return c.kind == ColliderKind::Piece ? pieces[c.index] : bodies[c.index]; }
    /// The slot of a body, a piece or the ground.
    std::uint32_t slotOf(const Collider& c) const;
    /// A body that enters, or a piece that stands still.
    SoftBody& add(Collider& collider, const Pose& pose);
    /// Takes the slots of the step before back.
    void clearSlots();
    /// Gives slots to the bodies that are awake, in the order of entry, whoever woke late.
    /// @param still  [bodies] frozen or gone
    void listAwake(const std::vector<char>& still);
    /// Gives slots to the pieces that move.
    void listMoving();
    /// @param held, heldPieces  bodies and pieces that ever entered, in order
    void keep(Archive& archive, std::span<const std::unique_ptr<Collider>> held,
              std::span<const std::unique_ptr<Collider>> heldPieces);
};

/// A pose as results have it: with its axes as a matrix and back, so that its quaternion is the usual one of the two.
Pose throughAxes(const Pose& pose);

}  // namespace rubble
