#include "widgets/render/framing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace rubble::render {
namespace {

constexpr double strayShare = 0.002;  // of the elements at each side that need not be seen
constexpr double strayReach = 0.1;    // of what the others span: whatever lies within that is seen
constexpr int directions = 192;       // in which the outermost point is kept; the margin of a picture takes what that misses
constexpr double flattest = 8.0;
constexpr double tallest = 0.5;

/// Directions over the whole sphere, evenly.
Eigen::Matrix<float, directions, 3> allDirections() {
    Eigen::Matrix<float, directions, 3> rows;
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (int k = 0; k < directions; ++k) {
        const double z = 1.0 - (2.0 * k + 1.0) / directions;
        const double r = std::sqrt(1.0 - z * z);
        rows.row(k) = Eigen::Vector3d(r * std::cos(golden * k), r * std::sin(golden * k), z).cast<float>();
    }
    return rows;
}

struct Span {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();

    bool holds(double value) const { return low <= value && value <= high; }
};

/// Where what is shown lies along a direction, without what lies far out.
Span spanAlong(const Vec3& direction, std::span<const Vec3> centres, const Aabb& always, double largest) {
    std::vector<double> places;
    for (const Vec3& centre : centres) {
        places.push_back(centre.dot(direction));
    }
    const auto out = static_cast<std::ptrdiff_t>(strayShare * static_cast<double>(places.size()));
    if (out == 0) {
        return {};
    }
    std::sort(places.begin(), places.end());
    double low = places[static_cast<std::size_t>(out)];
    double high = places[places.size() - 1 - static_cast<std::size_t>(out)];
    const double reach = strayReach * (high - low) + largest;
    low -= reach;
    high += reach;
    for (int i = 0; i < 8 && !always.isEmpty(); ++i) {
        const double place = always.corner(static_cast<Aabb::CornerType>(i)).dot(direction);
        low = std::min(low, place - largest);
        high = std::max(high, place + largest);
    }
    return {low, high};
}

}  // namespace

void Framing::add(std::span<const Vec3> points, std::span<const Vec3> centres, const Aabb& always, double largest) {
    static const Eigen::Matrix<float, directions, 3> rows = allDirections();
    const std::array<Vec3, 1> origin{Vec3::Zero()};
    const Camera look = fitCamera(origin, 1.0, m_look);
    const Vec3 right = (look.focalPoint - look.position).cross(look.up).normalized();
    const Vec3 up = look.up.normalized();
    const Span across = spanAlong(right, centres, always, largest);
    const Span upwards = spanAlong(up, centres, always, largest);
    std::array<std::size_t, directions> outermost{};
    Eigen::Matrix<float, directions, 1> farthest =
        Eigen::Matrix<float, directions, 1>::Constant(-std::numeric_limits<float>::max());
    bool any = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3& point = points[i];
        if (!point.allFinite() || !across.holds(point.dot(right)) || !upwards.holds(point.dot(up))) {
            continue;
        }
        any = true;
        const Eigen::Matrix<float, directions, 1> reach = rows * (point - points.front()).cast<float>();
        for (int k = 0; k < directions; ++k) {
            if (reach[k] > farthest[k]) {
                farthest[k] = reach[k];
                outermost[static_cast<std::size_t>(k)] = i;
            }
        }
    }
    if (!any) {
        return;
    }
    std::sort(outermost.begin(), outermost.end());
    const auto end = std::unique(outermost.begin(), outermost.end());
    for (auto each = outermost.begin(); each != end; ++each) {
        m_points.push_back(points[*each]);
    }
}

void Framing::widen(double factor) {
    Aabb box;
    for (const Vec3& point : m_points) {
        box.extend(point);
    }
    const std::size_t count = box.isEmpty() ? 0 : m_points.size();
    for (std::size_t i = 0; i < count; ++i) {
        Vec3 farther = box.center() + factor * (m_points[i] - box.center());
        farther.z() = m_points[i].z();
        m_points.push_back(farther);
    }
}

double Framing::aspect() const {
    double aspect = 1.6;
    // The angle of the view, and with it how perspective shows the depth, follows the shape.
    for (int round = 0; round < 4 && !empty(); ++round) {
        const Camera seen = camera(aspect);
        Eigen::AlignedBox2d box;
        for (const Vec3& point : m_points) {
            if (const auto place = project(seen, point, aspect)) {
                box.extend(Eigen::Vector2d(aspect * place->u, place->v));
            }
        }
        const Eigen::Vector2d size = box.isEmpty() ? Eigen::Vector2d(1.6, 1.0) : Eigen::Vector2d(box.sizes());
        aspect = std::clamp(size.x() / std::max(size.y(), 1e-9), tallest, flattest);
    }
    return aspect;
}

}  // namespace rubble::render
