#include "core/simulation/run/terrain_ends.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace rubble {
namespace {

using testing::HasSubstr;

std::string nameOf(std::size_t piece) {
    return "piece " + std::to_string(piece);
}

TerrainGrid level(GridSides unread = {}) {
    TerrainExtent extent;
    extent.unread = unread;
    return TerrainGrid(HeightGrid{-50.0, -50.0, 10.0, 10.0, 11, 11, std::vector<double>(121, 0.0)}, std::move(extent));
}

TEST(TerrainEnds, DebrisOnTheRasterSaysNothing) {
    Findings findings;
    const double none = std::numeric_limits<double>::quiet_NaN();
    addTerrainEnds(level(), std::array{Vec3(0, 0, 1), Vec3(54, -54, 1), Vec3(none, 0, 0)}, nameOf, findings);
    EXPECT_TRUE(findings.empty());
}

TEST(TerrainEnds, BeyondTheRasterEachPieceCountsAndTheFarthestIsNamed) {
    Findings findings;
    addTerrainEnds(level({0, 3, 0, 0}), std::array{Vec3(-60, 0, 1), Vec3(0, 0, 1), Vec3(-95, 20, -7), Vec3(70, 0, 1)}, nameOf,
                   findings);
    EXPECT_EQ(findings.count("simulation.terrain_ended"), 2);
    EXPECT_EQ(findings.count("simulation.terrain_unread"), 1);
    const Finding& ended = findings.list().front();
    EXPECT_EQ(ended.example, "piece 2 at x = -95 m, y = 20 m");
    EXPECT_THAT(englishText(ended.remedy), HasSubstr("x = -95 to -60 m, y = 0 to 20 m"));
    EXPECT_THAT(englishText(findings.list().back().remedy), HasSubstr("coarser"));
}

TEST(TerrainEnds, DebrisBelowWaterThatActedOnNothingIsCounted) {
    Findings findings;
    const double none = std::numeric_limits<double>::quiet_NaN();
    addWaterMissed(-3.0, std::array{Vec3(0, 0, 1), Vec3(9, 0, -2.9)}, nameOf, findings);
    EXPECT_TRUE(findings.empty());
    addWaterMissed(-3.0, std::array{Vec3(0, 0, none), Vec3(40, 0, -4), Vec3(0, 0, 1), Vec3(50, 0, -6), Vec3(45, 0, -5)}, nameOf,
                   findings);
    EXPECT_EQ(findings.count("simulation.water_missed"), 3);
    EXPECT_EQ(findings.list().front().example, "piece 3 at z = -6 m");
}

}  // namespace
}  // namespace rubble
