#pragma once

#include <cstddef>
#include <cstdint>

namespace rubble {

/// Contacts that the solver takes side by side: no two of them move the same body. Eight fill one register of 512 bits, or two of
/// 256 that fill each other's waits.
constexpr int solverLanes = 8;

/// One number of each of those contacts. Speeds in single precision would keep momentum to six digits only, and towers of twenty
/// blocks lean.
struct alignas(8 * solverLanes) Lanes {
    double at[solverLanes];
    double& operator[](std::size_t i) { return at[i]; }
    double operator[](std::size_t i) const { return at[i]; }
};
/// The same as kept in memory where single precision does: what both bodies see alike, and what nothing adds up. The passes wait
/// for memory, and this halves it.
using KeptNumber = float;
struct alignas(4 * solverLanes) KeptLanes {
    KeptNumber at[solverLanes];
    KeptNumber& operator[](std::size_t i) { return at[i]; }
    KeptNumber operator[](std::size_t i) const { return at[i]; }
};

struct LaneVector {
    Lanes x, y, z;
};
struct KeptLaneVector {
    KeptLanes x, y, z;
};
/// Symmetric.
struct KeptLaneTensor {
    KeptLanes xx, yy, zz, xy, xz, yz;
};

/// What the passes change of a body, on a line of the cache of its own. The fourth number of the velocity is 1 once a contact has
/// acted on it in this substep.
struct alignas(64) LaneBody {
    double velocity[4] = {};  ///< m/s
    double spin[4] = {};      ///< rad/s, world axes
};
/// How far a body has gone since the start of the step. The fourth number of the way is 1 once a contact has acted on it in this
/// step.
struct alignas(64) LaneTravel {
    double moved[4] = {};   ///< m
    double turned[4] = {};  ///< rad
};
/// Where a body is.
struct alignas(64) LanePose {
    double position[4] = {};     ///< m
    double orientation[4] = {};  ///< quaternion x, y, z, w
};
/// What decides how a body moves by itself.
struct alignas(64) LaneSolid {
    double inertia[4] = {1.0, 1.0, 1.0, 0.0};  ///< kg m2 about its own axes; m, of its farthest corner
    double limit[4] = {};                      ///< m/s that it may get to in this step where contacts act on it
};
/// How far overlap that comes apart moves a body, by position only: momentum does not depend on it, so single precision does.
struct alignas(32) LaneWay {
    KeptNumber moved[4] = {};   ///< m
    KeptNumber turned[4] = {};  ///< rad
};

/// A point of each contact, as every pass sees it; where a contact has fewer points, its masses are zero.
struct alignas(8 * solverLanes) LanePoint {
    Lanes normalImpulse;  ///< N s in a substep
    Lanes tangentImpulse[2];
    KeptLanes now;                ///< m, separation in this substep, rest offset taken off
    KeptLaneVector fromA, fromB;  ///< m, from the centres of mass, at the start of the step
    KeptLanes normalMass;         ///< kg; before it is prepared 1 where there is a point
    KeptLanes tangentMass[2];
};

/// What of a point only some passes look at.
struct alignas(8 * solverLanes) LanePointTally {
    Lanes impulseSum;          ///< N s along the normal, over the substeps
    KeptLanes separation;      ///< m, at the start of the step, rest offset taken off
    KeptLanes approach;        ///< m/s at the start of the step, positive when closing
    KeptLanes before;          ///< N s, normal impulse one substep earlier
    KeptLanes largestImpulse;  ///< N s, at the end of the soft pass or of a substep
};

/// What accounting for the work of a point takes.
struct alignas(8 * solverLanes) LanePointWork {
    LaneVector opening;  ///< m/s, of b from a, before any impulse of this substep
    Lanes raised;        ///< N s, upward part of what acted in the soft pass
};

/// A point as bringing overlap apart sees it: along the normal only, so that its many passes read little.
struct alignas(4 * solverLanes) LaneCorrectionPoint {
    KeptLanes push;                 ///< kg m, spent so far in this step
    KeptLaneVector turnA, turnB;    ///< m, arm x normal: how far apart a turn of the body brings the point
    KeptLaneVector swingA, swingB;  ///< 1/(kg m), turn of the body by a push
    KeptLanes mass;                 ///< kg
    KeptLanes gap;                  ///< m, that may close
};

/// Contacts side by side, likewise.
struct alignas(4 * solverLanes) LaneCorrection {
    std::uint32_t a[solverLanes], b[solverLanes];  ///< bodies
    KeptLanes inverseMassA, inverseMassB;          ///< 1/kg
    KeptLaneVector normal;                         ///< from a to b
    KeptLanes correction;                          ///< m, by which the two are to come apart in this step; zero: none
    std::uint32_t firstPoint = 0;
    std::uint32_t points = 0;
    bool allMove = false;  ///< no body of any of them is immovable
};

/// Contacts side by side, as every pass sees them. Missing ones at the end of a colour have no mass and no body.
struct alignas(8 * solverLanes) LaneContacts {
    std::uint32_t a[solverLanes], b[solverLanes];  ///< bodies
    std::uint32_t firstPoint = 0;
    std::uint32_t points = 0;  ///< the most of any of them
    bool allMove = false;      ///< no body of any of them is immovable
    bool countsWork = false;   ///< one of them accounts for its work
    KeptLanes friction;
    Lanes inverseMassA, inverseMassB;  ///< 1/kg, as this contact sees them
    KeptLaneTensor inverseInertiaA, inverseInertiaB;
    KeptLaneVector normal;   ///< from a to b
    KeptLaneVector tangent;  ///< one of the two, the other is orthogonal to both
    KeptLanes impulseLimit;  ///< N s per point and substep
};

/// What of contacts only some passes look at.
struct alignas(8 * solverLanes) LaneTally {
    KeptLanes frequency;     ///< Hz, of the contact as an oscillator, at least
    KeptLanes sinkAllowed;   ///< m, by which the load may press the two into each other; stiffer if it takes that
    KeptLanes fastest;       ///< m/s at the start of the step, of the points that come closer
    KeptLanes weight;        ///< N s, impulse of the lighter body's weight in a substep
    KeptLanes biasRate;      ///< 1/s, of the soft pass
    KeptLanes massScale;     ///< of the soft pass
    KeptLanes impulseScale;  ///< of the soft pass
    KeptLanes correction;    ///< m, by which the two are brought apart by position only in this step; zero: none
    KeptLanes lift;          ///< m/s, what an upward impulse gains against gravity in a substep; zero between two that move
    KeptLanes workShare;     ///< 1: its work of pushing apart is accounted for
    KeptLanes drivenByA;     ///< 1: the work of a moving piece a is accounted for
    KeptLanes drivenByB;     ///< 1: the same of b
    Lanes work;              ///< J, in this step
};

/// Damping ratio of a contact: above 1, so that overlap comes apart without a bounce.
constexpr double contactDamping = 10.0;
/// Largest omega h of a contact. Higher: what is pressed hard trembles; lower: it sinks in.
constexpr double stiffestContact = 1.1;

/// All that the passes work on.
struct LaneScene {
    LaneContacts* contacts = nullptr;
    LaneTally* tallies = nullptr;  ///< beside the contacts
    std::uint8_t* acts = nullptr;  ///< likewise: zero where none of them carried anything in this substep
    LanePoint* points = nullptr;
    LanePointTally* pointTallies = nullptr;  ///< beside the points
    LanePointWork* works = nullptr;          ///< likewise
    LaneBody* bodies = nullptr;
    LaneTravel* travel = nullptr;
    LanePose* poses = nullptr;
    const LaneSolid* solids = nullptr;
    std::uint32_t movable = 0;                        ///< bodies below this one move
    double h = 0.0;                                   ///< s, length of a substep
    LaneCorrection* corrections = nullptr;            ///< beside the contacts
    LaneCorrectionPoint* correctionPoints = nullptr;  ///< beside the points
    LaneWay* corrected = nullptr;                     ///< [bodies] by which overlap is brought apart
};

/// The passes over contacts [first, last) of one colour, in three SIMD variants: for every processor, and for those with 256-bit
/// and 512-bit vectors. All round alike, and what a contact gets does not depend on those beside it.
struct LanePasses {
    /// Masses of the points, speeds of approach and stiffness.
    void (*prepare)(const LaneScene& scene, std::size_t first, std::size_t last);
    /// Applies the impulses of the substep before. @param growth  most by which what is new may grow
    void (*warmStart)(const LaneScene& scene, std::size_t first, std::size_t last, double growth);
    /// Solves once. @param push  m/s at most for pushing overlap apart
    void (*soft)(const LaneScene& scene, std::size_t first, std::size_t last, double push);
    /// Solves once without the push, where the bodies have moved to. @param moved  they have since the pass before
    /// @param final  the last pass of the substep: its impulses are added up
    void (*relax)(const LaneScene& scene, std::size_t first, std::size_t last, bool moved, bool final);
    /// Moves and turns bodies [first, last) by their velocities through a substep, under `gravity` [m/s2]. First those that
    /// contacts act on are held back to what they may get to. Returns how many were.
    std::int64_t (*move)(const LaneScene& scene, std::size_t first, std::size_t last, double gravity);
    /// Makes out of contacts and points what the next passes read, and applies the pushes of the step before.
    void (*startCorrection)(const LaneScene& scene, std::size_t first, std::size_t last);
    /// Brings overlap apart by position only. @param hold  nothing is pushed further, only kept from going back
    void (*correct)(const LaneScene& scene, std::size_t first, std::size_t last, bool hold);
    /// Notes the velocities before any impulse, for the work of contacts that are accounted for.
    void (*noteOpening)(const LaneScene& scene, std::size_t first, std::size_t last);
    /// Adds up the work of a substep.
    void (*accumulateWork)(const LaneScene& scene, std::size_t first, std::size_t last);
};

/// The variant for this processor.
const LanePasses& lanePasses();
/// The variant for every processor.
const LanePasses& commonLanePasses();
/// The variants for 256-bit and 512-bit vectors; null where they were not built. Their passes need a processor that has them.
const LanePasses* wideLanePasses();
const LanePasses* widestLanePasses();

}  // namespace rubble
