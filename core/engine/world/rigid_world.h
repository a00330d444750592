#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/standard_gravity.h"
#include "core/engine/world/moving_body.h"
#include "core/fe/terrain_grid.h"
#include "core/fragments/fragment_set.h"
#include "core/scenario/scenario.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

class Archive;

/// One convex part of a collision shape: a box, or the hull of points.
struct ConvexPart {
    OrientedBox box;           ///< in the frame of its body or piece; for a hull a box around it
    std::vector<Vec3> points;  ///< hull vertices in that frame, m; empty for a box
    double margin = 0.0;       ///< m, by which Bullet's solver rounds the edges of a hull
};
using CollisionShape = std::vector<ConvexPart>;

/// A rigid body at the instant it enters. Its frame: centre of mass and principal axes of inertia.
struct NewBody {
    double mass = 0.0;                    ///< kg
    Vec3 inertia = Vec3::Zero();          ///< kg m2 about the principal axes
    Pose pose;                            ///< of centre of mass and principal axes
    Vec3 velocity = Vec3::Zero();         ///< m/s
    Vec3 angularVelocity = Vec3::Zero();  ///< rad/s, world axes
    CollisionShape shape;
    double smallestSide = 0.0;  ///< m, of the shape
    double volume = 0.0;        ///< m3, of its material
    Material material = Material::Concrete;
    /// Of the mesh, of its elements, ascending; empty: not told. What shares one with it was joined to it: the two were one solid,
    /// and an overlap of theirs at birth is by how much their boxes are coarser than their elements.
    std::vector<std::uint32_t> nodes;
    /// A part of the structure that has come loose: pieces that it lies in by more than the share of occupied space when either of
    /// the two enters let it pass, as the FE result does. They were one solid, and their boxes are not as exact as their elements.
    bool loose = false;
};

/// Index of a kinematic piece in the order in which pieces entered.
enum class PieceId : std::uint32_t {};

/// Where a body is and how it moves.
struct BodyMotion {
    Pose pose;
    Vec3 velocity = Vec3::Zero();
    Vec3 angularVelocity = Vec3::Zero();
};

/// What a world needs to know besides its bodies.
struct WorldSettings {
    double gravity = standardGravity;  ///< m/s2, downwards
    bool ground = true;
    double groundHeight = 0.0;                   ///< m, top of the level ground
    std::shared_ptr<const TerrainGrid> terrain;  ///< takes the place of the level ground where it has heights
    Material groundMaterial = Material::Soil;
    bool bodyContacts = true;  ///< bodies collide with each other; off: no such pair is ever formed
    Aabb reach;                ///< m, of the structure; the ground covers it with a margin
    PairTable pairs;
    int iterations = 10;  ///< of the stock solver
    int substeps = 4;     ///< of the soft-step solver
    int threads = 1;      ///< no result depends on it
    bool freeze = true;
    double freezeSpeed = 0.02;    ///< m/s
    double freezeDelay = 0.5;     ///< s
    double overlapSpeed = 1.5;    ///< m/s
    double overlapTime = 7.0;     ///< s, for each pair, or as the next says
    bool bounceFriction = false;  ///< what a bounce presses with rubs too, soft-step solver
    /// That time counts for all contacts of two bodies alike, from when the later one entered. Off: for each contact from when its
    /// overlap began, so that overlap which moves from pair to pair has its time anew in each, and stirs a pile for long.
    bool overlapTimeFromEntry = false;
    /// Bodies that others have pressed into each other for a while (jamPatience) come apart by position. Off: only where overlap at
    /// birth pushes one of them.
    bool partsJammed = false;
    /// Bodies with very many contacts are solved as several that share their mass, so that no contact waits for another.
    bool splitsMass = false;
    /// Boxes that are deep in each other meet by faces sooner than by edges, and a patch that has turned takes of the one before
    /// what acts along it.
    bool steadyPatches = false;
    /// Asked now and then within a step; a step that is told to stop ends early and leaves the world good for destruction only.
    std::function<bool()> cancelled;
};

/// What the contacts did, all cumulated from the first step except the first two.
struct ContactReport {
    std::int64_t pairs = 0;          ///< touching pairs of the latest step
    std::int64_t points = 0;         ///< contact points of the latest step
    double penetrationMax = 0.0;     ///< m, deepest contact so far, overlap at birth and yielding pieces excepted
    double overlapWork = 0.0;        ///< J, done on bodies by pushing overlapping solids apart
    double pieceWork = 0.0;          ///< J, done by moving pieces on bodies
    std::int64_t piecesYielded = 0;  ///< contacts in which a moving piece gave way
    std::int64_t speedLimits = 0;    ///< bodies held back because nothing they touched could have made them that fast
};

/// Wall time of the steps so far by what it was spent on, s. Pair finding, contact geometry and solving count for the kind of
/// contact that asked for them.
struct StepCosts {
    double motion = 0.0;            ///< integration, freezing, bookkeeping
    double groundContact = 0.0;     ///< plane or terrain
    double structureContact = 0.0;  ///< bodies against pieces
    double fragmentContact = 0.0;   ///< bodies against bodies
    double substepHook = 0.0;       ///< what the caller did in the substeps
    double total = 0.0;             ///< whole steps
};

/// J/kg, of a body to which nothing has handed on energy that it did not have by its birth.
constexpr double noPush = -std::numeric_limits<double>::infinity();

/// The seam behind which a solver lives: rigid bodies, kinematic pieces, a ground, and time. Bodies and pieces are numbered in the
/// order they enter; the same calls in the same order give the same bits. Not thread-safe.
class RigidWorld {
public:
    virtual ~RigidWorld() = default;

    /// Takes a body in. What it overlaps in the next step is overlap at birth: kept as the pair's rest offset, never a push.
    virtual BodyId addBody(const NewBody& body) = 0;
    /// Takes a body out; frozen bodies that touched it thaw.
    virtual void removeBody(BodyId body) = 0;
    /// Takes a piece in, standing still. What it overlaps in the next step is treated as overlap at birth.
    /// @param nodes  of its elements, as those of a body
    virtual PieceId addPiece(const CollisionShape& shape, const Pose& pose, Material material = Material::Concrete,
                             std::span<const std::uint32_t> nodes = {}) = 0;
    virtual void removePiece(PieceId piece) = 0;
    /// Where the piece will be at the end of the next step; it moves there at constant speed. Without this call it stands still.
    virtual void movePiece(PieceId piece, const Pose& atStepEnd) = 0;
    /// Called at the start of every substep, with the bodies that move. It may change their velocities, nothing else. A velocity
    /// that is no number is not taken over, so that no contact hands it on; motion() says so from then on, and the body should
    /// leave.
    virtual void onSubstep(SubstepHook hook) = 0;
    /// Thaws a frozen body before the next step.
    virtual void wake(BodyId body) = 0;
    /// Substeps of the steps from now on in place of those of the settings, soft-step solver; others have none.
    virtual void setSubsteps(int) {}
    /// Advances by dt [s].
    virtual void step(double dt) = 0;
    /// Calls work(first, last) for [0, count) in parts of at most `grain`, on the threads that steps run on. Not from within such a
    /// part; parts write to places of their own and do not throw.
    virtual void onThreads(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& work) const;

    /// Bodies that ever entered, removed ones included.
    virtual std::size_t bodyCount() const = 0;
    /// Awake or frozen (or what would be frozen, when freezing is off), or removed.
    virtual BodyState state(BodyId body) const = 0;
    /// Where a body is; of a removed one, where it was last.
    virtual BodyMotion motion(BodyId body) const = 0;
    virtual double mass(BodyId body) const = 0;           ///< kg
    virtual double kineticEnergy(BodyId body) const = 0;  ///< J
    /// Mass, momenta and energy as the engine holds them; zero for a removed body.
    virtual Momenta momenta(BodyId body) const = 0;
    virtual double smallestSide(BodyId body) const = 0;  ///< m, of its shape
    /// Depth of a body's deepest contact in the latest step in which it was awake, m; overlap at birth and pieces that gave way
    /// excepted. 0 for what touches nothing or was removed.
    virtual double penetration(BodyId body) const = 0;
    /// How deep a body was inside older bodies and pieces when it entered, over its own smallest side; 0 before its first step.
    virtual double birthDepth(BodyId body) const = 0;
    /// The same, inside what it was not joined to alone.
    virtual double birthDepthApart(BodyId body) const = 0;
    /// m, of overlap at birth with other bodies: the deepest that has not come apart yet.
    virtual double overlapLeft(BodyId body) const = 0;
    /// m, by which bringing it out of overlap at birth has lifted a body so far, by position only.
    virtual double lifted(BodyId body) const = 0;
    /// A moving piece has pushed this body at some time.
    virtual bool pushedByPiece(BodyId body) const = 0;
    /// J/kg, v^2 / 2 + g z with the speed of the fastest point of another body that pushed this one and the height of this one's
    /// centre then, at most so far, where that is more than it had at birth. What has more energy itself than by its birth and by
    /// what pushed it hands on no more than it may have. noPush: none has, or the solver does not tell.
    virtual double handedEnergy(BodyId) const { return noPush; }
    virtual const ContactReport& contacts() const = 0;
    virtual const StepCosts& costs() const = 0;

    /// Its state between two steps, out or in: into a world that was just made with the same settings, which then goes on bit for
    /// bit. False, and nothing happens, if what decides the next step cannot be kept (the stock solver's contacts are its own).
    virtual bool keep(Archive&) { return false; }
};

/// The world that a solver kind stands for.
std::unique_ptr<RigidWorld> makeWorld(SolverKind solver, const WorldSettings& settings);

/// Bullet's own world as it comes, for comparison: its islands, its sleeping, its solver settings; no rest offsets, no freeze, no
/// limits. Reports contacts as zero.
std::unique_ptr<RigidWorld> makePlainBulletWorld(const WorldSettings& settings);

}  // namespace rubble
