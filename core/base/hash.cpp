#include "core/base/hash.h"

#include <xxhash.h>

#include <cassert>
#include <new>

#include "core/base/xxh_digest.h"

namespace rubble {

std::string Digest::hex() const {
    static constexpr char digits[] = "0123456789abcdef";
    std::string result;
    result.reserve(2 * bytes.size());
    for (const std::uint8_t byte : bytes) {
        result += digits[byte >> 4];
        result += digits[byte & 15];
    }
    return result;
}

struct Hasher::State {
    XXH3_state_t* xxh = XXH3_createState();

    State() {
        if (!xxh) {
            throw std::bad_alloc();
        }
        XXH3_128bits_reset(xxh);
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() { XXH3_freeState(xxh); }
};

Hasher::Hasher() : m_state(std::make_unique<State>()) {}
Hasher::~Hasher() = default;
Hasher::Hasher(Hasher&&) noexcept = default;
Hasher& Hasher::operator=(Hasher&&) noexcept = default;

Hasher& Hasher::bytes(const void* data, std::size_t size) {
    assert(data || size == 0);
    if (size > 0) {
        XXH3_128bits_update(m_state->xxh, data, size);
    }
    return *this;
}

Hasher& Hasher::text(std::string_view text) {
    value(static_cast<std::uint64_t>(text.size()));
    return bytes(text.data(), text.size());
}

Digest Hasher::finish() const {
    return digestOf(XXH3_128bits_digest(m_state->xxh));
}

}  // namespace rubble
