#include "core/trajectory/island_times.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace rubble {
namespace {

/// Two islands at 0.2 s, of three and of one element; what is left of the first at 0.3 s; another one at 0.4 s.
class SomeIslands : public testing::Test {
protected:
    void SetUp() override {
        trajectory.begin({});
        add(0.2, 30.0, {0, 1, 2});
        add(0.2, 10.0, {5});
        add(0.3, 20.0, {0, 2});
        add(0.4, 40.0, {4});
    }
    void add(double from, double mass, const std::vector<std::size_t>& elements) {
        BodyRecord body;
        body.body = idAt<BodyId>(trajectory.bodies().size());
        body.cluster = noCluster;
        body.from = from;
        body.mass = mass;
        IslandRecord island{body.body, 0, {}, {}};
        for (const std::size_t e : elements) {
            island.elements.push_back(idAt<ElementIndex>(e));
        }
        trajectory.addBodies(std::span(&body, 1), {});
        trajectory.addIslands(std::span(&island, 1), {});
    }
    MemoryTrajectory trajectory;
};

TEST_F(SomeIslands, WhatIsLeftOfOneIsNoHandOver) {
    const IslandTimes islands = islandTimes(trajectory, 7);
    ASSERT_EQ(islands.handOvers.size(), 2u);
    EXPECT_EQ(islands.handOvers[0].time, 0.2);
    EXPECT_EQ(islands.handOvers[0].islands, 2u);
    EXPECT_EQ(islands.handOvers[0].elements, 4u);
    EXPECT_EQ(islands.handOvers[0].mass, 40.0);
    EXPECT_EQ(islands.handOvers[1].time, 0.4);
    EXPECT_EQ(islands.handOvers[1].elements, 1u);
    EXPECT_EQ(islands.since[2], 0.2) << "since the first that had it";
    EXPECT_EQ(islands.since[4], 0.4);
    EXPECT_FALSE(islands.carried(ElementIndex{3}));
    EXPECT_FALSE(islands.carried(ElementIndex{99}));
}

TEST_F(SomeIslands, DeathsInThemAreCountedByState) {
    const std::vector<double> times{0.0, 0.1, 0.2, 0.3, 0.4, 0.5};
    Activity activity(times.size(), 7);
    // Element 3 dies at 0.4 s in no island, 4 at 0.1 s and again at 0.5 s, 1 at 0.4 s, 2 at 0.5 s.
    const std::vector<std::string> alive{"111111", "111100", "111110", "111100", "101110", "111111", "111111"};
    for (std::size_t e = 0; e < alive.size(); ++e) {
        for (std::size_t k = 0; k < times.size(); ++k) {
            activity.set(k, idAt<ElementIndex>(e), alive[e][k] == '1');
        }
    }
    const std::vector<double> deaths = islandTimes(trajectory, 7).deathsByState(activity, times);
    EXPECT_EQ(deaths, (std::vector<double>{0, 0, 0, 0, 1, 2})) << "not the first death of element 4";
}

TEST(IslandTimes, WithoutIslandsThereIsNothing) {
    const MemoryTrajectory trajectory;
    const IslandTimes islands = islandTimes(trajectory, 3);
    EXPECT_TRUE(islands.handOvers.empty());
    EXPECT_FALSE(islands.carried(ElementIndex{1}));
}

}  // namespace
}  // namespace rubble
