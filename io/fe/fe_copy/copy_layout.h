#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/hash.h"

namespace rubble::io {

// A copy of an FE result is an HDF5 file: attributes `format` and `version` at its root, and these datasets. Lengths in m, z up.
inline constexpr const char* copyFormatName = "rubble-fe";
inline constexpr int copyVersion = 1;

/// Datasets that are read when a copy is opened; all others are one state each.
namespace copy_table {
inline constexpr const char* about = "/about";            ///< JSON text: source, parts, findings, how activity was decided
inline constexpr const char* times = "/times";            ///< s [states]
inline constexpr const char* activity = "/activity";      ///< bits, element 0 lowest in word 0 [states, words]
inline constexpr const char* nodeIds = "/mesh/node_ids";  ///< [nodes]
inline constexpr const char* nodes = "/mesh/nodes";       ///< m, at rest [nodes, 3]
inline constexpr const char* elementIds = "/mesh/element_ids";
inline constexpr const char* shapes = "/mesh/shapes";    ///< ElementShape [elements]
inline constexpr const char* part = "/mesh/part";        ///< index into the parts of /about [elements]
inline constexpr const char* corners = "/mesh/corners";  ///< nodes, element by element
inline constexpr const char* density = "/mesh/density";  ///< kg/m3 or NaN [elements]
inline constexpr const char* section = "/mesh/section";  ///< m or m2 or NaN [elements]
inline constexpr const char* deathTime = "/death_time";  ///< s or NaN [elements]; missing where no time is known
inline constexpr const char* chunks = "/chunks";    ///< ChunkPlace of positions, then of velocities if there are any, of each state
inline constexpr const char* digests = "/digests";  ///< of the values of each state [states, 16]
inline constexpr const char* seal = "/seal";        ///< digest over all tables above [16]
}  // namespace copy_table

/// Table of a state, a chunk by itself: "/positions/000012", "/velocities/000012".
inline std::string copyStateTable(std::string_view what, std::size_t k) {
    std::string number = std::to_string(k);
    number.insert(0, number.size() < 6 ? 6 - number.size() : 0, '0');
    return "/" + std::string(what) + "/" + number;
}

}  // namespace rubble::io
