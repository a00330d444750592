#pragma once

#include <chrono>

namespace rubble {

/// s of wall clock since an instant.
inline double secondsSince(std::chrono::steady_clock::time_point from) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

}  // namespace rubble
