#include "core/simulation/effects/submerged_box.h"

#include <array>

namespace rubble {

namespace {

/// Part of a face below z = 0; a quadrilateral cut once has at most five corners.
struct Polygon {
    std::array<Vec3, 5> corners;
    std::size_t count = 0;

    void add(const Vec3& p) {
        if (count < corners.size()) {
            corners[count++] = p;
        }
    }
};

Polygon clipBelow(const std::array<Vec3, 4>& face) {
    Polygon below;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3& a = face[i];
        const Vec3& b = face[(i + 1) % 4];
        if (a.z() <= 0.0) {
            below.add(a);
        }
        if ((a.z() < 0.0 && b.z() > 0.0) || (a.z() > 0.0 && b.z() < 0.0)) {
            Vec3 cut = a + a.z() / (a.z() - b.z()) * (b - a);
            cut.z() = 0.0;
            below.add(cut);
        }
    }
    return below;
}

/// Integral of x^2 over a triangle seen from above, over its signed area.
double meanSquare(double a, double b, double c) {
    return (a * a + b * b + c * c + a * b + b * c + c * a) / 6.0;
}

}  // namespace

SubmergedBox submerge(const OrientedBox& box, double level) {
    const Mat3 axes = box.orientation.toRotationMatrix();
    const double reach = axes.row(2).cwiseAbs().dot(box.halfExtents);
    SubmergedBox below;
    below.centroid = box.centre;
    if (box.centre.z() - reach >= level) {
        return below;
    }
    if (box.centre.z() + reach <= level) {
        below.volume = box.volume();
        return below;
    }
    const Vec3 origin(box.centre.x(), box.centre.y(), level);  // in the plane, so that the cut spans no volume
    Vec3 moment = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 u = axes.col((axis + 1) % 3) * box.halfExtents[(axis + 1) % 3];
        const Vec3 v = axes.col((axis + 2) % 3) * box.halfExtents[(axis + 2) % 3];
        for (const double side : {-1.0, 1.0}) {
            const Vec3 centre = box.centre - origin + side * box.halfExtents[axis] * axes.col(axis);
            // Counter-clockwise seen from outside.
            const Vec3 w = side * v;
            const Polygon face = clipBelow({centre - u - w, centre + u - w, centre + u + w, centre - u + w});
            for (std::size_t i = 1; i + 1 < face.count; ++i) {
                const Vec3 &a = face.corners[0], &b = face.corners[i], &c = face.corners[i + 1];
                const double volume = a.dot(b.cross(c)) / 6.0;
                below.volume += volume;
                moment += volume * (a + b + c) / 4.0;
                const double seen = 0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
                below.waterplane -= seen;
                below.momentX -= seen * meanSquare(a.y(), b.y(), c.y());
                below.momentY -= seen * meanSquare(a.x(), b.x(), c.x());
            }
        }
    }
    if (below.volume > 0.0) {
        below.centroid = origin + moment / below.volume;
    }
    return below;
}

double projectedArea(const OrientedBox& box, const Vec3& direction) {
    const Vec3 along = box.orientation.conjugate() * direction;
    const Vec3& h = box.halfExtents;
    return 4.0 * along.cwiseAbs().dot(Vec3(h.y() * h.z(), h.x() * h.z(), h.x() * h.y()));
}

}  // namespace rubble
