#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <vector>

namespace rubble {

/// A number that is the larger the higher, as bits.
inline std::uint64_t heightKey(double height) {
    const auto bits = std::bit_cast<std::uint64_t>(height + 0.0);  // no negative zero
    constexpr std::uint64_t sign = std::uint64_t{1} << 63;
    return (bits & sign) != 0 ? ~bits : bits | sign;
}

/// Sorts by height, digit by digit from the last one on; what is equally high keeps its order.
template <class Entry>
void sortByHeight(std::vector<Entry>& entries) {
    constexpr unsigned digitBits = 11, digits = 6;
    constexpr std::uint64_t mask = (1u << digitBits) - 1;
    std::vector<std::array<std::uint32_t, mask + 1>> counts(digits);
    for (const Entry& entry : entries) {
        for (unsigned d = 0; d < digits; ++d) {
            ++counts[d][entry.height >> (d * digitBits) & mask];
        }
    }
    std::vector<Entry> sorted(entries.size());
    for (unsigned d = 0; d < digits && !entries.empty(); ++d) {
        const auto digitOf = [&](const Entry& entry) { return entry.height >> (d * digitBits) & mask; };
        if (counts[d][digitOf(entries[0])] == entries.size()) {
            continue;
        }
        std::exclusive_scan(counts[d].begin(), counts[d].end(), counts[d].begin(), 0u);
        for (const Entry& entry : entries) {
            sorted[counts[d][digitOf(entry)]++] = entry;
        }
        entries.swap(sorted);
    }
}

}  // namespace rubble
