#include "core/analysis/debris/collapse_plan.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "core/base/geometry.h"

namespace rubble {

namespace {

/// Monotone chain (Andrew 1979): corners only, counter-clockwise.
std::vector<Vec2> convexHull(std::vector<Vec2> points) {
    std::erase_if(points, [](const Vec2& p) { return !p.allFinite(); });
    const auto before = [](const Vec2& a, const Vec2& b) { return std::tuple(a.x(), a.y()) < std::tuple(b.x(), b.y()); };
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) {
        return points;
    }
    std::vector<Vec2> hull;
    const auto half = [&hull](auto first, auto last) {
        const std::size_t start = hull.size();
        for (auto p = first; p != last; ++p) {
            while (hull.size() >= start + 2 && planeCross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0.0) {
                hull.pop_back();
            }
            hull.push_back(*p);
        }
        hull.pop_back();
    };
    half(points.begin(), points.end());
    half(points.rbegin(), points.rend());
    return hull;
}

double distanceToSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    const double square = along.squaredNorm();
    const double t = square > 0.0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
    return (p - a - t * along).norm();
}

std::vector<Vec2> cornersAtRest(const FragmentSet& fragments, const Mesh& mesh) {
    std::vector<Vec2> corners;
    for (const Fragment& fragment : fragments.list) {
        for (const std::uint32_t node : mesh.cornersOf(fragment.element)) {
            corners.push_back(mesh.nodes[node].head<2>());
        }
    }
    return corners;
}

}  // namespace

CollapsePlan::CollapsePlan(std::vector<Vec2> points) : m_outline(convexHull(std::move(points))) {}

CollapsePlan::CollapsePlan(const FragmentSet& fragments, const Mesh& mesh) : CollapsePlan(cornersAtRest(fragments, mesh)) {}

double CollapsePlan::distance(const Vec2& place) const {
    if (m_outline.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    bool within = m_outline.size() > 2;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < m_outline.size(); ++i) {
        const Vec2& a = m_outline[i];
        const Vec2& b = m_outline[(i + 1) % m_outline.size()];
        within = within && planeCross(b - a, place - a) >= 0.0;
        nearest = std::min(nearest, distanceToSegment(place, a, b));
    }
    return within ? 0.0 : nearest;
}

}  // namespace rubble
