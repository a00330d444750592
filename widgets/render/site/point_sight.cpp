#include "widgets/render/site/point_sight.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble::render {

double pixelsOf(const Camera& camera, double aspect, int height, const Aabb& box, double length) {
    if (box.isEmpty() || height <= 0) {
        return 0.0;
    }
    const Vec3 ahead = (camera.focalPoint - camera.position).normalized();
    const Vec3 right = ahead.cross(camera.up).normalized();
    const Vec3 up = right.cross(ahead);
    const Vec3 middle = box.center() - camera.position;
    const double radius = 0.5 * box.sizes().norm();
    const double x = std::abs(middle.dot(right));
    const double y = std::abs(middle.dot(up));
    const double z = middle.dot(ahead);
    if (camera.parallel) {
        const double half = camera.parallelScale;
        const bool inside = x <= half * aspect + radius && y <= half + radius;
        return inside ? length * height / (2.0 * half) : 0.0;
    }
    const double tangent = std::tan(0.5 * camera.viewAngle * std::numbers::pi / 180.0);
    // Of the ball about the box against the four sides of the view.
    const auto beside = [&](double off, double slope) { return off - z * slope > radius * std::sqrt(1.0 + slope * slope); };
    if (z < -radius || beside(x, tangent * aspect) || beside(y, tangent)) {
        return 0.0;
    }
    const double away = std::max(1e-3, box.exteriorDistance(camera.position));
    return length * height / (2.0 * tangent * away);
}

}  // namespace rubble::render
