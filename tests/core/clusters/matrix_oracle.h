#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>
#include <vector>

namespace rubble {

/// The groups of the paper's matrix method along one axis, as plainly as it can be written: the whole matrix D, rows counted anew
/// after every group. O(n^2) memory, O(n^2 groups) time.
inline std::vector<std::uint32_t> matrixGroups(std::span<const double> low, std::span<const double> high,
                                               std::span<const double> centre, std::span<const std::int64_t> elementId,
                                               double size) {
    const std::size_t n = low.size();
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::make_tuple(centre[a], low[a], elementId[a]) < std::make_tuple(centre[b], low[b], elementId[b]);
    });
    std::vector<std::uint8_t> matrix(n * n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i; j < n; ++j) {
            const bool near = high[order[j]] - low[order[i]] <= size * (1.0 + 1e-9);
            matrix[i * n + j] = (near || i == j) ? 1 : 0;
        }
    }
    std::vector<std::uint8_t> living(n, 1);
    std::vector<std::uint32_t> group(n);
    std::uint32_t groups = 0;
    for (std::size_t left = n; left > 0; ++groups) {
        std::size_t best = 0;
        int most = 0;
        for (std::size_t i = 0; i < n; ++i) {
            int ones = 0;
            for (std::size_t j = 0; living[i] && j < n; ++j) {
                ones += matrix[i * n + j] & living[j];
            }
            if (ones > most) {
                most = ones;
                best = i;
            }
        }
        for (std::size_t j = 0; j < n; ++j) {
            if (living[j] && matrix[best * n + j]) {
                group[order[j]] = groups;
                living[j] = 0;
                --left;
            }
        }
    }
    return group;
}

}  // namespace rubble
