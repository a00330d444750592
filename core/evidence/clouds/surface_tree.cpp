#include "core/evidence/clouds/surface_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace rubble {

namespace {

constexpr std::uint32_t leafTriangles = 4;
constexpr int binCount = 16;
/// A tree of 2^32 triangles cut at random is far lower than this; below it nodes are halved.
constexpr int depthMost = 60;
constexpr float nowhere = std::numeric_limits<float>::infinity();

double halfArea(const Aabb& box) {
    const Vec3 sides = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.sizes());
    return sides.x() * sides.y() + sides.y() * sides.z() + sides.z() * sides.x();
}

/// The number in single precision that is next to another, not above it.
float roundedDown(double number) {
    const auto rounded = static_cast<float>(number);
    return rounded > number ? std::nextafter(rounded, -std::numeric_limits<float>::infinity()) : rounded;
}

float roundedUp(double number) {
    return -roundedDown(-number);
}

}  // namespace

/// Cuts the triangles where the areas of the two boxes, weighed by what lies in them, are least; the cuts of each node that
/// have the greatest boxes become one node.
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
        m_cuts.reserve(all.size());
        m_cuts.emplace_back();
        cut(0, 0, static_cast<std::uint32_t>(all.size()), 0);
        m_tree.m_box = m_cuts[0].box;
        m_tree.m_middle = m_tree.m_box.center();
        m_tree.m_nodes.emplace_back();
        gather(0, 0);
    }

private:
    /// Two children that lie behind each other, or triangles.
    struct Cut {
        Aabb box;
        std::uint32_t first = 0;
        std::uint32_t count = 0;  ///< triangles; 0: children
    };

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
        m_cuts[node].box = Aabb(box.min() - margin, box.max() + margin);
        if (last - first <= leafTriangles) {
            m_cuts[node].first = first;
            m_cuts[node].count = last - first;
            return;
        }
        const std::uint32_t middle = depth < depthMost ? cutAt(first, last, middles) : (first + last) / 2;
        const auto children = static_cast<std::uint32_t>(m_cuts.size());
        m_cuts[node].first = children;
        m_cuts.emplace_back();
        m_cuts.emplace_back();
        cut(children, first, middle, depth + 1);
        cut(children + 1, middle, last, depth + 1);
    }

    /// Makes a node of the greatest boxes below a cut, and the nodes below it.
    void gather(std::uint32_t node, std::uint32_t top) {
        std::vector<std::uint32_t> parts{top};
        const auto opens = [&](std::uint32_t part) { return m_cuts[part].count == 0 ? halfArea(m_cuts[part].box) : -1.0; };
        while (parts.size() < width) {
            const auto greatest =
                std::max_element(parts.begin(), parts.end(), [&](std::uint32_t a, std::uint32_t b) { return opens(a) < opens(b); });
            if (m_cuts[*greatest].count > 0) {
                break;
            }
            const std::uint32_t children = m_cuts[*greatest].first;
            *greatest = children;
            parts.push_back(children + 1);
        }
        const auto below = static_cast<std::uint32_t>(m_tree.m_nodes.size());
        std::uint32_t nodes = 0;
        for (std::size_t k = 0; k < width; ++k) {
            Node& made = m_tree.m_nodes[node];
            const bool there = k < parts.size();
            const Cut none;
            const Cut& part = there ? m_cuts[parts[k]] : none;
            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                const double middle = m_tree.m_middle[axis];
                made.low[axis][k] = there ? roundedDown(part.box.min()[axis] - middle) : nowhere;
                made.high[axis][k] = there ? roundedUp(part.box.max()[axis] - middle) : -nowhere;
            }
            made.count[k] = part.count;
            made.first[k] = part.count > 0 || !there ? part.first : below + nodes++;
        }
        m_tree.m_nodes.resize(below + nodes);
        nodes = 0;
        for (const std::uint32_t part : parts) {
            if (m_cuts[part].count == 0) {
                gather(below + nodes++, part);
            }
        }
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
    std::vector<Cut> m_cuts;
};

/// A ray as boxes are met by it: from where it comes near the tree, in single precision. Whatever rounding may do to it makes the
/// boxes larger.
class SurfaceTree::Ray {
public:
    /// @param before  m, how far the start of the ray is from the tree at least
    Ray(const SurfaceTree& tree, const Vec3& from, const Vec3& direction, double before) : m_before(before) {
        const Vec3 start = from + before * direction - tree.m_middle;
        // Differences of two such numbers, and their product with the inverse, are off by less than four roundings.
        const double reach = start.cwiseAbs().maxCoeff() + tree.m_box.sizes().maxCoeff();
        const double margin = 4.0 * std::numeric_limits<float>::epsilon() * reach;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // A component of zero would make 0 times infinity at the faces of a box.
            const double along = direction[static_cast<Eigen::Index>(axis)];
            const double inverse = 1.0 / (std::abs(along) > 1e-30 ? along : 1e-30);
            const double at = start[static_cast<Eigen::Index>(axis)];
            m_inverse[axis] = static_cast<float>(inverse);
            m_enter[axis] = static_cast<float>(inverse > 0.0 ? at + margin : at - margin);
            m_leave[axis] = static_cast<float>(inverse > 0.0 ? at - margin : at + margin);
            m_downwards[axis] = inverse < 0.0;
        }
    }

    /// As far as boxes are met, from the start of the ray on, m.
    void endAt(double length) { m_length = roundedUp((length - m_before) * (1.0 + 1e-6) + 1e-6); }
    float length() const { return m_length; }

    /// Lengths to where the ray enters the boxes of a node; infinite where it passes by or enters too late.
    std::array<float, width> entries(const Node& node) const {
        Four enter = Four{} + 0.0F;
        Four leave = Four{} + m_length;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float(&near)[width] = m_downwards[axis] ? node.high[axis] : node.low[axis];
            const float(&far)[width] = m_downwards[axis] ? node.low[axis] : node.high[axis];
            const Four in = (*reinterpret_cast<const Four*>(near) - m_enter[axis]) * m_inverse[axis];
            const Four out = (*reinterpret_cast<const Four*>(far) - m_leave[axis]) * m_inverse[axis];
            enter = in > enter ? in : enter;
            leave = out < leave ? out : leave;
        }
        return std::bit_cast<std::array<float, width>>(enter <= leave ? enter : Four{} + nowhere);
    }

private:
    /// Every processor compares four at once.
    using Four = float __attribute__((vector_size(16), may_alias));

    double m_before;
    float m_length = 0.0F;
    std::array<float, 3> m_inverse{}, m_enter{}, m_leave{};
    std::array<bool, 3> m_downwards{};
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
    // A ray that is no number would be met by all boxes.
    if (m_nodes.empty() || !from.allFinite() || !direction.allFinite()) {
        return std::nullopt;
    }
    // What starts far away would be far from where it is by rounding.
    const double before = std::min(length, std::max(0.0, std::sqrt(m_box.squaredExteriorDistance(from)) * (1.0 - 1e-6)));
    Ray ray(*this, from, direction, before);
    ray.endAt(length);
    struct Open {
        float entry;
        std::uint32_t first, count;
    };
    std::array<Open, (depthMost + 40) * (width - 1)> open;
    std::size_t waiting = 0;
    open[waiting++] = {0.0F, 0, 0};
    std::optional<RayHit> nearest;
    while (waiting > 0) {
        const Open next = open[--waiting];
        if (next.entry > ray.length()) {
            continue;
        }
        if (next.count > 0) {
            const double longest = length;
            meet(next.first, next.count, from, direction, length, nearest);
            if (length < longest) {
                ray.endAt(length);
            }
            continue;
        }
        const Node& node = m_nodes[next.first];
        const std::array<float, width> entries = ray.entries(node);
        // The nearest comes last, and is looked at first.
        const std::size_t begin = waiting;
        for (std::size_t k = 0; k < width; ++k) {
            if (entries[k] < nowhere) {
                std::size_t at = waiting++;
                for (; at > begin && open[at - 1].entry < entries[k]; --at) {
                    open[at] = open[at - 1];
                }
                open[at] = {entries[k], node.first[k], node.count[k]};
            }
        }
    }
    return nearest;
}

void SurfaceTree::meet(std::uint32_t first, std::uint32_t count, const Vec3& from, const Vec3& direction, double& length,
                       std::optional<RayHit>& nearest) const {
    // Möller & Trumbore 1997, with the rim of a triangle belonging to it.
    for (std::uint32_t i = first; i < first + count; ++i) {
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
            const bool before = !nearest || range < nearest->range || at.triangle < nearest->triangle;
            length = range;
            nearest = before ? RayHit{range, at.triangle} : nearest;
        }
    }
}

}  // namespace rubble
