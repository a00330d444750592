#include "core/simulation/run/bulking.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/base/same_bits.h"

namespace rubble {

namespace {

/// m, between the points of the raster: four to a cell of 1 m along each side.
constexpr double spacing = 0.25;
/// Points of the raster at most; a pile spread wider is sampled more coarsely.
constexpr double pointsMax = 64e6;

/// Height at which the upright line through (x, y) leaves a box, if it meets it.
std::optional<double> topOf(const OrientedBox& box, double x, double y) {
    const Mat3 inverse = box.orientation.conjugate().toRotationMatrix();
    const Vec3 from = inverse * (Vec3(x, y, 0.0) - box.centre);
    const Vec3 up = inverse.col(2);
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(up[axis]) < 1e-12) {
            if (std::abs(from[axis]) > box.halfExtents[axis]) {
                return std::nullopt;
            }
            continue;
        }
        const double a = (-box.halfExtents[axis] - from[axis]) / up[axis];
        const double b = (box.halfExtents[axis] - from[axis]) / up[axis];
        low = std::max(low, std::min(a, b));
        high = std::min(high, std::max(a, b));
    }
    return low <= high ? std::optional(high) : std::nullopt;
}

/// Heights above ground on a raster; NaN where structure stands or lies.
class Raster {
public:
    Raster(const Aabb& area, const SiteSurface& ground) : m_low(area.min()), m_ground(ground) {
        const Vec3 size = area.sizes();
        m_step = std::max(spacing, std::sqrt(std::max(size.x() * size.y(), 0.0) / pointsMax));
        m_columns = static_cast<std::int64_t>(size.x() / m_step) + 1;
        m_rows = static_cast<std::int64_t>(size.y() / m_step) + 1;
        m_heights.assign(static_cast<std::size_t>(m_columns * m_rows), 0.0);
    }

    template <class Visit>
    void visit(const Aabb& box, Visit visit) {
        const auto first = [&](double low, double origin) {
            return std::max<std::int64_t>(0, std::llround(std::ceil((low - origin) / m_step)));
        };
        const auto last = [&](double high, double origin, std::int64_t count) {
            return std::min<std::int64_t>(count - 1, std::llround(std::floor((high - origin) / m_step)));
        };
        for (std::int64_t r = first(box.min().y(), m_low.y()); r <= last(box.max().y(), m_low.y(), m_rows); ++r) {
            for (std::int64_t c = first(box.min().x(), m_low.x()); c <= last(box.max().x(), m_low.x(), m_columns); ++c) {
                visit(m_heights[static_cast<std::size_t>(r * m_columns + c)], m_low.x() + static_cast<double>(c) * m_step,
                      m_low.y() + static_cast<double>(r) * m_step);
            }
        }
    }
    void blot(const Aabb& structure) {
        visit(structure, [](double& height, double, double) { height = std::numeric_limits<double>::quiet_NaN(); });
    }
    void cover(const OrientedBox& box) {
        visit(outline(box), [&](double& height, double x, double y) {
            const std::optional<double> top = topOf(box, x, y);
            if (top) {
                const double above = *top - m_ground.height(x, y);
                if (above > height) {
                    height = above;
                }
            }
        });
    }
    bool blotted(const Vec3& place) {
        bool found = false;
        const Vec3 half(0.5 * m_step, 0.5 * m_step, 0.0);
        visit(Aabb(Vec3(place - half), Vec3(place + half)), [&](double& height, double, double) { found |= std::isnan(height); });
        return found;
    }
    double volume() const {
        double sum = 0.0;
        for (const double height : m_heights) {
            sum += std::isnan(height) ? 0.0 : height;
        }
        return sum * m_step * m_step;
    }
    double coveredArea() const {
        const auto covered = std::count_if(m_heights.begin(), m_heights.end(), [](double height) { return height > 0.0; });
        return static_cast<double>(covered) * m_step * m_step;
    }

private:
    Vec3 m_low;
    const SiteSurface& m_ground;
    double m_step = spacing;
    std::int64_t m_columns = 0;
    std::int64_t m_rows = 0;
    std::vector<double> m_heights;
};

}  // namespace

Aabb outline(const OrientedBox& box) {
    const Vec3 half = box.orientation.toRotationMatrix().cwiseAbs() * box.halfExtents;
    return Aabb(Vec3(box.centre - half), Vec3(box.centre + half));
}

PileMeasure measurePile(const std::vector<DebrisBox>& debris, const std::vector<Aabb>& structure, const SiteSurface& ground) {
    Aabb area;
    for (const DebrisBox& d : debris) {
        area.extend(outline(d.box));
    }
    if (area.isEmpty() || !area.sizes().allFinite()) {
        return {};
    }
    Raster raster(area, ground);
    for (const Aabb& box : structure) {
        raster.blot(box);
    }
    double material = 0.0;
    double count = 0.0;
    for (const DebrisBox& d : debris) {
        if (!raster.blotted(d.box.centre)) {
            raster.cover(d.box);
            material += d.volume;
            ++count;
        }
    }
    if (material <= 0.0) {
        return {};
    }
    PileMeasure pile{raster.volume() / material, 0.0};
    if (const double covered = raster.coveredArea(); covered > 0.0) {
        pile.layers = raster.volume() / covered / cubeRootOf(material / count);
    }
    return pile;
}

}  // namespace rubble
