#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "core/base/execution.h"

namespace rubble {

/// How long a piece of work still takes, from how far it has got since its stage began. What was said does not grow, and nothing is
/// said where that would mislead: at the beginning, where all seems done, and where far more is left than was said.
class TimeLeft {
public:
    using Clock = std::chrono::steady_clock;

    void restart() { *this = {}; }
    /// Seconds; NaN: nothing can be said. A stage that begins, or begins again, starts its own clock.
    double after(const Progress& progress, Clock::time_point now = Clock::now());

private:
    std::optional<Clock::time_point> m_since;
    std::string m_stage;
    double m_first = 0.0;
    std::optional<double> m_said;  ///< s
};

}  // namespace rubble
