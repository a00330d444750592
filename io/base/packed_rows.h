#pragma once

#include <hdf5.h>
#include <libdeflate.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/base/hdf5_rows.h"

namespace rubble::io {

/// Puts rows behind those of a dataset and packs each chunk once it is full, by a library that takes less than half of the time of
/// the one within HDF5. What lies in the file is the same to every reader (HDF5 File Format Specification: filters shuffle, then
/// deflate). A chunk that is not full yet is left to HDF5, where readers of the same process find it at once.
/// The caller holds an Hdf5Session.
class PackedRows {
public:
    /// @param numberBytes  of each number in a row
    PackedRows(const GrowingRows& rows, std::size_t numberBytes);

    /// Returns why the library could not; nothing if it could. All rows of the dataset come through here, in order.
    /// @param type  of one number in memory, the same as in the file. @param before  rows that are there
    std::optional<std::string> append(hid_t dataset, hid_t type, hsize_t before, const void* rows, hsize_t count);

private:
    struct Free {
        void operator()(libdeflate_compressor* own) const { libdeflate_free_compressor(own); }
    };
    std::optional<std::string> writeChunk(hid_t dataset, hsize_t first);

    GrowingRows m_growing;
    std::size_t m_numberBytes;
    std::unique_ptr<libdeflate_compressor, Free> m_compressor;
    std::vector<unsigned char> m_chunk;   ///< as it is
    std::vector<unsigned char> m_planes;  ///< shuffled
    std::vector<unsigned char> m_packed;
};

}  // namespace rubble::io
