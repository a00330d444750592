#pragma once

#include <hdf5.h>

#include <optional>
#include <string>

#include "io/base/hdf5_handle.h"

namespace rubble::io {

/// How a dataset of rows that only grows lies in its file. The caller holds an Hdf5Session.
struct GrowingRows {
    hsize_t width = 0;      ///< numbers in a row; 0: a plain list
    hsize_t chunkRows = 1;  ///< rows compressed together
    std::size_t rowBytes = 1;

    /// Makes the dataset, without rows, with the groups above it. Not valid if the library could not.
    Hdf5Handle make(hid_t file, const char* path, hid_t type) const;
    /// Opens it, with room for the chunk that is being filled. Not valid if the library could not.
    Hdf5Handle open(hid_t file, const char* path) const;
    /// Puts rows behind those that are there. Returns why the library could not; nothing if it could.
    /// @param type  of one number in memory. @param before  rows that are there
    std::optional<std::string> append(hid_t dataset, hid_t type, hsize_t before, const void* rows, hsize_t count) const;

private:
    int rank() const { return width > 0 ? 2 : 1; }
};

}  // namespace rubble::io
