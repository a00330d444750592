#pragma once

#include <memory>
#include <type_traits>

#include "core/base/archive.h"
#include "core/base/hash.h"

namespace rubble {

/// Accumulates the same Digest as a Hasher, and can go on in another process from what it has been fed so far.
class ResumableHasher {
public:
    ResumableHasher();
    ~ResumableHasher();
    ResumableHasher(const ResumableHasher&) = delete;
    ResumableHasher& operator=(const ResumableHasher&) = delete;

    ResumableHasher& bytes(const void* data, std::size_t size);
    template <class T>
        requires(std::is_arithmetic_v<T>)
    ResumableHasher& value(T value) {
        return bytes(&value, sizeof value);
    }
    /// The digest of all fed so far; feeding may go on.
    Digest finish() const;
    /// The bytes are those of one version of the hash library: stateVersion().
    void keep(Archive& archive);
    static std::uint32_t stateVersion();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace rubble
