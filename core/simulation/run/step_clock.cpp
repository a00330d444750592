#include "core/simulation/run/step_clock.h"

#include <algorithm>
#include <numeric>

#include "core/base/archive.h"
#include "core/base/elapsed.h"

namespace rubble {

void StepClock::add(Instant from, double dt) {
    const double seconds = secondsSince(from);
    m_milliseconds.push_back(1000.0 * seconds);
    m_simulated += dt;
    m_inTime += seconds < dt;
}

void StepClock::keep(Archive& archive) {
    using Seconds = std::chrono::duration<double>;
    const Instant now = std::chrono::steady_clock::now();
    // Instants mean something in one process only; until the last birth the last one is none yet.
    const bool started = m_first != Instant{};
    const bool stopped = m_last != Instant{};
    double sinceFirst = started ? Seconds(now - m_first).count() : -1.0;
    double sinceLast = stopped ? Seconds(now - m_last).count() : -1.0;
    archive(sinceFirst, sinceLast, m_simulated, m_milliseconds, m_inTime);
    if (archive.reading()) {
        const auto before = [now](double seconds) {
            return seconds < 0.0 ? Instant{} : now - std::chrono::duration_cast<Instant::duration>(Seconds(seconds));
        };
        m_first = before(sinceFirst);
        m_last = before(sinceLast);
    }
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
