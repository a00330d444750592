#include "core/evidence/maps/tile_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {

namespace {

using Vec2 = Eigen::Vector2d;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where the line from a to b crosses a height between theirs.
double crossing(const Vec2& a, const Vec2& b, double y) {
    return a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
}

struct Span {
    double low = infinity;
    double high = -infinity;
};

/// What a level line at y has in common with a convex polygon.
Span spanAt(const SmallPolygon& polygon, double y) {
    Span span;
    for (std::size_t k = 0; k < polygon.size; ++k) {
        const Vec2& a = polygon.corners[k];
        const Vec2& b = polygon.corners[k + 1 < polygon.size ? k + 1 : 0];
        if ((a.y() <= y) != (b.y() <= y)) {
            const double x = crossing(a, b, y);
            span.low = std::min(span.low, x);
            span.high = std::max(span.high, x);
        }
    }
    return span;
}

/// The top of a box as the lowest of three planes z = height + slope (place - centre), m.
struct BoxRoof {
    struct Plane {
        double height = infinity;
        Vec2 slope = Vec2::Zero();
    };
    std::array<Plane, 3> planes;

    explicit BoxRoof(const OrientedBox& box) {
        const Mat3 axes = box.orientation.toRotationMatrix();
        for (int a = 0; a < 3; ++a) {
            const Vec3 up = axes(2, a) < 0.0 ? Vec3(-axes.col(a)) : Vec3(axes.col(a));
            // A face that stands upright is met by no upright line but at its edge.
            if (up.z() < 1e-12) {
                continue;
            }
            Plane& plane = planes[static_cast<std::size_t>(a)];
            plane.height = box.centre.z() + box.halfExtents[a] / up.z();
            plane.slope = -up.head<2>() / up.z();
        }
    }
};

}  // namespace

void TileCover::take(const SmallPolygon& outline) {
    m_high = {-1, -1};
    m_low = {0, 0};
    if (outline.size < 3) {
        return;
    }
    Vec2 low = outline.corners[0];
    Vec2 high = low;
    for (std::size_t k = 1; k < outline.size; ++k) {
        low = low.cwiseMin(outline.corners[k]);
        high = high.cwiseMax(outline.corners[k]);
    }
    const double end = tileCells;
    if (!(low.maxCoeff() < end) || !(high.minCoeff() > 0.0)) {
        return;
    }
    SmallPolygon part = outline;
    if (low.x() < 0.0 || high.x() > end) {
        part = clipped(part, 0, 0.0, end);
    }
    if (low.y() < 0.0 || high.y() > end) {
        part = clipped(part, 1, 0.0, end);
    }
    if (part.size < 3) {
        return;
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto of = static_cast<Eigen::Index>(axis);
        m_low[axis] = static_cast<int>(std::floor(std::max(0.0, low[of])));
        m_high[axis] = std::min(tileCells, static_cast<int>(std::ceil(high[of]))) - 1;
        m_high[axis] = std::max(m_high[axis], m_low[axis]);
    }
    for (int j = m_low[1]; j <= m_high[1]; ++j) {
        auto& row = m_area[static_cast<std::size_t>(j)];
        std::fill(row.begin() + m_low[0], row.begin() + m_high[0] + 3, 0.0);
    }
    for (std::size_t k = 0; k < part.size; ++k) {
        addEdge(part.corners[k], part.corners[k + 1 < part.size ? k + 1 : 0]);
    }
    for (int j = m_low[1]; j <= m_high[1]; ++j) {
        auto& row = m_area[static_cast<std::size_t>(j)];
        for (int i = m_low[0] + 1; i <= m_high[0]; ++i) {
            row[static_cast<std::size_t>(i)] += row[static_cast<std::size_t>(i - 1)];
        }
    }
}

void TileCover::addEdge(Vec2 from, Vec2 to) {
    // Going round counter-clockwise, what lies to the right of an edge that goes down is inside, up to the one that goes up.
    double sign = -1.0;
    if (from.y() > to.y()) {
        std::swap(from, to);
        sign = 1.0;
    }
    if (!(from.y() < to.y())) {
        return;
    }
    const int first = std::clamp(static_cast<int>(std::floor(from.y())), m_low[1], m_high[1]);
    const int last = std::clamp(static_cast<int>(std::ceil(to.y())) - 1, first, m_high[1]);
    double x0 = from.x();
    double y0 = from.y();
    for (int j = first; j <= last; ++j) {
        const double y1 = j == last ? to.y() : j + 1.0;
        const double x1 = j == last ? to.x() : crossing(from, to, y1);
        addWithinRow(m_area[static_cast<std::size_t>(j)], x0, x1, sign * (y1 - y0));
        x0 = x1;
        y0 = y1;
    }
}

void TileCover::addWithinRow(std::array<double, tileCells + 2>& row, double x0, double x1, double rise) {
    const double left = std::clamp(std::min(x0, x1), static_cast<double>(m_low[0]), m_high[0] + 1.0);
    const double right = std::clamp(std::max(x0, x1), left, m_high[0] + 1.0);
    const int first = std::min(static_cast<int>(left), m_high[0]);
    const int last = std::clamp(static_cast<int>(std::ceil(right)) - 1, first, m_high[0]);
    const double each = first == last ? 0.0 : rise / (right - left);
    for (int i = first; i <= last; ++i) {
        const double a = i == first ? left : i;
        const double b = i == last ? right : i + 1.0;
        const double part = first == last ? rise : each * (b - a);
        const double beyond = part * (0.5 * (a + b) - i);
        row[static_cast<std::size_t>(i)] += part - beyond;
        row[static_cast<std::size_t>(i + 1)] += beyond;
    }
}

void TileSurface::clear() {
    for (auto& row : m_height) {
        row.fill(-infinity);
    }
}

void TileSurface::raise(const OrientedBox& box, const SmallPolygon& outline, const Vec2& corner, double cell) {
    if (outline.size < 3) {
        return;
    }
    const double step = cell / heightPoints;
    const BoxRoof roof(box);
    double low = infinity;
    double high = -infinity;
    for (std::size_t k = 0; k < outline.size; ++k) {
        low = std::min(low, outline.corners[k].y());
        high = std::max(high, outline.corners[k].y());
    }
    // Point p along an axis lies at (p + 0.5) / heightPoints cells.
    const auto firstAt = [](double place) {
        return static_cast<int>(std::ceil(std::clamp(place, -1.0, tileCells + 1.0) * heightPoints - 0.5));
    };
    const auto lastAt = [](double place) {
        return static_cast<int>(std::floor(std::clamp(place, -1.0, tileCells + 1.0) * heightPoints - 0.5));
    };
    const int top = std::min(side - 1, lastAt(high));
    for (int b = std::max(0, firstAt(low)); b <= top; ++b) {
        const double y = (b + 0.5) / heightPoints;
        const Span span = spanAt(outline, y);
        if (!(span.low <= span.high)) {
            continue;
        }
        const int from = std::max(0, firstAt(span.low));
        const int to = std::min(side - 1, lastAt(span.high));
        const Vec2 start = corner + Vec2(0.5 * step, y * cell) - box.centre.head<2>();
        std::array<double, 3> base{};
        for (std::size_t a = 0; a < 3; ++a) {
            base[a] = roof.planes[a].height + roof.planes[a].slope.dot(start);
        }
        const std::array<double, 3> slope{roof.planes[0].slope.x() * step, roof.planes[1].slope.x() * step,
                                          roof.planes[2].slope.x() * step};
        auto& row = m_height[static_cast<std::size_t>(b)];
        for (int a = from; a <= to; ++a) {
            const double z = std::min({base[0] + slope[0] * a, base[1] + slope[1] * a, base[2] + slope[2] * a});
            double& surface = row[static_cast<std::size_t>(a)];
            if (surface < z) {
                surface = z;
            }
        }
    }
}

}  // namespace rubble
