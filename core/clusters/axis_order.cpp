#include "core/clusters/axis_order.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <tuple>

namespace rubble {

double AxisOrder::meanDistance() const {
    if (size() < 2) {
        return size() == 0 ? 0.0 : high[0] - low[0];
    }
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < size(); ++i) {
        sum += high[i + 1] - low[i];
    }
    return sum / static_cast<double>(size() - 1);
}

AxisOrder orderAlongAxis(std::span<const double> low, std::span<const double> high, std::span<const double> centre,
                         std::span<const std::int64_t> elementId) {
    assert(high.size() == low.size() && centre.size() == low.size() && elementId.size() == low.size());
    assert(std::ranges::all_of(low, [](double v) { return std::isfinite(v); }));
    assert(std::ranges::all_of(high, [](double v) { return std::isfinite(v); }));
    assert(std::ranges::all_of(centre, [](double v) { return std::isfinite(v); }));
    AxisOrder order;
    order.item.resize(low.size());
    std::iota(order.item.begin(), order.item.end(), 0u);
    std::ranges::sort(order.item, [&](std::uint32_t a, std::uint32_t b) {
        return std::tie(centre[a], low[a], elementId[a], a) < std::tie(centre[b], low[b], elementId[b], b);
    });
    for (const std::uint32_t i : order.item) {
        order.low.push_back(low[i]);
        order.high.push_back(high[i]);
    }
    std::vector<std::uint32_t> byHigh(low.size());
    std::iota(byHigh.begin(), byHigh.end(), 0u);
    std::ranges::sort(byHigh,
                      [&](std::uint32_t a, std::uint32_t b) { return std::tie(order.high[a], a) < std::tie(order.high[b], b); });
    order.highRank.resize(low.size());
    for (std::uint32_t rank = 0; rank < byHigh.size(); ++rank) {
        order.highRank[byHigh[rank]] = rank;
        order.sortedHigh.push_back(order.high[byHigh[rank]]);
    }
    return order;
}

}  // namespace rubble
