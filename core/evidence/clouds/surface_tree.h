#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// Where a ray meets a surface.
struct RayHit {
    double range = 0.0;          ///< m, from the start of the ray
    std::uint32_t triangle = 0;  ///< by its number in the list that the tree was made of
};

/// Triangles that are found by rays, in a tree of boxes, four to a node. Boxes are kept in single precision about the middle of
/// all, and met a little too often rather than missed; triangles are met in double precision. May be asked by several threads.
class SurfaceTree {
public:
    /// @param triangles  of points; those with a corner that is no number, or without an area, are never met
    SurfaceTree(const std::vector<Vec3>& points, const std::vector<std::array<std::uint32_t, 3>>& triangles);

    /// The nearest triangle that a ray meets, from either side; nothing where it meets none within its length.
    /// @param direction  of length 1; @param length  m
    std::optional<RayHit> firstHit(const Vec3& from, const Vec3& direction, double length) const;
    /// Around all triangles that can be met, m; empty: there are none.
    const Aabb& box() const { return m_box; }

private:
    static constexpr std::uint32_t width = 4;
    /// Boxes about the middle of the tree [m], rounded outwards; those that are not there are never met.
    struct alignas(64) Node {
        float low[3][width], high[3][width];
        std::uint32_t first[width];  ///< node, or triangle
        std::uint32_t count[width];  ///< triangles; 0: a node
    };
    struct Corners {
        Vec3 a, toB, toC;
        std::uint32_t triangle = 0;
    };
    class Build;
    class Ray;

    void meet(std::uint32_t first, std::uint32_t count, const Vec3& from, const Vec3& direction, double& length,
              std::optional<RayHit>& nearest) const;

    Aabb m_box;
    Vec3 m_middle = Vec3::Zero();
    std::vector<Node> m_nodes;
    std::vector<Corners> m_triangles;  ///< in the order of the leaves
};

}  // namespace rubble
