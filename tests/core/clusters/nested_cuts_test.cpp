#include "core/clusters/nested_cuts.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
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

/// Second moment of mass of a part's fragments, each about its own centre, from their solids; thin ones as if they were thicker.
Mat3 ownMoment(const FragmentBlocks& blocks, const Members& part, bool thickened) {
    Mat3 sum = Mat3::Zero();
    for (const std::uint32_t f : part) {
        const Fragment& fragment = blocks.set.list[f];
        sum += 0.5 * fragment.inertia.trace() * Mat3::Identity() - fragment.inertia;
    }
    return thickened ? Mat3(sum + 1e-4 / 3.0 * sum.trace() * Mat3::Identity()) : sum;
}

/// Of their centres, from all pairs: sum of m_i m_j (x_i - x_j) (x_i - x_j)^T / 2 over the mass.
Mat3 momentBetween(const FragmentBlocks& blocks, const Members& part) {
    Mat3 pairs = Mat3::Zero();
    double mass = 0.0;
    for (const std::uint32_t i : part) {
        const Fragment& a = blocks.set.list[i];
        mass += a.mass;
        for (const std::uint32_t j : part) {
            const Vec3 apart = a.centre - blocks.set.list[j].centre;
            pairs += 0.5 * a.mass * blocks.set.list[j].mass * apart * apart.transpose();
        }
    }
    return pairs / mass;
}

double massOf(const FragmentBlocks& blocks, const Members& part) {
    double mass = 0.0;
    for (const std::uint32_t i : part) {
        mass += blocks.set.list[i].mass;
    }
    return mass;
}

/// T of a part.
Mat3 boxOf(const FragmentBlocks& blocks, const Members& part, const Size& size) {
    Members everyone(blocks.set.size());
    std::iota(everyone.begin(), everyone.end(), 0u);
    const Vec3 mean = ownMoment(blocks, everyone, true).diagonal();
    const Mat3 shape = ownMoment(blocks, part, true);
    const Vec3 stretch = Vec3(size[0], size[1], size[2]).cwiseQuotient((mean / std::cbrt(mean.prod())).cwiseSqrt());
    return stretch.asDiagonal() * (shape / std::cbrt(shape.determinant())) * stretch.asDiagonal();
}

bool compact(const FragmentBlocks& blocks, const Members& part, const Size& size) {
    const Mat3 all = momentBetween(blocks, part) + ownMoment(blocks, part, false);
    const double spread = boxOf(blocks, part, size).fullPivLu().solve(all).trace();
    return part.size() == 1 || spread <= 0.25 * massOf(blocks, part) * (1.0 + 1e-9);
}

/// A part in two, and what its centres are apart within both.
struct Halves {
    std::array<Members, 2> sides;
    double left = std::numeric_limits<double>::infinity();
};

/// Every cut across a direction; the one that leaves the least spread along it.
Halves bestAcross(const FragmentBlocks& blocks, Members part, const Vec3& normal) {
    std::ranges::sort(part, {}, [&](std::uint32_t f) { return normal.dot(blocks.set.list[f].centre); });
    Halves best;
    for (std::size_t k = 1; k < part.size(); ++k) {
        const auto middle = part.begin() + static_cast<std::ptrdiff_t>(k);
        Halves halves{{Members(part.begin(), middle), Members(middle, part.end())}, 0.0};
        for (const Members& side : halves.sides) {
            halves.left += normal.dot(momentBetween(blocks, side) * normal);
        }
        if (halves.left < best.left) {
            best = halves;
        }
    }
    return best;
}

/// The cuts by trying every one, with spreads from all pairs.
void cutPlainly(const FragmentBlocks& blocks, const Size& size, Members part, std::set<Members>& parts) {
    std::ranges::sort(part);
    if (compact(blocks, part, size)) {
        parts.insert(part);
        return;
    }
    const Mat3 box = boxOf(blocks, part, size);
    const Mat3 between = momentBetween(blocks, part);
    int longest = 0;
    const double square = between.diagonal().cwiseQuotient(box.diagonal()).maxCoeff(&longest);
    std::vector<Halves> cuts{bestAcross(blocks, part, Vec3::Unit(longest))};
    // The direction n with the largest n.B n / n.T n.
    const Eigen::GeneralizedSelfAdjointEigenSolver<Mat3> directions(between, box);
    if (directions.eigenvalues()[2] > 1.01 * square) {
        cuts.push_back(bestAcross(blocks, part, directions.eigenvectors().col(2)));
    }
    for (Halves& cut : cuts) {
        cut.left = 0.0;
        for (const Members& side : cut.sides) {
            cut.left += box.fullPivLu().solve(momentBetween(blocks, side)).trace();
        }
    }
    for (const Members& side : std::ranges::min(cuts, {}, &Halves::left).sides) {
        cutPlainly(blocks, size, side, parts);
    }
}

/// Turns the solids of fragments about y, each about its own centre.
void turnSolids(FragmentBlocks& blocks, double degrees) {
    const Mat3 turn = Eigen::AngleAxisd(degrees * EIGEN_PI / 180.0, Vec3::UnitY()).toRotationMatrix();
    for (Fragment& fragment : blocks.set.list) {
        fragment.inertia = turn * fragment.inertia * turn.transpose();
    }
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

TEST(NestedCuts, PartsAreInTheProportionsOfTheirOwnFragments) {
    // Two fields of 8 x 8 x 8 fragments of one volume: tall ones and flat ones. Of both the grid takes 2 x 2 x 2 together.
    FragmentBlocks blocks;
    const std::array<Vec3, 2> forms{Vec3(1.0, 1.0, 4.0), Vec3(2.0, 2.0, 1.0)};
    for (std::size_t field = 0; field < 2; ++field) {
        for (int i = 0; i < 512; ++i) {
            const Vec3 place(i % 8, i / 8 % 8, i / 64);
            blocks.add(Vec3(100.0 * static_cast<double>(field), 0, 0) + place.cwiseProduct(forms[field]), forms[field]);
        }
    }
    const double side = 1.001 * 2.0 * std::cbrt(4.0);  // the tall ones count as slightly thicker
    const Vec3 mean = ((forms[0].cwiseAbs2() + forms[1].cwiseAbs2()) / 2.0).cwiseSqrt();
    const Vec3 size = side * mean / std::cbrt(mean.prod());
    const std::vector<Members> parts = partsOf(blocks, {size.x(), size.y(), size.z()});
    EXPECT_EQ(parts.size(), 128u);
    for (const Members& part : parts) {
        Aabb bounds;
        for (const std::uint32_t f : part) {
            bounds.extend(blocks.set.list[f].bounds);
        }
        EXPECT_EQ(bounds.sizes(), 2.0 * forms[part.front() / 512]);
    }
}

TEST(NestedCuts, WhatLeansIsCutAcrossWhereItLeans) {
    // A leaning wall, thin across: 2 x 16 stones along directions that are those of no axis.
    for (const double degrees : {0.0, 20.0, 45.0, 70.0}) {
        const Mat3 turn = Eigen::AngleAxisd(degrees * EIGEN_PI / 180.0, Vec3::UnitY()).toRotationMatrix();
        FragmentBlocks blocks;
        for (int i = 0; i < 32; ++i) {
            const Vec3 centre = turn * Vec3(i % 2, 0.0, i / 2);
            blocks.add(centre - 0.5 * Vec3::Ones(), Vec3::Ones());
        }
        turnSolids(blocks, degrees);
        const std::vector<Members> parts = partsOf(blocks, {2.0, 2.0, 2.0});
        std::set<Members> squares;
        for (std::uint32_t i = 0; i < 32; i += 4) {
            squares.insert({i, i + 1, i + 2, i + 3});
        }
        EXPECT_EQ(std::set<Members>(parts.begin(), parts.end()), squares) << degrees;
    }
}

TEST(NestedCuts, FragmentsWithoutThicknessAreCutLikeOthers) {
    FragmentBlocks blocks;
    for (int i = 0; i < 64; ++i) {
        blocks.add(Vec3(i % 8, i / 8, 0.0), Vec3(1.0, 1.0, 0.0)).mass = 1.0;
        blocks.set.list.back().inertia = Vec3(1.0, 1.0, 2.0).asDiagonal();
        blocks.set.list.back().inertia /= 12.0;
    }
    // The box has no thickness either; of 2 x 2 of its own volume.
    const double thin = std::sqrt(1e-4 / 3.0 * 2.0);
    const std::vector<Members> parts = partsOf(blocks, {2.0, 2.0, 2.0 * thin});
    EXPECT_EQ(parts.size(), 16u);
    EXPECT_TRUE(std::ranges::all_of(parts, [](const Members& part) { return part.size() == 4; }));
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
