#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace rubble::io {

/// Where the data of a classic netCDF file (CDF-1, -2 or -5) ends by its own header.
struct ClassicExtent {
    std::int64_t bytes = 0;        ///< size that the file must have at least
    std::string lastVariable;      ///< the variable that ends there
    std::int64_t recordCount = 0;  ///< states
    bool wholeHeader = true;       ///< false: the file ends inside its header
};

/// Reads the header of a classic netCDF file. The library itself gives zeros for data behind the end of a file, so a file that was
/// cut off must be found by its size. Nothing if the header makes no sense. Format: "The NetCDF Classic Format Specification".
/// Throws WorldError if the file cannot be read.
std::optional<ClassicExtent> classicExtent(const std::string& path);

}  // namespace rubble::io
