#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/base/geometry.h"

namespace rubble {

/// Boxes along the axes [m], for finding which of them overlap another one. Nodes hold eight boxes or eight nodes each, neighbours
/// along a space-filling curve; when boxes move the nodes follow, and once all have moved often the tree is laid out anew.
/// Bounds are kept in single precision, rounded outwards: more is found than overlaps, never less. What is found does not
/// depend on the history of the tree, except what is found in excess and the order.
class BoxIndex {
public:
    /// Puts in the box of a key or moves it. Counts from the next refit on.
    /// @param key  small: there is a place for every key below the largest
    void set(std::uint32_t key, const Aabb& box);
    /// Takes out the box of a key, if there is one. Counts from the next refit on.
    void remove(std::uint32_t key);
    /// Brings the nodes up to date.
    void refit();

    /// Calls visit(key) for every box that overlaps `box`, and perhaps for some that barely miss it. Any number of threads.
    template <class Visit>
    void find(const Aabb& box, Visit&& visit) const {
        if (!m_levels.empty()) {
            find(bounds(box), m_levels.size() - 1, 0, visit);
        }
    }

private:
    static constexpr std::uint32_t width = 8;
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    static constexpr float nowhere = std::numeric_limits<float>::infinity();
    /// Every processor compares four at once.
    using Four = float __attribute__((vector_size(16), may_alias));
    using FourMarks = std::int32_t __attribute__((vector_size(16)));

    struct Bounds {
        std::array<float, 3> low{nowhere, nowhere, nowhere};
        std::array<float, 3> high{-nowhere, -nowhere, -nowhere};
    };
    struct alignas(32) Node {
        float low[3][width], high[3][width];
    };
    struct Level {
        std::vector<Node> nodes;
        std::vector<char> changed;  ///< [nodes]
    };

    static Bounds bounds(const Aabb& box);
    /// One bit for each of the node's eight that overlaps.
    static unsigned overlapping(const Node& node, const Bounds& box) {
        FourMarks marks{};
        for (std::size_t half = 0; half < width; half += 4) {
            FourMarks own = half == 0 ? FourMarks{1, 2, 4, 8} : FourMarks{16, 32, 64, 128};
            for (std::size_t k = 0; k < 3; ++k) {
                const Four low = *reinterpret_cast<const Four*>(node.low[k] + half);
                const Four high = *reinterpret_cast<const Four*>(node.high[k] + half);
                own &= (low <= box.high[k]) & (high >= box.low[k]);
            }
            marks |= own;
        }
        const auto halves = std::bit_cast<std::array<std::uint64_t, 2>>(marks);
        const std::uint64_t all = halves[0] | halves[1];
        return static_cast<unsigned>((all | all >> 32) & 0xff);
    }
    template <class Visit>
    void find(const Bounds& box, std::size_t level, std::size_t node, Visit& visit) const {
        for (unsigned found = overlapping(m_levels[level].nodes[node], box); found != 0; found &= found - 1) {
            const std::size_t child = width * node + static_cast<std::size_t>(std::countr_zero(found));
            if (level > 0) {
                find(box, level - 1, child, visit);
            } else {
                visit(m_keys[child]);
            }
        }
    }
    void put(std::size_t level, std::size_t place, const Bounds& box);
    Bounds around(const Node& node) const;
    void grow();
    void layOut();

    std::vector<Level> m_levels;          ///< from the boxes up to a single node
    std::vector<std::uint32_t> m_keys;    ///< of each place, or none
    std::vector<std::uint32_t> m_places;  ///< of each key, or none
    std::uint64_t m_changes = 0;          ///< since the tree was laid out
};

}  // namespace rubble
