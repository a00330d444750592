#pragma once

#include <cstdint>

#include "core/base/geometry.h"

namespace rubble {

/// Where one fragment went.
struct FragmentOutcome {
    Vec3 birthPosition = Vec3::Zero();  ///< m, at its birth time (on the trajectory)
    double birthSpeed = 0.0;            ///< m/s, then
    Vec3 finalPosition = Vec3::Zero();  ///< m, at the end
    double impactSpeed = 0.0;           ///< m/s, of its centre just before the hardest hit of its body; 0 if it never hit anything
};

/// Relative errors of what must be conserved at a hand-over, the largest over all hand-overs. Momentum is relative to sum(m |v|),
/// angular momentum to sum(|x| m |v|), of what is handed over.
struct LedgerErrors {
    double mass = 0.0;  ///< fragments against FE
    double momentum = 0.0;
    double angularMomentum = 0.0;
    double bodyMass = 0.0;  ///< engine, as read back, against FE
    double bodyMomentum = 0.0;
    double bodyAngularMomentum = 0.0;
};

/// Births in space that older bodies or pieces occupy already.
struct OccupiedBirths {
    std::int64_t births = 0;     ///< bodies that entered
    std::int64_t occupied = 0;   ///< of these, deeper than 5 % of their own smallest side inside another body or piece
    std::int64_t joined = 0;     ///< of the occupied ones: inside nothing but what they share nodes of the mesh with
    double medianDepth = 0.0;    ///< of the occupied ones: depth over the own smallest side
    std::int64_t left = 0;       ///< bodies that at the end still lie deeper than 5 % of their smallest side in others from birth
    double work = 0.0;           ///< J, done by resolving all overlap at birth
    double piecePushWork = 0.0;  ///< J, done by moving pieces on bodies
    std::int64_t piecesYielded = 0;  ///< contacts in which a moving piece gave way
};

/// Parts of the structure that are alive at the end of the FE result without a path to a support.
struct LiveIslands {
    std::int64_t islands = 0;
    std::int64_t elements = 0;
    double mass = 0.0;                  ///< kg
    std::int64_t moving = 0;            ///< elements of these still faster than 0.1 m/s at the last FE state
    std::int64_t released = 0;          ///< islands that became rigid bodies; the others are held where they are
    std::int64_t releasedElements = 0;  ///< of those
    double releasedMass = 0.0;          ///< kg
    std::int64_t refused = 0;           ///< held although released was asked for: no finite place, or no mass
    std::int64_t occupied = 0;          ///< released deeper than 5 % of their smallest side inside bodies and pieces
    std::int64_t stillMoving = 0;       ///< released ones awake at the end
    double droppedKineticEnergy = 0.0;  ///< J, of deformation, which a rigid body cannot carry
    LedgerErrors ledger;                ///< elements and bodies of the released ones against the FE result

    std::int64_t held() const { return islands - released; }
};

/// Loose structure that the engine moved before the FE result ended (setting loose_structure).
struct CarriedStructure {
    std::int64_t islands = 0;     ///< handed over by the FE result
    std::int64_t elements = 0;    ///< of those
    double mass = 0.0;            ///< kg
    std::int64_t refused = 0;     ///< islands without a finite place or mass, at each state: the FE result goes on moving them
    std::int64_t bodies = 0;      ///< of islands, and of what was left of them whenever they lost something
    std::int64_t born = 0;        ///< fragments that were born from them
    double bornMass = 0.0;        ///< kg
    double bornAtRestMass = 0.0;  ///< kg, of this: killed by the FE result after the island had come to rest elsewhere
    double bornSofterMass =
        0.0;                ///< kg, of this: of elements that the FE result hit more than twice as hard as the engine had by then
    std::int64_t left = 0;  ///< bodies at the end
    double leftMass = 0.0;  ///< kg
    std::int64_t stillMoving = 0;       ///< of these, awake at the end
    double droppedKineticEnergy = 0.0;  ///< J, of deformation, which a rigid body cannot carry
    LedgerErrors handOvers;             ///< elements and bodies against the FE result, the largest over all states
    LedgerErrors losses;                ///< the same for bodies born and left against those before; only those of bodies are used
};

struct StepTimes {
    double meanMs = 0.0;  ///< from the first to the last birth
    double p95Ms = 0.0;
    double worstMs = 0.0;
    double shareInTime = 0.0;     ///< share of steps from first to last birth that took less than the time they simulate
    double realTimeFactor = 0.0;  ///< simulated over wall time, first to last birth, recording included

    // Means over all steps, settling included.
    double allMs = 0.0;          ///< by a clock around each step: what the costs of the effects are shares of
    double motionMs = 0.0;       ///< the world, less contact and hook: motion, freezing; with solver = bullet contact too
    double hookMs = 0.0;         ///< handing bodies to the effects that act in substeps, less those effects
    double bookkeepingMs = 0.0;  ///< places, speeds, hits, energy, progress
    double healthMs = 0.0;       ///< the monitor
    // Between the steps, over the same number.
    double recordingMs = 0.0;  ///< frames made and handed to the sink; in live mode its waiting for the screen too
    double birthsMs = 0.0;     ///< bodies in and out at FE states, the ledger

    /// What no effect took.
    double restMs() const { return motionMs + hookMs + bookkeepingMs + healthMs; }
};

struct EnergyBalance {
    double gravityWork = 0.0;  ///< J, potential energy lost so far by all bodies
    double kineticIn = 0.0;    ///< J, brought in at hand-overs
    double kineticNow = 0.0;   ///< J
    double effectWork = 0.0;   ///< J, done by water, air drag and ties; negative where they took energy
    double dissipated = 0.0;   ///< J, lost in contacts; negative would be a gain
    double drift =
        0.0;  ///< largest gain so far beyond gravity, births, and the work of overlap, pieces and effects, over gravity work
};

}  // namespace rubble
