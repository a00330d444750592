#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_set>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// Puts places beside each other that lie beside each other, cube by cube, so that finding them takes fewer ways through memory.
/// Within a cube they keep their order. @return for each place where it stood before
std::vector<std::uint32_t> orderByCubes(std::vector<Vec3>& places, double cube);

/// Of places in the order of orderByCubes() the first in each cube.
std::vector<Vec3> firstOfCubes(const std::vector<Vec3>& places, double cube);

/// Takes one point of each cube, the first of them, in whatever order they come.
class CubeThinning {
public:
    /// @param cube  side, above zero
    explicit CubeThinning(double cube) : m_cube(cube) {}
    /// @return true: it is the first in its cube
    bool takes(const Vec3& place);

private:
    struct Hash {
        std::size_t operator()(const std::array<std::int64_t, 3>& cube) const;
    };

    double m_cube;
    std::unordered_set<std::array<std::int64_t, 3>, Hash> m_taken;
};

/// Where the points of a ball lie, and how they spread.
struct BallMoments {
    std::uint32_t points = 0;
    Vec3 mean = Vec3::Zero();    ///< from the middle of the ball
    Mat3 spread = Mat3::Zero();  ///< sum of the products of what they are off the mean
};

/// Points that are found by their place. May be asked by several threads at once.
class PointIndex {
public:
    /// @param places  at most 2^32 - 1, about an origin near them; @param cube  side of the cubes by which points are put beside
    /// each other, m: about the smallest radius that is searched; quickest if orderByCubes() did that before
    PointIndex(std::vector<Vec3> places, double cube);
    ~PointIndex();
    PointIndex(PointIndex&&) noexcept;

    /// All of them, neighbours beside each other.
    std::vector<Vec3> places() const;
    /// The places within a radius of a place, its rim included; in the same order each time.
    void within(const Vec3& centre, double radius, std::vector<Vec3>& found) const;
    /// Of the points within a radius of a place, its rim included. Places count in steps of 2^-29 of the radius or finer, so that
    /// sums are those of whole numbers and no order of the points matters.
    BallMoments moments(const Vec3& centre, double radius) const;
    /// How far along a line from a place the points within a cylinder about it lie, its ends and mantle included. Their order
    /// depends on which other points there are.
    /// @param axis     of length 1; @param halfLength  to each side
    /// @param numbers  of these points in the list that the index was made of, which orderByCubes() put in order; null: not asked
    /// for
    void withinCylinder(const Vec3& centre, const Vec3& axis, double radius, double halfLength, std::vector<double>& offsets,
                        std::vector<std::uint32_t>* numbers = nullptr) const;

private:
    struct Tree;
    std::unique_ptr<Tree> m_tree;
};

}  // namespace rubble
