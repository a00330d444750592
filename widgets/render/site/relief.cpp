#include "widgets/render/site/relief.h"

#include <algorithm>
#include <cmath>

#include "widgets/render/basics/sun.h"

namespace rubble::render {
namespace {

/// Rows and columns drawn around the model, and beyond it to the edge of the raster.
constexpr double linesNear = 140.0;
constexpr double linesFar = 30.0;
/// Model lengths around the model that are drawn finely.
constexpr double nearShare = 0.6;
/// Where the level beyond the raster has its rows, as shares of the way to the rim.
constexpr std::array<double, 5> beyond{0.08, 0.2, 0.4, 0.7, 1.0};
/// Slopes are darker than level ground also where they face the sun, so that white ground shows them.
constexpr double slopeShade = 0.65;

/// Rows or columns of a terrain: those of its window about the structure, and how far it goes on around them.
struct TerrainLines {
    double first;  ///< m, of the window
    double cell;
    std::size_t nodes;
    double low;  ///< m, of the whole terrain
    double high;
};

/// Lines from the edge of the window to that of the terrain, ever farther apart, nearest first; none beyond `reach`.
std::vector<double> linesOutwards(double from, double to, double spacing, double centre, double reach) {
    constexpr double growth = 1.1;
    const double sign = to < from ? -1.0 : 1.0;
    const double last = sign * std::min(sign * to, sign * centre + reach);
    std::vector<double> lines;
    double x = from + sign * spacing;
    for (double step = spacing; sign * x < sign * last; x += sign * step) {
        lines.push_back(x);
        step *= growth;
    }
    if (sign * last > sign * from) {
        lines.push_back(last);
    }
    return lines;
}

/// Coordinates of the rows or columns, ascending.
std::vector<double> linesAlong(const TerrainLines& along, double low, double high, double margin, double centre, double reach) {
    const double first = along.first;
    const double cell = along.cell;
    const double last = first + cell * static_cast<double>(along.nodes - 1);
    const auto stride = [cell](double span, double lines) { return std::max(1.0, std::ceil(span / cell / lines)); };
    const double nearLow = low - margin;
    const double nearHigh = high + margin;
    const double fine = stride(nearHigh - nearLow, linesNear);
    const double coarse = std::max(fine, stride(std::max(0.0, nearLow - first) + std::max(0.0, last - nearHigh), linesFar));
    const std::vector<double> before = linesOutwards(first, along.low, coarse * cell, centre, reach);
    const std::vector<double> after = linesOutwards(last, along.high, coarse * cell, centre, reach);
    const double begin = before.empty() ? first : before.back();
    const double end = after.empty() ? last : after.back();
    std::vector<double> lines;
    for (auto share = beyond.rbegin(); share != beyond.rend(); ++share) {
        lines.push_back(begin - *share * std::max(0.0, reach - (centre - begin)));
    }
    lines.insert(lines.end(), before.rbegin(), before.rend());
    double i = 0.0;
    while (i < static_cast<double>(along.nodes - 1)) {
        const double x = first + cell * i;
        lines.push_back(x);
        const bool isNear = x + coarse * cell > nearLow && x < nearHigh;
        i += isNear ? fine : coarse;
    }
    lines.push_back(last);
    lines.insert(lines.end(), after.begin(), after.end());
    for (const double share : beyond) {
        lines.push_back(end + share * std::max(0.0, reach - (end - centre)));
    }
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    return lines;
}

/// Light at a point by the slope between its neighbours.
double shadeAt(const std::vector<Vec3>& points, std::size_t columns, std::size_t rows, std::size_t i, std::size_t j) {
    const auto at = [&](std::size_t x, std::size_t y) -> const Vec3& { return points[y * columns + x]; };
    const Vec3 east = at(std::min(i + 1, columns - 1), j) - at(i > 0 ? i - 1 : 0, j);
    const Vec3 north = at(i, std::min(j + 1, rows - 1)) - at(i, j > 0 ? j - 1 : 0);
    const Vec3 normal = east.cross(north).normalized();
    return std::max(0.0, normal.dot(sun)) / sun.z() * (1.0 - slopeShade + slopeShade * normal.z());
}

}  // namespace

Relief reliefOf(const TerrainGrid& terrain, const Aabb& bounds, double reach) {
    const Vec3 centre = bounds.center();
    const double margin = nearShare * bounds.sizes().norm();
    const TerrainExtent& window = terrain.extent();
    const double east = terrain.x0() + terrain.cell() * static_cast<double>(terrain.nx() - 1);
    const double north = terrain.y0() + terrain.cell() * static_cast<double>(terrain.ny() - 1);
    const std::vector<double> xs = linesAlong({window.x0, terrain.cell(), window.columns, terrain.x0(), east}, bounds.min().x(),
                                              bounds.max().x(), margin, centre.x(), reach);
    const std::vector<double> ys = linesAlong({window.y0, terrain.cell(), window.rows, terrain.y0(), north}, bounds.min().y(),
                                              bounds.max().y(), margin, centre.y(), reach);
    Relief relief;
    relief.points.reserve(xs.size() * ys.size());
    for (const double y : ys) {
        for (const double x : xs) {
            relief.points.emplace_back(x, y, terrain.height(x, y));
        }
    }
    for (std::size_t j = 0; j < ys.size(); ++j) {
        for (std::size_t i = 0; i < xs.size(); ++i) {
            relief.shade.push_back(shadeAt(relief.points, xs.size(), ys.size(), i, j));
        }
    }
    for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
        for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
            const auto low = static_cast<std::int32_t>(j * xs.size() + i);
            const auto high = static_cast<std::int32_t>(low + static_cast<std::int32_t>(xs.size()));
            relief.triangles.push_back({low, low + 1, high + 1});
            relief.triangles.push_back({low, high + 1, high});
        }
    }
    return relief;
}

std::optional<double> meetTerrain(const TerrainGrid& terrain, const Ray& ray, double reach) {
    const auto above = [&](double t) {
        const Vec3 p = ray.origin + t * ray.direction;
        return p.z() - terrain.height(p.x(), p.y());
    };
    double from = 0.0;
    double to = reach;
    // Only between the highest and the lowest point can there be a meeting.
    if (ray.direction.z() != 0.0) {
        const double a = (terrain.highest() - ray.origin.z()) / ray.direction.z();
        const double b = (terrain.lowest() - ray.origin.z()) / ray.direction.z();
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    if (!(from <= to) || above(from) < -1e-9 * reach) {
        return std::nullopt;
    }
    constexpr int samples = 4000;
    double t = from;
    for (int i = 1; i <= samples; ++i) {
        double next = from + (to - from) * i / samples;
        if (above(next) > 0.0) {
            t = next;
            continue;
        }
        for (int halving = 0; halving < 50; ++halving) {
            const double middle = 0.5 * (t + next);
            (above(middle) > 0.0 ? t : next) = middle;
        }
        return next;
    }
    return std::nullopt;
}

}  // namespace rubble::render
