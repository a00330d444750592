#include <algorithm>

#include "core/simulation/soft_step_world.h"

namespace rubble {

namespace {

/// All pairs in order.
/// @param numbers  above every number of a collider
std::vector<ColliderPair> inOrder(const std::vector<std::vector<ColliderPair>>& parts, std::size_t numbers, WorkerPool& pool) {
    std::vector<std::uint32_t> begin(numbers + 1, 0);
    for (const std::vector<ColliderPair>& part : parts) {
        for (const ColliderPair pair : part) {
            ++begin[firstOf(pair) + 1];
        }
    }
    for (std::size_t i = 0; i < numbers; ++i) {
        begin[i + 1] += begin[i];
    }
    std::vector<ColliderPair> ordered(begin.back());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (const std::vector<ColliderPair>& part : parts) {
        for (const ColliderPair pair : part) {
            ordered[next[firstOf(pair)]++] = pair;
        }
    }
    pool.loop(numbers, 512, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            std::sort(ordered.begin() + begin[i], ordered.begin() + begin[i + 1]);
        }
    });
    return ordered;
}

}  // namespace

bool SoftStepWorld::mayMeet(ColliderKind a, ColliderKind b) const {
    return a == ColliderKind::Body ? b == ColliderKind::Piece || m_settings.bodyContacts : b == ColliderKind::Body;
}

/// Pairs of which one stirs and whose ways in this step may cross, in the order of their numbers.
void SoftStepWorld::findPairs() {
    for (const std::uint32_t number : m_stirring) {
        m_entries[number].stirs = false;
    }
    m_stirring.clear();
    for (const std::uint32_t i : m_awake) {
        m_stirring.push_back(m_bodies[i].collider->number);
    }
    for (const std::uint32_t i : m_standing) {
        if (const Collider& piece = *m_pieces[i].collider; piece.moving || piece.newborn) {
            m_stirring.push_back(piece.number);
        }
    }
    constexpr std::size_t grain = 128;
    m_pool.loop(m_stirring.size(), grain, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            BroadPhaseEntry& entered = m_entries[m_stirring[i]];
            entered.stirs = true;
            entered.swept = solidOf(*entered.collider).swept;
        }
    });
    for (const std::uint32_t number : m_stirring) {
        m_boxes.set(number, m_entries[number].swept);
    }
    m_boxes.refit();

    m_pairParts.resize(std::max(m_pairParts.size(), m_stirring.size() / grain + 1));
    for (std::vector<ColliderPair>& part : m_pairParts) {
        part.clear();
    }
    m_pool.loop(m_stirring.size(), grain, [&](std::size_t first, std::size_t last) {
        std::vector<ColliderPair>& found = m_pairParts[first / grain];
        for (std::size_t i = first; i < last; ++i) {
            const std::uint32_t number = m_stirring[i];
            const BroadPhaseEntry& own = m_entries[number];
            m_boxes.find(own.swept, [&](std::uint32_t other) {
                const BroadPhaseEntry& met = m_entries[other];
                // Of two that stir the older one finds the younger one.
                const bool foundThere = met.stirs && other <= number;
                if (!foundThere && mayMeet(own.kind, met.kind) && own.swept.intersects(met.swept)) {
                    found.push_back(colliderPair(number, other));
                }
            });
        }
    });
    for (std::vector<Pair>& list : m_pairs) {
        list.clear();
    }
    for (const ColliderPair pair : inOrder(m_pairParts, m_entries.size(), m_pool)) {
        const BroadPhaseEntry& a = m_entries[firstOf(pair)];
        const BroadPhaseEntry& b = m_entries[secondOf(pair)];
        const bool structure = a.kind == ColliderKind::Piece || b.kind == ColliderKind::Piece;
        m_pairs[structure ? Structure : Fragments].push_back({firstOf(pair), secondOf(pair)});
    }
}

/// Pairs of bodies that woke in this step with what did not stir before.
void SoftStepWorld::findPairsOfWoken(const std::vector<std::uint32_t>& woken, double dt, std::vector<Pair>& structure,
                                     std::vector<Pair>& fragments) const {
    for (const std::uint32_t i : woken) {
        Collider& own = *m_bodies[i].collider;
        if (m_entries[own.number].stirs) {
            continue;
        }
        Aabb swept = m_bodies[i].swept;
        // It was swept as one at rest.
        swept.min().array() -= m_settings.gravity * dt * dt;
        swept.max().array() += m_settings.gravity * dt * dt;
        m_boxes.find(swept, [&](std::uint32_t other) {
            Collider& met = *m_entries[other].collider;
            if (m_entries[other].stirs || (awake(met) && other <= own.number) || !mayMeet(own.kind, met.kind)) {
                return;
            }
            (met.kind == ColliderKind::Piece ? structure : fragments)
                .push_back({std::min(own.number, other), std::max(own.number, other)});
        });
    }
}

}  // namespace rubble
