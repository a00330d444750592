#include "core/evidence/maps/footprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "tests/core/analysis/random_numbers.h"

namespace rubble {
namespace {

double areaOf(const std::vector<FootprintPolygon>& polygons) {
    double area = 0.0;
    for (const FootprintPolygon& polygon : polygons) {
        area += signedArea(polygon.outer);
        for (const FootprintRing& hole : polygon.holes) {
            area += signedArea(hole);
        }
    }
    return area;
}

TEST(Footprint, OfOneCellIsItsFourCorners) {
    const std::vector<MapCell> cells{{-2, 5}};
    const std::vector<FootprintPolygon> polygons = footprintOf(cells);
    ASSERT_EQ(polygons.size(), 1u);
    EXPECT_EQ(polygons[0].outer, (FootprintRing{{-2, 5}, {-2, 6}, {-1, 6}, {-1, 5}}));
    EXPECT_EQ(signedArea(polygons[0].outer), 1.0);
}

TEST(Footprint, HasNoCornerOnAStraightStretch) {
    std::vector<MapCell> cells;
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 7; ++i) {
            cells.push_back({j, i});
        }
    }
    const std::vector<FootprintPolygon> polygons = footprintOf(cells);
    ASSERT_EQ(polygons.size(), 1u);
    EXPECT_EQ(polygons[0].outer.size(), 4u);
    EXPECT_EQ(signedArea(polygons[0].outer), 21.0);
}

TEST(Footprint, AHoleIsARingOfItsOwnThatRunsTheOtherWay) {
    const std::vector<MapCell> cells{{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 2}, {2, 0}, {2, 1}, {2, 2}};
    const std::vector<FootprintPolygon> polygons = footprintOf(cells);
    ASSERT_EQ(polygons.size(), 1u);
    EXPECT_EQ(signedArea(polygons[0].outer), 9.0);
    ASSERT_EQ(polygons[0].holes.size(), 1u);
    EXPECT_EQ(signedArea(polygons[0].holes[0]), -1.0);
}

TEST(Footprint, CellsThatMeetByACornerStayApart) {
    const std::vector<MapCell> cells{{0, 0}, {0, 2}, {1, 1}, {2, 0}, {2, 2}};
    EXPECT_EQ(footprintOf(cells).size(), 5u);
    // A ring of cells that is closed by a corner only: what is inside is a hole that touches the outer ring there.
    const std::vector<MapCell> hook{{0, 0}, {0, 1}, {1, 0}, {1, 2}, {2, 0}, {2, 1}, {2, 2}};
    const std::vector<FootprintPolygon> polygons = footprintOf(hook);
    ASSERT_EQ(polygons.size(), 1u);
    EXPECT_EQ(areaOf(polygons), 7.0);
    EXPECT_EQ(polygons[0].holes.size(), 1u);
}

TEST(Footprint, CoversExactlyTheCellsWhateverTheirPattern) {
    RandomNumbers random(3);
    for (int trial = 0; trial < 50; ++trial) {
        std::set<MapCell> set;
        for (int k = 0; k < 40 + 10 * trial; ++k) {
            set.insert({static_cast<int>(random.between(-12, 12)), static_cast<int>(random.between(-12, 12))});
        }
        const std::vector<MapCell> cells(set.begin(), set.end());
        const std::vector<FootprintPolygon> polygons = footprintOf(cells);
        EXPECT_EQ(areaOf(polygons), static_cast<double>(cells.size()));
        for (const FootprintPolygon& polygon : polygons) {
            EXPECT_GE(polygon.outer.size(), 4u) << "every part has its outer ring";
            EXPECT_GT(signedArea(polygon.outer), 0.0);
            for (const FootprintRing& hole : polygon.holes) {
                EXPECT_LT(signedArea(hole), 0.0);
            }
            std::set<MapCell> corners(polygon.outer.begin(), polygon.outer.end());
            EXPECT_EQ(corners.size(), polygon.outer.size()) << "no corner is met twice";
        }
    }
}

TEST(Footprint, OfNothingIsNothing) {
    EXPECT_TRUE(footprintOf({}).empty());
}

OutlineRing rectangleRing(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

using Spans = std::vector<std::pair<double, double>>;

TEST(Outline, AHoleIsNoPartOfItsPolygon) {
    const Outline outline{{{rectangleRing(0.0, 0.0, 10.0, 10.0), rectangleRing(4.0, 4.0, 6.0, 6.0)}}};
    OutlineFill fill(outline);
    EXPECT_EQ(fill.within(5.0), (Spans{{0.0, 4.0}, {6.0, 10.0}}));
    EXPECT_EQ(fill.within(7.0), (Spans{{0.0, 10.0}}));
    EXPECT_EQ(fill.within(11.0), Spans());
    EXPECT_EQ(fill.within(0.0), (Spans{{0.0, 10.0}})) << "the lower edge belongs to it";
    EXPECT_EQ(fill.within(10.0), Spans()) << "the upper one does not";
}

TEST(Outline, PolygonsThatOverlapDoNotCancel) {
    const Outline outline{{{rectangleRing(0.0, 0.0, 6.0, 2.0)},
                           {rectangleRing(4.0, 0.0, 10.0, 2.0)},
                           {rectangleRing(1.0, 0.0, 2.0, 2.0)},
                           {rectangleRing(10.0, 0.0, 12.0, 2.0)}}};
    OutlineFill fill(outline);
    EXPECT_EQ(fill.within(1.0), (Spans{{0.0, 10.0}, {10.0, 12.0}}));
}

TEST(Outline, AreaOfAStarIsThatOfTheShoelaceFormula) {
    std::mt19937 random(7);
    OutlineRing ring;
    constexpr int corners = 40;
    for (int k = 0; k < corners; ++k) {
        const double radius = 2.0 + 3.0 * static_cast<double>(random() % 1000) / 1000.0;
        const double angle = 2.0 * std::numbers::pi * k / corners;
        ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    double area = 0.0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Eigen::Vector2d& a = ring[k];
        const Eigen::Vector2d& b = ring[(k + 1) % ring.size()];
        area += 0.5 * (a.x() * b.y() - b.x() * a.y());
    }
    const Outline outline{{{ring}}};
    OutlineFill fill(outline);
    const auto [low, high] = outline.bounds();
    constexpr int lines = 20000;
    const double step = (high.y() - low.y()) / lines;
    double filled = 0.0;
    for (int line = 0; line < lines; ++line) {
        for (const auto& [from, to] : fill.within(low.y() + (line + 0.5) * step)) {
            filled += step * (to - from);
        }
    }
    // The rule of midpoints errs at corners only, each by less than a line is wide.
    EXPECT_NEAR(filled, area, 1e-4 * area);
}

}  // namespace
}  // namespace rubble
