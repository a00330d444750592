#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/engine/soft/contact_strips.h"
#include "core/engine/soft/lanes/soft_lanes.h"
#include "core/engine/soft/mass_split.h"
#include "core/engine/world/worker_pool.h"

namespace rubble {

/// What of a body changes while contacts are solved. Immovable ones have zero inverse mass and inertia.
struct SolverBody {
    Vec3 velocity = Vec3::Zero();        ///< m/s
    Vec3 spin = Vec3::Zero();            ///< rad/s, world axes
    Vec3 moved = Vec3::Zero();           ///< m, since the start of the step
    Vec3 turned = Vec3::Zero();          ///< rad, since the start of the step
    double inverseMass = 0.0;            ///< 1/kg
    Mat3 inverseInertia = Mat3::Zero();  ///< 1/(kg m2), world axes
    Vec3 inertia = Vec3::Ones();         ///< kg m2, principal
    double radius = 0.0;                 ///< m, of its farthest corner
    double fastest =
        std::numeric_limits<double>::infinity();  ///< m/s, that it and its corners may get to in this step where contacts act on it
    bool active = false;                          ///< a contact acted on it in this step
};
/// A body in the middle of a step.
struct SolverMotion {
    Pose pose;
    Vec3 velocity = Vec3::Zero();  ///< m/s
    Vec3 spin = Vec3::Zero();      ///< rad/s, world axes
};

/// How far a body is brought by position only.
struct SolverWay {
    Vec3 moved = Vec3::Zero();   ///< m
    Vec3 turned = Vec3::Zero();  ///< rad
};

/// What a contact point carries, and what the substeps made of it.
struct PointImpulses {
    double normal = 0.0;  ///< N s in a substep, carried from step to step
    double tangent[2] = {0.0, 0.0};
    double push = 0.0;     ///< kg m in a step, by position only, carried from step to step
    double largest = 0.0;  ///< N s along the normal, of any substep; known after them
    double sum = 0.0;      ///< N s along the normal, over the substeps; known after them
};

/// One contact point as the solver takes it.
struct SolverPoint {
    Vec3 fromA, fromB;        ///< m, from the centres of mass, at the start of the step
    double separation = 0.0;  ///< m, at the start of the step, rest offset taken off
    PointImpulses impulses;
};

/// Where a contact of two bodies is; all else of it is made when it is needed.
struct SolverContact {
    std::uint32_t a = 0, b = 0;  ///< bodies
    std::uint32_t points = 0;
    float x = 0.0f, y = 0.0f;  ///< m, about where it is
    std::uint32_t found = 0;   ///< where the contact came from
    bool idle = false;         ///< carried nothing in the step before
};

/// What a contact asks of its two bodies: points with one normal.
struct ContactConstraint {
    Vec3 normal = Vec3::UnitZ();  ///< from a to b
    Vec3 tangent[2];              ///< orthogonal to it
    double friction = 0.0;
    double restitution = 0.0;
    double frequency = 0.0;             ///< Hz, of the contact as an oscillator, at least
    double sinkAllowed = 0.0;           ///< m, by which the load may press the two into each other; stiffer if it takes that
    double weight = 0.0;                ///< N s, impulse of the lighter body's weight in a substep
    double correction = 0.0;            ///< m, by which the two are brought apart by position only in this step; zero: none
    double lift = 0.0;                  ///< m/s, what an upward impulse gains against gravity in a substep; see LaneContacts
    double impulseLimit = 0.0;          ///< N s per point and substep; negative: none
    bool countsWork = false;            ///< account for the work of pushing apart
    bool driven = false;                ///< account for the work of the immovable one of the two
    std::array<SolverPoint, 4> points;  ///< as many as the contact has; the others are never looked at
};

/// What a step made of a contact.
struct ContactOutcome {
    double work = 0.0;        ///< J: of pushing the bodies apart, or of a moving piece
    bool corrected = false;   ///< the two were to come apart by position
    bool countsWork = false;  ///< as its constraint has it, likewise the next
    bool driven = false;
    std::array<PointImpulses, 4> points;  ///< as many as the contact has
};

/// Soft contacts solved by small substeps: one warm-started soft pass that pushes overlap apart, then, after the bodies moved,
/// three relax passes without the push. Macklin et al. 2019, Small steps in physics simulation; Catto 2024, Solver2D.
/// Contacts lie in the order of the colours. The passes run over several contacts of a colour side by side (soft_lanes.h).
class SoftSolver {
public:
    explicit SoftSolver(WorkerPool& pool) : m_pool(pool) {}

    /// Takes another variant of the passes than the processor's own.
    void use(const LanePasses& passes) { m_passes = passes; }

    std::vector<SolverBody> bodies;
    std::vector<SolverContact> contacts;
    std::vector<std::uint32_t> firstOfGroup;  ///< [groups + 1]
    bool lastInOrder = false;
    std::span<const SplitBody> split;  ///< bodies that the passes see as several, for the whole step
    /// [contacts] the copies that each is between; empty: the bodies themselves. What does not move comes behind the copies.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> copies;

    /// Makes room for bodies.
    void resizeBodies(std::size_t count);
    /// Where a body is: from here on the solver has it. Any number of threads for different ones.
    void place(std::size_t body, const Pose& pose);
    /// Where constraints come from. None is kept: what bounces is made again.
    struct Source {
        /// Makes the constraint of a contact with its points, all but what is known after the substeps; to the same bits until
        /// contacts are given out.
        std::function<void(std::uint32_t contact, ContactConstraint& made)> make = [](std::uint32_t, ContactConstraint&) {};
        std::function<void(std::uint32_t contact)> prefetch = [](std::uint32_t) {};  ///< which one is made soon
    };
    /// Takes the bodies as they are into a step; from here to its end what moves them lies elsewhere.
    /// @param movable  bodies below this one move
    void begin(std::size_t movable);
    using Shown = std::function<void(std::uint32_t contact, const ContactConstraint& made)>;
    /// Lays contacts side by side for substeps of h [s], with what their points move and how stiff they are.
    /// @param source  is kept until the next step
    /// @param made    is shown each constraint
    void layOut(double h, const Source& source, const Shown& made = [](std::uint32_t, const ContactConstraint&) {});
    /// What a body may get to where contacts act on it, m/s.
    void bound(std::size_t body, double fastest);
    /// Between the passes and after them.
    Pose poseOf(std::size_t body) const;
    /// Between the passes.
    SolverMotion motion(std::size_t body) const;
    void setVelocity(std::size_t body, const Vec3& velocity, const Vec3& spin);
    /// Begins a substep: what moves gets `speed` [m/s] faster downwards.
    void applyGravity(double speed);
    /// Moves and turns the bodies through the substep, under `gravity` [m/s2]. Returns how many were too fast and held back.
    std::int64_t move(double gravity);
    /// Bodies are what the substeps made of them.
    void end();
    /// Applies the impulses of the substep before and solves once, pushing overlap apart at `push` [m/s] at most.
    void solveSoft(double push);
    /// Solves without the push until little of it is left.
    void relax();
    /// Adds up the work of this substep.
    void accumulateWork();
    /// Brings apart by position only what overlaps from birth or is jammed, after the last substep; false: nothing does.
    bool correctPositions();
    /// What this moves and turns a body by.
    SolverWay correctionOf(std::size_t body) const;
    /// Gives back the speed of approach of every hit above `threshold` [m/s].
    /// @param friction  what gives it back rubs as well, by Coulomb's law
    void restitute(double threshold, bool friction = false);
    /// Gives out each contact with the impulses and the work that the passes and restitution left. From any thread.
    void takeBack(const std::function<void(std::uint32_t contact, const ContactOutcome& outcome)>& take) const;

private:
    /// Groups of lanes of one colour in one strip; those at its borders come first.
    struct Colour {
        std::size_t first = 0, inside = 0, last = 0;
        bool meets = false;  ///< some strip has such a group
    };
    /// A strip of the site and the thread that solves it.
    struct Strip {
        std::vector<Colour> colours;
        Milestone border;      ///< colours that meet and whose groups at the border are done, in all passes at hand
        std::size_t done = 0;  ///< colours, in all passes at hand
    };
    /// A contact that is hit, and where it lies.
    struct Hit {
        std::uint32_t contact = 0, group = 0, lane = 0;
    };
    /// What contacts take of a body, close together.
    struct MassProperties {
        double inverseMass = 0.0;           ///< 1/kg
        KeptNumber inverseInertia[6] = {};  ///< 1/(kg m2), in the order of KeptLaneTensor
    };
    template <class Pass, class Join>
    void forEachPass(int passes, Pass pass, Join join);
    std::pair<std::uint32_t, std::uint32_t> endsOf(std::size_t contact) const;
    bool isSplit(std::uint32_t body) const { return !m_copiesOf.empty() && body < m_movable && m_copiesOf[body] > 1; }
    void shareOut();
    /// Contacts that go side by side.
    struct Group {
        std::uint32_t firstPoint = 0;
        std::uint32_t points = 0;  ///< the most of any of them
        std::uint32_t count = 0;
        std::uint32_t found[solverLanes] = {};
    };
    template <class Pass>
    void forEachWithWork(Pass pass);
    template <class Pass>
    void forEachColour(int passes, Pass pass);
    template <class Pass>
    void solveStrip(Strip& strip, int passes, Pass pass);
    std::size_t stripCount();
    void arrange();
    void fillLanes(std::size_t group, const Shown& made);
    void prefetchGroup(std::size_t group) const;
    PointImpulses impulsesOf(std::size_t point, std::size_t lane) const;
    void giveBack(const Hit& hit, double threshold, bool friction);

    WorkerPool& m_pool;
    std::size_t m_movable = 0;              ///< bodies below this one move
    std::uint32_t m_added = 0;              ///< copies behind them
    std::vector<std::uint32_t> m_copiesOf;  ///< [movable bodies]; empty: none is split
    LanePasses m_passes = lanePasses();
    LaneScene m_scene;
    ContactStrips m_cut;
    std::vector<Strip> m_strips;
    std::atomic<bool> m_givenUp{false};  ///< the threads do not run at the same time, in this step
    int m_alone = 0;                     ///< steps for which this thread does all
    Source m_source;
    std::vector<Group> m_groups;
    std::vector<std::uint32_t> m_withWork;  ///< groups
    std::vector<LaneContacts> m_lanes;
    std::vector<LaneTally> m_tallies;  ///< beside them
    std::vector<std::uint8_t> m_acts;  ///< likewise
    std::vector<LanePoint> m_lanePoints;
    std::vector<LanePointTally> m_pointTallies;  ///< beside them, as the next ones
    std::vector<LanePointWork> m_laneWorks;
    std::vector<MassProperties> m_massProperties;  ///< [copies], as the next ones
    std::vector<LaneBody> m_laneBodies;
    std::vector<LaneTravel> m_laneTravel;
    std::vector<LanePose> m_lanePoses;
    std::vector<LaneSolid> m_laneSolids;
    std::vector<LaneCorrection> m_laneCorrections;        ///< beside the contacts
    std::vector<LaneCorrectionPoint> m_correctionPoints;  ///< beside the points
    std::vector<LaneWay> m_corrections;                   ///< [copies]
};

}  // namespace rubble
