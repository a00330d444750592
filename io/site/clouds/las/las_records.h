#pragma once

#include <cstddef>

#include "io/site/clouds/cloud_block.h"
#include "io/site/clouds/las/las_head.h"

namespace rubble::io {

/// The columns that points of a format fill.
CloudColumns lasColumns(const LasHead& head);

/// What the head of a LAS or LAZ says, in the words of every cloud: version, columns, scale, bounds and coordinate system.
void describeLas(const CloudFile& file, const LasHead& las, CloudHead& head);

/// Reads records of points as they lie in a LAS file into a block, which they fill.
/// @param records  [count * head.recordBytes]
void decodeLasRecords(const LasHead& head, const unsigned char* records, std::size_t count, CloudBlock& block);

}  // namespace rubble::io
