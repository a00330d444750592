#pragma once

#include <btBulletDynamicsCommon.h>

#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/base/prefetch.h"
#include "core/simulation/box_contact.h"
#include "core/simulation/box_index.h"
#include "core/simulation/collider.h"
#include "core/simulation/freeze.h"
#include "core/simulation/ground_contact.h"
#include "core/simulation/sleeping_contacts.h"
#include "core/simulation/soft_contact.h"
#include "core/simulation/soft_solver.h"
#include "core/simulation/worker_pool.h"

namespace rubble {

/// Bullet's world stepped by soft contacts in small substeps. Shapes and the geometry of hulls are Bullet's; the search for pairs,
/// box and ground contact, solver, freeze, births and pieces are Rubble's. One step: boxes swept by the motion ahead, pairs,
/// contacts once, then substeps of {the caller's hook, gravity, one soft pass, move, three relax passes}, position correction,
/// restitution, freeze and thaw.
/// Every contact has its place in an order of its own, so neither threads nor the history of the search for pairs reach a result.
class SoftStepWorld : public btDiscreteDynamicsWorld {
public:
    SoftStepWorld(btDispatcher* dispatcher, btBroadphaseInterface* broadphase, btConstraintSolver* solver,
                  btCollisionConfiguration* configuration, const WorldSettings& settings, StepCosts& costs);

    const FreezeClock& freezeClock() const { return m_freeze; }
    const ContactReport& report() const { return m_report; }
    void onSubstep(SubstepHook hook) { m_hook = std::move(hook); }
    void addBody(Collider* body);
    void addPiece(Collider* piece);
    /// Of one whose contacts are gone, see letGoOfLeaving().
    void forget(Collider& collider);
    void thaw(Collider& body);
    /// Thaws the frozen bodies that touch what is marked as leaving, and drops its contacts.
    void letGoOfLeaving();
    /// See RigidWorld::onThreads().
    void onThreads(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& work) {
        m_pool.loop(count, grain, work);
    }
    /// Its state between two steps, out or in.
    /// @param bodies, pieces  that ever entered, in order
    void keep(Archive& archive, std::span<const std::unique_ptr<Collider>> bodies,
              std::span<const std::unique_ptr<Collider>> pieces);

protected:
    void internalSingleStepSimulation(btScalar dt) override;

private:
    enum Kind : std::uint32_t { Ground, Structure, Fragments, Kinds };
    /// A body or piece beside its Bullet object.
    struct Solid {
        Collider* collider = nullptr;                                       ///< null once gone
        std::vector<std::shared_ptr<const btPolyhedralConvexShape>> hulls;  ///< of its parts, made when the first hull comes near
        Aabb swept;                                                         ///< around the way of this step
        Pose pose;
        Vec3 velocity = Vec3::Zero();
        Vec3 spin = Vec3::Zero();
        Vec3 inertia = Vec3::Ones();
        double inverseMass = 0.0;
        std::int32_t slot = -1;  ///< among the solver's bodies in this step; -1: immovable and still
        int drivers = 0;         ///< moving pieces that press on it in this step
        bool active = false;     ///< a contact acted on it in this step
        bool supported = false;  ///< it stood, in the step before, on something immovable or supported

        /// What outlasts a step and does not follow from collider and pose.
        void keep(Archive& archive) { archive(swept, pose, velocity, spin, inertia, inverseMass, active, supported); }
    };
    struct Pair {
        std::uint32_t a = 0, b = 0;  ///< numbers, in the order in which they entered
    };
    /// What the search for pairs looks at in a collider, side by side.
    struct alignas(64) BroadPhaseEntry {
        Aabb swept;
        Collider* collider = nullptr;  ///< null once gone
        ColliderKind kind = ColliderKind::Body;
        bool stirs = false;      ///< in this step
        bool hull = false;       ///< a part is a hull
        std::uint32_t part = 0;  ///< the first of its parts among all
    };
    /// How fast a collider is, which decides from how far away contacts are found.
    struct Pace {
        Vec3 velocity = Vec3::Zero();  ///< m/s
        double rim = 0.0;              ///< m/s, of the farthest corner by the spin
    };
    /// What contacts ask of a body or piece, on a line of the cache of its own.
    struct alignas(64) Side {
        Vec3 centre = Vec3::Zero();
        double inverseMass = 0.0;                                    ///< 1/kg, as the solver takes it
        double yield = 1.0;                                          ///< share of the true one that this is
        double thickness = std::numeric_limits<double>::infinity();  ///< m
        Material material = Material::Concrete;
        bool swelling = false;  ///< a body that is in overlap from birth in this step
    };
    /// A contact of this step where it was found.
    struct Found {
        ColliderPair pair = 0;
        std::uint32_t part = 0;
        const FoundContact* contact = nullptr;
    };
    /// Which of the two bodies of a contact stands on the other.
    enum class Support : std::uint8_t { None, ByA, ByB };
    /// A contact on its way to the solver.
    struct Taken {
        std::uint64_t height = 0;  ///< of its first point, as a number that grows with it
        float x = 0.0f, y = 0.0f;  ///< m, where that is
        std::uint32_t contact = 0;
        std::uint32_t a = 0, b = 0;  ///< slots
        std::uint8_t points = 0;
        std::uint8_t kind = Ground;
        Support support = Support::None;
        bool idle = false;  ///< carried nothing in the step before
    };
    /// What the solver made of a contact.
    struct Outcome {
        double work = 0.0;                ///< J, of a contact that accounts for it
        std::uint32_t points = 0;         ///< if one of them acted
        std::uint32_t unloaded = nobody;  ///< a frozen body
        bool driven = false;              ///< the work is that of a piece
    };
    static constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();
    using SlotPair = std::pair<std::uint32_t, std::uint32_t>;

    Solid& solidOf(const Collider& c) { return c.kind == ColliderKind::Piece ? m_pieces[c.index] : m_bodies[c.index]; }
    const Solid& solidOf(const Collider& c) const { return c.kind == ColliderKind::Piece ? m_pieces[c.index] : m_bodies[c.index]; }
    bool awake(const Collider& c) const { return c.kind == ColliderKind::Body && !m_freeze.frozen(c.index); }
    static double speedOf(const Solid& solid) { return solid.velocity.norm() + solid.spin.norm() * solid.collider->radius; }
    bool stirs(const Collider& c) const { return awake(c) || c.moving || c.newborn; }

    void enter(Collider& collider);
    void keepSolids(Archive& archive, std::vector<Solid>& solids, std::span<const std::unique_ptr<Collider>> colliders);
    Collider* colliderNumbered(std::uint32_t number);
    void keepContacts(Archive& archive, std::vector<SoftContact>& contacts);
    void takeSlots(double dt);
    void listAwake();
    void listMoving(double dt);
    void place(Solid& solid);
    void sweep(Solid& solid, double dt);
    void findPairs();
    void findPairsOfWoken(const std::vector<std::uint32_t>& woken, double dt, std::vector<Pair>& structure,
                          std::vector<Pair>& fragments) const;
    bool mayMeet(ColliderKind a, ColliderKind b) const;
    std::span<PlacedBox> placedOf(const Collider& c) {
        return std::span(m_placed).subspan(m_entries[c.number].part, c.parts.size());
    }
    double marginOf(std::uint32_t a, std::uint32_t b, double dt) const;
    void collideAll(double dt);
    void collidePairs(const std::vector<Pair>& pairs, Kind kind, double dt);
    void collidePair(const Pair& pair, double dt, std::vector<FoundContact>& found) const;
    void collideHullParts(const Collider& a, std::size_t i, const Collider& b, std::size_t j, double margin,
                          ContactPatch& patch) const;
    void collideWithGround(std::span<const std::uint32_t> bodies, double dt);
    void collideWithGround(Solid& solid, double dt, std::vector<FoundContact>& found);
    std::size_t beginRun(std::size_t count, std::size_t grain);
    void prepareHulls(const Collider& collider);
    bool wakeByContacts();
    void wakeByContact(const FoundContact& contact, std::vector<std::uint32_t>& lifted);
    void wakeAbove(std::vector<std::uint32_t> lifted);
    void boundSpeeds(double dt);
    void holdBack(SolverBody& body);
    void wakeAndCollideAgain(double dt);
    std::vector<Found> foundInOrder() const;
    void takeFound(double dt);
    bool recall(SoftContact& contact) const;
    void restPair(std::size_t first, std::size_t last, double dt);
    void limitPiece(std::size_t first, std::size_t last);
    void giveWayToJam(SoftContact& contact, double dt);
    void takeBodies();
    Taken taken(std::size_t contact);
    double thinLoad(const SoftContact& contact) const;
    void buildSolver(double h);
    static double thicknessOf(const Collider& c) {
        return c.kind == ColliderKind::Body ? c.smallestSide : std::numeric_limits<double>::infinity();
    }
    Side sideOf(const Collider& collider) const;
    const Side& sideOf(std::uint32_t slot, const Collider& collider, Side& still) const;
    double correctionOf(const SoftContact& contact, double thickness, double dt) const;
    void fillContact(const SoftContact& contact, SolverContact& c, double frequency, double h);
    static bool idle(const SoftContact& contact);
    void limitMassRatios();
    double yieldOf(const SolverContact& c) const;
    void noteSupport(const SolverContact& c);
    Vec3 loadOf(const SoftContact& contact) const;
    static Kind kindOf(const SoftContact& contact);
    bool unloads(const SoftContact& contact) const;
    void substeps(double dt);
    int substepsFor(double dt) const;
    static double sinkAllowed(double thickness);
    void prepareHook();
    void runHook(double h);
    void prefetchFor(const SolverContact& c) const { prefetch(m_contacts[c.found], SoftContact::bytes(c.points)); }
    void takeResult(const SolverContact& c, Outcome& outcome);
    void takeResults();
    double pressedByCorrection(const SolverContact& c, const SoftContact& contact) const;
    void accountForPiece(SoftContact& contact, const SolverContact& c, double pushed);
    void writeBack(double dt);
    double applyCorrection(std::size_t slot, double dt);
    double keepAboveGround(Solid& solid, double dt) const;
    void settle(double dt);
    void putAsideWhatRests(const std::vector<char>& froze);
    template <class Visit>
    void forEachContact(Visit visit) const {
        for (const SoftContact& contact : m_contacts) {
            if (!contact.aside) {
                visit(contact);
            }
        }
    }
    void freeze(Collider& body);
    void linkDependants();
    void shareSolveTime(double seconds);

    WorldSettings m_settings;
    StepCosts& m_costs;
    WorkerPool m_pool;
    SiteSurface m_surface;
    Collider m_ground;
    FreezeClock m_freeze;
    ContactReport m_report;
    SoftSolver m_solver;
    SubstepHook m_hook;
    std::vector<Solid> m_bodies;            ///< [bodies]
    std::vector<Solid> m_pieces;            ///< [pieces]
    std::vector<std::uint32_t> m_standing;  ///< pieces that are there, in order of entry
    std::vector<std::uint32_t> m_awake;     ///< body of each slot, in order of entry
    std::vector<std::uint32_t> m_moving;    ///< piece of each slot behind the bodies
    std::vector<char> m_still;              ///< [bodies] frozen or gone
    std::uint32_t m_stillSlot = 0;
    std::vector<char> m_supported, m_supportedNow;  ///< [slots] firm in the step before, in this step; moving pieces never
    std::vector<Side> m_sides;                      ///< [slots], but for the still one
    std::vector<double> m_inverse;                  ///< 1/kg, [slots], as the solver takes it
    std::vector<double> m_reach;                    ///< m/s, [slots] that its corners may get to
    std::vector<SlotPair> m_ends;                   ///< [contacts of the solver]
    std::array<double, Kinds> m_points{};           ///< contact points that the solver got, by kind
    bool m_correcting = false;                      ///< bodies come apart by position in this step
    int m_substeps = 1;                             ///< of this step
    double m_substepLength = 0.0;                   ///< s, of the step before: what the impulses carried on are for
    std::vector<Pair> m_pairs[Kinds];
    BoxIndex m_boxes;                                    ///< swept boxes by number
    std::vector<BroadPhaseEntry> m_entries;              ///< [numbers]
    std::vector<Pace> m_paces;                           ///< [numbers], at the start of the step
    std::vector<PlacedBox> m_placed;                     ///< of the parts of every collider that entered, at the start of the step
    std::vector<std::uint32_t> m_stirring;               ///< numbers, in this step
    std::vector<std::vector<ColliderPair>> m_pairParts;  ///< as found
    std::vector<std::vector<FoundContact>> m_parts;      ///< contacts as found, run after run
    std::vector<std::size_t> m_runs;                     ///< first part of each run
    std::size_t m_partsUsed = 0;
    std::vector<SoftContact> m_contacts, m_previous;
    std::vector<Taken> m_taken;                                                   ///< [contacts], then those that the solver gets
    std::vector<double> m_thinLoads;                                              ///< [contacts], see thinLoad()
    std::vector<std::vector<std::pair<ColliderPair, std::uint32_t>>> m_recalled;  ///< keys of contacts that slept
    double m_takingSeconds = 0.0;                                                 ///< s, of this step, for taking what was found
    std::vector<Outcome> m_outcomes;                                              ///< [contacts of the solver]
    SleepingContacts m_asleep;
    std::vector<std::uint32_t> m_justThawed;
    std::vector<std::uint32_t> m_unloaded;  ///< frozen bodies whose loads changed in this step
    std::vector<MovingBody> m_hooked;
    std::vector<std::int32_t> m_slotOf;
};

}  // namespace rubble
