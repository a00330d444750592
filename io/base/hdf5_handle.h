#pragma once

#include <hdf5.h>

#include <string>
#include <utility>

#include "io/base/native_lock.h"

namespace rubble::io {

/// Owns an HDF5 identifier and closes it, under the lock of the native libraries.
class Hdf5Handle {
public:
    using Close = herr_t (*)(hid_t);

    Hdf5Handle() = default;
    Hdf5Handle(hid_t id, Close close) : m_id(id), m_close(close) {}
    ~Hdf5Handle() { reset(); }
    Hdf5Handle(Hdf5Handle&& other) noexcept : m_id(std::exchange(other.m_id, H5I_INVALID_HID)), m_close(other.m_close) {}
    Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
        if (this != &other) {
            reset();
            m_id = std::exchange(other.m_id, H5I_INVALID_HID);
            m_close = other.m_close;
        }
        return *this;
    }

    hid_t get() const { return m_id; }
    bool valid() const { return m_id >= 0; }
    /// Closes now. Returns false if the library could not.
    bool reset() {
        const hid_t id = std::exchange(m_id, H5I_INVALID_HID);
        if (id < 0) {
            return true;
        }
        const std::scoped_lock lock(nativeLibraries());
        return m_close(id) >= 0;
    }

private:
    hid_t m_id = H5I_INVALID_HID;
    Close m_close = nullptr;
};

/// Holds the lock of the native libraries and keeps HDF5 from printing its errors, for as long as it lives.
class Hdf5Session {
public:
    Hdf5Session();
    ~Hdf5Session();
    Hdf5Session(const Hdf5Session&) = delete;
    Hdf5Session& operator=(const Hdf5Session&) = delete;

private:
    std::unique_lock<std::recursive_mutex> m_lock;
    H5E_auto2_t m_print = nullptr;
    void* m_printData = nullptr;
};

/// Why the last HDF5 call of this thread failed, for people: the operating system's reason if there is one ("No space left on
/// device"), else the library's own. To be called before any other HDF5 call.
std::string hdf5Reason();

}  // namespace rubble::io
