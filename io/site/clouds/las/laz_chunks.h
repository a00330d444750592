#pragma once

#include <cstdint>
#include <vector>

#include "core/base/finding.h"
#include "io/site/clouds/las/las_head.h"
#include "io/site/clouds/las/laz_layers.h"

namespace rubble::io {

/// How the points of a LAZ are packed, from its record of LASzip.
struct LazPacking {
    bool layered = false;
    bool chunked = false;
    std::uint64_t chunkPoints = 0;  ///< in each chunk but the last; 0: the table says it of each
    LazLayers::Turns turns = LazLayers::Turns::Item4;
};

/// Throws ParseError for a packing that is not known, naming it.
LazPacking readLazPacking(const CloudFile& file, const LasHead& head);

/// Points packed together, which need nothing of others.
struct LazChunk {
    std::uint64_t start = 0;
    std::uint64_t end = 0;
    std::uint64_t points = 0;
};

/// The chunks of a file, from the table behind them. Empty where the table is missing or cannot be: then they are read one after
/// another, which is a finding. Throws ParseError where they cannot be.
std::vector<LazChunk> readLazChunks(const CloudFile& file, const LasHead& head, const LazPacking& packing, Findings& findings);

}  // namespace rubble::io
