#include "widgets/render/basics/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace rubble::render {
namespace {

constexpr double margin = 1.06;            // the model does not touch the edges of its pane
constexpr double sideElevation = 0.12;     // rad, slightly from above
constexpr double widestAngle = 36.0;       // degrees across; a wider lens bends long bridges
constexpr double pitchLimit = 1.55;        // rad, short of the pole where "up" loses its meaning
constexpr double smallestDistance = 1e-3;  // m

struct Axes {
    Vec3 forward, right, up;
};

Axes axesOf(const Camera& camera) {
    Vec3 forward = camera.focalPoint - camera.position;
    forward = forward.norm() > 0 ? forward.normalized() : Vec3(Vec3::UnitY());
    Vec3 right = forward.cross(camera.up);
    // Looking along "up" leaves "right" open: any level direction will do.
    right = right.norm() > 1e-9 ? right.normalized() : Vec3(Vec3::UnitX());
    return {forward, right, right.cross(forward)};
}

double tangent(const Camera& camera) {
    return std::tan(0.5 * camera.viewAngle * std::numbers::pi / 180.0);
}

/// Half the height of what is seen in the plane of the focal point, m.
double halfHeight(const Camera& camera) {
    return camera.parallel ? camera.parallelScale : tangent(camera) * (camera.focalPoint - camera.position).norm();
}

/// What is seen in a standard direction, from nowhere in particular.
Camera directed(double aspect, Preset preset) {
    Camera camera;
    camera.focalPoint = Vec3::Zero();
    camera.up = preset == Preset::Top || preset == Preset::Bottom ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitZ());
    switch (preset) {
        case Preset::Side:
            camera.position = Vec3(0, -std::cos(sideElevation), std::sin(sideElevation));
            break;
        case Preset::Front:
            camera.position = -Vec3::UnitY();
            break;
        case Preset::Back:
            camera.position = Vec3::UnitY();
            break;
        case Preset::Left:
            camera.position = -Vec3::UnitX();
            break;
        case Preset::Right:
            camera.position = Vec3::UnitX();
            break;
        case Preset::Top:
            camera.position = Vec3::UnitZ();
            break;
        case Preset::Bottom:
            camera.position = -Vec3::UnitZ();
            break;
        case Preset::Corner:
            camera.position = Vec3(-1.0, -1.6, 0.9).normalized();
            break;
    }
    if (aspect > 0) {
        const double half = std::tan(0.5 * widestAngle * std::numbers::pi / 180.0) / aspect;
        camera.viewAngle = std::min(camera.viewAngle, 2.0 * std::atan(half) * 180.0 / std::numbers::pi);
    }
    return camera;
}

/// The same direction, moved so that points fit. @param middle  m, about which they lie
Camera around(const Camera& start, std::span<const Vec3> points, const Vec3& middle, double aspect, double heightShare) {
    Camera camera = start;
    const Axes axes = axesOf(start);
    const double tanV = tangent(start) * heightShare;
    const double tanH = tangent(start) * aspect;
    camera.focalPoint = middle;
    double distance = smallestDistance;
    std::vector<Vec3> local(points.size());
    // Two rounds: perspective moves the picture's middle, so centre what was seen and fit again.
    for (int round = 0; round < 3; ++round) {
        distance = smallestDistance;
        double lowU = std::numeric_limits<double>::infinity(), highU = -lowU, lowV = lowU, highV = -lowU, scale = smallestDistance;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec3 d = points[i] - camera.focalPoint;
            local[i] = Vec3(d.dot(axes.right), d.dot(axes.up), d.dot(axes.forward));
            distance = std::max({distance, margin * std::abs(local[i].x()) / tanH - local[i].z(),
                                 margin * std::abs(local[i].y()) / tanV - local[i].z()});
            scale = std::max({scale, margin * std::abs(local[i].x()) / aspect, margin * std::abs(local[i].y()) / heightShare});
        }
        camera.parallelScale = scale;
        for (const Vec3& p : local) {
            const double w = start.parallel ? 1.0 : distance / std::max(distance + p.z(), 1e-6 * distance);
            lowU = std::min(lowU, p.x() * w);
            highU = std::max(highU, p.x() * w);
            lowV = std::min(lowV, p.y() * w);
            highV = std::max(highV, p.y() * w);
        }
        if (round < 2) {
            camera.focalPoint += axes.right * 0.5 * (lowU + highU) + axes.up * 0.5 * (lowV + highV);
        }
    }
    camera.position = camera.focalPoint - axes.forward * distance;
    camera.up = axes.up;
    return camera;
}

}  // namespace

Camera refit(const Camera& start, const Aabb& bounds, double aspect, double heightShare) {
    if (bounds.isEmpty() || !bounds.min().allFinite() || !bounds.max().allFinite() || !(aspect > 0)) {
        return start;
    }
    std::array<Vec3, 8> corners;
    for (int i = 0; i < 8; ++i) {
        corners[static_cast<std::size_t>(i)] = bounds.corner(static_cast<Aabb::CornerType>(i));
    }
    return around(start, corners, bounds.center(), aspect, heightShare);
}

Camera fitCamera(const Aabb& bounds, double aspect, Preset preset) {
    return bounds.isEmpty() ? Camera{} : refit(directed(aspect, preset), bounds, aspect);
}

Camera fitCamera(std::span<const Vec3> points, double aspect, Preset preset) {
    Aabb box;
    for (const Vec3& point : points) {
        box.extend(point);
    }
    if (box.isEmpty() || !box.min().allFinite() || !box.max().allFinite() || !(aspect > 0)) {
        return Camera{};
    }
    return around(directed(aspect, preset), points, box.center(), aspect, 1.0);
}

Ray rayThrough(const Camera& camera, double u, double v, double aspect) {
    const Axes axes = axesOf(camera);
    const double x = (2.0 * u - 1.0) * aspect;
    const double y = 1.0 - 2.0 * v;
    if (camera.parallel) {
        return {camera.position + camera.parallelScale * (x * axes.right + y * axes.up), axes.forward};
    }
    const double t = tangent(camera);
    return {camera.position, (axes.forward + t * (x * axes.right + y * axes.up)).normalized()};
}

std::optional<Projected> project(const Camera& camera, const Vec3& point, double aspect) {
    const Axes axes = axesOf(camera);
    const Vec3 offset = point - camera.position;
    const double depth = offset.dot(axes.forward);
    const double half = camera.parallel ? camera.parallelScale : tangent(camera) * depth;
    if (!(half > 0.0) || !(aspect > 0.0) || (!camera.parallel && !(depth > smallestDistance))) {
        return std::nullopt;
    }
    return Projected{0.5 * (1.0 + offset.dot(axes.right) / (half * aspect)), 0.5 * (1.0 - offset.dot(axes.up) / half)};
}

Camera withProjection(const Camera& camera, bool parallel) {
    if (camera.parallel == parallel) {
        return camera;
    }
    Camera other = camera;
    other.parallel = parallel;
    other.parallelScale = std::max(halfHeight(camera), smallestDistance);
    if (!parallel) {
        other.position = other.focalPoint - axesOf(camera).forward * (camera.parallelScale / tangent(camera));
    }
    return other;
}

Camera orbit(const Camera& camera, double yaw, double pitch) {
    Camera turned = camera;
    const Vec3 offset = camera.position - camera.focalPoint;
    const double distance = std::max(offset.norm(), smallestDistance);
    const Axes axes = axesOf(camera);
    // Straight above or below, the heading is told by what is up on the picture.
    const bool polar = std::hypot(offset.x(), offset.y()) < 1e-6 * distance;
    const double heading = (polar ? std::atan2(-axes.up.y(), -axes.up.x()) : std::atan2(offset.y(), offset.x())) + yaw;
    const double elevation = std::clamp(std::asin(std::clamp(offset.z() / distance, -1.0, 1.0)) + pitch, -pitchLimit, pitchLimit);
    turned.position = camera.focalPoint + distance * Vec3(std::cos(elevation) * std::cos(heading),
                                                          std::cos(elevation) * std::sin(heading), std::sin(elevation));
    turned.up = Vec3::UnitZ();
    return turned;
}

Camera pan(const Camera& camera, double dx, double dy, double paneHeight) {
    const Axes axes = axesOf(camera);
    const Vec3 shift = metresPerPixel(camera, paneHeight) * (-dx * axes.right + dy * axes.up);
    Camera moved = camera;
    moved.position += shift;
    moved.focalPoint += shift;
    return moved;
}

Camera zoom(const Camera& camera, double factor, double u, double v, double aspect) {
    if (!(factor > 0) || !std::isfinite(factor)) {
        return camera;
    }
    const Axes axes = axesOf(camera);
    const double half = halfHeight(camera);
    const Vec3 cursor = camera.focalPoint + half * ((2.0 * u - 1.0) * aspect * axes.right + (1.0 - 2.0 * v) * axes.up);
    Camera zoomed = camera;
    zoomed.focalPoint = cursor + (camera.focalPoint - cursor) / factor;
    const double distance = std::max((camera.focalPoint - camera.position).norm() / factor, smallestDistance);
    zoomed.position = zoomed.focalPoint - distance * axes.forward;
    zoomed.parallelScale = std::max(camera.parallelScale / factor, smallestDistance);
    return zoomed;
}

Camera centreOn(const Camera& camera, const Vec3& point) {
    Camera moved = camera;
    moved.position += point - camera.focalPoint;
    moved.focalPoint = point;
    return moved;
}

bool showsAlike(const Camera& a, const Camera& b) {
    constexpr double rounding = 1e-9;
    const double least = rounding * (a.position - a.focalPoint).norm();
    return a.parallel == b.parallel && (a.position - b.position).norm() <= least && (a.focalPoint - b.focalPoint).norm() <= least &&
           (a.up - b.up).norm() <= rounding && std::abs(a.viewAngle - b.viewAngle) <= rounding * a.viewAngle &&
           std::abs(a.parallelScale - b.parallelScale) <= rounding * a.parallelScale;
}

Camera between(const Camera& from, const Camera& to, double t) {
    t = std::clamp(t, 0.0, 1.0);
    if (t == 0.0 || t == 1.0) {
        return t == 0.0 ? from : to;
    }
    Camera camera = to;
    const Vec3 a = from.position - from.focalPoint;
    const Vec3 b = to.position - to.focalPoint;
    const double distance = (1 - t) * a.norm() + t * b.norm();
    Vec3 direction = (1 - t) * a.normalized() + t * b.normalized();
    direction = direction.norm() > 1e-6 ? direction.normalized() : b.normalized();
    camera.focalPoint = (1 - t) * from.focalPoint + t * to.focalPoint;
    camera.position = camera.focalPoint + distance * direction;
    const Vec3 up = (1 - t) * from.up + t * to.up;
    camera.up = up.norm() > 1e-6 ? Vec3(up.normalized()) : to.up;
    camera.viewAngle = (1 - t) * from.viewAngle + t * to.viewAngle;
    camera.parallelScale = (1 - t) * from.parallelScale + t * to.parallelScale;
    return camera;
}

double metresPerPixel(const Camera& camera, double paneHeight) {
    return paneHeight > 0 ? 2.0 * halfHeight(camera) / paneHeight : 0.0;
}

}  // namespace rubble::render
