#include "core/engine/soft/pair_finder.h"

#include <algorithm>

namespace rubble {

namespace {

/// Colliders that one thread looks for partners of at a time.
constexpr std::size_t searchGrain = 128;

}  // namespace

void PairFinder::enter(Collider& collider, std::uint32_t firstPart) {
    m_entries.resize(std::max<std::size_t>(m_entries.size(), collider.number + 1));
    BroadPhaseEntry& entry = m_entries[collider.number];
    entry.collider = &collider;
    entry.kind = collider.kind;
    entry.hull = std::ranges::any_of(collider.parts, [](const ConvexPart& p) { return !p.points.empty(); });
    entry.part = firstPart;
}

void PairFinder::forget(std::uint32_t number) {
    m_entries[number].collider = nullptr;
    m_boxes.remove(number);
}

Collider* PairFinder::colliderNumbered(std::uint32_t number) const {
    return number < m_entries.size() ? m_entries[number].collider : nullptr;
}

void PairFinder::rest(std::uint32_t number, const Aabb& swept) {
    m_entries[number].swept = swept;
    m_boxes.set(number, swept);
}

bool PairFinder::mayMeet(ColliderKind a, ColliderKind b) const {
    return a == ColliderKind::Body ? b == ColliderKind::Piece || m_bodyContacts : b == ColliderKind::Body;
}

void PairFinder::stir(std::span<const std::uint32_t> stirring) {
    for (const std::uint32_t number : m_stirring) {
        m_entries[number].stirs = false;
    }
    m_stirring.assign(stirring.begin(), stirring.end());
    for (const std::uint32_t number : m_stirring) {
        m_entries[number].stirs = true;
        m_boxes.set(number, m_entries[number].swept);
    }
    m_boxes.refit();
}

void PairFinder::find(std::span<const std::uint32_t> stirring) {
    stir(stirring);
    m_found.resize(std::max(m_found.size(), m_stirring.size() / searchGrain + 1));
    for (std::vector<ColliderPair>& part : m_found) {
        part.clear();
    }
    m_pool.loop(m_stirring.size(), searchGrain, [&](std::size_t first, std::size_t last) {
        std::vector<ColliderPair>& found = m_found[first / searchGrain];
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
    m_pairs.structure.clear();
    m_pairs.fragments.clear();
    for (const ColliderPair pair : inOrder()) {
        const std::uint32_t a = firstOf(pair), b = secondOf(pair);
        const bool structure = m_entries[a].kind == ColliderKind::Piece || m_entries[b].kind == ColliderKind::Piece;
        (structure ? m_pairs.structure : m_pairs.fragments).push_back({a, b});
    }
}

/// All pairs that were found, by counting those of each first number and sorting those.
std::vector<ColliderPair> PairFinder::inOrder() const {
    const std::size_t numbers = m_entries.size();
    std::vector<std::uint32_t> begin(numbers + 1, 0);
    for (const std::vector<ColliderPair>& part : m_found) {
        for (const ColliderPair pair : part) {
            ++begin[firstOf(pair) + 1];
        }
    }
    for (std::size_t i = 0; i < numbers; ++i) {
        begin[i + 1] += begin[i];
    }
    std::vector<ColliderPair> ordered(begin.back());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (const std::vector<ColliderPair>& part : m_found) {
        for (const ColliderPair pair : part) {
            ordered[next[firstOf(pair)]++] = pair;
        }
    }
    m_pool.loop(numbers, 512, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            std::sort(ordered.begin() + begin[i], ordered.begin() + begin[i + 1]);
        }
    });
    return ordered;
}

NearPairs PairFinder::ofWoken(std::span<const std::uint32_t> woken, double reach, const Sleep& sleep) const {
    NearPairs pairs;
    for (const std::uint32_t number : woken) {
        const BroadPhaseEntry& own = m_entries[number];
        if (own.stirs) {
            continue;
        }
        Aabb swept = own.swept;
        swept.min().array() -= reach;
        swept.max().array() += reach;
        m_boxes.find(swept, [&](std::uint32_t other) {
            const BroadPhaseEntry& met = m_entries[other];
            // Of two that woke the older one finds the younger one.
            if (!met.stirs && !(sleep.awake(*met.collider) && other <= number) && mayMeet(own.kind, met.kind)) {
                (met.kind == ColliderKind::Piece ? pairs.structure : pairs.fragments)
                    .push_back({std::min(number, other), std::max(number, other)});
            }
        });
    }
    return pairs;
}

void PairFinder::keep(Archive& archive, const Collider& collider) {
    Aabb swept = m_entries[collider.number].swept;
    archive(swept);
    // A newborn has not been swept yet.
    if (archive.reading() && !collider.newborn) {
        rest(collider.number, swept);
    }
}

}  // namespace rubble
