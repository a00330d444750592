#include "core/evidence/clouds/point_index.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <nanoflann.hpp>
#include <numeric>
#include <span>
#include <utility>

#include "core/base/memory.h"
#include "core/base/unknown.h"
#include "core/evidence/clouds/rounded_box.h"

namespace rubble {

namespace {

/// Points to a run, the leaf of the tree.
constexpr std::size_t runPoints = 48;
/// Bits of a cube's number that a run may differ in: it stays within cubes of twice the side.
constexpr unsigned runBits = 3;

/// Every third bit of a number that holds the 21 lowest of another.
std::uint64_t spreadBits(std::uint64_t bits) {
    bits &= 0x1F'FFFF;
    bits = (bits | bits << 32) & 0x1F'0000'0000'FFFF;
    bits = (bits | bits << 16) & 0x1F'0000'FF00'00FF;
    bits = (bits | bits << 8) & 0x100F'00F0'0F00'F00F;
    bits = (bits | bits << 4) & 0x10C3'0C30'C30C'30C3;
    return (bits | bits << 2) & 0x1249'2492'4924'9249;
}

/// Which cube a place lies in, counted along each axis.
Vec3 cubeOf(const Vec3& place, double cube) {
    return (place / cube).array().floor();
}

/// Numbers cubes along a curve that leads through all of them, from the lowest of some places on. Strays beyond 2^20 cubes from the
/// origin count as there, so that they take no numbers from the others.
class CubeCurve {
public:
    CubeCurve(const std::vector<Vec3>& places, double cube) : m_cube(cube), m_lowest(Vec3::Zero()) {
        if (!places.empty()) {
            const auto lower = [](const Vec3& low, const Vec3& place) { return Vec3(low.cwiseMin(place)); };
            m_lowest = cubeOf(std::accumulate(places.begin() + 1, places.end(), places.front(), lower), cube).cwiseMax(-farthest);
        }
    }

    std::uint64_t numberOf(const Vec3& place) const {
        constexpr double most = 2.0 * farthest - 1.0;
        const Vec3 own = cubeOf(place, m_cube) - m_lowest;
        const auto along = [&](int axis) { return spreadBits(static_cast<std::uint64_t>(std::clamp(own[axis], 0.0, most))); };
        return along(0) | along(1) << 1 | along(2) << 2;
    }

private:
    static constexpr double farthest = 1 << 20;  // cubes

    double m_cube;
    Vec3 m_lowest;
};

/// Sorts by whole numbers byte by byte, those alone that differ; equal ones keep their order.
/// @param keyOf  (item) an unsigned number; @param spare  room that is used again
template <class Item, class Key>
void sortByBytes(std::vector<Item>& items, std::vector<Item>& spare, const Key& keyOf) {
    auto differing = keyOf(items.front());
    differing = 0;
    for (const Item& item : items) {
        differing |= keyOf(item) ^ keyOf(items.front());
    }
    reserveLarge(spare, items.size());
    spare.resize(items.size());
    for (unsigned shift = 0; shift < 8 * sizeof(differing); shift += 8) {
        if ((differing >> shift & 0xFF) == 0) {
            continue;
        }
        std::array<std::size_t, 257> starts{};
        for (const Item& item : items) {
            ++starts[(keyOf(item) >> shift & 0xFF) + 1];
        }
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
        for (const Item& item : items) {
            spare[starts[keyOf(item) >> shift & 0xFF]++] = item;
        }
        items.swap(spare);
    }
}

/// A length by which boxes are searched a little beyond what was asked for, so that rounding loses no point on a rim.
double widened(double length) {
    return length * (1.0 + 1e-6) + 1e-9;
}

/// Whether most places lie within some cubes of the one before.
bool followEachOther(const std::vector<Vec3>& places, double cube) {
    constexpr double near = 3.0;        // cubes
    constexpr std::size_t jumpsOf = 8;  // one of so many may lie farther
    std::size_t jumps = 0;
    for (std::size_t i = 1; i < places.size(); ++i) {
        jumps += (places[i] - places[i - 1]).cwiseAbs().maxCoeff() > near * cube ? 1 : 0;
    }
    return jumpsOf * jumps <= places.size();
}

/// Puts places that follow each other into the order of their cubes, some hundred at a time, which stay in the fast memory.
void orderNearby(std::vector<Vec3>& places, const CubeCurve& curve) {
    constexpr std::size_t window = 256;
    std::vector<std::pair<std::uint64_t, Vec3>> some;
    for (std::size_t from = 0; from < places.size(); from += window) {
        const auto begin = places.begin() + static_cast<std::ptrdiff_t>(from);
        const auto end = begin + static_cast<std::ptrdiff_t>(std::min(window, places.size() - from));
        some.clear();
        std::transform(begin, end, std::back_inserter(some),
                       [&](const Vec3& place) { return std::pair(curve.numberOf(place), place); });
        const auto lower = [](const auto& a, const auto& b) { return a.first < b.first; };
        if (!std::is_sorted(some.begin(), some.end(), lower)) {
            std::stable_sort(some.begin(), some.end(), lower);
            std::transform(some.begin(), some.end(), begin, [](const auto& each) { return each.second; });
        }
    }
}

/// Whether a box may hold points of a ball.
class BallCull {
public:
    BallCull(const Vec3& centre, double radius) : m_centre(centre), m_squared(radius * radius) {
        m_around.set(centre - Vec3::Constant(radius), centre + Vec3::Constant(radius));
    }

    bool operator()(const RoundedBox& box) const {
        if (!m_around.meets(box)) {
            return false;
        }
        const Vec3 beyond = (box.lowest() - m_centre).cwiseMax(m_centre - box.highest()).cwiseMax(0.0);
        return beyond.squaredNorm() <= m_squared;
    }

private:
    RoundedBox m_around;
    Vec3 m_centre;
    double m_squared;
};

/// Whether a box may hold points of a cylinder: by the box around it, by planes across its axis, and by one between the axis and
/// the middle of the box.
class CylinderCull {
public:
    CylinderCull(const Vec3& centre, const Vec3& axis, double radius, double halfLength)
        : m_centre(centre), m_axis(axis), m_steep(axis.cwiseAbs()), m_squared(radius * radius), m_halfLength(halfLength) {
        const Vec3 half = halfLength * m_steep + radius * (1.0 - axis.array().square()).max(0.0).sqrt().matrix();
        m_around.set(centre - half, centre + half);
    }

    bool operator()(const RoundedBox& box) const {
        if (!m_around.meets(box)) {
            return false;
        }
        const Vec3 low = box.lowest(), high = box.highest();
        const Vec3 half = 0.5 * (high - low);
        const Vec3 from = 0.5 * (low + high) - m_centre;
        const double along = m_axis.dot(from);
        if (std::abs(along) > m_halfLength + m_steep.dot(half)) {
            return false;
        }
        // Along the shortest way from the axis to the middle the box reaches its half sides times the parts of that way.
        const Vec3 beside = from - along * m_axis;
        const double length = beside.squaredNorm();
        const double rest = length - beside.cwiseAbs().dot(half);
        return rest <= 0.0 || rest * rest <= m_squared * length;
    }

private:
    RoundedBox m_around;
    Vec3 m_centre;
    Vec3 m_axis;
    Vec3 m_steep;  ///< by how much of each side a box reaches along the axis
    double m_squared;
    double m_halfLength;
};

/// Sums of places in whole numbers of 31 bits with their sign, and of their products, each in two halves, so that 2^31 of them fit.
class StepSums {
public:
    /// Products of so many places fill no more than 63 bits.
    static constexpr std::size_t together = 7;

    /// @param places  in steps, at most `together`
    void add(std::span<const Vec3> places) {
        std::array<std::int64_t, 6> products{};
        for (const Vec3& place : places) {
            const auto x = static_cast<std::int64_t>(place.x());
            const auto y = static_cast<std::int64_t>(place.y());
            const auto z = static_cast<std::int64_t>(place.z());
            m_sums[0] += x;
            m_sums[1] += y;
            m_sums[2] += z;
            products[0] += x * x;
            products[1] += x * y;
            products[2] += x * z;
            products[3] += y * y;
            products[4] += y * z;
            products[5] += z * z;
        }
        for (std::size_t k = 0; k < products.size(); ++k) {
            m_low[k] += products[k] & 0xFFFF'FFFF;
            m_high[k] += products[k] >> 32;
        }
    }
    Vec3 sum() const { return {static_cast<double>(m_sums[0]), static_cast<double>(m_sums[1]), static_cast<double>(m_sums[2])}; }
    Mat3 products() const {
        const auto sum = [&](std::size_t k) {
            return std::ldexp(static_cast<double>(m_high[k]), 32) + static_cast<double>(m_low[k]);
        };
        Mat3 made;
        made << sum(0), sum(1), sum(2), sum(1), sum(3), sum(4), sum(2), sum(4), sum(5);
        return made;
    }

private:
    std::array<std::int64_t, 3> m_sums{};
    std::array<std::int64_t, 6> m_low{};
    std::array<std::int64_t, 6> m_high{};
};

}  // namespace

/// A tree of boxes over runs of points that lie beside each other. How it branches is the library's; boxes fit what they hold.
struct PointIndex::Tree {
    /// In the order in which they are met: below a node come its children, and then what `next` names.
    struct Node {
        RoundedBox box;       ///< m, about `middle`
        std::uint32_t next;   ///< node after all below this one
        std::uint32_t first;  ///< point
        std::uint32_t count;  ///< points; 0: it has children
    };

    /// The coordinates of a run, axis by axis.
    struct RunView {
        std::array<const double*, 3> axes;
        std::size_t count = 0;
        std::uint32_t first = 0;  ///< number of the first of them

        Vec3 at(std::size_t i) const { return {axes[0][i], axes[1][i], axes[2][i]}; }
    };

    Tree(std::vector<Vec3> unordered, double cube) : places(std::move(unordered)) {
        if (places.empty()) {
            return;
        }
        const CubeCurve curve(places, cube);
        if (followEachOther(places, cube)) {
            orderNearby(places, curve);
        } else {
            orderByCubes(places, cube);
        }
        // Single precision is fine where most are, wherever a stray lies.
        middle = places[places.size() / 2];
        Runs runs;
        std::uint64_t within = 0;
        for (std::uint32_t i = 0; i < places.size(); ++i) {
            const std::uint64_t number = curve.numberOf(places[i]) >> runBits;
            if (i == 0 || number != within || i - runs.firsts.back() == runPoints) {
                runs.firsts.push_back(i);
                within = number;
            }
        }
        runs.firsts.push_back(static_cast<std::uint32_t>(places.size()));
        for (std::size_t k = 0; k + 1 < runs.firsts.size(); ++k) {
            const std::span<Vec3> run = std::span(places).subspan(runs.firsts[k], runs.firsts[k + 1] - runs.firsts[k]);
            runs.boxes.push_back(boxOf(run));
            turn(run);
        }
        const Index index(3, runs, nanoflann::KDTreeSingleIndexAdaptorParams(1));
        reserveLarge(nodes, 2 * runs.boxes.size());
        addNode(*index.root_node, index, runs);
    }

    /// Hands over the runs whose boxes a test does not cull.
    /// @param meets  (RoundedBox about `middle`); @param visit  (RunView)
    template <class Meets, class Visit>
    void visitRuns(const Meets& meets, const Visit& visit) const {
        const std::size_t end = nodes.size();
        for (std::size_t n = 0; n < end;) {
            const Node& node = nodes[n];
            if (!meets(node.box)) {
                n = node.next;
                continue;
            }
            if (node.count > 0) {
                const double* first = places[node.first].data();
                visit(RunView{{first, first + node.count, first + 2 * std::size_t{node.count}}, node.count, node.first});
            }
            ++n;
        }
    }

    /// Three numbers a point, m: of each run first all x, then all y, then all z, where its points were before.
    std::vector<Vec3> places;
    Vec3 middle = Vec3::Zero();  ///< a point in the midst of the others
    std::vector<Node> nodes;

private:
    /// What the library asks of a list of points: here the middles of the runs.
    struct Runs {
        std::vector<Aabb> boxes;
        std::vector<std::uint32_t> firsts;  ///< [runs + 1] points

        std::size_t kdtree_get_point_count() const { return boxes.size(); }
        double kdtree_get_pt(std::size_t i, std::size_t axis) const { return boxes[i].center()[static_cast<Eigen::Index>(axis)]; }
        template <class Box>
        bool kdtree_get_bbox(Box& /*box*/) const {
            return false;
        }
    };

    using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Runs, double, std::uint32_t>, Runs, 3,
                                                      std::uint32_t>;

    static void turn(std::span<Vec3> run) {
        std::array<Vec3, runPoints> before;
        std::copy(run.begin(), run.end(), before.begin());
        double* to = run.front().data();
        for (int axis = 0; axis < 3; ++axis) {
            for (std::size_t i = 0; i < run.size(); ++i) {
                *to++ = before[i][axis];
            }
        }
    }

    static Aabb boxOf(std::span<const Vec3> places) {
        Aabb box;
        for (const Vec3& place : places) {
            box.extend(place);
        }
        return box;
    }

    /// Adds a node of the library's tree and all below it. @return what it holds
    Aabb addNode(const Index::Node& from, const Index& index, const Runs& runs) {
        const std::size_t own = nodes.size();
        nodes.emplace_back();
        Aabb box;
        if (from.child1 == nullptr) {
            assert(from.node_type.lr.right == from.node_type.lr.left + 1);
            const std::uint32_t run = index.vAcc[from.node_type.lr.left];
            nodes[own].first = runs.firsts[run];
            nodes[own].count = runs.firsts[run + 1] - runs.firsts[run];
            box = runs.boxes[run];
        } else {
            box = addNode(*from.child1, index, runs);
            box.extend(addNode(*from.child2, index, runs));
            nodes[own].first = nodes[own].count = 0;
        }
        nodes[own].next = static_cast<std::uint32_t>(nodes.size());
        nodes[own].box.set(box.min() - middle, box.max() - middle);
        return box;
    }
};

std::vector<std::uint32_t> orderByCubes(std::vector<Vec3>& places, double cube) {
    const CubeCurve curve(places, cube);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> numbers;
    reserveLarge(numbers, places.size());
    for (std::uint32_t i = 0; i < places.size(); ++i) {
        numbers.emplace_back(curve.numberOf(places[i]), i);
    }
    if (!numbers.empty()) {
        std::vector<std::pair<std::uint64_t, std::uint32_t>> spare;
        sortByBytes(numbers, spare, [](const std::pair<std::uint64_t, std::uint32_t>& each) { return each.first; });
    }
    std::vector<std::uint32_t> before;
    std::vector<Vec3> ordered;
    reserveLarge(before, places.size());
    reserveLarge(ordered, places.size());
    for (const auto& [number, i] : numbers) {
        before.push_back(i);
        ordered.push_back(places[i]);
    }
    places = std::move(ordered);
    return before;
}

std::vector<Vec3> firstOfCubes(const std::vector<Vec3>& places, double cube) {
    std::vector<Vec3> firsts;
    Vec3 last = Vec3::Constant(unknown);
    for (const Vec3& place : places) {
        const Vec3 own = cubeOf(place, cube);
        if (own != last) {
            firsts.push_back(place);
            last = own;
        }
    }
    return firsts;
}

std::size_t CubeThinning::Hash::operator()(const std::array<std::int64_t, 3>& cube) const {
    std::uint64_t hash = 0;
    for (const std::int64_t k : cube) {
        hash = (hash ^ static_cast<std::uint64_t>(k)) * 0x9E3779B97F4A7C15ULL;
        hash ^= hash >> 29;
    }
    return hash;
}

bool CubeThinning::takes(const Vec3& place) {
    const Vec3 cube = cubeOf(place, m_cube);
    return m_taken.insert({std::llround(cube.x()), std::llround(cube.y()), std::llround(cube.z())}).second;
}

PointIndex::PointIndex(std::vector<Vec3> places, double cube) : m_tree(std::make_unique<Tree>(std::move(places), cube)) {}

PointIndex::~PointIndex() = default;
PointIndex::PointIndex(PointIndex&&) noexcept = default;

std::vector<Vec3> PointIndex::places() const {
    std::vector<Vec3> made;
    reserveLarge(made, m_tree->places.size());
    m_tree->visitRuns([](const RoundedBox& /*box*/) { return true; },
                      [&](const Tree::RunView& run) {
                          for (std::size_t i = 0; i < run.count; ++i) {
                              made.push_back(run.at(i));
                          }
                      });
    return made;
}

void PointIndex::within(const Vec3& centre, double radius, std::vector<Vec3>& found) const {
    found.clear();
    m_tree->visitRuns(BallCull(centre - m_tree->middle, widened(radius)), [&](const Tree::RunView& run) {
        for (std::size_t i = 0; i < run.count; ++i) {
            if ((run.at(i) - centre).squaredNorm() <= radius * radius) {
                found.push_back(run.at(i));
            }
        }
    });
}

BallMoments PointIndex::moments(const Vec3& centre, double radius) const {
    constexpr int bits = 30;
    const double scale = std::ldexp(1.0, bits - 1 - std::ilogb(radius));
    std::size_t points = 0;
    StepSums sums;
    std::array<double, runPoints> squares;
    std::array<Vec3, runPoints> inside;
    m_tree->visitRuns(BallCull(centre - m_tree->middle, widened(radius)), [&](const Tree::RunView& run) {
        for (std::size_t i = 0; i < run.count; ++i) {
            const double x = run.axes[0][i] - centre.x(), y = run.axes[1][i] - centre.y(), z = run.axes[2][i] - centre.z();
            squares[i] = x * x + (y * y + z * z);
        }
        // Each is written, and stays only if it is inside: what a processor cannot foresee costs more than the work.
        std::size_t length = 0;
        for (std::size_t i = 0; i < run.count; ++i) {
            inside[length] = (run.at(i) - centre) * scale;
            length += squares[i] <= radius * radius ? 1 : 0;
        }
        for (std::size_t i = 0; i < length; i += StepSums::together) {
            sums.add({inside.data() + i, std::min(StepSums::together, length - i)});
        }
        points += length;
    });
    BallMoments made;
    made.points = static_cast<std::uint32_t>(points);
    if (points == 0) {
        return made;
    }
    made.mean = sums.sum() / static_cast<double>(points);
    made.spread = sums.products() - made.mean * sums.sum().transpose();
    made.mean /= scale;
    made.spread /= scale * scale;
    return made;
}

void PointIndex::withinCylinder(const Vec3& centre, const Vec3& axis, double radius, double halfLength,
                                std::vector<double>& offsets, std::vector<std::uint32_t>* numbers) const {
    offsets.clear();
    std::array<double, runPoints> heights, squares;
    const CylinderCull cull(centre - m_tree->middle, axis, widened(radius), widened(halfLength));
    std::size_t length = 0;
    const auto isIn = [&](std::size_t i) {
        const bool along = std::abs(heights[i]) <= halfLength;
        const bool beside = squares[i] <= radius * radius;
        return along && beside;
    };
    m_tree->visitRuns(cull, [&](const Tree::RunView& run) {
        if (offsets.size() < length + run.count) {
            offsets.resize(2 * length + run.count);
        }
        for (std::size_t i = 0; i < run.count; ++i) {
            const double x = run.axes[0][i] - centre.x(), y = run.axes[1][i] - centre.y(), z = run.axes[2][i] - centre.z();
            heights[i] = axis.x() * x + (axis.y() * y + axis.z() * z);
            squares[i] = x * x + (y * y + z * z) - heights[i] * heights[i];
        }
        if (numbers != nullptr) {
            numbers->resize(offsets.size());
            std::size_t last = length;
            for (std::size_t i = 0; i < run.count; ++i) {
                (*numbers)[last] = run.first + static_cast<std::uint32_t>(i);
                last += isIn(i) ? 1 : 0;
            }
        }
        for (std::size_t i = 0; i < run.count; ++i) {
            offsets[length] = heights[i];
            length += isIn(i) ? 1 : 0;
        }
    });
    offsets.resize(length);
    if (numbers != nullptr) {
        numbers->resize(length);
    }
}

}  // namespace rubble
