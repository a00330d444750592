#pragma once

#include <string>

namespace rubble::io {

/// Turns the bits of one stored byte of a dataset round, in the middle of its first chunk.
void damageChunk(const std::string& path, const char* dataset);

}  // namespace rubble::io
