#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Points (i, key of i) that can be removed one by one and counted in a quadrant: a Fenwick tree over i whose nodes hold their
/// points sorted by key, with a Fenwick tree of the living among them. O(n log n) to build and to hold, O(log^2 n) a call.
class DominanceCount {
public:
    /// All points alive. @param keys  distinct [points]
    void build(std::span<const std::uint32_t> keys);
    void remove(std::size_t i);
    /// Living points with index >= i and key < bound.
    std::uint32_t count(std::size_t i, std::uint32_t bound) const;
    bool empty() const { return m_keys.empty(); }

private:
    struct Node {
        std::size_t begin = 0;
        std::size_t end = 0;
    };
    std::uint32_t countBelow(const Node& node, std::uint32_t bound) const;

    std::vector<std::uint32_t> m_keys;
    std::vector<Node> m_nodes;            ///< into m_sorted and m_living
    std::vector<std::uint32_t> m_sorted;  ///< keys of each node, ascending
    std::vector<std::uint32_t> m_living;  ///< Fenwick tree of each node
};

}  // namespace rubble
