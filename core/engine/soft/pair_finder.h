#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engine/soft/box_index.h"
#include "core/engine/world/birth_overlap.h"
#include "core/engine/world/collider.h"
#include "core/engine/world/sleep.h"
#include "core/engine/world/worker_pool.h"

namespace rubble {

/// What the phases of the search for contacts look at in a collider, side by side and on a line of the cache of its own.
struct alignas(64) BroadPhaseEntry {
    Aabb swept;                    ///< m, around its way in the latest step in which it stirred
    Collider* collider = nullptr;  ///< null once gone
    ColliderKind kind = ColliderKind::Body;
    bool stirs = false;      ///< in this step
    bool hull = false;       ///< a part is a hull
    std::uint32_t part = 0;  ///< the first of its parts among all
};

/// Two colliders whose ways in this step may cross, by their numbers, the smaller one first.
struct NearPair {
    std::uint32_t a = 0, b = 0;
    bool operator==(const NearPair&) const = default;
};

/// The pairs of a search, in the order of their numbers.
struct NearPairs {
    std::vector<NearPair> structure;  ///< a piece and a body
    std::vector<NearPair> fragments;  ///< two bodies
};

/// The broad phase: pairs of colliders of which one stirs and whose swept boxes overlap. Neither threads nor the history of its
/// tree reach the pairs or their order.
class PairFinder {
public:
    /// @param bodyContacts  bodies meet each other
    PairFinder(bool bodyContacts, WorkerPool& pool) : m_bodyContacts(bodyContacts), m_pool(pool) {}

    /// Takes a collider in by its number. It is found once it has stirred, or was put to rest.
    void enter(Collider& collider, std::uint32_t firstPart);
    void forget(std::uint32_t number);
    const BroadPhaseEntry& entry(std::uint32_t number) const { return m_entries[number]; }
    /// Null: there is none, or no longer.
    Collider* colliderNumbered(std::uint32_t number) const;
    /// Box around the way of one that stirs in the next search, m. Any number of threads for different ones.
    void sweep(std::uint32_t number, const Aabb& swept) { m_entries[number].swept = swept; }
    /// Where it stays until it stirs: what searches find without being told.
    void rest(std::uint32_t number, const Aabb& swept);

    /// Finds the pairs of this step.
    /// @param stirring  numbers of all that stirs
    void find(std::span<const std::uint32_t> stirring);
    const NearPairs& pairs() const { return m_pairs; }
    /// Adds pairs of bodies that woke since then with what did not stir before.
    /// @param woken  numbers; those awake by now, of which each pair is found once
    /// @param reach  m, by which a box swept at rest is too small
    NearPairs ofWoken(std::span<const std::uint32_t> woken, double reach, const Sleep& sleep) const;
    /// Box of a collider that is there, out or in, and with it its place in the tree.
    void keep(Archive& archive, const Collider& collider);

private:
    bool mayMeet(ColliderKind a, ColliderKind b) const;
    void stir(std::span<const std::uint32_t> stirring);
    std::vector<ColliderPair> inOrder() const;

    bool m_bodyContacts;
    WorkerPool& m_pool;
    BoxIndex m_boxes;                                ///< swept boxes by number
    std::vector<BroadPhaseEntry> m_entries;          ///< [numbers]
    std::vector<std::uint32_t> m_stirring;           ///< numbers, in this step
    std::vector<std::vector<ColliderPair>> m_found;  ///< by parts of the search
    NearPairs m_pairs;
};

}  // namespace rubble
