#include "core/clusters/clustering.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <tuple>

#include "core/base/error.h"
#include "core/clusters/partition.h"
#include "tests/core/clusters/fragment_blocks.h"
#include "tests/core/clusters/matrix_oracle.h"

namespace rubble {
namespace {

Clustering cluster(const FragmentBlocks& blocks, const BasicGrid& grid, const GridSettings& settings) {
    return makeClusters(blocks.set, blocks.mesh, grid, settings, Execution());
}

GridSettings alongAxes() {
    GridSettings settings;
    settings.grouping = Grouping::Axes;
    return settings;
}

GridSettings withoutVelocitySplit() {
    GridSettings settings = alongAxes();
    settings.velocityTolerance = 0.0;
    return settings;
}

/// Member sets of a clustering, so that partitions can be compared whatever their numbering.
std::set<std::set<std::size_t>> memberSets(const Clustering& clustering) {
    std::set<std::set<std::size_t>> sets;
    for (std::size_t c = 0; c < clustering.list.size(); ++c) {
        std::set<std::size_t> members;
        for (const FragmentId f : clustering.membersOf(idAt<ClusterId>(c))) {
            members.insert(at(f));
        }
        sets.insert(members);
    }
    return sets;
}

/// The method by the book: matrix groups along each axis of each birth, their product, split by component.
std::set<std::set<std::size_t>> byTheBook(const FragmentBlocks& blocks, const BasicGrid& grid, bool acrossComponents) {
    std::map<std::pair<std::uint32_t, double>, std::vector<std::size_t>> births;
    for (std::size_t f = 0; f < blocks.set.size(); ++f) {
        births[{blocks.set.list[f].handOverState, blocks.set.list[f].endTime}].push_back(f);
    }
    std::set<std::set<std::size_t>> sets;
    const std::array<double, 3> size{grid.l, grid.w, grid.h};
    for (const auto& [birth, members] : births) {
        std::array<std::vector<std::uint32_t>, 3> label;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<Eigen::Index>(axis);
            std::vector<double> low;
            std::vector<double> high;
            std::vector<double> centre;
            std::vector<std::int64_t> id;
            for (const std::size_t f : members) {
                const Fragment& fragment = blocks.set.list[f];
                low.push_back(fragment.bounds.min()[a]);
                high.push_back(fragment.bounds.max()[a]);
                centre.push_back(fragment.bounds.center()[a]);
                id.push_back(blocks.mesh.elementIds[at(fragment.element)]);
            }
            label[axis] = matrixGroups(low, high, centre, id, size[axis]);
        }
        std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::size_t>, std::set<std::size_t>> groups;
        for (std::size_t i = 0; i < members.size(); ++i) {
            const std::size_t component = acrossComponents ? 0 : at(blocks.set.list[members[i]].component);
            groups[{label[0][i], label[1][i], label[2][i], component}].insert(members[i]);
        }
        for (const auto& [key, group] : groups) {
            sets.insert(group);
        }
    }
    return sets;
}

void expectSound(const FragmentBlocks& blocks, const Clustering& clustering) {
    ASSERT_EQ(clustering.of.size(), blocks.set.size());
    ASSERT_EQ(clustering.members.size(), blocks.set.size());
    std::vector<int> seen(blocks.set.size(), 0);
    std::pair<std::uint32_t, std::size_t> before{0, 0};
    for (std::size_t c = 0; c < clustering.list.size(); ++c) {
        const Cluster& body = clustering.list[c];
        const auto members = clustering.membersOf(idAt<ClusterId>(c));
        ASSERT_FALSE(members.empty());
        const std::pair<std::uint32_t, std::size_t> place{body.handOverState, at(members.front())};
        EXPECT_TRUE(c == 0 || before < place);
        before = place;
        EXPECT_TRUE(std::ranges::is_sorted(members));
        EXPECT_EQ(body.component, blocks.set.list[at(members.front())].component);
        Momenta sum;
        for (const FragmentId id : members) {
            const Fragment& f = blocks.set.list[at(id)];
            EXPECT_EQ(at(clustering.of[at(id)]), c);
            EXPECT_EQ(f.handOverState, body.handOverState);
            EXPECT_EQ(f.endTime, body.endTime);
            ++seen[at(id)];
            sum += rigidMomenta(f.mass, f.centre, f.inertia, f.velocity, f.angularVelocity);
        }
        const Momenta own = rigidMomenta(body.mass, body.centre, body.inertia, body.velocity, body.angularVelocity);
        // Rounding of a few dozen additions.
        EXPECT_NEAR(own.mass, sum.mass, 1e-12 * sum.mass);
        EXPECT_LT((own.linear - sum.linear).norm(), 1e-12 * sum.mass * 10.0);
        EXPECT_LT((own.angular - sum.angular).norm(), 1e-11 * sum.mass * 10.0 * (1.0 + body.centre.norm()));
        EXPECT_LE(own.kineticEnergy, sum.kineticEnergy * (1.0 + 1e-9));
    }
    EXPECT_TRUE(std::ranges::all_of(seen, [](int times) { return times == 1; }));
    EXPECT_EQ(clustering.productGroups + clustering.splitByComponent + clustering.splitByVelocity, clustering.list.size());
}

TEST(Clustering, EqualsTheMatrixMethodByTheBook) {
    std::mt19937 random(1);
    for (int round = 0; round < 60; ++round) {
        FragmentBlocks blocks = randomBlocks(random, 3, 40, 2.5);
        for (std::size_t f = 0; f < blocks.set.size(); f += 7) {
            blocks.set.list[f].endTime = 5.0;
        }
        const BasicGrid grid{uniform(random, 0.5, 4.0), uniform(random, 0.5, 4.0), uniform(random, 0.5, 4.0)};
        GridSettings settings = withoutVelocitySplit();
        for (const bool across : {false, true}) {
            settings.acrossComponents = across;
            const Clustering clustering = cluster(blocks, grid, settings);
            EXPECT_EQ(memberSets(clustering), byTheBook(blocks, grid, across)) << round;
            EXPECT_EQ(clustering.splitByVelocity, 0u);
            expectSound(blocks, clustering);
        }
    }
}

TEST(Clustering, EveryFragmentOnceAndMomentaConservedWithAllSplits) {
    std::mt19937 random(2);
    for (int round = 0; round < 40; ++round) {
        const FragmentBlocks blocks = randomBlocks(random, 4, 50, 2.0);
        const Clustering clustering = cluster(blocks, {3.0, 3.0, 3.0}, alongAxes());
        EXPECT_GT(clustering.splitByVelocity, 0u);
        EXPECT_GT(clustering.splitByComponent, 0u);
        expectSound(blocks, clustering);
        const Clustering nested = cluster(blocks, {3.0, 3.0, 3.0}, {});
        EXPECT_GT(nested.splitByVelocity, 0u);
        EXPECT_EQ(nested.splitByComponent, 0u);
        expectSound(blocks, nested);
    }
}

TEST(Clustering, OneBodyPerFragmentIsTheReference) {
    std::mt19937 random(3);
    const FragmentBlocks blocks = randomBlocks(random, 2, 30, 2.0);
    GridSettings settings;
    settings.oneBodyPerFragment = true;
    const Clustering clustering = cluster(blocks, {100.0, 100.0, 100.0}, settings);
    ASSERT_EQ(clustering.list.size(), blocks.set.size());
    expectSound(blocks, clustering);
    for (std::size_t f = 0; f < blocks.set.size(); ++f) {
        EXPECT_EQ(at(clustering.of[f]), f);
        EXPECT_EQ(clustering.list[f].velocity, blocks.set.list[f].velocity);
        EXPECT_EQ(clustering.list[f].angularVelocity, blocks.set.list[f].angularVelocity);
    }
}

TEST(Clustering, NothingToCluster) {
    const FragmentBlocks blocks;
    const Clustering clustering = cluster(blocks, {1.0, 1.0, 1.0}, {});
    EXPECT_TRUE(clustering.list.empty());
    EXPECT_TRUE(clustering.of.empty());
}

TEST(Clustering, RepeatsBitForBit) {
    std::mt19937 random(4);
    const FragmentBlocks blocks = randomBlocks(random, 3, 60, 2.0);
    const Clustering a = cluster(blocks, {2.0, 2.0, 2.0}, {});
    const Clustering b = cluster(blocks, {2.0, 2.0, 2.0}, {});
    ASSERT_EQ(a.list.size(), b.list.size());
    EXPECT_EQ(a.members, b.members);
    for (std::size_t c = 0; c < a.list.size(); ++c) {
        EXPECT_EQ(a.list[c].velocity, b.list[c].velocity);
        EXPECT_EQ(a.list[c].angularVelocity, b.list[c].angularVelocity);
    }
}

TEST(Clustering, CancelStopsIt) {
    std::mt19937 random(5);
    const FragmentBlocks blocks = randomBlocks(random, 1, 10, 2.0);
    const Execution execution;
    execution.cancel();
    EXPECT_THROW(makeClusters(blocks.set, blocks.mesh, {1.0, 1.0, 1.0}, {}, execution), Cancelled);
}

TEST(Partitioner, WhatItKeepsBetweenGridsChangesNothing) {
    std::mt19937 random(6);
    const FragmentBlocks blocks = randomBlocks(random, 3, 50, 3.0);
    Partitioner kept(blocks.set, blocks.mesh);
    GridSettings settings;
    for (int round = 0; round < 60; ++round) {
        std::array<double, 3> size;
        for (double& s : size) {
            s = 1.0 + static_cast<double>(random() % 4);  // few values, so that axes often stay
        }
        settings.velocityTolerance = random() % 2 ? 0.5 : 0.0;
        settings.acrossComponents = random() % 2 == 0;
        settings.grouping = random() % 2 ? Grouping::Nested : Grouping::Axes;
        Partitioner fresh(blocks.set, blocks.mesh);
        const Partition& a = kept.at(size, settings, Execution());
        const Partition& b = fresh.at(size, settings, Execution());
        ASSERT_EQ(a.members, b.members);
        ASSERT_EQ(a.sizes, b.sizes);
        // A count that stops early answers as a whole one does, and leaves nothing behind.
        const std::size_t clusters = b.clusters();
        EXPECT_TRUE(kept.atMost(clusters, size, settings, Execution()));
        EXPECT_FALSE(kept.atMost(clusters - 1, size, settings, Execution()));
        EXPECT_FALSE(kept.atMost(0, size, settings, Execution()));
        EXPECT_EQ(kept.at(size, settings, Execution()).sizes, b.sizes);
    }
}

}  // namespace
}  // namespace rubble
