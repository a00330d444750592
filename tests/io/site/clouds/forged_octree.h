#pragma once

#include <cstring>
#include <string>

#include "core/base/hash.h"
#include "io/site/clouds/octree/octree_file.h"

namespace rubble::io {

/// Puts marks and digests of an octree right whose bytes were changed, so that what lies behind them is read.
inline void putOctreeRight(std::string& bytes) {
    OctreeFoot foot;
    if (bytes.size() < octreeStart + sizeof foot) {
        return;
    }
    const std::size_t footAt = bytes.size() - sizeof foot;
    std::memcpy(&foot, &bytes[footAt], sizeof foot);
    foot.mark = octreeMark;
    if (foot.table < octreeStart || foot.table > footAt) {
        return;
    }
    for (std::size_t at = foot.table; sizeof(OctreeRow) <= footAt - at; at += sizeof(OctreeRow)) {
        OctreeRow row;
        std::memcpy(&row, &bytes[at], sizeof row);
        const std::size_t pointBytes =
            12 + (foot.columns[0] != 0 ? 4U : 0U) + (foot.columns[1] != 0 ? 3U : 0U) + (foot.columns[2] != 0 ? 1U : 0U);
        if (row.start <= foot.table && row.points * pointBytes <= foot.table - row.start) {
            row.digest = Hasher().bytes(&bytes[row.start], row.points * pointBytes).finish().bytes;
            std::memcpy(&bytes[at], &row, sizeof row);
        }
    }
    std::memcpy(&bytes[footAt], &foot, sizeof foot);
    foot.digest = Hasher().bytes(&bytes[foot.table], footAt - foot.table + offsetof(OctreeFoot, digest)).finish().bytes;
    std::memcpy(&bytes[footAt], &foot, sizeof foot);
}

}  // namespace rubble::io
