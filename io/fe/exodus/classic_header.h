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
    std::int64_t fixedBytes = 0;   ///< where the last variable without states ends
    std::int64_t firstBytes = 0;   ///< where the first state ends; 0: there are no states
    std::int64_t stateBytes = 0;   ///< from the end of one state to that of the next

    /// States that lie whole in a file of this size; nothing where not even the mesh does.
    std::optional<std::int64_t> wholeStates(std::int64_t size) const;
};

/// Reads the header of a classic netCDF file. The library itself gives zeros for data behind the end of a file, so a file that was
/// cut off must be found by its size. Nothing if the header makes no sense. Format: "The NetCDF Classic Format Specification".
/// Throws WorldError if the file cannot be read.
std::optional<ClassicExtent> classicExtent(const std::string& path);

}  // namespace rubble::io
