#include "core/fe/terrain_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/base/error.h"

namespace rubble {
namespace {

constexpr std::size_t pointsEast = 23;
constexpr std::size_t pointsNorth = 17;
constexpr double x0 = -31.0;
constexpr double y0 = 12.0;
constexpr double spacing = 2.5;
constexpr double east = x0 + spacing * (pointsEast - 1);
constexpr double north = y0 + spacing * (pointsNorth - 1);

TerrainGrid made(const std::function<double(double, double)>& heightAt) {
    std::vector<double> heights;
    for (std::size_t j = 0; j < pointsNorth; ++j) {
        for (std::size_t i = 0; i < pointsEast; ++i) {
            heights.push_back(heightAt(x0 + spacing * static_cast<double>(i), y0 + spacing * static_cast<double>(j)));
        }
    }
    return TerrainGrid(x0, y0, spacing, pointsEast, pointsNorth, heights);
}

TerrainGrid rough(unsigned seed = 1) {
    auto random = std::make_shared<std::mt19937>(seed);
    return made([random](double, double) { return std::uniform_real_distribution(-4.0, 9.0)(*random); });
}

/// Places in and around the grid.
std::vector<std::pair<double, double>> places(int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution xs(x0 - 20.0, east + 20.0);
    std::uniform_real_distribution ys(y0 - 20.0, north + 20.0);
    std::vector<std::pair<double, double>> all;
    for (int i = 0; i < count; ++i) {
        all.emplace_back(xs(random), ys(random));
    }
    return all;
}

TEST(TerrainGrid, APlaneIsMetExactlyWithItsNormal) {
    const auto plane = [](double x, double y) { return 0.25 * x - 0.5 * y + 3.0; };
    const TerrainGrid terrain = made(plane);
    const Vec3 normal = Vec3(-0.25, 0.5, 1.0).normalized();
    for (const auto& [x, y] : places(500)) {
        if (x > x0 && x < east && y > y0 && y < north) {
            // Heights up to 40 m, a handful of roundings of 1e-16 each.
            EXPECT_NEAR(terrain.height(x, y), plane(x, y), 1e-13);
            EXPECT_NEAR((terrain.normal(x, y) - normal).norm(), 0.0, 1e-13);
        }
    }
}

TEST(TerrainGrid, NodesKeepTheirHeights) {
    const TerrainGrid terrain = rough();
    for (std::size_t j = 0; j < pointsNorth; ++j) {
        for (std::size_t i = 0; i < pointsEast; ++i) {
            EXPECT_DOUBLE_EQ(terrain.height(x0 + spacing * static_cast<double>(i), y0 + spacing * static_cast<double>(j)),
                             terrain.node(i, j));
        }
    }
}

TEST(TerrainGrid, TheSurfaceHasNoStepAcrossCellsAndDiagonals) {
    const TerrainGrid terrain = rough();
    // The steepest slope there can be: 13 m between neighbours 2.5 m apart, along both axes.
    const double steepest = std::sqrt(2.0) * 13.0 / spacing;
    const double apart = 1e-9;
    for (std::size_t k = 0; k < 2000; ++k) {
        const double s = static_cast<double>(k) / 2000.0;
        const double i = std::floor(s * (pointsEast - 2)) + 1.0;
        const double onLine = x0 + spacing * i;
        const double along = y0 + s * (north - y0);
        EXPECT_NEAR(terrain.height(onLine - apart, along), terrain.height(onLine + apart, along), 2.0 * apart * steepest + 1e-13);
        const double diagonal = s * spacing;
        EXPECT_NEAR(terrain.height(onLine + diagonal - apart, y0 + diagonal + apart),
                    terrain.height(onLine + diagonal + apart, y0 + diagonal - apart), 4.0 * apart * steepest + 1e-13);
    }
}

TEST(TerrainGrid, TheNormalIsThatOfTheSlopeOfTheHeight) {
    const TerrainGrid terrain = rough();
    const double step = 1e-6;
    int compared = 0;
    for (const auto& [x, y] : places(3000)) {
        const double u = std::fmod(x - x0 + 100.0 * spacing, spacing) / spacing;
        const double v = std::fmod(y - y0 + 100.0 * spacing, spacing) / spacing;
        const bool nearLine = std::min({u, v, 1.0 - u, 1.0 - v, std::abs(u - v)}) < 1e-4;
        if (nearLine) {
            continue;
        }
        const double alongX = (terrain.height(x + step, y) - terrain.height(x - step, y)) / (2.0 * step);
        const double alongY = (terrain.height(x, y + step) - terrain.height(x, y - step)) / (2.0 * step);
        // Rounding of the heights, 1e-15, over the step.
        EXPECT_NEAR((terrain.normal(x, y) - Vec3(-alongX, -alongY, 1.0).normalized()).norm(), 0.0, 1e-8) << x << " " << y;
        ++compared;
    }
    EXPECT_GT(compared, 2000);
}

TEST(TerrainGrid, TheSplitRunsFromSouthWestToNorthEast) {
    const TerrainGrid terrain(0.0, 0.0, 1.0, 2, 2, {0.0, 1.0, 1.0, 0.0});
    EXPECT_DOUBLE_EQ(terrain.height(0.5, 0.5), 0.0);
    EXPECT_DOUBLE_EQ(terrain.height(0.75, 0.25), 0.5);
    EXPECT_DOUBLE_EQ(terrain.height(0.25, 0.75), 0.5);
}

TEST(TerrainGrid, BeyondTheEdgesItGoesOnLevel) {
    const TerrainGrid terrain = rough();
    for (const auto& [x, y] : places(1000)) {
        const double onX = std::clamp(x, x0, east);
        const double onY = std::clamp(y, y0, north);
        EXPECT_DOUBLE_EQ(terrain.height(x, y), terrain.height(onX, onY));
    }
    EXPECT_DOUBLE_EQ(terrain.height(-1e300, -1e300), terrain.node(0, 0));
    EXPECT_DOUBLE_EQ(terrain.height(std::numeric_limits<double>::infinity(), 1e300), terrain.node(pointsEast - 1, pointsNorth - 1));
    EXPECT_EQ(terrain.normal(x0 - 1.0, y0 - 1.0), Vec3::UnitZ());
    EXPECT_EQ(terrain.normal(x0 - 1.0, y0 + 1.0).x(), 0.0);
}

TEST(TerrainGrid, NoPointOverARectangleIsHigherThanItsBound) {
    const TerrainGrid terrain = rough();
    const auto corners = places(400);
    std::mt19937 random(3);
    std::uniform_real_distribution share(0.0, 1.0);
    for (std::size_t k = 0; k + 1 < corners.size(); k += 2) {
        const auto [xMin, xMax] = std::minmax(corners[k].first, corners[k + 1].first);
        const auto [yMin, yMax] = std::minmax(corners[k].second, corners[k + 1].second);
        const double bound = terrain.highestOver(xMin, yMin, xMax, yMax);
        for (int n = 0; n < 50; ++n) {
            const double x = xMin + share(random) * (xMax - xMin);
            const double y = yMin + share(random) * (yMax - yMin);
            EXPECT_LE(terrain.height(x, y), bound + 1e-13);
        }
        EXPECT_LE(bound, terrain.highest());
    }
    // A single point is bounded by the corners of its cell, no more.
    const TerrainGrid peak(0.0, 0.0, 1.0, 4, 2, {0, 0, 0, 9, 0, 0, 0, 9});
    EXPECT_EQ(peak.highestOver(0.5, 0.5, 0.5, 0.5), 0.0);
    EXPECT_EQ(peak.highestOver(2.5, 0.5, 2.5, 0.5), 9.0);
}

TEST(TerrainGrid, WhatIsNoPlaceAsksForNoMemoryOutside) {
    const TerrainGrid terrain = rough();
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(terrain.height(none, y0)));
    EXPECT_EQ(terrain.highestOver(none, none, none, none), terrain.highest());
    EXPECT_EQ(terrain.highestOver(1.0, 1.0, -1.0, -1.0), terrain.highest());
}

/// The rough terrain with more of it around: `more` nodes to each side, which go on from its edges.
TerrainGrid widened(const TerrainGrid& window, std::size_t more, TerrainExtent extent = {}) {
    extent.column = extent.row = more;
    extent.columns = window.nx();
    extent.rows = window.ny();
    extent.x0 = window.x0();
    extent.y0 = window.y0();
    HeightGrid grid;
    grid.dx = grid.dy = window.cell();
    grid.x0 = window.x0() - grid.dx * static_cast<double>(more);
    grid.y0 = window.y0() - grid.dy * static_cast<double>(more);
    grid.nx = window.nx() + 2 * more;
    grid.ny = window.ny() + 2 * more;
    for (std::size_t j = 0; j < grid.ny; ++j) {
        for (std::size_t i = 0; i < grid.nx; ++i) {
            const auto inside = [more](std::size_t n, std::size_t count) {
                return std::clamp(static_cast<std::ptrdiff_t>(n) - static_cast<std::ptrdiff_t>(more), std::ptrdiff_t{0},
                                  static_cast<std::ptrdiff_t>(count) - 1);
            };
            grid.heights.push_back(
                window.node(static_cast<std::size_t>(inside(i, window.nx())), static_cast<std::size_t>(inside(j, window.ny()))));
        }
    }
    return TerrainGrid(std::move(grid), std::move(extent));
}

TEST(TerrainGrid, WhatLiesAroundTheWindowChangesNoBitWithin) {
    const TerrainGrid window = rough();
    const TerrainGrid wide = widened(window, 1000);
    for (const auto& [x, y] : places(5000)) {
        if (x > x0 && x < east && y > y0 && y < north) {
            EXPECT_EQ(wide.height(x, y), window.height(x, y)) << x << " " << y;
            EXPECT_EQ(wide.normal(x, y), window.normal(x, y)) << x << " " << y;
        }
    }
    EXPECT_EQ(wide.window().min(), window.window().min());
    EXPECT_EQ(wide.window().max(), window.window().max());
    EXPECT_NE(wide.digest(), window.digest()) << "the ground of a run says how far it went";
}

TEST(TerrainGrid, SaysWhereTheRasterHasNoHeights) {
    using Source = TerrainGrid::Source;
    const double step = spacing;
    const TerrainGrid plain = rough();
    EXPECT_EQ(plain.source(x0, y0), Source::Raster);
    EXPECT_EQ(plain.source(x0 - 0.4 * step, y0), Source::Raster) << "a height stands for its cell";
    EXPECT_EQ(plain.source(x0 - 0.6 * step, y0), Source::Ended);
    EXPECT_EQ(plain.source(x0, north + 0.6 * step), Source::Ended);
    TerrainExtent extent;
    extent.unread = {5, 0, 0, 0};
    extent.missing.assign((pointsEast + 4) * (pointsNorth + 4), 0);
    extent.missing.back() = 1;
    const TerrainGrid cut = widened(plain, 2, extent);
    EXPECT_EQ(cut.source(x0 - 1.9 * step, y0), Source::Raster);
    EXPECT_EQ(cut.source(x0 - 9.0 * step, y0), Source::Unread);
    EXPECT_EQ(cut.source(x0 - 9.0 * step, y0 - 9.0 * step), Source::Ended) << "to the south there is no more";
    EXPECT_EQ(cut.source(east + 2.0 * step, north + 2.0 * step), Source::Ended) << "no data";
    EXPECT_EQ(cut.source(east + 1.0 * step, north + 2.0 * step), Source::Raster);
}

TEST(TerrainGrid, RoomAroundAWindowIsSharedByItsSides) {
    const auto count = [](std::size_t columns, std::size_t rows) { return static_cast<double>(columns * rows); };
    EXPECT_EQ(roomAround(10, 10, {5, 6, 7, 8}, 1000.0, count), (GridSides{5, 6, 7, 8}));
    EXPECT_EQ(roomAround(10, 10, {500, 2, 0, 900}, 600.0, count), (GridSides{13, 2, 0, 13}));
    EXPECT_EQ(roomAround(10, 10, {5, 5, 5, 5}, 100.0, count), (GridSides{}));
    EXPECT_EQ(roomAround(10, 10, {}, 10.0, count), (GridSides{}));
}

TEST(TerrainGrid, RefusesWhatIsNoTerrain) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> flat(6, 0.0);
    EXPECT_THROW(TerrainGrid(0.0, 0.0, 1.0, 2, 2, flat), UsageError);
    EXPECT_THROW(TerrainGrid(0.0, 0.0, 1.0, 1, 6, flat), UsageError);
    EXPECT_THROW(TerrainGrid(0.0, 0.0, 1.0, 0, 0, {}), UsageError);
    EXPECT_THROW(TerrainGrid(0.0, 0.0, 0.0, 2, 3, flat), UsageError);
    EXPECT_THROW(TerrainGrid(none, 0.0, 1.0, 2, 3, flat), UsageError);
    EXPECT_THROW(TerrainGrid(0.0, 0.0, none, 2, 3, flat), UsageError);
    // Counts whose product wraps around must not pass for a small grid.
    EXPECT_THROW(TerrainGrid(0.0, 0.0, 1.0, std::size_t{1} << 63, 2, {}), UsageError);
    try {
        TerrainGrid(0.0, 0.0, 1.0, 3, 2, {0, 0, 0, 0, none, 0});
        FAIL() << "a height that is none was taken";
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("node 1 of row 1"), std::string::npos) << error.what();
    }
}

TEST(TerrainGrid, TheDigestNamesTheContent) {
    EXPECT_EQ(rough().digest(), rough().digest());
    EXPECT_NE(rough(1).digest(), rough(2).digest());
    const TerrainGrid a(0.0, 0.0, 1.0, 2, 3, std::vector<double>(6, 0.0));
    const TerrainGrid b(0.0, 0.0, 1.0, 3, 2, std::vector<double>(6, 0.0));
    const TerrainGrid c(0.5, 0.0, 1.0, 2, 3, std::vector<double>(6, 0.0));
    EXPECT_NE(a.digest(), b.digest());
    EXPECT_NE(a.digest(), c.digest());
}

TEST(TerrainGrid, RoughnessHasItsHeightItsSpacingAndItsSeed) {
    const TerrainGrid slope(0.0, 0.0, 5.0, 5, 5, [] {
        std::vector<double> heights;
        for (int k = 0; k < 25; ++k) {
            heights.push_back(2.5 * (k % 5));
        }
        return heights;
    }());
    const TerrainGrid rough = slope.roughened({0.1, 0.25, 3});
    double difference = 0.0, mean = 0.0, most = 0.0;
    int count = 0;
    for (int j = 0; j < 79; ++j) {
        for (int i = 0; i < 79; ++i, ++count) {
            const double x = 0.25 * i, y = 0.25 * j;
            const auto bump = [&](double at) { return rough.height(at, y) - slope.height(at, y); };
            mean += bump(x);
            most = std::max(most, std::abs(bump(x)));
            difference += std::abs(bump(x + 0.25) - bump(x));
        }
    }
    // 6,241 nodes: a mean obstacle within 2 % of its height; the deviation of a node is 0.089 m, of their mean 1.1 mm.
    EXPECT_NEAR(difference / count, 0.1, 0.003);
    EXPECT_NEAR(mean / count, 0.0, 0.004);
    EXPECT_LE(most, 0.1 * 3.1);
    EXPECT_GE(rough.highestOver(3.0, 3.0, 4.0, 4.0), rough.height(3.5, 3.5));
    EXPECT_NE(rough.digest(), slope.digest());
    EXPECT_NE(rough.digest(), slope.roughened({0.1, 0.25, 4}).digest());
    EXPECT_NE(rough.height(7.0, 7.0), slope.roughened({0.1, 0.25, 4}).height(7.0, 7.0));
    EXPECT_EQ(rough.height(7.0, 7.0), slope.roughened({0.1, 0.25, 3}).height(7.0, 7.0));
    // Continuous, and its normal is that of the triangle below.
    EXPECT_NEAR(rough.height(1.0 - 1e-9, 0.6), rough.height(1.0 + 1e-9, 0.6), 1e-7);
    const Vec3 n = rough.normal(2.1, 2.05);
    EXPECT_NEAR((rough.height(2.11, 2.05) - rough.height(2.1, 2.05)) / 0.01, -n.x() / n.z(), 1e-9);
    EXPECT_NEAR((rough.height(2.1, 2.06) - rough.height(2.1, 2.05)) / 0.01, -n.y() / n.z(), 1e-9);
    EXPECT_THROW(slope.roughened({0.1, 0.0, 1}), UsageError);
    EXPECT_EQ(slope.roughened({0.0, 1.0, 1}).height(3.3, 4.4), slope.height(3.3, 4.4));
}

}  // namespace
}  // namespace rubble
