#include "core/clusters/dominance_count.h"

#include <algorithm>

#include "core/clusters/lowest_bit.h"

namespace rubble {

void DominanceCount::build(std::span<const std::uint32_t> keys) {
    m_keys.assign(keys.begin(), keys.end());
    m_nodes.assign(m_keys.size() + 1, {});
    m_sorted.clear();
    // Node k counts from the end, so that a prefix of nodes is a suffix of points.
    for (std::size_t k = 1; k <= m_keys.size(); ++k) {
        m_nodes[k].begin = m_sorted.size();
        for (std::size_t q = k - lowestBit(k); q < k; ++q) {
            m_sorted.push_back(m_keys[m_keys.size() - 1 - q]);
        }
        m_nodes[k].end = m_sorted.size();
        std::sort(m_sorted.begin() + static_cast<std::ptrdiff_t>(m_nodes[k].begin), m_sorted.end());
    }
    m_living.resize(m_sorted.size());
    for (std::size_t k = 1; k <= m_keys.size(); ++k) {
        for (std::size_t i = m_nodes[k].begin; i < m_nodes[k].end; ++i) {
            m_living[i] = static_cast<std::uint32_t>(lowestBit(i - m_nodes[k].begin + 1));
        }
    }
}

void DominanceCount::remove(std::size_t i) {
    const std::uint32_t key = m_keys[i];
    for (std::size_t k = m_keys.size() - i; k <= m_keys.size(); k += lowestBit(k)) {
        const Node& node = m_nodes[k];
        const auto first = m_sorted.begin() + static_cast<std::ptrdiff_t>(node.begin);
        const auto last = m_sorted.begin() + static_cast<std::ptrdiff_t>(node.end);
        const auto place = static_cast<std::size_t>(std::lower_bound(first, last, key) - first);
        for (std::size_t q = place + 1; q <= node.end - node.begin; q += lowestBit(q)) {
            --m_living[node.begin + q - 1];
        }
    }
}

std::uint32_t DominanceCount::countBelow(const Node& node, std::uint32_t bound) const {
    const auto first = m_sorted.begin() + static_cast<std::ptrdiff_t>(node.begin);
    const auto last = m_sorted.begin() + static_cast<std::ptrdiff_t>(node.end);
    std::uint32_t sum = 0;
    for (auto q = static_cast<std::size_t>(std::lower_bound(first, last, bound) - first); q > 0; q -= lowestBit(q)) {
        sum += m_living[node.begin + q - 1];
    }
    return sum;
}

std::uint32_t DominanceCount::count(std::size_t i, std::uint32_t bound) const {
    std::uint32_t sum = 0;
    for (std::size_t k = m_keys.size() - i; k > 0; k -= lowestBit(k)) {
        sum += countBelow(m_nodes[k], bound);
    }
    return sum;
}

}  // namespace rubble
