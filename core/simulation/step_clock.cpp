#include "core/simulation/step_clock.h"

#include <algorithm>
#include <numeric>

namespace rubble {

void StepClock::add(Instant from, double dt) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
    m_milliseconds.push_back(1000.0 * seconds);
    m_simulated += dt;
    m_inTime += seconds < dt;
}

StepTimes StepClock::times() const {
    StepTimes times;
    if (m_milliseconds.empty()) {
        return times;
    }
    std::vector<double> sorted = m_milliseconds;
    std::sort(sorted.begin(), sorted.end());
    const auto count = static_cast<double>(sorted.size());
    times.meanMs = std::accumulate(sorted.begin(), sorted.end(), 0.0) / count;
    times.p95Ms = sorted[static_cast<std::size_t>(0.95 * (count - 1.0))];
    times.worstMs = sorted.back();
    times.shareInTime = static_cast<double>(m_inTime) / count;
    const double wall = std::chrono::duration<double>(m_last - m_first).count();
    times.realTimeFactor = wall > 0.0 ? m_simulated / wall : 0.0;
    return times;
}

}  // namespace rubble
