#include "core/analysis/debris/cell_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "core/analysis/debris/box_outline.h"
#include "core/base/error.h"
#include "tests/core/analysis/debris_scene.h"
#include "tests/scenes/level_site.h"

namespace rubble {
namespace {

using namespace analysis_scene;

TEST(CellMap, ABoxWithinOneCellGivesItAllItsMass) {
    const CellMap map = massMap(debrisFrom({boxAt(Vec3(1.0, 1.0, 0.5), 100.0)}), 2.0);
    ASSERT_EQ(map.size(), 1u);
    EXPECT_EQ(map.cells[0], (MapCell{0, 0}));
    EXPECT_EQ(map.values[0], 100.0);
    EXPECT_EQ(map.area(), 4.0);
}

TEST(CellMap, ABoxOnACrossingGivesEachCellItsShare) {
    // From -0.75 to 0.25 along x, from -0.5 to 0.5 along y.
    const CellMap map = massMap(debrisFrom({boxAt(Vec3(-0.25, 0.0, 0.5), 100.0)}), 2.0);
    ASSERT_EQ(map.size(), 4u);
    EXPECT_DOUBLE_EQ(map.at({0, -1}), 37.5);
    EXPECT_DOUBLE_EQ(map.at({-1, -1}), 37.5);
    EXPECT_DOUBLE_EQ(map.at({0, 0}), 12.5);
    EXPECT_DOUBLE_EQ(map.at({-1, 0}), 12.5);
    EXPECT_EQ(map.at({5, 5}), 0.0);
}

TEST(CellMap, ABoxThatOnlyTouchesACellDoesNotReachIntoIt) {
    // Turned by a quarter, so that its faces lie on the edges of cells up to rounding only.
    const Quat quarter(Eigen::AngleAxisd(M_PI / 2.0, Vec3::UnitZ()));
    const Debris debris = debrisFrom({boxAt(Vec3(3.0, 5.0, 0.5), 1.0, Vec3(1.0, 1.0, 0.5), quarter)});
    EXPECT_EQ(massMap(debris, 2.0).size(), 1u);
    EXPECT_EQ(heightMap(debris, 2.0, levelSite).size(), 1u);
    EXPECT_EQ(heightMap(debris, 1.0, levelSite).size(), 4u);
}

TEST(CellMap, ABoxWithoutOutlineGoesToTheCellOfItsCentre) {
    const Debris debris =
        debrisFrom({boxAt(Vec3(2.5, 0.5, 1.0), 7.0, Vec3(0.0, 0.0, 1.0)), boxAt(Vec3(0.5, 0.5, 1.0), 5.0, Vec3::Zero()),
                    boxAt(Vec3(5.9, 0.5, 1.0), 3.0, Vec3(4.0, 0.0, 1.0))});
    const CellMap map = massMap(debris, 1.0);
    EXPECT_EQ(map.at({0, 2}), 7.0);
    EXPECT_EQ(map.at({0, 0}), 5.0);
    EXPECT_EQ(map.at({0, 5}), 3.0);
    EXPECT_EQ(map.sum(), 15.0);
}

TEST(CellMap, KeepsAllMassAndItsPlace) {
    const Debris debris = randomField(3, 2000, 30.0);
    double mass = 0.0;
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    for (const DebrisFragment& lies : debris.fragments) {
        mass += lies.mass;
        moment += lies.mass * lies.centre.head<2>();
    }
    for (const double cell : {0.25, 1.0, 2.0, 7.3}) {
        const CellMap map = massMap(debris, cell);
        EXPECT_NEAR(map.sum(), mass, 1e-12 * mass) << cell;
        // The centroid of the map is that of the debris to within half a cell at the very worst; here to a small part of one.
        Eigen::Vector2d ofMap = Eigen::Vector2d::Zero();
        for (std::size_t k = 0; k < map.size(); ++k) {
            ofMap += map.values[k] * cell * Eigen::Vector2d(map.cells[k].i + 0.5, map.cells[k].j + 0.5);
        }
        EXPECT_LT((ofMap - moment).norm() / mass, 0.05 * cell) << cell;
    }
}

// The same by another way: points on a fine raster under each outline instead of polygons.
TEST(CellMap, AgreesWithCountingPoints) {
    const Debris debris = randomField(5, 40, 4.0);
    const double cell = 1.0;
    constexpr int points = 80;  // per metre
    std::map<MapCell, double> counted;
    for (const DebrisFragment& lies : debris.fragments) {
        const BoxTop top(lies.box);
        std::map<MapCell, int> hits;
        int all = 0;
        const double reach = lies.box.halfExtents.norm();
        const int firstX = static_cast<int>(std::floor((lies.centre.x() - reach) * points));
        const int firstY = static_cast<int>(std::floor((lies.centre.y() - reach) * points));
        const int count = static_cast<int>(std::ceil(2.0 * reach * points)) + 1;
        for (int b = 0; b < count; ++b) {
            for (int a = 0; a < count; ++a) {
                const double x = (firstX + a + 0.5) / points;
                const double y = (firstY + b + 0.5) / points;
                if (top.at(x, y)) {
                    ++hits[{static_cast<std::int32_t>(std::floor(y)), static_cast<std::int32_t>(std::floor(x))}];
                    ++all;
                }
            }
        }
        for (const auto& [where, number] : hits) {
            counted[where] += lies.mass * number / all;
        }
    }
    const CellMap map = massMap(debris, cell);
    double difference = 0.0;
    for (std::size_t k = 0; k < map.size(); ++k) {
        difference += std::abs(map.values[k] - counted[map.cells[k]]);
    }
    // 80 points a metre resolve the edge of an outline to about 1 % of its area.
    EXPECT_LT(difference / map.sum(), 0.01);
}

TEST(CellMap, MovesWithTheDebrisByWholeCells) {
    // Places on a raster of 2^-10 m: shifting them by whole cells loses no bit.
    Debris debris = randomField(11, 500, 20.0);
    for (DebrisFragment& lies : debris.fragments) {
        lies.centre = lies.box.centre = (lies.centre * 1024.0).array().round() / 1024.0;
    }
    const CellMap before = massMap(debris, 2.0);
    const CellMap after = massMap(moved(debris, Vec3(14.0, -6.0, 0.0)), 2.0);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t k = 0; k < before.size(); ++k) {
        EXPECT_EQ(after.cells[k].i, before.cells[k].i + 7);
        EXPECT_EQ(after.cells[k].j, before.cells[k].j - 3);
        EXPECT_NEAR(after.values[k], before.values[k], 1e-9 * before.values[k] + 1e-9);
    }
}

TEST(CellMap, HeightOfASlabIsItsTop) {
    // Half of the cell to the right is covered: eight of its sixteen points.
    const CellMap map = heightMap(debrisFrom({boxAt(Vec3(0.75, 0.5, 0.2), 1.0, Vec3(0.75, 0.5, 0.2))}), 1.0, levelSite);
    ASSERT_EQ(map.size(), 2u);
    EXPECT_DOUBLE_EQ(map.at({0, 0}), 0.4);
    EXPECT_DOUBLE_EQ(map.at({0, 1}), 0.2);
}

TEST(CellMap, HeightIsTheHighestOfWhatLiesThere) {
    const CellMap map = heightMap(debrisFrom({boxAt(Vec3(0.5, 0.5, 0.5), 1.0), boxAt(Vec3(0.5, 0.5, 1.5), 1.0)}), 1.0, levelSite);
    EXPECT_DOUBLE_EQ(map.at({0, 0}), 2.0);
}

TEST(CellMap, HeightCountsFromTheGroundAndNeverBelow) {
    SiteSurface high;
    high.levelHeight = 0.75;
    EXPECT_DOUBLE_EQ(heightMap(debrisFrom({boxAt(Vec3(0.5, 0.5, 0.5), 1.0)}), 1.0, high).at({0, 0}), 0.25);
    const CellMap sunk = heightMap(debrisFrom({boxAt(Vec3(0.5, 0.5, -5.0), 1.0)}), 1.0, high);
    ASSERT_EQ(sunk.size(), 1u) << "what sank still belongs to the footprint";
    EXPECT_EQ(sunk.values[0], 0.0);
    SiteSurface slope;
    slope.terrain = std::make_shared<TerrainGrid>(0.0, 0.0, 4.0, 2, 2, std::vector<double>{0.0, 4.0, 0.0, 4.0});  // z = x
    // The mean of 2 - x over the cell from 0 to 1.
    EXPECT_DOUBLE_EQ(heightMap(debrisFrom({boxAt(Vec3(0.5, 0.5, 1.5), 1.0)}), 1.0, slope).at({0, 0}), 1.5);
}

TEST(CellMap, AbsentFragmentsDoNotCount) {
    Debris debris = debrisFrom({boxAt(Vec3(0.5, 0.5, 0.5), 1.0), boxAt(Vec3(9.5, 0.5, 0.5), 1.0)});
    debris.fragments[1].present = false;
    debris.fragments[1].centre.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(massMap(debris, 1.0).size(), 1u);
    EXPECT_EQ(heightMap(debris, 1.0, levelSite).size(), 1u);
    EXPECT_EQ(massMap(Debris{}, 1.0).size(), 0u);
}

TEST(CellMap, AFragmentThatFlewFarCostsOneCell) {
    const CellMap map = massMap(
        debrisFrom({boxAt(Vec3(1e8 + 0.5, -1e8 + 0.5, 0.0), 3.0, Vec3::Constant(0.25)), boxAt(Vec3(0.5, 0.5, 0.0), 1.0)}), 1.0);
    EXPECT_EQ(map.size(), 2u);
}

TEST(CellMap, RefusesWhatIsNoNumberAndWhatIsTooLarge) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    for (const Vec3& place : {Vec3(nan, 0, 0), Vec3(0, 0, nan), Vec3(0, infinite, 0), Vec3(1e300, 0, 0), Vec3(0, 4e9, 0)}) {
        EXPECT_THROW(massMap(debrisFrom({boxAt(place, 1.0)}), 1.0), UsageError) << place.transpose();
        EXPECT_THROW(heightMap(debrisFrom({boxAt(place, 1.0)}), 1.0, levelSite), UsageError);
    }
    for (const double mass : {nan, infinite, -1.0}) {
        EXPECT_THROW(massMap(debrisFrom({boxAt(Vec3::Zero(), mass)}), 1.0), UsageError) << mass;
    }
    for (const double half : {nan, infinite, -1.0, 1e6}) {
        EXPECT_THROW(massMap(debrisFrom({boxAt(Vec3::Zero(), 1.0, Vec3(half, 1e6, 1.0))}), 1.0), UsageError) << half;
    }
    for (const double cell : {nan, infinite, 0.0, -1.0, 1e-9}) {
        EXPECT_THROW(massMap(debrisFrom({boxAt(Vec3(1e3, 0, 0), 1.0)}), cell), UsageError) << cell;
    }
    Debris debris = debrisFrom({boxAt(Vec3::Zero(), 1.0)});
    debris.fragments[0].box.orientation.coeffs()[1] = nan;
    EXPECT_THROW(massMap(debris, 1.0), UsageError);
}

}  // namespace
}  // namespace rubble
