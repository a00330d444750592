#pragma once

#include <mutex>

namespace rubble::io {

/// The one lock around HDF5, netCDF and Exodus II: none of the packaged libraries is thread-safe, and they share the HDF5 library's
/// global state. Held for single calls, never across a callback into code that is not io's.
inline std::recursive_mutex& nativeLibraries() {
    static std::recursive_mutex mutex;
    return mutex;
}

}  // namespace rubble::io
