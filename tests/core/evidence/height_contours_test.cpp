#include "core/evidence/maps/height_contours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/error.h"

namespace rubble {
namespace {

struct Heights {
    std::vector<MapCell> cells;
    std::vector<double> values;
};

template <class Height>
Heights heightsOf(int reach, double side, Height height) {
    Heights map;
    for (int j = -reach; j < reach; ++j) {
        for (int i = -reach; i < reach; ++i) {
            map.cells.push_back({j, i});
            map.values.push_back(height((i + 0.5) * side, (j + 0.5) * side));
        }
    }
    return map;
}

double areaOf(const HeightContour& contour) {
    double twice = 0.0;
    for (std::size_t k = 0; k < contour.corners.size(); ++k) {
        const Eigen::Vector2d& a = contour.corners[k];
        const Eigen::Vector2d& b = contour.corners[(k + 1) % contour.corners.size()];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return 0.5 * twice;
}

TEST(HeightContours, OfAConeAreCircles) {
    const Heights cone = heightsOf(60, 0.1, [](double x, double y) { return std::max(0.0, 5.0 - std::hypot(x, y)); });
    const std::vector<HeightContour> contours = heightContours(cone.cells, cone.values, 0.1, 1.0);
    ASSERT_EQ(contours.size(), 4u) << "1 to 4 m; the top is below 5";
    for (std::size_t k = 0; k < contours.size(); ++k) {
        const double radius = 4.0 - static_cast<double>(k);
        EXPECT_EQ(contours[k].level, 1.0 + static_cast<double>(k));
        // Counter-clockwise with the higher ground to the left; linear between places 0.1 m apart, 1e-3 of a radius of 1 m.
        EXPECT_NEAR(areaOf(contours[k]), std::numbers::pi * radius * radius, 0.01 * radius * radius);
        for (const Eigen::Vector2d& corner : contours[k].corners) {
            EXPECT_NEAR(corner.norm(), radius, 2e-3);
        }
    }
}

TEST(HeightContours, APitIsWalkedTheOtherWay) {
    const Heights pit = heightsOf(40, 0.1, [](double x, double y) { return std::hypot(x, y) < 3.0 ? std::hypot(x, y) : 0.0; });
    const std::vector<HeightContour> contours = heightContours(pit.cells, pit.values, 0.1, 2.0);
    ASSERT_EQ(contours.size(), 2u) << "the rim outside and the pit inside";
    EXPECT_GT(areaOf(contours[0]), 0.0);
    EXPECT_LT(areaOf(contours[1]), 0.0);
}

TEST(HeightContours, CloseAroundASingleCellAndAroundGaps) {
    const std::vector<MapCell> cells{{3, -7}};
    const std::vector<double> one{2.0};
    const std::vector<HeightContour> contours = heightContours(cells, one, 0.5, 1.0);
    ASSERT_EQ(contours.size(), 2u);
    // Half way down to zero at the four neighbours: a diamond of half a cell.
    EXPECT_EQ(contours[0].corners.size(), 4u);
    EXPECT_NEAR(areaOf(contours[0]), 2.0 * 0.25 * 0.25, 1e-12);
    const std::vector<double> unknown{std::numeric_limits<double>::quiet_NaN()};
    EXPECT_TRUE(heightContours(cells, unknown, 0.5, 1.0).empty());
    EXPECT_TRUE(heightContours({}, {}, 0.5, 1.0).empty());
}

TEST(HeightContours, ASaddleIsDecidedByItsMiddle) {
    const std::vector<MapCell> cells{{0, 0}, {0, 1}, {1, 0}, {1, 1}};
    const std::vector<double> joined{3.0, 1.5, 1.5, 3.0};  // the middle is at 2.25
    EXPECT_EQ(heightContours(cells, joined, 1.0, 2.0).size(), 1u);
    const std::vector<double> apart{2.2, 0.0, 0.0, 2.2};  // at 1.1
    EXPECT_EQ(heightContours(cells, apart, 1.0, 2.0).size(), 2u);
}

TEST(HeightContours, RefusesASpacingThatIsNone) {
    const std::vector<MapCell> cells{{0, 0}};
    const std::vector<double> high{50.0};
    for (const double spacing : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), 0.01}) {
        EXPECT_THROW(heightContours(cells, high, 1.0, spacing), UsageError) << spacing;
    }
}

}  // namespace
}  // namespace rubble
