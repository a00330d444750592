#include "core/evidence/clouds/point_index.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nanoflann.hpp>
#include <numeric>
#include <utility>

#include "core/base/memory.h"
#include "core/base/unknown.h"

namespace rubble {

namespace {

/// Points to a leaf of the tree.
constexpr std::size_t leafPoints = 16;
/// Share by which a ball is searched larger than asked for, so that rounding loses no point on its rim.
constexpr double roundingShare = 1e-9;

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

/// Number of a cube along a curve that leads through all of them.
std::uint64_t cubeNumber(const Vec3& place, double cube) {
    constexpr double middle = 1 << 20;
    const Vec3 own = cubeOf(place, cube);
    const auto along = [&](int axis) {
        return spreadBits(static_cast<std::uint64_t>(std::clamp(own[axis] + middle, 0.0, 2.0 * middle - 1.0)));
    };
    return along(0) | along(1) << 1 | along(2) << 2;
}

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

/// Whether a cell may hold points of a ball.
class BallCull {
public:
    BallCull(const Vec3& centre, double radius) : m_centre(centre), m_squared(radius * radius * (1.0 + roundingShare) + 1e-12) {}

    bool operator()(const Vec3& middle, const Vec3& half) const {
        const Vec3 beyond = ((middle - m_centre).cwiseAbs() - half).cwiseMax(0.0);
        return beyond.squaredNorm() <= m_squared;
    }

private:
    Vec3 m_centre;
    double m_squared;
};

/// Whether a cell may hold points of a cylinder.
class CylinderCull {
public:
    CylinderCull(const Vec3& centre, const Vec3& axis, double radius, double halfLength)
        : m_centre(centre), m_axis(axis), m_steep(axis.cwiseAbs()), m_radius(radius), m_halfLength(halfLength) {}

    bool operator()(const Vec3& middle, const Vec3& half) const {
        const Vec3 from = middle - m_centre;
        const double along = m_axis.dot(from);
        const double beside = m_radius + half.norm();
        constexpr double wider = 1.0 + roundingShare;
        return std::abs(along) <= (m_halfLength + m_steep.dot(half)) * wider + 1e-12 &&
               from.squaredNorm() - along * along <= (beside * beside + from.squaredNorm() * roundingShare) * wider + 1e-12;
    }

private:
    Vec3 m_centre;
    Vec3 m_axis;
    Vec3 m_steep;  ///< by how much of each side a cell reaches along the axis
    double m_radius;
    double m_halfLength;
};

/// Sums of products of whole numbers of 30 bits, each in two halves, so that 2^31 of them fit.
class ProductSums {
public:
    void add(const std::array<std::int64_t, 3>& steps) {
        std::size_t k = 0;
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = row; column < 3; ++column, ++k) {
                const std::int64_t product = steps[row] * steps[column];
                m_low[k] += product & 0xFFFF'FFFF;
                m_high[k] += product >> 32;
            }
        }
    }
    Mat3 total() const {
        const auto sum = [&](std::size_t k) {
            return std::ldexp(static_cast<double>(m_high[k]), 32) + static_cast<double>(m_low[k]);
        };
        Mat3 made;
        made << sum(0), sum(1), sum(2), sum(1), sum(3), sum(4), sum(2), sum(4), sum(5);
        return made;
    }

private:
    std::array<std::int64_t, 6> m_low{};
    std::array<std::int64_t, 6> m_high{};
};

}  // namespace

struct PointIndex::Tree {
    /// What the library asks of a list of points.
    struct PointList {
        std::vector<Vec3> places;

        std::size_t kdtree_get_point_count() const { return places.size(); }
        double kdtree_get_pt(std::size_t i, std::size_t axis) const { return places[i][static_cast<Eigen::Index>(axis)]; }
        template <class Box>
        bool kdtree_get_bbox(Box& /*box*/) const {
            return false;
        }
    };

    using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointList, double, std::uint32_t>,
                                                      PointList, 3, std::uint32_t>;
    explicit Tree(std::vector<Vec3> places)
        : list{std::move(places)}, index(3, list, nanoflann::KDTreeSingleIndexAdaptorParams(leafPoints)) {
        // What lies in one leaf is read at once.
        std::vector<Vec3> ordered;
        reserveLarge(ordered, list.places.size());
        std::transform(index.vAcc.begin(), index.vAcc.end(), std::back_inserter(ordered),
                       [&](std::uint32_t i) { return list.places[i]; });
        list.places = std::move(ordered);
        std::iota(index.vAcc.begin(), index.vAcc.end(), 0U);
    }

    /// Hands over the points of all leaves whose cells a test does not cull.
    /// @param meets  (middle, half the sides) of a cell; @param visit  (number of a point, its place)
    template <class Meets, class Visit>
    void visitCells(const Meets& meets, const Visit& visit) const {
        if (index.root_node != nullptr) {
            Vec3 low, high;
            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                low[axis] = index.root_bbox[static_cast<std::size_t>(axis)].low;
                high[axis] = index.root_bbox[static_cast<std::size_t>(axis)].high;
            }
            visitCell(*index.root_node, low, high, meets, visit);
        }
    }

    PointList list;
    Index index;

private:
    template <class Node, class Meets, class Visit>
    void visitCell(const Node& node, Vec3& low, Vec3& high, const Meets& meets, const Visit& visit) const {
        if (!meets(Vec3(0.5 * (low + high)), Vec3(0.5 * (high - low)))) {
            return;
        }
        if (node.child1 == nullptr) {
            for (std::size_t k = node.node_type.lr.left; k < node.node_type.lr.right; ++k) {
                visit(static_cast<std::uint32_t>(k), list.places[k]);
            }
            return;
        }
        const auto axis = static_cast<Eigen::Index>(node.node_type.sub.divfeat);
        const double before = std::exchange(high[axis], node.node_type.sub.divlow);
        visitCell(*node.child1, low, high, meets, visit);
        high[axis] = before;
        const double under = std::exchange(low[axis], node.node_type.sub.divhigh);
        visitCell(*node.child2, low, high, meets, visit);
        low[axis] = under;
    }
};

std::vector<std::uint32_t> orderByCubes(std::vector<Vec3>& places, double cube) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> numbers;
    reserveLarge(numbers, places.size());
    for (std::uint32_t i = 0; i < places.size(); ++i) {
        numbers.emplace_back(cubeNumber(places[i], cube), i);
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

PointIndex::PointIndex(std::vector<Vec3> places) : m_tree(std::make_unique<Tree>(std::move(places))) {}

PointIndex::~PointIndex() = default;
PointIndex::PointIndex(PointIndex&&) noexcept = default;

const std::vector<Vec3>& PointIndex::places() const {
    return m_tree->list.places;
}

void PointIndex::within(const Vec3& centre, double radius, std::vector<std::uint32_t>& found) const {
    found.clear();
    m_tree->visitCells(BallCull(centre, radius), [&](std::uint32_t i, const Vec3& place) {
        if ((place - centre).squaredNorm() <= radius * radius) {
            found.push_back(i);
        }
    });
}

BallMoments PointIndex::moments(const Vec3& centre, double radius) const {
    constexpr int bits = 30;
    const double scale = std::ldexp(1.0, bits - 1 - std::ilogb(radius));
    std::int64_t count = 0;
    std::array<std::int64_t, 3> sums{};
    ProductSums products;
    m_tree->visitCells(BallCull(centre, radius), [&](std::uint32_t /*i*/, const Vec3& place) {
        const Vec3 from = place - centre;
        if (from.squaredNorm() > radius * radius) {
            return;
        }
        const std::array<std::int64_t, 3> steps{static_cast<std::int64_t>(from.x() * scale),
                                                static_cast<std::int64_t>(from.y() * scale),
                                                static_cast<std::int64_t>(from.z() * scale)};
        ++count;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            sums[axis] += steps[axis];
        }
        products.add(steps);
    });
    BallMoments made;
    made.points = static_cast<std::uint32_t>(count);
    if (count == 0) {
        return made;
    }
    const Vec3 sum(static_cast<double>(sums[0]), static_cast<double>(sums[1]), static_cast<double>(sums[2]));
    made.mean = sum / static_cast<double>(count);
    made.spread = products.total() - made.mean * sum.transpose();
    made.mean /= scale;
    made.spread /= scale * scale;
    return made;
}

void PointIndex::withinCylinder(const Vec3& centre, const Vec3& axis, double radius, double halfLength,
                                std::vector<double>& offsets) const {
    offsets.clear();
    const CylinderCull cull(centre, axis, radius, halfLength);
    m_tree->visitCells(cull, [&](std::uint32_t /*i*/, const Vec3& place) {
        const Vec3 from = place - centre;
        const double along = axis.dot(from);
        if (std::abs(along) <= halfLength && from.squaredNorm() - along * along <= radius * radius) {
            offsets.push_back(along);
        }
    });
}

}  // namespace rubble
