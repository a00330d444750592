#pragma once

#include <chrono>
#include <vector>

#include "core/simulation/run/simulation.h"

namespace rubble {

class Archive;

/// Measures steps on the wall clock while births go on. What it says never reaches a trajectory.
class StepClock {
public:
    using Instant = std::chrono::steady_clock::time_point;

    void start() { m_first = std::chrono::steady_clock::now(); }
    /// Adds one step of dt [s] that began at `from`.
    void add(Instant from, double dt);
    /// The last birth has passed.
    void stop() { m_last = std::chrono::steady_clock::now(); }
    StepTimes times() const;
    /// What was measured so far; a clock that goes on elsewhere leaves out the time between.
    void keep(Archive& archive);

private:
    Instant m_first{};
    Instant m_last{};
    double m_simulated = 0.0;
    std::vector<double> m_milliseconds;
    std::size_t m_inTime = 0;
};

}  // namespace rubble
