#include "core/engine/world/bricks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "core/base/same_bits.h"
#include "core/engine/world/tight_box.h"

namespace rubble {

namespace {

/// m. Bricks no farther apart than this touch.
constexpr double jointWidth = 0.02;

/// m3, of the tetrahedra that a solid is made of.
double volumeOf(ElementShape solid, std::span<const Vec3> c) {
    const auto tetrahedron = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
        return std::abs((c[j] - c[i]).dot((c[k] - c[i]).cross(c[l] - c[i]))) / 6.0;
    };
    switch (solid) {
        case ElementShape::Tetrahedron:
            return tetrahedron(0, 1, 2, 3);
        case ElementShape::Pyramid:
            return tetrahedron(0, 1, 2, 4) + tetrahedron(0, 2, 3, 4);
        case ElementShape::Wedge:
            return tetrahedron(0, 1, 2, 3) + tetrahedron(1, 2, 3, 4) + tetrahedron(2, 3, 4, 5);
        default:
            return tetrahedron(0, 1, 3, 4) + tetrahedron(2, 1, 3, 6) + tetrahedron(5, 1, 4, 6) + tetrahedron(7, 3, 4, 6) +
                   tetrahedron(1, 3, 4, 6);
    }
}

/// The box, drawn in towards its centre until it has the volume.
OrientedBox ofVolume(OrientedBox box, double volume) {
    const double scale = cubeRootOf(volume / box.volume());
    if (std::isfinite(scale) && scale < 1.0) {
        box.halfExtents *= scale;
    }
    return box;
}

/// Axes from the three mean edges, laid square in the order that loses least; halves of the edges' lengths along them.
OrientedBox brickOfHexahedron(std::span<const Vec3> c) {
    const std::array<Vec3, 3> edges{0.25 * (c[1] - c[0] + c[2] - c[3] + c[5] - c[4] + c[6] - c[7]),
                                    0.25 * (c[3] - c[0] + c[2] - c[1] + c[7] - c[4] + c[6] - c[5]),
                                    0.25 * (c[4] - c[0] + c[5] - c[1] + c[6] - c[2] + c[7] - c[3])};
    OrientedBox best;
    double least = std::numeric_limits<double>::infinity();
    std::array<std::size_t, 3> order{0, 1, 2};
    do {
        const Vec3 &a = edges[order[0]], &b = edges[order[1]], &d = edges[order[2]];
        const Vec3 u = a.normalized();
        const Vec3 v = (b - u.dot(b) * u).normalized();
        const Vec3 w = u.cross(v);
        // What the edges lose when they are laid square.
        const double lost = u.dot(b) * u.dot(b) + u.dot(d) * u.dot(d) + v.dot(d) * v.dot(d);
        if (lost < (1.0 - 1e-6) * least && u.allFinite() && v.allFinite()) {
            least = lost;
            Mat3 axes;
            axes << u, v, w;
            best.orientation = Quat(axes).normalized();
            best.halfExtents = 0.5 * Vec3(a.norm(), std::abs(v.dot(b)), std::abs(w.dot(d)));
        }
    } while (std::next_permutation(order.begin(), order.end()));
    best.centre = std::accumulate(c.begin(), c.begin() + 8, Vec3(Vec3::Zero())) / 8.0;
    return best;
}

/// Bricks that have become one box.
struct Joined {
    OrientedBox box;  ///< around its bricks
    Mat3 axes;        ///< of the box
    double volume = 0.0;
    std::size_t bricks = 1;
    std::vector<std::uint32_t> neighbours;  ///< some may have been joined to others since
};

Joined joinedOf(const OrientedBox& box, double volume, std::size_t bricks) {
    return {box, box.orientation.toRotationMatrix(), volume, bricks, {}};
}

/// The box in the axes of the larger one around both.
OrientedBox around(const Joined& a, const Joined& b) {
    const Joined& large = a.volume >= b.volume ? a : b;
    const Joined& small = a.volume >= b.volume ? b : a;
    const Vec3 centre = large.axes.transpose() * (small.box.centre - large.box.centre);
    const Vec3 reach = (large.axes.transpose() * small.axes).cwiseAbs() * small.box.halfExtents;
    const Vec3 low = (centre - reach).cwiseMin(-large.box.halfExtents);
    const Vec3 high = (centre + reach).cwiseMax(large.box.halfExtents);
    OrientedBox box;
    box.centre = large.box.centre + large.axes * (0.5 * (low + high));
    box.orientation = large.box.orientation;
    box.halfExtents = 0.5 * (high - low);
    return box;
}

/// What each group was joined to; a group that still stands alone leads to itself.
class Joins {
public:
    explicit Joins(std::size_t groups) : m_into(groups) { std::iota(m_into.begin(), m_into.end(), 0u); }

    /// The group that two others become, with the next number.
    void join(std::uint32_t i, std::uint32_t j) {
        const auto both = static_cast<std::uint32_t>(m_into.size());
        m_into[i] = m_into[j] = both;
        m_into.push_back(both);
    }

    bool alone(std::uint32_t group) const { return m_into[group] == group; }

    /// What a group has become by now. Half of the way there is left out the next time.
    std::uint32_t nowOf(std::uint32_t group) {
        while (!alone(group)) {
            group = m_into[group] = m_into[m_into[group]];
        }
        return group;
    }

private:
    std::vector<std::uint32_t> m_into;
};

/// The groups beside either of two that are joined, in order.
std::vector<std::uint32_t> neighboursOfBoth(const std::vector<Joined>& groups, Joins& joins, std::uint32_t i, std::uint32_t j) {
    std::vector<std::uint32_t> both;
    for (const std::uint32_t one : {i, j}) {
        for (const std::uint32_t n : groups[one].neighbours) {
            const std::uint32_t now = joins.nowOf(n);
            if (now != i && now != j) {
                both.push_back(now);
            }
        }
    }
    std::ranges::sort(both);
    both.erase(std::unique(both.begin(), both.end()), both.end());
    return both;
}

double longestSide(const OrientedBox& box) {
    return 2.0 * box.halfExtents.maxCoeff();
}

Aabb boundsOf(const Joined& group, double reach) {
    const Vec3 half = group.axes.cwiseAbs() * group.box.halfExtents + Vec3::Constant(reach);
    return {group.box.centre - half, group.box.centre + half};
}

bool touch(const Joined& a, const Joined& b) {
    return boundsOf(a, 0.5 * jointWidth).intersects(boundsOf(b, 0.5 * jointWidth));
}

/// m, how far a group looks for others: to what touches; what is finer than asked looks over gaps, and by its own length where gaps
/// must not be larger than what they part.
double reachOf(const Joined& group, const JoinLimits& limits) {
    const double longest = longestSide(group.box);
    if (longest > limits.finest) {
        return 0.5 * jointWidth;
    }
    const double over = 0.25 * limits.finest;
    return std::max(0.5 * jointWidth, limits.finestSlack < 1.0 ? std::min(over, longest) : over);
}

void findNeighbours(std::vector<Joined>& groups, const JoinLimits& limits) {
    std::vector<Aabb> bounds;
    Aabb all;
    for (const Joined& group : groups) {
        bounds.push_back(boundsOf(group, reachOf(group, limits)));
        all.extend(bounds.back());
    }
    // Along the longest side of all, where the fewest lie beside each other.
    Eigen::Index axis = 0;
    all.sizes().maxCoeff(&axis);
    std::vector<std::uint32_t> order(groups.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::pair(bounds[i].min()[axis], i); });
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = i + 1; j < order.size() && bounds[order[j]].min()[axis] <= bounds[order[i]].max()[axis]; ++j) {
            if (bounds[order[i]].intersects(bounds[order[j]])) {
                groups[order[i]].neighbours.push_back(order[j]);
                groups[order[j]].neighbours.push_back(order[i]);
            }
        }
    }
}

}  // namespace

OrientedBox brickOf(ElementShape solid, std::span<const Vec3> corners) {
    const double volume = volumeOf(solid, corners);
    if (solid == ElementShape::Hexahedron) {
        return ofVolume(brickOfHexahedron(corners), volume);
    }
    OrientedBox box = tightBox(corners, {}, true);
    box.centre = std::accumulate(corners.begin(), corners.end(), Vec3(Vec3::Zero())) / static_cast<double>(corners.size());
    return ofVolume(box, volume);
}

namespace {

std::vector<OrientedBox> joinedOnce(std::span<const OrientedBox> bricks, const JoinLimits& limits) {
    std::vector<Joined> groups;
    for (const OrientedBox& brick : bricks) {
        groups.push_back(joinedOf(brick, brick.volume(), 1));
    }
    findNeighbours(groups, limits);
    Joins joins(groups.size());
    /// Two that could be one: the share that would be empty, then by number.
    using Candidate = std::tuple<double, std::uint32_t, std::uint32_t>;
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> candidates;
    const auto consider = [&](std::uint32_t i, std::uint32_t j) {
        const Joined &a = groups[i], &b = groups[j];
        if (a.bricks + b.bricks > limits.bricksMax) {
            return;
        }
        const OrientedBox box = around(a, b);
        const double empty = 1.0 - (a.volume + b.volume) / box.volume();
        if (longestSide(box) <= limits.finest ? empty <= limits.finestSlack : empty <= limits.slack && touch(a, b)) {
            candidates.emplace(std::round(1e9 * empty) * 1e-9, std::min(i, j), std::max(i, j));
        }
    };
    for (std::uint32_t i = 0; i < groups.size(); ++i) {
        for (const std::uint32_t j : groups[i].neighbours) {
            if (i < j) {
                consider(i, j);
            }
        }
    }
    while (!candidates.empty()) {
        const auto [empty, i, j] = candidates.top();
        candidates.pop();
        if (!joins.alone(i) || !joins.alone(j)) {
            continue;
        }
        const auto number = static_cast<std::uint32_t>(groups.size());
        Joined both =
            joinedOf(around(groups[i], groups[j]), groups[i].volume + groups[j].volume, groups[i].bricks + groups[j].bricks);
        both.neighbours = neighboursOfBoth(groups, joins, i, j);
        joins.join(i, j);
        groups.push_back(std::move(both));
        for (const std::uint32_t n : groups[number].neighbours) {
            consider(n, number);
        }
    }
    std::vector<OrientedBox> boxes;
    for (std::uint32_t i = 0; i < groups.size(); ++i) {
        if (joins.alone(i)) {
            boxes.push_back(ofVolume(groups[i].box, groups[i].volume));
        }
    }
    return boxes;
}

}  // namespace

std::vector<OrientedBox> joinedBricks(std::span<const OrientedBox> bricks, const JoinLimits& limits) {
    std::vector<OrientedBox> boxes = joinedOnce(bricks, limits);
    if (boxes.size() <= limits.boxesMax) {
        return boxes;
    }
    // Too many: boxes of any emptiness, at first as long as the middle one, twice as long each time.
    std::vector<double> lengths;
    for (const OrientedBox& box : boxes) {
        lengths.push_back(longestSide(box));
    }
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::ranges::nth_element(lengths, middle);
    JoinLimits coarser{limits.slack, std::numeric_limits<std::size_t>::max(), std::max(limits.finest, *middle), 1.0,
                       limits.boxesMax};
    // Doubled so often, any length spans any site: what is left then has no finite place.
    constexpr int doublingsMax = 60;
    for (int i = 0; i < doublingsMax && boxes.size() > limits.boxesMax; ++i) {
        boxes = joinedOnce(boxes, coarser);
        coarser.finest *= 2.0;
    }
    return boxes;
}

}  // namespace rubble
