#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace rubble::io {

/// Where the numbers of a state stand in a file: one chunk of an HDF5 dataset.
struct ChunkPlace {
    std::int64_t address = 0;  ///< of its first byte
    std::int64_t bytes = 0;
    std::int64_t filtersLeftOut = 0;  ///< a bit each; the library leaves out deflate where it gains nothing
};

/// Reads chunks of numbers without the library that wrote them: shuffled and deflated, in single or double precision, little-endian
/// (HDF5 File Format Specification). Reading is from any thread, nothing waits for another, and no damage reaches the library,
/// which leaves objects open where it fails. The file may be replaced meanwhile: what was opened goes on being read.
class StateChunks {
public:
    /// Throws WorldError.
    explicit StateChunks(const std::string& path);
    ~StateChunks();
    StateChunks(const StateChunks&) = delete;
    StateChunks& operator=(const StateChunks&) = delete;

    /// Nothing where there is no such chunk, or one of another length.
    std::optional<std::vector<Vec3>> read(const ChunkPlace& place, std::size_t count) const;
    /// The same for numbers. False where there is no such chunk, or one of another length: what stands in `numbers` is then of no
    /// use.
    /// @param shuffled  false: the bytes of each number stand together
    bool read(const ChunkPlace& place, std::span<double> numbers, bool shuffled) const;

private:
    std::optional<std::vector<unsigned char>> bytesOf(const ChunkPlace& place, std::size_t numbers) const;

    int m_file = -1;
};

}  // namespace rubble::io
