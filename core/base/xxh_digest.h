#pragma once

#include <xxhash.h>

#include <algorithm>
#include <iterator>

#include "core/base/hash.h"

namespace rubble {

/// The same bytes on every machine.
inline Digest digestOf(const XXH128_hash_t& hash) {
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, hash);
    Digest digest;
    static_assert(sizeof canonical.digest == sizeof digest.bytes);
    std::copy(std::begin(canonical.digest), std::end(canonical.digest), digest.bytes.begin());
    return digest;
}

}  // namespace rubble
