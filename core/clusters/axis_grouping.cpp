#include "core/clusters/axis_grouping.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>

#include "core/clusters/lowest_bit.h"

namespace rubble {

namespace {

constexpr double sizeTolerance = 1e-9;  // relative; keeps fragments of one size together despite rounding
constexpr double nowhere = -std::numeric_limits<double>::infinity();
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr std::int32_t noRow = std::numeric_limits<std::int32_t>::min() / 2;  // additions never lift it to a count

void decrement(std::vector<std::uint32_t>& fenwick, std::size_t place) {
    for (std::size_t k = place + 1; k < fenwick.size(); k += lowestBit(k)) {
        --fenwick[k];
    }
}

std::uint32_t prefixSum(const std::vector<std::uint32_t>& fenwick, std::size_t places) {
    std::uint32_t sum = 0;
    for (std::size_t k = places; k > 0; k -= lowestBit(k)) {
        sum += fenwick[k];
    }
    return sum;
}

/// Turns counts at k = 1.. into a Fenwick tree.
void makeFenwick(std::vector<std::uint32_t>& counts) {
    for (std::size_t k = 1; k < counts.size(); ++k) {
        const std::size_t parent = k + lowestBit(k);
        if (parent < counts.size()) {
            counts[parent] += counts[k];
        }
    }
}

}  // namespace

std::uint32_t AxisGrouping::group(const AxisOrder& order, double size, std::span<std::uint32_t> group) {
    assert(group.size() == order.size() && size >= 0.0);
    if (order.size() == 0) {
        return 0;
    }
    start(order, size);
    std::uint32_t groups = 0;
    std::size_t living = order.size();
    while (living > 0) {
        takeRow(bestRow());
        for (const std::uint32_t position : m_taken) {
            group[order.item[position]] = groups;
        }
        living -= m_taken.size();
        ++groups;
    }
    return groups;
}

void AxisGrouping::start(const AxisOrder& order, double size) {
    const std::size_t n = order.size();
    m_order = &order;
    m_limit = size * (1.0 + sizeTolerance);
    m_leaves = std::bit_ceil(n);
    m_farthestLow.assign(2 * m_leaves, nowhere);
    m_leastRank.assign(2 * m_leaves, none);
    m_count.assign(2 * m_leaves, noRow);
    m_addition.assign(2 * m_leaves, 0);
    std::ranges::copy(order.low, m_farthestLow.begin() + static_cast<std::ptrdiff_t>(m_leaves));
    std::ranges::copy(order.highRank, m_leastRank.begin() + static_cast<std::ptrdiff_t>(m_leaves));
    for (std::size_t node = m_leaves - 1; node > 0; --node) {
        m_farthestLow[node] = std::max(m_farthestLow[2 * node], m_farthestLow[2 * node + 1]);
        m_leastRank[node] = std::min(m_leastRank[2 * node], m_leastRank[2 * node + 1]);
    }
    startWide();
    makeFenwick(m_livingRank);
    makeFenwick(m_livingPosition);
    m_previous.assign(n + 1, none);
    m_next.assign(n + 1, none);
    addRecordsAfter(0);
}

void AxisGrouping::startWide() {
    const AxisOrder& order = *m_order;
    const std::size_t n = order.size();
    m_livingRank.assign(n + 1, 1);
    m_livingPosition.assign(n + 1, 1);
    m_wideBefore.assign(n + 1, 0);
    std::vector<std::uint32_t> keys;
    for (std::size_t i = 0; i < n; ++i) {
        if (!fits(order.high[i], order.low[i])) {
            m_livingRank[order.highRank[i] + 1] = 0;
            m_livingPosition[i + 1] = 0;
            keys.push_back(order.highRank[i]);
        }
        m_wideBefore[i + 1] = static_cast<std::uint32_t>(keys.size());
    }
    m_wide.build(keys);
}

void AxisGrouping::takeRow(std::uint32_t row) {
    const AxisOrder& order = *m_order;
    const std::uint32_t reach = reachOf(row);
    m_taken.clear();
    if (order.highRank[row] >= reach) {
        m_taken.push_back(row);  // wider than the limit: alone on the diagonal
    }
    collect(1, row, reach);
    // Records leave the chain first, in ascending order, so that each gap is known by the living record before it.
    m_gaps.clear();
    for (const std::uint32_t position : m_taken) {
        removeFragment(position);
        const std::uint32_t link = position + 1;
        if (m_previous[link] == none) {
            continue;
        }
        setCount(position, noRow);
        const std::uint32_t before = m_previous[link];
        m_next[before] = m_next[link];
        if (m_next[link] != none) {
            m_previous[m_next[link]] = before;
        }
        m_previous[link] = none;
        if (m_gaps.empty() || m_gaps.back() != before) {
            m_gaps.push_back(before);
        }
    }
    for (const std::uint32_t position : m_taken) {
        countOut(position);
    }
    for (const std::uint32_t before : m_gaps) {
        addRecordsAfter(before);
    }
}

void AxisGrouping::removeFragment(std::uint32_t position) {
    const AxisOrder& order = *m_order;
    // Up each tree only as far as something changes.
    std::size_t node = m_leaves + position;
    m_farthestLow[node] = nowhere;
    for (node /= 2; node > 0; node /= 2) {
        const double farthest = std::max(m_farthestLow[2 * node], m_farthestLow[2 * node + 1]);
        if (farthest == m_farthestLow[node]) {
            break;
        }
        m_farthestLow[node] = farthest;
    }
    node = m_leaves + position;
    m_leastRank[node] = none;
    for (node /= 2; node > 0; node /= 2) {
        const std::uint32_t least = std::min(m_leastRank[2 * node], m_leastRank[2 * node + 1]);
        if (least == m_leastRank[node]) {
            break;
        }
        m_leastRank[node] = least;
    }
    if (fits(order.high[position], order.low[position])) {
        decrement(m_livingRank, order.highRank[position]);
        decrement(m_livingPosition, position);
    } else {
        m_wide.remove(m_wideBefore[position]);
    }
}

/// Takes a removed fragment out of the counts of the records that reach it.
void AxisGrouping::countOut(std::uint32_t position) {
    const std::uint32_t first = firstRowReaching(m_order->high[position]);
    if (first != none && first <= position) {
        addToCounts(first, position, -1);
    }
}

void AxisGrouping::addRecordsAfter(std::uint32_t record) {
    const std::uint32_t end = m_next[record];
    for (std::uint32_t last = record;;) {
        const std::uint32_t next = nextRecord(last);
        if (next == end || next == none) {
            return;
        }
        m_previous[next] = last;
        m_next[next] = end;
        m_next[last] = next;
        if (end != none) {
            m_previous[end] = next;
        }
        const std::uint32_t row = next - 1;
        setCount(row, rowCount(row));
        last = next;
    }
}

/// How many of all far faces, ascending, lie within the limit of a row's near face.
std::uint32_t AxisGrouping::reachOf(std::uint32_t row) const {
    const std::vector<double>& highs = m_order->sortedHigh;
    const auto within = [&](double high) { return fits(high, m_order->low[row]); };
    return static_cast<std::uint32_t>(std::ranges::partition_point(highs, within) - highs.begin());
}

/// Ones of a new record, counted among the living.
std::int32_t AxisGrouping::rowCount(std::uint32_t row) const {
    const std::uint32_t reach = reachOf(row);
    std::uint32_t count = prefixSum(m_livingRank, reach) - prefixSum(m_livingPosition, row);
    if (!m_wide.empty()) {
        count += m_wide.count(m_wideBefore[row], reach);
    }
    const bool onlyOnDiagonal = m_order->highRank[row] >= reach;
    return static_cast<std::int32_t>(count + (onlyOnDiagonal ? 1u : 0u));
}

/// Appends the living fragments at `from` and later whose rank is below `reach`.
void AxisGrouping::collect(std::size_t node, std::uint32_t from, std::uint32_t reach) {
    if (m_leastRank[node] >= reach) {
        return;
    }
    if (node >= m_leaves) {
        m_taken.push_back(static_cast<std::uint32_t>(node - m_leaves));
        return;
    }
    // The left child ends before `middle`.
    const auto depth = static_cast<unsigned>(std::bit_width(node)) - 1u;
    const std::size_t width = m_leaves >> depth;
    const std::size_t middle = (node - (std::size_t{1} << depth)) * width + width / 2;
    if (from < middle) {
        collect(2 * node, from, reach);
    }
    collect(2 * node + 1, from, reach);
}

/// First living position whose row reaches a far face, none if no row does. It is a record.
std::uint32_t AxisGrouping::firstRowReaching(double high) const {
    if (!fits(high, m_farthestLow[1])) {
        return none;
    }
    std::size_t node = 1;
    while (node < m_leaves) {
        node = fits(high, m_farthestLow[2 * node]) ? 2 * node : 2 * node + 1;
    }
    return static_cast<std::uint32_t>(node - m_leaves);
}

/// Link of the first living row after a record that begins beyond it, none if there is none.
std::uint32_t AxisGrouping::nextRecord(std::uint32_t record) const {
    const double beyond = record == 0 ? nowhere : m_order->low[record - 1];
    if (record >= m_order->size()) {
        return none;
    }
    std::size_t node = m_leaves + record;  // the position after the record
    while (!(m_farthestLow[node] > beyond)) {
        while (node & 1) {
            node /= 2;
        }
        if (node == 0) {
            return none;
        }
        ++node;
    }
    while (node < m_leaves) {
        node = m_farthestLow[2 * node] > beyond ? 2 * node : 2 * node + 1;
    }
    return static_cast<std::uint32_t>(node - m_leaves) + 1;
}

void AxisGrouping::setCount(std::uint32_t position, std::int32_t count) {
    std::size_t node = m_leaves + position;
    m_count[node] = count;
    if (count != noRow) {
        for (std::size_t above = node / 2; above > 0; above /= 2) {
            m_count[node] -= m_addition[above];
        }
    }
    for (node /= 2; node > 0; node /= 2) {
        const std::int32_t most = std::max(m_count[2 * node], m_count[2 * node + 1]) + m_addition[node];
        if (most == m_count[node]) {
            break;
        }
        m_count[node] = most;
    }
}

void AxisGrouping::addToCounts(std::uint32_t first, std::uint32_t last, std::int32_t change) {
    const auto apply = [&](std::size_t node) {
        m_count[node] += change;
        m_addition[node] += change;
    };
    std::size_t left = m_leaves + first;
    std::size_t right = m_leaves + last + 1;
    for (; left < right; left /= 2, right /= 2) {
        if (left & 1) {
            apply(left++);
        }
        if (right & 1) {
            apply(--right);
        }
    }
    const auto renew = [&](std::size_t node) {
        m_count[node] = std::max(m_count[2 * node], m_count[2 * node + 1]) + m_addition[node];
    };
    left = (m_leaves + first) / 2;
    right = (m_leaves + last) / 2;
    for (; left != right; left /= 2, right /= 2) {
        renew(left);
        renew(right);
    }
    for (; left > 0; left /= 2) {
        renew(left);
    }
}

std::uint32_t AxisGrouping::bestRow() const {
    std::size_t node = 1;
    while (node < m_leaves) {
        node = m_count[2 * node] >= m_count[2 * node + 1] ? 2 * node : 2 * node + 1;
    }
    return static_cast<std::uint32_t>(node - m_leaves);
}

}  // namespace rubble
