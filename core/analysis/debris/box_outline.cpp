#include "core/analysis/debris/box_outline.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/base/geometry.h"

namespace rubble {

namespace {

using Vec2 = Eigen::Vector2d;

/// Cuts a polygon along coordinate = limit and keeps the side where sign * coordinate <= sign * limit.
SmallPolygon cut(const SmallPolygon& polygon, int axis, double limit, double sign) {
    SmallPolygon kept;
    for (std::size_t k = 0; k < polygon.size; ++k) {
        const Vec2& a = polygon.corners[k];
        const Vec2& b = polygon.corners[(k + 1) % polygon.size];
        const double fromA = sign * (a[axis] - limit);
        const double fromB = sign * (b[axis] - limit);
        if (fromA <= 0.0) {
            kept.add(a);
        }
        if ((fromA < 0.0 && fromB > 0.0) || (fromA > 0.0 && fromB < 0.0)) {
            Vec2 point = a + (fromA / (fromA - fromB)) * (b - a);
            point[axis] = limit;
            kept.add(point);
        }
    }
    return kept;
}

}  // namespace

double SmallPolygon::area() const {
    double twice = 0.0;
    for (std::size_t k = 1; k + 1 < size; ++k) {
        twice += planeCross(corners[k] - corners[0], corners[k + 1] - corners[0]);
    }
    return 0.5 * std::max(0.0, twice);
}

SmallPolygon outlineOf(const OrientedBox& box) {
    // The shadow of a box is the sum of the shadows of its three edges, in the order of their directions.
    const Mat3 axes = box.orientation.toRotationMatrix();
    const double negligible = 1e-12 * box.halfExtents.maxCoeff();
    std::array<Vec2, 3> edges{Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
    std::size_t count = 0;
    for (int axis = 0; axis < 3; ++axis) {
        Vec2 edge = box.halfExtents[axis] * axes.col(axis).head<2>();
        if (edge.norm() <= negligible) {
            continue;
        }
        if (edge.y() < 0.0 || (edge.y() == 0.0 && edge.x() < 0.0)) {
            edge = -edge;
        }
        std::size_t place = count++;
        for (; place > 0 && planeCross(edge, edges[place - 1]) > 0.0; --place) {
            edges[place] = edges[place - 1];
        }
        edges[place] = edge;
    }
    SmallPolygon outline;
    Vec2 corner = box.centre.head<2>();
    for (std::size_t e = 0; e < count; ++e) {
        corner -= edges[e];
    }
    for (const double sign : {2.0, -2.0}) {
        for (std::size_t e = 0; e < count; ++e) {
            outline.add(corner);
            corner += sign * edges[e];
        }
    }
    return outline;
}

SmallPolygon clipped(const SmallPolygon& polygon, int axis, double low, double high) {
    return cut(cut(polygon, axis, high, 1.0), axis, low, -1.0);
}

BoxTop::BoxTop(const OrientedBox& box)
    : m_centre(box.centre), m_half(box.halfExtents), m_toBox(box.orientation.conjugate().toRotationMatrix()) {}

std::optional<double> BoxTop::at(double x, double y) const {
    const Vec3 from = m_toBox * Vec3(x - m_centre.x(), y - m_centre.y(), 0.0);
    const Vec3 up = m_toBox.col(2);
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(up[axis]) < 1e-12) {
            if (std::abs(from[axis]) > m_half[axis]) {
                return std::nullopt;
            }
            continue;
        }
        const double a = (-m_half[axis] - from[axis]) / up[axis];
        const double b = (m_half[axis] - from[axis]) / up[axis];
        low = std::max(low, std::min(a, b));
        high = std::min(high, std::max(a, b));
    }
    return low <= high ? std::optional(m_centre.z() + high) : std::nullopt;
}

}  // namespace rubble
