#include "core/base/resumable_hash.h"

// The state of a hash is to go on elsewhere.
#define XXH_STATIC_LINKING_ONLY
#include <xxhash.h>

#include "core/base/xxh_digest.h"

namespace rubble {

struct ResumableHasher::State {
    XXH3_state_t xxh{};

    State() { XXH3_128bits_reset(&xxh); }
};

ResumableHasher::ResumableHasher() : m_state(std::make_unique<State>()) {}
ResumableHasher::~ResumableHasher() = default;

ResumableHasher& ResumableHasher::bytes(const void* data, std::size_t size) {
    if (size > 0) {
        XXH3_128bits_update(&m_state->xxh, data, size);
    }
    return *this;
}

Digest ResumableHasher::finish() const {
    return digestOf(XXH3_128bits_digest(&m_state->xxh));
}

void ResumableHasher::keep(Archive& archive) {
    XXH3_state_t state = m_state->xxh;
    // Where the library has its secret is for it to know.
    const unsigned char* const secret = state.extSecret;
    state.extSecret = nullptr;
    archive.bytes(&state, sizeof state);
    if (archive.reading()) {
        state.extSecret = secret;
        m_state->xxh = state;
    }
}

std::uint32_t ResumableHasher::stateVersion() {
    return XXH_versionNumber();
}

}  // namespace rubble
