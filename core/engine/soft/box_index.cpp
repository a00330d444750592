#include "core/engine/soft/box_index.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {

namespace {

/// Times that every box may move before the tree is laid out anew. Lower: more sorting; higher: wider nodes.
constexpr std::uint64_t mostMoves = 4;
/// A new box, which goes to the end for the time being, counts as so many moves.
constexpr std::uint64_t movesOfNew = 16;
/// Bits per axis along the space-filling curve.
constexpr int curveBits = 21;

/// Every third bit.
std::uint64_t spread(std::uint64_t x) {
    x = (x | x << 32) & 0x1f00000000ffffull;
    x = (x | x << 16) & 0x1f0000ff0000ffull;
    x = (x | x << 8) & 0x100f00f00f00f00full;
    x = (x | x << 4) & 0x10c30c30c30c30c3ull;
    return (x | x << 2) & 0x1249249249249249ull;
}

/// Share [0, 1] of an axis in steps along the curve; what is no number goes to the start.
std::uint64_t steps(float share) {
    constexpr float most = (1 << curveBits) - 1;
    return share > 0.0f ? static_cast<std::uint64_t>(std::min(share, 1.0f) * most) : 0;
}

/// Twice the rounding to single precision.
float allowance(float x) {
    return std::abs(x) * 1.2e-7f + 1e-30f;
}

}  // namespace

BoxIndex::Bounds BoxIndex::bounds(const Aabb& box) {
    Bounds rounded;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto low = static_cast<float>(box.min()[static_cast<Eigen::Index>(k)]);
        const auto high = static_cast<float>(box.max()[static_cast<Eigen::Index>(k)]);
        rounded.low[k] = low - allowance(low);
        rounded.high[k] = high + allowance(high);
    }
    return rounded;
}

void BoxIndex::set(std::uint32_t key, const Aabb& box) {
    if (key >= m_places.size()) {
        m_places.resize(key + 1, none);
    }
    if (m_places[key] == none) {
        m_places[key] = static_cast<std::uint32_t>(m_keys.size());
        m_keys.push_back(key);
        grow();
        m_changes += movesOfNew;
    }
    put(0, m_places[key], bounds(box));
    ++m_changes;
}

void BoxIndex::remove(std::uint32_t key) {
    if (key >= m_places.size() || m_places[key] == none) {
        return;
    }
    const std::uint32_t place = std::exchange(m_places[key], none);
    m_keys[place] = none;
    put(0, place, {});
    m_changes += movesOfNew;
}

void BoxIndex::put(std::size_t level, std::size_t place, const Bounds& box) {
    Level& to = m_levels[level];
    Node& node = to.nodes[place / width];
    for (std::size_t k = 0; k < 3; ++k) {
        node.low[k][place % width] = box.low[k];
        node.high[k][place % width] = box.high[k];
    }
    to.changed[place / width] = 1;
}

BoxIndex::Bounds BoxIndex::around(const Node& node) const {
    Bounds all;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::uint32_t i = 0; i < width; ++i) {
            all.low[k] = std::min(all.low[k], node.low[k][i]);
            all.high[k] = std::max(all.high[k], node.high[k][i]);
        }
    }
    return all;
}

/// Makes room for as many boxes as there are keys.
void BoxIndex::grow() {
    Node empty;
    for (std::size_t k = 0; k < 3; ++k) {
        std::fill_n(empty.low[k], width, nowhere);
        std::fill_n(empty.high[k], width, -nowhere);
    }
    std::size_t count = m_keys.size();
    for (std::size_t level = 0; level == 0 || count > 1; ++level) {
        count = (count + width - 1) / width;
        if (level == m_levels.size()) {
            m_levels.emplace_back();
            // What was the only node so far has not been noted above.
            if (level > 0) {
                std::fill(m_levels[level - 1].changed.begin(), m_levels[level - 1].changed.end(), 1);
            }
        }
        m_levels[level].nodes.resize(count, empty);
        m_levels[level].changed.resize(count, 1);
    }
}

void BoxIndex::refit() {
    if (m_changes > mostMoves * m_keys.size()) {
        layOut();
    }
    for (std::size_t level = 0; level + 1 < m_levels.size(); ++level) {
        Level& of = m_levels[level];
        for (std::size_t i = 0; i < of.nodes.size(); ++i) {
            if (std::exchange(of.changed[i], 0) != 0) {
                put(level + 1, i, around(of.nodes[i]));
            }
        }
    }
}

void BoxIndex::layOut() {
    const auto boxAt = [&](std::size_t place) {
        const Node& node = m_levels[0].nodes[place / width];
        Bounds box;
        for (std::size_t k = 0; k < 3; ++k) {
            box.low[k] = node.low[k][place % width];
            box.high[k] = node.high[k][place % width];
        }
        return box;
    };
    struct Entry {
        std::uint64_t along = 0;  ///< the curve
        std::uint32_t key = 0;
        Bounds box;
    };
    std::vector<Entry> entries;
    entries.reserve(m_keys.size());
    Bounds all;
    for (std::size_t place = 0; place < m_keys.size(); ++place) {
        if (m_keys[place] == none) {
            continue;
        }
        entries.push_back({0, m_keys[place], boxAt(place)});
        for (std::size_t k = 0; k < 3; ++k) {
            all.low[k] = std::min(all.low[k], entries.back().box.low[k]);
            all.high[k] = std::max(all.high[k], entries.back().box.high[k]);
        }
    }
    // One scale for all axes: cells along the curve are cubes.
    float span = 1e-30f;
    for (std::size_t k = 0; k < 3; ++k) {
        span = std::max(span, all.high[k] - all.low[k]);
    }
    for (Entry& entry : entries) {
        for (std::size_t k = 0; k < 3; ++k) {
            const float middle = 0.5f * entry.box.low[k] + 0.5f * entry.box.high[k];
            entry.along |= spread(steps((middle - all.low[k]) / span)) << k;
        }
    }
    std::sort(entries.begin(), entries.end(),
              [](const Entry& x, const Entry& y) { return x.along != y.along ? x.along < y.along : x.key < y.key; });
    m_levels.clear();
    m_keys.clear();
    for (const Entry& entry : entries) {
        m_keys.push_back(entry.key);
    }
    if (!m_keys.empty()) {
        grow();
    }
    for (std::size_t i = 0; i < entries.size(); ++i) {
        m_places[entries[i].key] = static_cast<std::uint32_t>(i);
        put(0, i, entries[i].box);
    }
    m_changes = 0;
}

}  // namespace rubble
