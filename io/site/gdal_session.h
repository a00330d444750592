#pragma once

#include <mutex>
#include <string>

#include "io/base/native_lock.h"

namespace rubble::io {

/// While it lives, GDAL belongs to this thread, prints no errors and keeps the last one.
class GdalSession {
public:
    GdalSession();
    ~GdalSession();
    GdalSession(const GdalSession&) = delete;
    GdalSession& operator=(const GdalSession&) = delete;

    /// Why the last call failed, in GDAL's words.
    static std::string reason();

private:
    std::scoped_lock<std::recursive_mutex> m_lock;
};

}  // namespace rubble::io
