#pragma once

#include <cstddef>
#include <cstdint>

namespace rubble {

/// Contacts that the solver takes side by side: no two of them move the same body.
constexpr int solverLanes = 4;

/// One number of each of those contacts. In single precision momentum would be kept to six digits only, and towers of twenty blocks
/// lean.
using Lanes = double __attribute__((vector_size(8 * solverLanes), aligned(8 * solverLanes)));
/// The same as kept in memory where single precision does: what both bodies see alike, and what nothing adds up. The passes wait
/// for memory, and this halves it.
using KeptNumber = float;
using KeptLanes = KeptNumber __attribute__((vector_size(4 * solverLanes), aligned(4 * solverLanes)));

struct LaneVector {
    Lanes x, y, z;
};
struct KeptLaneVector {
    KeptLanes x, y, z;
};
/// Symmetric.
struct LaneTensor {
    Lanes xx, yy, zz, xy, xz, yz;
};
struct KeptLaneTensor {
    KeptLanes xx, yy, zz, xy, xz, yz;
};

/// What the passes change of a body, on a line of the cache of its own. The fourth number of the velocity is 1 once a contact has
/// acted on it in this substep.
struct alignas(64) LaneBody {
    double velocity[4] = {};  ///< m/s
    double spin[4] = {};      ///< rad/s, world axes
};
/// How far a body has gone since the start of the step.
struct alignas(64) LaneTravel {
    double moved[4] = {};   ///< m
    double turned[4] = {};  ///< rad
};

/// A point of each contact; where a contact has fewer points, its masses are zero.
struct alignas(8 * solverLanes) LanePoint {
    Lanes normalImpulse;  ///< N s in a substep
    Lanes tangentImpulse[2];
    Lanes impulseSum;             ///< N s along the normal, over the substeps
    Lanes separation;             ///< m, at the start of the step, rest offset taken off
    Lanes now;                    ///< m, in this substep
    KeptLaneVector fromA, fromB;  ///< m, from the centres of mass, at the start of the step
    KeptLanes normalMass;         ///< kg
    KeptLanes tangentMass[2];
    KeptLanes before;          ///< N s, normal impulse one substep earlier
    KeptLanes largestImpulse;  ///< N s, of any substep
};

/// What accounting for the work of a point takes.
struct alignas(8 * solverLanes) LanePointWork {
    LaneVector opening;  ///< m/s, of b from a, before any impulse of this substep
    Lanes raised;        ///< N s, upward part of what acted in the soft pass
};

/// A point as bringing overlap apart sees it: along the normal only, so that its many passes read little.
struct alignas(8 * solverLanes) LanePart {
    Lanes push;                     ///< kg m, spent so far in this step
    KeptLaneVector turnA, turnB;    ///< m, arm x normal: how far apart a turn of the body brings the point
    KeptLaneVector swingA, swingB;  ///< 1/(kg m), turn of the body by a push
    KeptLanes mass;                 ///< kg
    KeptLanes gap;                  ///< m, that may close
};

/// Contacts side by side, likewise.
struct alignas(8 * solverLanes) LaneParting {
    std::uint32_t a[solverLanes], b[solverLanes];  ///< bodies
    KeptLanes inverseMassA, inverseMassB;          ///< 1/kg
    KeptLaneVector normal;                         ///< from a to b
    KeptLanes parting;                             ///< m, by which the two are to come apart in this step; zero: none
    std::uint32_t firstPoint = 0;
    std::uint32_t points = 0;
};

/// Contacts side by side. Missing ones at the end of a colour have no mass and no body.
struct alignas(8 * solverLanes) LaneContacts {
    std::uint32_t a[solverLanes], b[solverLanes];  ///< bodies
    std::uint32_t firstPoint = 0;
    std::uint32_t points = 0;          ///< the most of any of them
    std::uint32_t found[solverLanes];  ///< contact in each lane
    std::uint32_t count = 0;           ///< lanes in use
    bool booked = false;               ///< one of them accounts for its work
    Lanes inverseMassA, inverseMassB;  ///< 1/kg, as this contact sees them
    KeptLaneTensor inverseInertiaA, inverseInertiaB;
    KeptLaneVector normal;  ///< from a to b
    KeptLaneVector tangent[2];
    KeptLanes friction;
    KeptLanes weight;        ///< N s, impulse of the lighter body's weight in a substep
    KeptLanes biasRate;      ///< 1/s, of the soft pass
    KeptLanes massScale;     ///< of the soft pass
    KeptLanes impulseScale;  ///< of the soft pass
    KeptLanes parting;       ///< m, by which the two are brought apart by position only in this step; zero: none
    KeptLanes impulseLimit;  ///< N s per point and substep
    KeptLanes lift;          ///< m/s, what an upward impulse gains against gravity in a substep; zero between two that move
    KeptLanes bookedShare;   ///< 1: its work of pushing apart is accounted for
    KeptLanes drivenByA;     ///< 1: the work of a moving piece a is accounted for
    KeptLanes drivenByB;     ///< 1: the same of b
    Lanes work;              ///< J, in this step
};

/// All that the passes work on.
struct LaneScene {
    LaneContacts* contacts = nullptr;
    LanePoint* points = nullptr;
    LanePointWork* works = nullptr;  ///< beside the points
    LaneBody* bodies = nullptr;
    const LaneTravel* travel = nullptr;
    std::uint32_t movable = 0;        ///< bodies below this one move
    double h = 0.0;                   ///< s, length of a substep
    LaneParting* partings = nullptr;  ///< beside the contacts
    LanePart* parts = nullptr;        ///< beside the points
    LaneBody* parted = nullptr;       ///< m and rad by which overlap is brought apart, in place of speeds
};

/// The passes over contacts [first, last) of one colour, in two makes: for every processor, and for those with 256-bit vectors.
/// Both round alike, and what a contact gets does not depend on those beside it.
struct LanePasses {
    /// Applies the impulses of the substep before. @param growth  most by which what is new may grow
    void (*warmStart)(const LaneScene& scene, std::size_t first, std::size_t last, double growth);
    /// Solves once. @param push  m/s at most for pushing overlap apart
    void (*soft)(const LaneScene& scene, std::size_t first, std::size_t last, double push);
    /// Solves once without the push, where the bodies have moved to. @param moved  they have since the pass before
    /// @param final  the last pass of the substep: its impulses are added up
    void (*relax)(const LaneScene& scene, std::size_t first, std::size_t last, bool moved, bool final);
    /// Makes out of contacts and points what the next passes read, and applies the pushes of the step before.
    void (*startParting)(const LaneScene& scene, std::size_t first, std::size_t last);
    /// Brings overlap apart by position only. @param hold  nothing is pushed further, only kept from going back
    void (*part)(const LaneScene& scene, std::size_t first, std::size_t last, bool hold);
    /// Notes the velocities before any impulse, for the work of contacts that are accounted for.
    void (*noteOpening)(const LaneScene& scene, std::size_t first, std::size_t last);
    /// Books the work of a substep.
    void (*book)(const LaneScene& scene, std::size_t first, std::size_t last);
};

/// The make for this processor.
const LanePasses& lanePasses();
/// The make for every processor.
const LanePasses& commonLanePasses();
/// The make for 256-bit vectors; null where it was not built. Its passes need a processor that has them.
const LanePasses* wideLanePasses();

}  // namespace rubble
