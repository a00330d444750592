#include "io/base/packed_rows.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <new>

namespace rubble::io {

namespace {

// Of libdeflate: as small as zlib's lowest.
constexpr int level = 1;

}  // namespace

PackedRows::PackedRows(const GrowingRows& rows, std::size_t numberBytes)
    : m_growing(rows),
      m_numberBytes(numberBytes),
      m_compressor(libdeflate_alloc_compressor(level)),
      m_chunk(rows.chunkRows * rows.rowBytes),
      m_planes(m_chunk.size()) {
    if (!m_compressor) {
        throw std::bad_alloc();
    }
    // Room for what does not get smaller: HDF5 1.10.8 does not read back a chunk that came to it packed, with a filter left out.
    m_packed.resize(libdeflate_zlib_compress_bound(m_compressor.get(), m_chunk.size()));
}

std::optional<std::string> PackedRows::append(hid_t dataset, hid_t type, hsize_t before, const void* rows, hsize_t count) {
    const auto* from = static_cast<const unsigned char*>(rows);
    std::optional<std::string> failure;
    while (count > 0 && !failure) {
        const hsize_t filled = before % m_growing.chunkRows;
        const hsize_t taken = std::min(count, m_growing.chunkRows - filled);
        std::memcpy(m_chunk.data() + filled * m_growing.rowBytes, from, taken * m_growing.rowBytes);
        const bool full = filled + taken == m_growing.chunkRows;
        failure = full ? writeChunk(dataset, before - filled) : m_growing.append(dataset, type, before, from, taken);
        from += taken * m_growing.rowBytes;
        before += taken;
        count -= taken;
    }
    return failure;
}

/// In place of what of it HDF5 holds.
std::optional<std::string> PackedRows::writeChunk(hid_t dataset, hsize_t first) {
    const std::size_t numbers = m_chunk.size() / m_numberBytes;
    for (std::size_t byte = 0; byte < m_numberBytes; ++byte) {
        for (std::size_t i = 0; i < numbers; ++i) {
            m_planes[byte * numbers + i] = m_chunk[i * m_numberBytes + byte];
        }
    }
    const std::size_t packed =
        libdeflate_zlib_compress(m_compressor.get(), m_planes.data(), m_planes.size(), m_packed.data(), m_packed.size());
    assert(packed > 0);
    const std::array<hsize_t, 2> begin{first, 0};
    const std::array<hsize_t, 2> extent{first + m_growing.chunkRows, m_growing.width};
    const bool written = H5Dset_extent(dataset, extent.data()) >= 0 &&
                         H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, begin.data(), packed, m_packed.data()) >= 0;
    return written ? std::nullopt : std::optional(hdf5Reason());
}

}  // namespace rubble::io
