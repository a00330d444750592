#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/engine/soft/contact_book.h"
#include "core/engine/soft/mass_split.h"
#include "core/engine/soft/rest_offsets.h"
#include "core/engine/soft/soft_bodies.h"
#include "core/engine/soft/soft_solver.h"
#include "core/engine/soft/speed_bound.h"

namespace rubble {

/// What a contact is one of, for the account of costs.
enum class ContactKind : std::uint8_t { Ground, Structure, Fragments };

/// What the solver is filled from.
struct AssemblyScene {
    const WorldSettings& settings;
    SoftBodies& bodies;
    const Sleep& sleep;
    ContactBook& contacts;
    const RestOffsets& rests;
    WorkerPool& pool;
};

/// Puts the bodies and contacts of a step before the solver, from the ground up. A light body that stands on something under a far
/// heavier one counts as heavier.
class SolverAssembly {
public:
    explicit SolverAssembly(const AssemblyScene& scene) : m_scene(scene) {}

    /// Makes room for the contacts of a step.
    void begin(std::size_t contacts);
    /// Notes a contact that is ready. Any number of threads for different ones.
    void take(std::size_t contact);
    /// Substeps that a step of dt [s] needs, so that thin bodies do not sink in too far.
    int substepsFor(double dt) const;
    /// Fills the solver for the substeps of dt [s], with the speeds that its bodies may get to.
    /// @param now  s, of the world's own time, at the start of the step
    void build(SoftSolver& solver, int substeps, double dt, double now);

    /// Prefetches what a contact of the solver comes from and goes to.
    void prefetchFor(const SolverContact& c) const;

    /// Contact points that the solver got, of all kinds or of one.
    double points() const { return points(ContactKind::Ground) + points(ContactKind::Structure) + points(ContactKind::Fragments); }
    double points(ContactKind kind) const { return m_points[static_cast<std::size_t>(kind)]; }
    /// The directions of friction of a contact.
    static std::array<Vec3, 2> tangentsOf(const Vec3& normal);
    /// m, from the centre of mass of one of the two of a contact to a point of it, at the start of the step.
    Vec3 armOf(bool ofA, const SolverContact& c, std::size_t point) const;
    /// N s per point and substep that a piece may give.
    double pieceLimit(const SoftContact& contact) const { return m_scene.rests.pieceLimit(contact, m_substeps, m_h * m_substeps); }
    /// Share of its true inverse mass that the lighter body of a contact has in this step.
    double yieldOf(const SolverContact& c) const;
    /// Notes that a contact acted: what lies on something firm is firm in the next step. Any number of threads.
    void noteSupport(const SolverContact& c, const Vec3& normal);
    /// The body of a slot lay on something firm in this step.
    bool supported(std::size_t slot) const { return m_supportedNow[slot] != 0; }
    int substeps() const { return m_substeps; }
    /// s, of the latest substeps: what the impulses carried on are for.
    double substepLength() const { return m_substepLength; }
    /// The substeps are done.
    void end() { m_substepLength = m_h; }
    void keep(Archive& archive) { archive(m_substepLength); }

private:
    /// What contacts ask of a body or piece, on a line of the cache of its own.
    struct alignas(64) Side {
        Vec3 centre = Vec3::Zero();
        double inverseMass = 0.0;                                    ///< 1/kg, as the solver takes it
        double yield = 1.0;                                          ///< share of the true one that this is
        double thickness = std::numeric_limits<double>::infinity();  ///< m
        Material material = Material::Concrete;
        bool swelling = false;  ///< a body that is in overlap from birth in this step
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
        ContactKind kind = ContactKind::Ground;
        Support support = Support::None;
        bool idle = false;  ///< carried nothing in the step before
    };

    Taken taken(std::size_t contact) const;
    double thinLoad(const SoftContact& contact) const;
    void takeBodies(SoftSolver& solver);
    void limitMassRatios(SoftSolver& solver);
    void order(SoftSolver& solver);
    Side sideOf(const Collider& collider) const;
    const Side& sideOf(std::uint32_t slot, const Collider& collider, Side& still) const;
    double correctionOf(const SoftContact& contact, double thickness, double dt) const;
    void makeConstraint(const SolverContact& c, ContactConstraint& made) const;
    void makePoints(const SolverContact& c, const Side& a, const Side& b, ContactConstraint& made) const;
    bool moves(std::uint32_t slot) const { return slot < m_scene.bodies.awake.size(); }

    AssemblyScene m_scene;
    double m_now = 0.0;                             ///< s, of the world's own time, at the start of this step
    int m_substeps = 1;                             ///< of this step
    double m_h = 0.0;                               ///< s, length of its substeps
    double m_substepLength = 0.0;                   ///< s, of the step before, then of this one
    std::vector<Taken> m_taken;                     ///< [contacts], then those that the solver gets
    std::vector<double> m_thinLoads;                ///< [contacts], see thinLoad()
    std::vector<Side> m_sides;                      ///< [slots], but for the still one
    std::vector<char> m_supported, m_supportedNow;  ///< [slots] firm in the step before, in this step; moving pieces never
    SpeedBound m_speeds;
    MassSplit m_split;
    std::vector<SpeedBound::SlotPair> m_ends;         ///< [contacts of the solver]
    std::vector<std::pair<double, double>> m_struck;  ///< m/s, likewise: see SpeedBound::struck()
    std::array<double, 3> m_points{};                 ///< by kind
};

}  // namespace rubble
