#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// How far two boxes are apart, m: their distance; negative where they overlap, by how much they would have to be shifted along one
/// axis to part.
double gapBetween(const Aabb& a, const Aabb& b);

/// A box that is there until an instant.
struct TimedBox {
    Aabb box;                 ///< finite, not empty
    std::uint32_t until = 0;  ///< last state at which it is there
    std::size_t tag = 0;      ///< what it stands for
};

/// Boxes in a binary tree of bounds, to ask which one comes nearest.
class BoxTree {
public:
    explicit BoxTree(std::vector<TimedBox> boxes);

    struct Nearest {
        double gap = std::numeric_limits<double>::infinity();  ///< m
        std::size_t tag = 0;
    };
    /// The box nearest to another one among those that are there after a state, other than the one tagged `except`; or `best` if
    /// none is nearer. Stops at the first that overlaps by more than `enough` [m].
    Nearest nearest(const Aabb& box, std::int64_t after, std::size_t except, double enough, Nearest best) const;

    bool empty() const { return m_boxes.empty(); }

private:
    struct Node {
        Aabb bounds;
        std::uint32_t until = 0;  ///< the latest of its boxes
        std::uint32_t first = 0, count = 0;
        std::uint32_t right = 0;  ///< 0: a leaf; the left child stands behind its parent
    };
    void build(std::uint32_t first, std::uint32_t count);

    std::vector<TimedBox> m_boxes;
    std::vector<Node> m_nodes;
};

}  // namespace rubble
