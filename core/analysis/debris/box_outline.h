#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/base/geometry.h"

namespace rubble {

/// A convex polygon of a few corners, counter-clockwise. Room for a hexagon cut four times, whatever rounding does to its corners.
struct SmallPolygon {
    std::array<Eigen::Vector2d, 32> corners;
    std::size_t size = 0;

    void add(const Eigen::Vector2d& corner) { corners[size++] = corner; }
    double area() const;
};

/// Outline of a box seen from above: a parallelogram or a hexagon, around its centre. Without area if the box has none from there.
SmallPolygon outlineOf(const OrientedBox& box);

/// The part of a polygon with low <= coordinate <= high along an axis (0 x, 1 y).
SmallPolygon clipped(const SmallPolygon& polygon, int axis, double low, double high);

/// Height at which the upright line through (x, y) leaves a box, if it meets it.
class BoxTop {
public:
    explicit BoxTop(const OrientedBox& box);
    std::optional<double> at(double x, double y) const;
    double highest() const { return m_centre.z() + m_toBox.col(2).cwiseAbs().dot(m_half); }  ///< m, of any corner

private:
    Vec3 m_centre;
    Vec3 m_half;
    Mat3 m_toBox;
};

}  // namespace rubble
