#include "io/fe/exodus/library_lock.h"

#include <hdf5.h>

#include <type_traits>

namespace rubble::io {

static_assert(std::is_same_v<H5E_auto2_t, int (*)(long, void*)>, "the header keeps HDF5's types out");

LibraryLock::LibraryLock() : m_lock(nativeLibraries()) {
    H5Eget_auto2(H5E_DEFAULT, &m_printer, &m_printerData);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

LibraryLock::~LibraryLock() {
    H5Eset_auto2(H5E_DEFAULT, m_printer, m_printerData);
}

}  // namespace rubble::io
