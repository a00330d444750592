#pragma once

#include <mutex>

#include "io/base/native_lock.h"

namespace rubble::io {

/// Holds the one lock around HDF5, netCDF and Exodus, and keeps HDF5 from printing its errors: it would do so anew on every thread.
class LibraryLock {
public:
    LibraryLock();
    ~LibraryLock();
    LibraryLock(const LibraryLock&) = delete;
    LibraryLock& operator=(const LibraryLock&) = delete;

private:
    using Printer = int (*)(long, void*);  ///< HDF5's callback

    std::lock_guard<std::recursive_mutex> m_lock;
    Printer m_printer = nullptr;
    void* m_printerData = nullptr;
};

}  // namespace rubble::io
