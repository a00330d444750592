#pragma once

#include <cstddef>

namespace rubble {

/// Largest power of two that divides k > 0: the width of node k of a Fenwick tree.
inline std::size_t lowestBit(std::size_t k) {
    return k & (~k + 1);
}

}  // namespace rubble
