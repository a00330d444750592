#include "io/fe/fe_copy/copy_seal.h"

namespace rubble::io {

Digest digestOfState(const FeState& state) {
    Hasher hasher;
    hasher.value(state.time);
    for (const std::vector<Vec3>* vectors : {&state.positions, &state.velocities}) {
        hasher.value(static_cast<std::uint64_t>(vectors->size())).bytes(vectors->data(), vectors->size() * sizeof(Vec3));
    }
    return hasher.finish();
}

}  // namespace rubble::io
