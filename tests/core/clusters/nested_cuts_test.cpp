#include "core/clusters/nested_cuts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include "tests/core/clusters/fragment_blocks.h"

namespace rubble {
namespace {

using Size = std::array<double, 3>;
using Members = std::vector<std::uint32_t>;

std::vector<Members> partsOf(const FragmentBlocks& blocks, const Size& size) {
    Members members(blocks.set.size());
    std::iota(members.begin(), members.end(), 0u);
    std::vector<std::uint32_t> sizes;
    NestedCuts(blocks.set, blocks.mesh).cut(size, members, sizes);
    std::vector<Members> parts;
    auto next = members.begin();
    for (const std::uint32_t count : sizes) {
        parts.emplace_back(next, next + count);
        next += count;
    }
    EXPECT_EQ(next, members.end());
    return parts;
}

/// D along one axis in terms of the grid, from all pairs: sum of m_i m_j (x_i - x_j)^2 / 2 over the mass, and the solids' own.
double spreadAlong(const FragmentBlocks& blocks, const Members& part, const Size& size, int axis, bool own) {
    double pairs = 0.0;
    double mass = 0.0;
    double within = 0.0;
    for (const std::uint32_t i : part) {
        const Fragment& a = blocks.set.list[i];
        mass += a.mass;
        within += a.mass * a.bounds.sizes()[axis] * a.bounds.sizes()[axis] / 12.0;
        for (const std::uint32_t j : part) {
            const Fragment& b = blocks.set.list[j];
            const double apart = a.centre[axis] - b.centre[axis];
            pairs += 0.5 * a.mass * b.mass * apart * apart;
        }
    }
    const double square = size[static_cast<std::size_t>(axis)] * size[static_cast<std::size_t>(axis)];
    return (pairs / mass + (own ? within : 0.0)) / square;
}

double massOf(const FragmentBlocks& blocks, const Members& part) {
    double mass = 0.0;
    for (const std::uint32_t i : part) {
        mass += blocks.set.list[i].mass;
    }
    return mass;
}

bool compact(const FragmentBlocks& blocks, const Members& part, const Size& size) {
    double spread = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        spread += spreadAlong(blocks, part, size, axis, true);
    }
    return part.size() == 1 || spread <= 0.25 * massOf(blocks, part) * (1.0 + 1e-9);
}

/// The cuts by trying every one, with spreads from all pairs.
void cutPlainly(const FragmentBlocks& blocks, const Size& size, Members part, std::set<Members>& parts) {
    std::ranges::sort(part);
    if (compact(blocks, part, size)) {
        parts.insert(part);
        return;
    }
    int longest = 0;
    for (const int axis : {1, 2}) {
        if (spreadAlong(blocks, part, size, axis, false) > spreadAlong(blocks, part, size, longest, false)) {
            longest = axis;
        }
    }
    std::ranges::stable_sort(part, [&](std::uint32_t a, std::uint32_t b) {
        return blocks.set.list[a].centre[longest] < blocks.set.list[b].centre[longest];
    });
    double least = std::numeric_limits<double>::infinity();
    std::size_t best = 0;
    for (std::size_t k = 1; k < part.size(); ++k) {
        const auto middle = part.begin() + static_cast<std::ptrdiff_t>(k);
        const double left = spreadAlong(blocks, Members(part.begin(), middle), size, longest, false) +
                            spreadAlong(blocks, Members(middle, part.end()), size, longest, false);
        if (left < least) {
            least = left;
            best = k;
        }
    }
    const auto middle = part.begin() + static_cast<std::ptrdiff_t>(best);
    cutPlainly(blocks, size, Members(part.begin(), middle), parts);
    cutPlainly(blocks, size, Members(middle, part.end()), parts);
}

TEST(NestedCuts, AFullBoxIsOnePartAndTwiceAsMuchIsTwo) {
    FragmentBlocks bar;
    for (int i = 0; i < 8; ++i) {
        bar.add(Vec3(i, 0, 0), Vec3::Ones());
    }
    EXPECT_EQ(partsOf(bar, {8.0, 1.0, 1.0}).size(), 1u);
    EXPECT_EQ(partsOf(bar, {7.99, 1.0, 1.0}).size(), 2u);
    const std::vector<Members> pairs = partsOf(bar, {2.0, 1.0, 1.0});
    EXPECT_EQ(pairs, (std::vector<Members>{{0, 1}, {2, 3}, {4, 5}, {6, 7}}));
    EXPECT_EQ(partsOf(bar, {0.9, 0.9, 0.9}).size(), 8u);
}

TEST(NestedCuts, ManyInAnyOrderAreCutIntoFullBoxes) {
    std::vector<int> places(4096);
    std::iota(places.begin(), places.end(), 0);
    std::mt19937 random(7);
    std::ranges::shuffle(places, random);
    FragmentBlocks bar;
    for (const int x : places) {
        bar.add(Vec3(x, 0, 0), Vec3::Ones());
    }
    const std::vector<Members> parts = partsOf(bar, {1024.0, 1.0, 1.0});
    ASSERT_EQ(parts.size(), 4u);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        EXPECT_EQ(parts[k].size(), 1024u);
        EXPECT_TRUE(std::ranges::all_of(
            parts[k], [&](std::uint32_t f) { return static_cast<std::size_t>(bar.set.list[f].centre.x()) / 1024 == k; }));
    }
}

TEST(NestedCuts, CutsWhereTheGapIs) {
    FragmentBlocks blocks;
    for (const double x : {0.0, 1.0, 2.0, 10.0, 11.0}) {
        blocks.add(Vec3(x, 0, 0), Vec3::Ones());
    }
    EXPECT_EQ(partsOf(blocks, {5.0, 5.0, 5.0}), (std::vector<Members>{{0, 1, 2}, {3, 4}}));
}

TEST(NestedCuts, EqualsTryingEveryCut) {
    std::mt19937 random(1);
    for (int round = 0; round < 60; ++round) {
        const FragmentBlocks blocks = randomBlocks(random, 1, 40, 2.5);
        const Size size{uniform(random, 0.5, 6.0), uniform(random, 0.5, 6.0), uniform(random, 0.5, 6.0)};
        Members all(blocks.set.size());
        std::iota(all.begin(), all.end(), 0u);
        std::set<Members> plain;
        cutPlainly(blocks, size, all, plain);
        const std::vector<Members> parts = partsOf(blocks, size);
        EXPECT_EQ(std::set<Members>(parts.begin(), parts.end()), plain) << round;
        for (const Members& part : parts) {
            EXPECT_TRUE(compact(blocks, part, size));
            EXPECT_TRUE(std::ranges::is_sorted(part));
        }
    }
}

TEST(NestedCuts, FragmentsAtOnePlaceThatAreTooLargeTogetherStandAlone) {
    FragmentBlocks blocks;
    for (int i = 0; i < 5; ++i) {
        blocks.add(Vec3::Zero(), Vec3::Constant(3.0));
    }
    EXPECT_EQ(partsOf(blocks, {2.0, 2.0, 2.0}).size(), 5u);
    EXPECT_EQ(partsOf(blocks, {3.0, 3.0, 3.0}).size(), 1u);
}

}  // namespace
}  // namespace rubble
