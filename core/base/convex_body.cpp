#include "core/base/convex_body.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/base/convex_hull.h"

namespace rubble {

namespace {

/// Of the size of the body. Points are in a plane, and no corner, within this.
constexpr double coplanar = 2e-6;

/// The point that is farthest by a measure; of equals the one farthest from the middle, which is a corner of the hull.
template <class Measure>
std::pair<std::size_t, double> farthest(std::span<const Vec3> points, const Vec3& middle, double tolerance, Measure measure) {
    std::size_t best = 0;
    double most = -1.0, out = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double value = measure(points[i]);
        if (value < most - tolerance) {
            continue;
        }
        const double distance = (points[i] - middle).squaredNorm();
        if (value > most + tolerance || distance > out) {
            best = i;
            out = distance;
            most = std::max(most, value);
        }
    }
    return {best, most};
}

/// Four corners of the hull that span a volume; fewer where there is none.
std::vector<Vec3> firstCorners(std::span<const Vec3> points, const Vec3& middle, double tolerance) {
    std::vector<Vec3> corners;
    const auto take = [&](auto measure) {
        const auto [index, distance] = farthest(points, middle, tolerance, measure);
        const bool apart = distance > tolerance;
        if (apart) {
            corners.push_back(points[index]);
        }
        return apart;
    };
    if (!take([&](const Vec3& p) { return (p - middle).norm(); })) {
        return corners;
    }
    if (!take([&](const Vec3& p) { return (p - corners[0]).norm(); })) {
        return corners;
    }
    const Vec3 line = (corners[1] - corners[0]).normalized();
    if (!take([&](const Vec3& p) { return (p - corners[0]).cross(line).norm(); })) {
        return corners;
    }
    const Vec3 normal = line.cross(corners[2] - corners[0]).normalized();
    take([&](const Vec3& p) { return std::abs(normal.dot(p - corners[0])); });
    return corners;
}

double heightOver(const ConvexHull& hull, const Vec3& point) {
    double height = -std::numeric_limits<double>::infinity();
    for (const HullFace& face : hull.faces) {
        height = std::max(height, face.normal.dot(point) - face.distance);
    }
    return height;
}

/// The points of a hull that are corners of its faces.
std::vector<Vec3> cornersInFaces(const ConvexHull& hull) {
    std::set<std::uint32_t> used;
    for (const HullFace& face : hull.faces) {
        used.insert(face.corners.begin(), face.corners.end());
    }
    std::vector<Vec3> corners;
    for (const std::uint32_t corner : used) {
        corners.push_back(hull.corners[corner]);
    }
    return corners;
}

Vec3 sidesOf(const std::vector<Vec3>& corners) {
    Aabb bounds;
    for (const Vec3& corner : corners) {
        bounds.extend(corner);
    }
    return bounds.sizes();
}

/// Moves the corners about the centre of mass, and takes the volume.
void centre(ConvexBody& body) {
    Vec3 inside = Vec3::Zero();
    for (const Vec3& corner : body.corners) {
        inside += corner / static_cast<double>(body.corners.size());
    }
    Vec3 moment = Vec3::Zero();
    for (const auto& [a, b, c] : body.triangles) {
        const Vec3 p = body.corners[a] - inside, q = body.corners[b] - inside, r = body.corners[c] - inside;
        const double volume = p.dot(q.cross(r)) / 6.0;
        body.volume += volume;
        moment += 0.25 * volume * (p + q + r);
    }
    const Vec3 mass = inside + moment / body.volume;
    for (Vec3& corner : body.corners) {
        corner -= mass;
    }
}

}  // namespace

std::optional<ConvexBody> convexBodyOf(std::span<const Vec3> points) {
    Aabb bounds;
    for (const Vec3& point : points) {
        bounds.extend(point);
    }
    if (bounds.isEmpty()) {
        return std::nullopt;
    }
    const double tolerance = coplanar * bounds.diagonal().norm();
    std::vector<Vec3> corners = firstCorners(points, bounds.center(), tolerance);
    if (corners.size() < 4) {
        return std::nullopt;
    }
    ConvexBody body;
    ConvexHull hull;
    for (;;) {
        hull = hullFaces(corners);
        corners = cornersInFaces(hull);
        if (corners.size() < 4) {
            return std::nullopt;
        }
        const auto [index, height] =
            farthest(points, bounds.center(), tolerance, [&](const Vec3& p) { return heightOver(hull, p); });
        const bool whole = height <= tolerance;
        if (whole || corners.size() >= hullCornersMax) {
            body.leftOut = whole ? 0.0 : height;
            break;
        }
        corners.push_back(points[index]);
    }
    hull = hullFaces(corners);
    body.corners = hull.corners;
    for (const HullFace& face : hull.faces) {
        for (std::size_t k = 2; k < face.corners.size(); ++k) {
            body.triangles.push_back({face.corners[0], face.corners[k - 1], face.corners[k]});
        }
    }
    centre(body);
    body.sides = sidesOf(body.corners);
    return body;
}

ConvexBody stretchedTo(ConvexBody body, const Vec3& sides) {
    const Vec3 stretch = sides.cwiseQuotient(body.sides);
    for (Vec3& corner : body.corners) {
        corner = corner.cwiseProduct(stretch);
    }
    body.volume *= stretch.prod();
    body.sides = sides;
    body.leftOut *= stretch.maxCoeff();
    return body;
}

}  // namespace rubble
