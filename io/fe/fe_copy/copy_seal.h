#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/hash.h"
#include "core/fe/fe_result.h"

namespace rubble::io {

inline constexpr std::size_t activityBits = 32;  ///< of a word of the table of activity
constexpr std::size_t activityWords(std::size_t elements) {
    return (elements + activityBits - 1) / activityBits;
}

/// Digest over the tables of a copy, in the order in which they are listed in copy_layout.h from the mesh on.
class CopySeal {
public:
    void add(const std::vector<std::int64_t>& values) { m_hasher.values(std::span<const std::int64_t>(values)); }
    void add(const std::vector<double>& values) { m_hasher.values(std::span<const double>(values)); }
    Digest finish() const { return m_hasher.finish(); }

private:
    Hasher m_hasher;
};

/// Names the nodal values of a state, bit by bit.
Digest digestOfState(const FeState& state);

}  // namespace rubble::io
