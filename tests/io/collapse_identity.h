#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "core/base/hash.h"
#include "core/fe/fe_result.h"

namespace rubble::io {

/// Elements that are dead at each state.
inline std::vector<std::int64_t> deadPerState(const FeResult& fe) {
    std::vector<std::int64_t> dead;
    for (std::size_t k = 0; k < fe.stateCount(); ++k) {
        dead.push_back(static_cast<std::int64_t>(fe.mesh().elementCount() - fe.activity().activeCount(k)));
    }
    return dead;
}

/// Names a collapse by its solids alone, whatever the format and the order in the file: numbers, which of them share a component,
/// and the dead of every state in `states`.
inline Digest collapseDigest(const FeResult& fe, const std::vector<std::size_t>& states) {
    const Mesh& mesh = fe.mesh();
    std::vector<std::size_t> order;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        if (isSolid(mesh.shapes[e])) {
            order.push_back(e);
        }
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return mesh.elementIds[a] < mesh.elementIds[b]; });
    std::map<std::uint32_t, std::uint32_t> component;
    Hasher hasher;
    for (const std::size_t e : order) {
        const auto place = component.emplace(mesh.part[e], static_cast<std::uint32_t>(component.size())).first->second;
        hasher.value(mesh.elementIds[e]).value(place);
        for (const std::size_t k : states) {
            hasher.value(fe.activity().active(k, idAt<ElementIndex>(e)));
        }
    }
    return hasher.finish();
}

}  // namespace rubble::io
