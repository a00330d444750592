#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/clusters/axis_order.h"
#include "core/clusters/dominance_count.h"

namespace rubble {

/// Takes the groups of DESIGN.md 2.3 along one axis without the matrix. Holds its working memory, so one object serves many
/// births; not for use from two threads at once.
///
/// Row i of the matrix has its ones at the living j >= i with high[j] - low[i] <= limit, and at i itself. Why this is fast:
///  - A row never wins while an earlier living row begins no further left: that one has at least as many ones (all of the later
///    row's but the later fragment itself, and its own fragment) and comes first on a tie. So only the *records* count: rows whose
///    near face lies beyond those of all earlier living rows. A record stays one until it is grouped; every row becomes one at
///    most once.
///  - Along the records position and near face rise together, so the rows that lose a one with fragment j are consecutive records:
///    one range update in a tree that keeps the largest count and its first row.
///  - The count of a new record: the earlier living fragments that are no wider than the limit all end within its reach (they begin
///    before it), so two prefix sums give it: living far faces within reach less living fragments before it. Only fragments wider
///    than the limit, which stand in no row of their own width, need a count in two dimensions.
/// Every fragment enters and leaves each structure once: O(n log n); with w fragments wider than the limit O(n log n + n log^2 w).
/// The search for the grid never goes below the largest fragment, so w is 0 there.
class AxisGrouping {
public:
    /// Groups intervals and writes the group of each to its place; groups are numbered as they are taken.
    /// @param group  by item [n]
    /// @return number of groups
    std::uint32_t group(const AxisOrder& order, double size, std::span<std::uint32_t> group);

private:
    bool fits(double high, double low) const { return high - low <= m_limit; }
    void start(const AxisOrder& order, double size);
    void startWide();
    void takeRow(std::uint32_t row);
    void removeFragment(std::uint32_t position);
    void countOut(std::uint32_t position);
    void addRecordsAfter(std::uint32_t record);
    std::uint32_t reachOf(std::uint32_t row) const;
    std::int32_t rowCount(std::uint32_t row) const;

    void collect(std::size_t node, std::uint32_t from, std::uint32_t reach);
    std::uint32_t firstRowReaching(double high) const;
    std::uint32_t nextRecord(std::uint32_t record) const;
    void setCount(std::uint32_t position, std::int32_t count);
    void addToCounts(std::uint32_t first, std::uint32_t last, std::int32_t change);
    std::uint32_t bestRow() const;

    const AxisOrder* m_order = nullptr;
    double m_limit = 0.0;
    std::size_t m_leaves = 0;                     ///< power of two >= n; trees have their root at 1
    std::vector<double> m_farthestLow;            ///< tree of living near faces: largest
    std::vector<std::uint32_t> m_leastRank;       ///< tree of living far-face ranks: smallest
    std::vector<std::int32_t> m_count;            ///< tree of the records' counts: largest, additions at inner nodes included
    std::vector<std::int32_t> m_addition;         ///< added to all counts below a node
    std::vector<std::uint32_t> m_livingRank;      ///< Fenwick tree over ranks: living fragments no wider than the limit
    std::vector<std::uint32_t> m_livingPosition;  ///< the same over positions
    DominanceCount m_wide;                        ///< living fragments wider than the limit
    std::vector<std::uint32_t> m_wideBefore;      ///< wide fragments before each position [n + 1]
    std::vector<std::uint32_t> m_previous;        ///< chain of records by position + 1; 0 is the head
    std::vector<std::uint32_t> m_next;
    std::vector<std::uint32_t> m_taken;  ///< positions of the group being taken, ascending
    std::vector<std::uint32_t> m_gaps;   ///< links after which new records may come
};

}  // namespace rubble
