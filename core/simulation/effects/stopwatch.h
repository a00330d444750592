#pragma once

#include <chrono>

#include "core/base/elapsed.h"

namespace rubble {

/// Adds the wall time of its scope to a sum [s]. What it says never reaches a trajectory.
class Stopwatch {
public:
    explicit Stopwatch(double& seconds) : m_seconds(seconds), m_from(std::chrono::steady_clock::now()) {}
    ~Stopwatch() { m_seconds += secondsSince(m_from); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

private:
    double& m_seconds;
    std::chrono::steady_clock::time_point m_from;
};

}  // namespace rubble
