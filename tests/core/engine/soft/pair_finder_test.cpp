#include "core/engine/soft/pair_finder.h"

#include <gtest/gtest.h>

#include <deque>
#include <numeric>
#include <random>

namespace rubble {
namespace {

/// Colliders in a cube, of which some are pieces and some stir.
struct Crowd {
    std::deque<Collider> colliders;
    std::vector<Aabb> boxes;  ///< [numbers]
    std::vector<std::uint32_t> stirring;

    Crowd(unsigned seed, std::uint32_t count) : boxes(1) {
        std::mt19937 random(seed);
        const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
        for (std::uint32_t number = 1; number <= count; ++number) {
            Collider& collider = colliders.emplace_back();
            collider.kind = number % 5 == 0 ? ColliderKind::Piece : ColliderKind::Body;
            collider.number = number;
            const Vec3 low(between(0, 10), between(0, 10), between(0, 10));
            boxes.emplace_back(low, low + Vec3(between(0.5, 2), between(0.5, 2), between(0.5, 2)));
            if (number % 3 != 0) {
                stirring.push_back(number);
            }
        }
    }

    void enterInto(PairFinder& finder) {
        for (Collider& collider : colliders) {
            finder.enter(collider, 0);
            if (collider.number % 3 == 0) {
                finder.rest(collider.number, boxes[collider.number]);
            } else {
                finder.sweep(collider.number, boxes[collider.number]);
            }
        }
    }

    /// Every pair looked at by itself.
    NearPairs expected(bool bodyContacts) const {
        NearPairs pairs;
        for (std::uint32_t a = 1; a < boxes.size(); ++a) {
            for (std::uint32_t b = a + 1; b < boxes.size(); ++b) {
                const bool pieceA = a % 5 == 0, pieceB = b % 5 == 0;
                const bool stirs = a % 3 != 0 || b % 3 != 0;
                const bool meet = (pieceA || pieceB) ? pieceA != pieceB : bodyContacts;
                if (stirs && meet && boxes[a].intersects(boxes[b])) {
                    (pieceA || pieceB ? pairs.structure : pairs.fragments).push_back({a, b});
                }
            }
        }
        return pairs;
    }
};

TEST(PairFinder, FindsEachPairOfWhichOneStirsOnceAndInOrder) {
    for (const int threads : {1, 2}) {
        for (const bool bodyContacts : {true, false}) {
            WorkerPool pool{threads};
            Crowd crowd(4, 600);
            PairFinder finder(bodyContacts, pool);
            crowd.enterInto(finder);
            finder.find(crowd.stirring);
            const NearPairs expected = crowd.expected(bodyContacts);
            EXPECT_GT(expected.structure.size(), 100u);
            EXPECT_EQ(expected.fragments.size() > 100u, bodyContacts);
            EXPECT_EQ(finder.pairs().structure, expected.structure) << threads;
            EXPECT_EQ(finder.pairs().fragments, expected.fragments) << threads;
        }
    }
}

TEST(PairFinder, ForgetsWhatLeftAndFindsWhatMoved) {
    WorkerPool pool{1};
    std::deque<Collider> colliders(3);
    PairFinder finder(true, pool);
    const Aabb here(Vec3(0, 0, 0), Vec3(1, 1, 1)), there(Vec3(5, 0, 0), Vec3(6, 1, 1));
    for (std::uint32_t i = 0; i < 3; ++i) {
        colliders[i].number = i + 1;
        finder.enter(colliders[i], 0);
        finder.sweep(i + 1, here);
    }
    const std::vector<std::uint32_t> all{1, 2, 3};
    finder.find(all);
    EXPECT_EQ(finder.pairs().fragments, (std::vector<NearPair>{{1, 2}, {1, 3}, {2, 3}}));
    finder.sweep(2, there);
    finder.find(all);
    EXPECT_EQ(finder.pairs().fragments, (std::vector<NearPair>{{1, 3}}));
    finder.forget(3);
    EXPECT_EQ(finder.colliderNumbered(3), nullptr);
    EXPECT_EQ(finder.colliderNumbered(1), &colliders[0]);
    finder.find(std::vector<std::uint32_t>{1, 2});
    EXPECT_TRUE(finder.pairs().fragments.empty());
}

TEST(PairFinder, BodiesThatWokeMeetWhatDidNotStirOnce) {
    WorkerPool pool{1};
    std::deque<Collider> colliders(4);
    PairFinder finder(true, pool);
    Sleep sleep(0.02, 0.5);
    const Aabb here(Vec3(0, 0, 0), Vec3(1, 1, 1));
    for (std::uint32_t i = 0; i < 4; ++i) {
        colliders[i].index = i;
        colliders[i].number = i + 1;
        sleep.addBody();
        finder.enter(colliders[i], 0);
        finder.rest(i + 1, here);
        sleep.freeze(colliders[i]);
    }
    sleep.thaw(colliders[0], Vec3::Zero());
    finder.sweep(1, here);
    finder.find(std::vector<std::uint32_t>{1});
    EXPECT_EQ(finder.pairs().fragments, (std::vector<NearPair>{{1, 2}, {1, 3}, {1, 4}}));
    // Two of the sleepers wake: what the first one has met already is not found again, and the two find each other once.
    sleep.thaw(colliders[1], Vec3::Zero());
    sleep.thaw(colliders[2], Vec3::Zero());
    NearPairs woken = finder.ofWoken(std::vector<std::uint32_t>{2, 3}, 0.01, sleep);
    std::ranges::sort(woken.fragments, {}, [](const NearPair& p) { return std::pair(p.a, p.b); });
    EXPECT_EQ(woken.fragments, (std::vector<NearPair>{{2, 3}, {2, 4}, {3, 4}}));
    EXPECT_TRUE(woken.structure.empty());
}

}  // namespace
}  // namespace rubble
