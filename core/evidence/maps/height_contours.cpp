#include "core/evidence/maps/height_contours.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/base/error.h"

namespace rubble {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double levelsMax = 1000.0;
/// Corners of a square: south-west, south-east, north-east, north-west.
constexpr std::array<MapCell, 4> around{{{0, 0}, {0, 1}, {1, 1}, {1, 0}}};

/// Four neighbouring middles of cells, with their heights.
struct Square {
    MapCell corner;  ///< the south-west one
    std::array<double, 4> heights{};
    friend bool operator<(const Square& a, const Square& b) { return a.corner < b.corner; }
};

/// The line between two neighbouring middles: from `from` to the east or to the north.
struct Link {
    MapCell from;
    int axis = 0;  ///< 0 east, 1 north
    friend auto operator<=>(const Link&, const Link&) = default;
};

/// A stretch of a line across a square.
struct Stretch {
    Link from;
    Link to;
    Vec2 start = Vec2::Zero();
    friend bool operator<(const Stretch& a, const Stretch& b) { return a.from < b.from; }
};

/// Every square that has a height at one of its corners.
std::vector<Square> squaresOf(std::span<const MapCell> cells, std::span<const double> heights) {
    std::vector<MapCell> corners;
    corners.reserve(4 * cells.size());
    for (const MapCell& cell : cells) {
        for (const MapCell& corner : around) {
            corners.push_back({cell.j - corner.j, cell.i - corner.i});
        }
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    const auto heightAt = [&](MapCell cell) {
        const auto found = std::lower_bound(cells.begin(), cells.end(), cell);
        const bool known = found != cells.end() && *found == cell;
        const double height = known ? heights[static_cast<std::size_t>(found - cells.begin())] : 0.0;
        return std::isfinite(height) ? height : 0.0;
    };
    std::vector<Square> squares;
    squares.reserve(corners.size());
    for (const MapCell& corner : corners) {
        Square& square = squares.emplace_back();
        square.corner = corner;
        for (std::size_t k = 0; k < around.size(); ++k) {
            square.heights[k] = heightAt({corner.j + around[k].j, corner.i + around[k].i});
        }
    }
    return squares;
}

/// Side k of a square, from its corner k to the next.
Link sideOf(MapCell corner, std::size_t k) {
    switch (k) {
        case 0:
            return {corner, 0};
        case 1:
            return {{corner.j, corner.i + 1}, 1};
        case 2:
            return {{corner.j + 1, corner.i}, 0};
        default:
            return {corner, 1};
    }
}

Vec2 crossing(const Square& square, std::size_t k, double level, double cell) {
    const std::size_t next = (k + 1) % 4;
    const Vec2 a(square.corner.i + around[k].i + 0.5, square.corner.j + around[k].j + 0.5);
    const Vec2 b(square.corner.i + around[next].i + 0.5, square.corner.j + around[next].j + 0.5);
    const double share = (level - square.heights[k]) / (square.heights[next] - square.heights[k]);
    return cell * (a + share * (b - a));
}

void addStretches(const Square& square, double level, double cell, std::vector<Stretch>& stretches) {
    const auto high = [&](std::size_t k) { return square.heights[k % 4] >= level; };
    const double middle = 0.25 * (square.heights[0] + square.heights[1] + square.heights[2] + square.heights[3]);
    for (std::size_t k = 0; k < 4; ++k) {
        if (!high(k) || high(k + 1)) {
            continue;
        }
        // Where the line goes down over side k it ends where it comes up again: of two such sides the middle decides, whether the
        // two high corners hang together.
        const std::size_t turn = middle >= level ? 1 : 3;
        std::size_t end = (k + turn) % 4;
        while (high(end) || !high(end + 1)) {
            end = (end + turn) % 4;
        }
        stretches.push_back({sideOf(square.corner, k), sideOf(square.corner, end), crossing(square, k, level, cell)});
    }
}

void joinStretches(double level, std::vector<Stretch>& stretches, std::vector<HeightContour>& contours) {
    std::sort(stretches.begin(), stretches.end());
    std::vector<bool> used(stretches.size(), false);
    for (std::size_t first = 0; first < stretches.size(); ++first) {
        if (used[first]) {
            continue;
        }
        HeightContour& contour = contours.emplace_back();
        contour.level = level;
        for (std::size_t s = first; !used[s];) {
            used[s] = true;
            contour.corners.push_back(stretches[s].start);
            const auto next = std::lower_bound(stretches.begin(), stretches.end(), Stretch{stretches[s].to, {}, {}});
            assert(next != stretches.end() && next->from == stretches[s].to);
            s = static_cast<std::size_t>(next - stretches.begin());
        }
    }
}

}  // namespace

std::vector<HeightContour> heightContours(std::span<const MapCell> cells, std::span<const double> heights, double cell,
                                          double spacing) {
    assert(cells.size() == heights.size());
    double top = 0.0;
    for (const double height : heights) {
        if (std::isfinite(height)) {
            top = std::max(top, height);
        }
    }
    if (!(spacing > 0.0) || !std::isfinite(spacing) || top > levelsMax * spacing) {
        throw UsageError(
            {"map.contour_spacing", "Contours cannot be drawn every {0} up to a height of {1}.", {{spacing, "m"}, {top, "m"}}},
            {"map.contour_spacing.remedy",
             "Give a spacing above zero that makes a thousand lines at most, 0.5 m for example.",
             {}});
    }
    const std::vector<Square> squares = squaresOf(cells, heights);
    std::vector<HeightContour> contours;
    std::vector<Stretch> stretches;
    for (int k = 1; k * spacing <= top; ++k) {
        stretches.clear();
        for (const Square& square : squares) {
            addStretches(square, k * spacing, cell, stretches);
        }
        joinStretches(k * spacing, stretches, contours);
    }
    return contours;
}

}  // namespace rubble
