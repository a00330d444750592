#pragma once

#include <cstddef>

namespace rubble {

/// Records ahead of the one at hand that a loop prefetches.
constexpr std::size_t recordsAhead = 4;

/// Prefetches a record that a loop will come to a little later: where records lie anywhere, such loops wait for little else.
/// @param bytes  of it that the loop will look at
template <class Record>
inline void prefetch(const Record& record, std::size_t bytes = sizeof(Record)) {
    constexpr std::size_t line = 64;
    const auto* const first = reinterpret_cast<const char*>(&record);
    for (std::size_t at = 0; at < bytes; at += line) {
        __builtin_prefetch(first + at);
    }
}

}  // namespace rubble
