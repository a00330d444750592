#include "core/base/convex_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/same_bits.h"

namespace rubble {

namespace {

/// Of the size of the body. Coplanar and equal within this.
constexpr double flat = 1e-6;

/// The points of a plane that are corners of its polygon, in order about the normal.
std::vector<std::uint32_t> polygonOf(std::span<const Vec3> points, const Vec3& normal, std::vector<std::uint32_t> inPlane,
                                     double tolerance) {
    const Vec3 off = std::abs(normal.x()) < 0.57735 ? Vec3::UnitX() : Vec3::UnitY();
    const Vec3 u = normal.cross(off).normalized();
    const Vec3 v = normal.cross(u);
    const auto place = [&](std::uint32_t i) { return std::pair(u.dot(points[i]), v.dot(points[i])); };
    std::sort(inPlane.begin(), inPlane.end(), [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
    // Andrew's monotone chain: the lower side from left to right, then the upper one back.
    std::vector<std::uint32_t> polygon;
    const auto add = [&](std::uint32_t i, std::size_t fixed) {
        const auto [x, y] = place(i);
        while (polygon.size() > fixed + 1) {
            const auto [ax, ay] = place(polygon[polygon.size() - 2]);
            const auto [bx, by] = place(polygon.back());
            const double length = lengthOf(x - ax, y - ay);
            if ((bx - ax) * (y - ay) - (by - ay) * (x - ax) > tolerance * length) {
                break;
            }
            polygon.pop_back();
        }
        polygon.push_back(i);
    };
    for (const std::uint32_t i : inPlane) {
        add(i, 0);
    }
    const std::size_t lower = polygon.size() - 1;
    for (auto i = inPlane.rbegin() + 1; i != inPlane.rend(); ++i) {
        add(*i, lower);
    }
    polygon.pop_back();
    return polygon;
}

void addFace(ConvexHull& hull, Vec3 normal, double tolerance) {
    double distance = 0.0;
    for (const Vec3& p : hull.corners) {
        distance = std::max(distance, normal.dot(p - hull.corners.front()));
    }
    distance += normal.dot(hull.corners.front());
    std::vector<std::uint32_t> inPlane;
    for (std::uint32_t i = 0; i < hull.corners.size(); ++i) {
        if (normal.dot(hull.corners[i]) > distance - tolerance) {
            inPlane.push_back(i);
        }
    }
    HullFace face{normal, distance, polygonOf(hull.corners, normal, std::move(inPlane), tolerance)};
    if (face.corners.size() >= 3) {
        hull.faces.push_back(std::move(face));
    }
}

/// Every edge lies in two faces, once in either direction.
void addEdges(ConvexHull& hull) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> faceOf;
    for (std::uint32_t f = 0; f < hull.faces.size(); ++f) {
        const auto& corners = hull.faces[f].corners;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            faceOf[{corners[k], corners[(k + 1) % corners.size()]}] = f;
        }
    }
    for (const auto& [ends, face] : faceOf) {
        const auto other = faceOf.find({ends.second, ends.first});
        if (ends.first < ends.second && other != faceOf.end()) {
            hull.edges.push_back({ends.first, ends.second, face, other->second});
        }
    }
}

}  // namespace

ConvexHull hullFaces(std::span<const Vec3> points) {
    ConvexHull hull{{points.begin(), points.end()}, {}, {}};
    Aabb bounds;
    for (const Vec3& p : points) {
        bounds.extend(p);
    }
    const double tolerance = bounds.isEmpty() ? 0.0 : flat * bounds.diagonal().norm();
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 1; j < count; ++j) {
            for (std::size_t k = j + 1; k < count; ++k) {
                Vec3 normal = (points[j] - points[i]).cross(points[k] - points[i]);
                const double area = normal.norm();
                if (!(area > tolerance * bounds.diagonal().norm())) {
                    continue;
                }
                normal /= area;
                bool above = false, below = false;
                for (std::size_t p = 0; p < count && !(above && below); ++p) {
                    const double height = normal.dot(points[p] - points[i]);
                    above = above || height > tolerance;
                    below = below || height < -tolerance;
                }
                if (above == below) {
                    continue;
                }
                if (above) {
                    normal = -normal;
                }
                const auto known = [&](const HullFace& face) {
                    return std::ranges::all_of(std::array{i, j, k}, [&](std::size_t p) {
                        return std::abs(face.normal.dot(points[p]) - face.distance) <= tolerance;
                    });
                };
                if (std::ranges::none_of(hull.faces, known)) {
                    addFace(hull, normal, tolerance);
                }
            }
        }
    }
    addEdges(hull);
    return hull;
}

}  // namespace rubble
