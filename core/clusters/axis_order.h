#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Intervals of one birth along one axis in the order of DESIGN.md 2.2, with all that does not depend on the size of the grid:
/// made once, grouped at many sizes.
struct AxisOrder {
    std::vector<std::uint32_t> item;      ///< which interval stands at each position of the order [n]
    std::vector<double> low;              ///< near face by position [n] m
    std::vector<double> high;             ///< far face by position [n] m
    std::vector<std::uint32_t> highRank;  ///< rank of the far face among all, ties by position; by position [n]
    std::vector<double> sortedHigh;       ///< far faces ascending [n] m

    std::size_t size() const { return item.size(); }
    /// Mean outer distance d of neighbours in the order: sum of high[i + 1] - low[i] over n - 1 [m]; the size of the only interval
    /// for n = 1, and 0 for none.
    double meanDistance() const;
};

/// Orders intervals by centre, then near face, then element number. All values finite.
/// @param low, high, centre  [n] m
/// @param elementId  [n]
AxisOrder orderAlongAxis(std::span<const double> low, std::span<const double> high, std::span<const double> centre,
                         std::span<const std::int64_t> elementId);

}  // namespace rubble
