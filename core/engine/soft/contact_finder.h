#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/engine/soft/box_contact.h"
#include "core/engine/soft/pair_finder.h"
#include "core/engine/soft/soft_bodies.h"
#include "core/engine/soft/soft_contact.h"
#include "core/engine/world/hull_contact.h"
#include "core/engine/world/worker_pool.h"
#include "core/fe/site_surface.h"

namespace rubble {

/// A contact of this step where it was found.
struct Found {
    ColliderPair pair = 0;
    std::uint32_t part = 0;
    const FoundContact* contact = nullptr;
};

/// The narrow phase: contacts of pairs that come near each other and of bodies near the ground. Poses are those at the start of the
/// step. Contacts have an order of their own, which threads do not reach.
class ContactFinder {
public:
    /// @param faces  deep boxes meet by faces, see collideBoxes()
    ContactFinder(const SiteSurface& surface, double gravity, bool faces, const SoftBodies& bodies, PairFinder& pairs,
                  WorkerPool& pool);

    Collider& ground() { return m_ground; }
    /// Takes a body or piece in, here and among the pairs.
    void enter(Collider& collider);
    void forget(const Collider& collider);
    /// Where the parts of a body or piece are now. Any number of threads for different ones.
    void place(const SoftBody& body);
    /// Box around the way of a placed one through dt [s], m, and how fast it is: contacts are found from as far away as a step
    /// leads.
    Aabb sweep(const SoftBody& body, double dt);
    /// A piece stands still.
    void stand(const SoftBody& piece) { m_paces[piece.collider->number] = {}; }
    /// m from which two colliders may touch within dt [s].
    double marginOf(std::uint32_t a, std::uint32_t b, double dt) const;

    /// Forgets what was found.
    void begin();
    void collide(std::span<const NearPair> pairs, double dt);
    void collideWithGround(std::span<const std::uint32_t> bodies, double dt);
    /// What was found so far, in parts.
    std::span<const std::vector<FoundContact>> parts() const { return std::span(m_parts).first(m_partsUsed); }
    /// The same in the order of pairs and parts.
    std::vector<Found> inOrder() const;

private:
    /// How fast a collider is.
    struct Pace {
        Vec3 velocity = Vec3::Zero();  ///< m/s
        double rim = 0.0;              ///< m/s, of the farthest corner by the spin
    };

    std::span<PlacedBox> placedOf(const Collider& c) {
        return std::span(m_placed).subspan(m_pairs.entry(c.number).part, c.parts.size());
    }
    void leaveOutApart(ContactPatch& patch, const Collider& a, const Collider& b, double dt) const;
    void collidePair(const NearPair& pair, double dt, std::vector<FoundContact>& found) const;
    PlacedHull placedHull(const Collider& of, std::size_t part) const;
    void collideBodyWithGround(const SoftBody& body, double dt, std::vector<FoundContact>& found);
    std::size_t beginRun(std::size_t count, std::size_t grain);
    void prepareHulls(const Collider& collider);

    SiteSurface m_surface;
    double m_gravity;  ///< m/s2
    bool m_faces;
    Collider m_ground;
    const SoftBodies& m_bodies;
    PairFinder& m_pairs;
    WorkerPool& m_pool;
    std::vector<Pace> m_paces;                       ///< [numbers], at the start of the step
    std::vector<PlacedBox> m_placed;                 ///< of the parts of every collider that entered, at the start of the step
    std::vector<std::vector<ConvexHull>> m_hulls;    ///< [numbers] of the parts, made when the first hull comes near
    std::vector<std::vector<FoundContact>> m_parts;  ///< contacts as found, run after run
    std::vector<std::size_t> m_runs;                 ///< first part of each run
    std::size_t m_partsUsed = 0;
};

}  // namespace rubble
