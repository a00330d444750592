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

/// Triangles that are found by rays, in a tree of boxes. May be asked by several threads at once.
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
    /// Children of a node lie behind each other; a leaf has triangles instead.
    struct Node {
        Vec3 low;
        Vec3 high;
        std::uint32_t first = 0;  ///< of the two children, or of the triangles
        std::uint32_t count = 0;  ///< triangles; 0: a node with children
    };
    struct Corners {
        Vec3 a, toB, toC;
        std::uint32_t triangle = 0;
    };
    class Build;

    Aabb m_box;
    std::vector<Node> m_nodes;
    std::vector<Corners> m_triangles;  ///< in the order of the leaves
};

}  // namespace rubble
