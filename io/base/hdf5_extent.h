#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rubble::io {

/// By which every HDF5 file begins that has no block of its user before it. "HDF5 File Format Specification", superblock.
inline constexpr std::string_view hdf5Signature{"\x89HDF\r\n\x1a\n", 8};

/// Where an HDF5 file ends by its own first block, in bytes; so a file that was cut off is told without the library's help. Nothing
/// if the block has another layout or does not say: the library judges such a file. "HDF5 File Format Specification", superblock
/// versions 0 to 3. Throws ParseError if the file ends within the block, WorldError if it cannot be read.
std::optional<std::uint64_t> hdf5End(const std::string& path);

/// Throws ParseError if a file is shorter than it says; else as hdf5End().
void requireWholeHdf5(const std::string& path);

}  // namespace rubble::io
