#include "core/fe/loose_structure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/fragments/lifetimes.h"
#include "tests/core/fragments/element_scene.h"

namespace rubble {
namespace {

/// Cubes of 1 m in a row along x that share their faces, and how the states of each begin and end.
class Row {
public:
    Row(const std::vector<std::string>& activity, double height) : m_first(activity.size() + 1) {
        const std::string never(activity.front().size(), '0');
        for (std::size_t i = 0; i < m_first; ++i) {
            const auto x = static_cast<double>(i);
            // Never active: it is here for its nodes.
            scene.element(ElementShape::Quadrilateral, {{x, 0, height}, {x, 1, height}, {x, 1, height + 1}, {x, 0, height + 1}},
                          never, 0.1);
        }
        for (std::uint32_t i = 0; i < activity.size(); ++i) {
            const std::uint32_t left = 4 * i;
            const std::uint32_t right = left + 4;
            scene.between(ElementShape::Hexahedron, {left, right, right + 1, left + 1, left + 3, right + 3, right + 2, left + 2},
                          activity[i]);
        }
    }

    LooseStructure loose(Revival revival = Revival::Latch) const {
        const auto fe = scene.result();
        return looseStructure(*fe, activityUnder(fe->activity(), revival), {true, 0.0, nullptr}, Execution());
    }

    LooseAccount account() const {
        const auto fe = scene.result();
        return accountOf(loose(), *fe, activityUnder(fe->activity(), Revival::Latch), test::ElementScene::components(*fe));
    }

    /// Which cubes an island begins with.
    std::vector<std::size_t> cubes(const LooseIsland& island) const {
        std::vector<std::size_t> list;
        for (const ElementIndex e : island.elements) {
            list.push_back(at(e) - m_first);
        }
        return list;
    }

    std::uint32_t islandOf(const LooseStructure& loose, std::size_t state, std::size_t cube) const {
        return loose.islandOf(state, idAt<ElementIndex>(cube + m_first));
    }

    test::ElementScene scene;

private:
    std::size_t m_first;  ///< index of the first cube
};

using Cubes = std::vector<std::size_t>;

/// What lies beyond x falls from the first second on.
test::ElementScene::Motion fallBeyond(double x) {
    return [x](const Vec3& rest, double t) {
        const double fallen = rest.x() > x && t > 1.0 ? 4.9 * (t - 1.0) * (t - 1.0) : 0.0;
        return Vec3(rest - fallen * Vec3::UnitZ());
    };
}

TEST(LooseStructure, NothingIsLooseWhileAllHangsOnASupport) {
    const Row row({"11111", "11111", "11111"}, 0.0);
    EXPECT_TRUE(row.loose().islands.empty());
    EXPECT_EQ(row.account().looseAtOnce, 0);
}

TEST(LooseStructure, BeginsWhereThePathToTheSupportEndsAndGoesOnAsItsLargestPart) {
    // The second cube dies at 2 s: four fall. The sixth dies at 4 s: of three and one the three go on, and die at 5 s.
    Row row({"1111111", "1100000", "1111100", "1111100", "1111100", "1111000", "1111111"}, 50.0);
    row.scene.position = fallBeyond(1.5);
    const LooseStructure loose = row.loose();
    ASSERT_EQ(loose.islands.size(), 2u);
    const LooseIsland& span = loose.islands[0];
    EXPECT_EQ(row.cubes(span), (Cubes{2, 3, 4, 5, 6}));
    EXPECT_EQ(span.from, 2u);
    EXPECT_EQ(span.to, 4u);
    EXPECT_EQ(span.end, IslandEnd::Died);
    EXPECT_FALSE(span.parent);
    const LooseIsland& end = loose.islands[1];
    EXPECT_EQ(row.cubes(end), (Cubes{6}));
    EXPECT_EQ(end.from, 4u);
    EXPECT_EQ(end.to, 6u);
    EXPECT_EQ(end.end, IslandEnd::Alive);
    EXPECT_EQ(end.parent, std::optional<std::uint32_t>(0)) << "it came out of the span";
    EXPECT_EQ(row.islandOf(loose, 3, 5), 0u);
    EXPECT_EQ(row.islandOf(loose, 4, 5), inNoIsland) << "dead";
    EXPECT_EQ(row.islandOf(loose, 6, 0), inNoIsland) << "stands";
}

TEST(LooseStructure, TellsHowLongElementsWereLooseBeforeTheyDied) {
    Row row({"1111111", "1100000", "1111100", "1111100", "1111100", "1111000", "1111111"}, 50.0);
    row.scene.position = fallBeyond(1.5);
    const LooseAccount account = row.account();
    EXPECT_EQ(account.dead, 5);
    EXPECT_EQ(account.deadLoose, 4) << "all but the one that still stood";
    EXPECT_DOUBLE_EQ(account.median, 2.0) << "1, 2, 2 and 2 s to the last active state";
    EXPECT_DOUBLE_EQ(account.tenth, 1.0);
    EXPECT_EQ(account.looseAtOnce, 5);
    EXPECT_EQ(account.largeAtOnce, 0);
    ASSERT_EQ(account.islands.size(), 2u);
    EXPECT_EQ(account.islands[0].island, 0u) << "the heaviest first";
    EXPECT_DOUBLE_EQ(account.islands[0].mass, 5 * 2000.0);
    EXPECT_DOUBLE_EQ(account.islands[0].from, 2.0);
    EXPECT_EQ(account.islands[0].died, 4);
    EXPECT_EQ(account.islands[1].died, 0);
    EXPECT_TRUE(std::isnan(account.islands[1].medianSeconds));
}

TEST(LooseStructure, WhatComesBackToLifeHoldsAgain) {
    Row row({"111111", "110011", "111111", "111111"}, 50.0);
    row.scene.position = [](const Vec3& rest, double t) {
        const bool away = rest.x() > 1.5 && t > 1.5 && t < 3.5;
        return Vec3(rest + (away ? 0.5 * (t - 1.0) : 0.0) * Vec3::UnitY());
    };
    const LooseStructure loose = row.loose(Revival::Follow);
    ASSERT_EQ(loose.islands.size(), 1u);
    EXPECT_EQ(loose.islands[0].from, 2u);
    EXPECT_EQ(loose.islands[0].to, 3u);
    EXPECT_EQ(loose.islands[0].end, IslandEnd::Supported);
}

TEST(LooseStructure, TwoThatAreJoinedGoOnAsTheLarger) {
    // The fourth cube is away from 2 to 3 s, the second for good: three islands, then one of two of them.
    Row row({"111111", "110000", "111111", "110011", "111111", "111111"}, 50.0);
    row.scene.position = fallBeyond(1.5);
    const LooseStructure loose = row.loose(Revival::Follow);
    ASSERT_EQ(loose.islands.size(), 2u);
    EXPECT_EQ(row.cubes(loose.islands[0]), (Cubes{2}));
    EXPECT_EQ(loose.islands[0].to, 3u);
    EXPECT_EQ(loose.islands[0].end, IslandEnd::Joined);
    EXPECT_EQ(row.cubes(loose.islands[1]), (Cubes{4, 5}));
    EXPECT_EQ(loose.islands[1].end, IslandEnd::Alive);
    EXPECT_EQ(row.islandOf(loose, 5, 2), 1u);
}

TEST(LooseStructure, AnEarthquakeLoosensNothingThatItsGroundCarries) {
    Row row({"111111", "110000", "111111"}, 0.0);
    const auto shaken = [](double t) {
        // At rest again at the end, 0.1 m from where it was; up to 0.5 m/s before.
        const std::vector<double> places{0.0, 0.3, -0.2, 0.2, 0.1, 0.1};
        return places[static_cast<std::size_t>(t + 0.5)];
    };
    row.scene.position = [shaken](const Vec3& rest, double t) { return Vec3(rest + shaken(t) * Vec3::UnitX()); };
    EXPECT_TRUE(row.loose().islands.empty()) << "both parts stand on the ground";

    row.scene.position = [shaken](const Vec3& rest, double t) {
        const double lifted = rest.x() > 1.5 && t > 1.5 ? 0.3 * (t - 1.0) : 0.0;
        return Vec3(rest + shaken(t) * Vec3::UnitX() + lifted * Vec3::UnitZ());
    };
    const LooseStructure loose = row.loose();
    ASSERT_EQ(loose.islands.size(), 1u) << "what left the ground is loose, shaken or not";
    EXPECT_EQ(loose.islands[0].from, 2u);
}

TEST(LooseStructure, AllOfAStructureCanBeLoose) {
    Row row({"111111", "111110"}, 50.0);
    row.scene.position = fallBeyond(-1.0);
    const LooseStructure loose = row.loose();
    ASSERT_EQ(loose.islands.size(), 1u);
    EXPECT_EQ(loose.islands[0].from, 2u) << "at 0 and 1 s it is still where it was at rest";
    EXPECT_EQ(loose.islands[0].end, IslandEnd::Alive);
}

TEST(LooseStructure, SaysWhetherAnythingComesLoose) {
    const auto any = [](const Row& row) {
        const auto fe = row.scene.result();
        return comesLoose(*fe, activityUnder(fe->activity(), Revival::Latch), {true, 0.0, nullptr});
    };
    EXPECT_FALSE(any(Row({"11111", "11111", "10000", "11111"}, 0.0))) << "all stand on the ground";
    Row falling({"11111", "11000", "11111", "11110"}, 50.0);
    falling.scene.position = fallBeyond(1.5);
    EXPECT_TRUE(any(falling));
    // Loose from 2 s on, and dead or at the end of the FE result by 3 s.
    Row brief({"1111", "1100", "1110", "1110"}, 50.0);
    brief.scene.position = fallBeyond(1.5);
    EXPECT_FALSE(brief.loose().islands.empty());
    EXPECT_FALSE(any(brief));
}

TEST(LooseStructure, SaysHowMuchIsLooseAtOneTime) {
    const auto most = [](const Row& row) {
        const auto fe = row.scene.result();
        return mostLooseAtOnce(*fe, activityUnder(fe->activity(), Revival::Latch), {true, 0.0, nullptr}, Execution());
    };
    EXPECT_EQ(most(Row({"11111", "11111", "10000", "11111"}, 0.0)).elements, 0) << "all stand on the ground";
    Row falling({"11111", "11000", "11111", "11110"}, 50.0);
    falling.scene.position = fallBeyond(-1.0);
    const LooseAtOnce here = most(falling);
    EXPECT_EQ(here.time, 2.0) << "at 3 s one of them is about to die";
    EXPECT_EQ(here.islands, 2);
    EXPECT_EQ(here.elements, 3);
    Row brief({"1111", "1100", "1110", "1110"}, 50.0);
    brief.scene.position = fallBeyond(1.5);
    EXPECT_EQ(most(brief).elements, 0) << "loose, and dead or at the end of the FE result by the next state";
}

TEST(LooseStructure, CanBeCancelled) {
    const Row row({"11", "11"}, 0.0);
    const auto fe = row.scene.result();
    const Execution execution;
    execution.cancel();
    EXPECT_THROW(looseStructure(*fe, fe->activity(), {true, 0.0, nullptr}, execution), Cancelled);
    EXPECT_THROW(mostLooseAtOnce(*fe, fe->activity(), {true, 0.0, nullptr}, execution), Cancelled);
}

}  // namespace
}  // namespace rubble
