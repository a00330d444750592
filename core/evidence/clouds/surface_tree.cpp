#include "core/evidence/clouds/surface_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rubble {

namespace {

constexpr std::uint32_t leafTriangles = 4;
constexpr int binCount = 16;
/// A tree of 2^32 triangles cut at random is far lower than this; below it nodes are halved.
constexpr int depthMost = 60;

double halfArea(const Aabb& box) {
    const Vec3 sides = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.sizes());
    return sides.x() * sides.y() + sides.y() * sides.z() + sides.z() * sides.x();
}

/// Length along a ray to where it enters a box; infinite where it passes by or enters beyond a length.
double entryOf(const Vec3& low, const Vec3& high, const Vec3& from, const Vec3& inverse, double length) {
    // By axes, without a loop: this is where the time goes.
    const double x0 = (low.x() - from.x()) * inverse.x(), x1 = (high.x() - from.x()) * inverse.x();
    const double y0 = (low.y() - from.y()) * inverse.y(), y1 = (high.y() - from.y()) * inverse.y();
    const double z0 = (low.z() - from.z()) * inverse.z(), z1 = (high.z() - from.z()) * inverse.z();
    const double enter = std::max({std::min(x0, x1), std::min(y0, y1), std::min(z0, z1), 0.0});
    const double leave = std::min({std::max(x0, x1), std::max(y0, y1), std::max(z0, z1), length});
    return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

}  // namespace

/// Cuts the triangles where the areas of the two boxes, weighed by what lies in them, are least.
class SurfaceTree::Build {
public:
    explicit Build(SurfaceTree& tree) : m_tree(tree) {}

    void add(const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t triangle) {
        const Vec3 toB = b - a;
        const Vec3 toC = c - a;
        if (!a.allFinite() || !b.allFinite() || !c.allFinite() || !(toB.cross(toC).squaredNorm() > 0.0)) {
            return;
        }
        m_tree.m_triangles.push_back({a, toB, toC, triangle});
    }

    void make() {
        std::vector<Corners>& all = m_tree.m_triangles;
        if (all.empty()) {
            return;
        }
        m_tree.m_nodes.reserve(all.size());
        m_tree.m_nodes.emplace_back();
        cut(0, 0, static_cast<std::uint32_t>(all.size()), 0);
        m_tree.m_box = {m_tree.m_nodes[0].low, m_tree.m_nodes[0].high};
    }

private:
    static Aabb boxOf(const Corners& of) {
        Aabb box(of.a);
        box.extend(Vec3(of.a + of.toB));
        box.extend(Vec3(of.a + of.toC));
        return box;
    }
    static Vec3 middleOf(const Corners& of) { return of.a + (of.toB + of.toC) / 3.0; }

    void cut(std::uint32_t node, std::uint32_t first, std::uint32_t last, int depth) {
        Aabb box;
        Aabb middles;
        for (std::uint32_t i = first; i < last; ++i) {
            box.extend(boxOf(m_tree.m_triangles[i]));
            middles.extend(middleOf(m_tree.m_triangles[i]));
        }
        // A ray along a face must not slip past by rounding.
        const Vec3 margin = Vec3::Constant(1e-12 * (1.0 + box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff()));
        Node& made = m_tree.m_nodes[node];
        made.low = box.min() - margin;
        made.high = box.max() + margin;
        if (last - first <= leafTriangles) {
            made.first = first;
            made.count = last - first;
            return;
        }
        const std::uint32_t middle = depth < depthMost ? cutAt(first, last, middles) : (first + last) / 2;
        const auto children = static_cast<std::uint32_t>(m_tree.m_nodes.size());
        made.first = children;
        m_tree.m_nodes.emplace_back();
        m_tree.m_nodes.emplace_back();
        cut(children, first, middle, depth + 1);
        cut(children + 1, middle, last, depth + 1);
    }

    /// Sorts triangles to both sides of the best of a few planes. @return the first of the second side
    std::uint32_t cutAt(std::uint32_t first, std::uint32_t last, const Aabb& middles) {
        std::vector<Corners>& all = m_tree.m_triangles;
        int axis = 0;
        const double side = middles.sizes().maxCoeff(&axis);
        const double low = middles.min()[axis];
        const auto binOf = [&](const Corners& of) {
            return std::min(binCount - 1, static_cast<int>(binCount * (middleOf(of)[axis] - low) / side));
        };
        const std::uint32_t half = (first + last) / 2;
        if (!(side > 0.0)) {
            return half;
        }
        std::array<Aabb, binCount> boxes;
        std::array<std::uint32_t, binCount> counts{};
        for (std::uint32_t i = first; i < last; ++i) {
            const auto bin = static_cast<std::size_t>(binOf(all[i]));
            boxes[bin].extend(boxOf(all[i]));
            ++counts[bin];
        }
        std::array<double, binCount> costs{};
        const auto sweep = [&](bool upwards) {
            Aabb box;
            std::uint32_t count = 0;
            for (int k = 0; k + 1 < binCount; ++k) {
                const auto bin = static_cast<std::size_t>(upwards ? k : binCount - 1 - k);
                box.extend(boxes[bin]);
                count += counts[bin];
                costs[upwards ? bin : bin - 1] += halfArea(box) * count;
            }
        };
        sweep(true);
        sweep(false);
        const auto best = std::min_element(costs.begin(), costs.end() - 1) - costs.begin();
        const auto middle =
            std::partition(all.begin() + first, all.begin() + last, [&](const Corners& of) { return binOf(of) <= best; });
        const auto cutting = static_cast<std::uint32_t>(middle - all.begin());
        return cutting > first && cutting < last ? cutting : half;
    }

    SurfaceTree& m_tree;
};

SurfaceTree::SurfaceTree(const std::vector<Vec3>& points, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    Build build(*this);
    m_triangles.reserve(triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        build.add(points[triangles[t][0]], points[triangles[t][1]], points[triangles[t][2]], t);
    }
    build.make();
}

std::optional<RayHit> SurfaceTree::firstHit(const Vec3& from, const Vec3& direction, double length) const {
    if (m_nodes.empty()) {
        return std::nullopt;
    }
    // A component of zero would make 0 times infinity at the faces of a box.
    const Vec3 inverse = direction.unaryExpr([](double d) { return 1.0 / (std::abs(d) > 1e-200 ? d : 1e-200); });
    std::array<std::pair<std::uint32_t, double>, depthMost + 40> open;
    std::size_t waiting = 0;
    std::optional<RayHit> nearest;
    open[waiting++] = {0, entryOf(m_nodes[0].low, m_nodes[0].high, from, inverse, length)};
    while (waiting > 0) {
        const auto [index, entry] = open[--waiting];
        if (!(entry <= length)) {
            continue;
        }
        const Node& node = m_nodes[index];
        if (node.count == 0) {
            const Node& left = m_nodes[node.first];
            const Node& right = m_nodes[node.first + 1];
            std::pair near{node.first, entryOf(left.low, left.high, from, inverse, length)};
            std::pair far{node.first + 1, entryOf(right.low, right.high, from, inverse, length)};
            if (far.second < near.second) {
                std::swap(near, far);
            }
            if (far.second <= length) {
                open[waiting++] = far;
            }
            if (near.second <= length) {
                open[waiting++] = near;
            }
            continue;
        }
        // Möller & Trumbore 1997, with the rim of a triangle belonging to it.
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const Corners& at = m_triangles[i];
            const Vec3 across = direction.cross(at.toC);
            const double scale = across.dot(at.toB);
            if (scale == 0.0) {
                continue;
            }
            const Vec3 off = from - at.a;
            const double u = off.dot(across) / scale;
            const Vec3 up = off.cross(at.toB);
            const double v = direction.dot(up) / scale;
            constexpr double rim = 1e-9;
            const double range = at.toC.dot(up) / scale;
            if (u >= -rim && v >= -rim && u + v <= 1.0 + rim && range >= 0.0 && range <= length) {
                const bool first = !nearest || range < nearest->range || at.triangle < nearest->triangle;
                length = range;
                nearest = first ? RayHit{range, at.triangle} : nearest;
            }
        }
    }
    return nearest;
}

}  // namespace rubble
