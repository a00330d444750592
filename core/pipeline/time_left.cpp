#include "core/pipeline/time_left.h"

#include <algorithm>

#include "core/base/unknown.h"

namespace rubble {

namespace {

constexpr double knownFrom = 0.02;       // of the stage: before, nothing is said
constexpr double knownUpTo = 0.99;       // likewise: something may come that the stage does not count
constexpr double secondsFrom = 1.0;      // s, likewise
constexpr double leastSaid = 0.5;        // s: less is no time to wait for
constexpr double misleadingTimes = 2.0;  // as much left as was said, and a second

}  // namespace

double TimeLeft::after(const Progress& progress, Clock::time_point now) {
    const double fraction = std::clamp(progress.fraction, 0.0, 1.0);
    if (!m_since || progress.stage.id != m_stage || fraction < m_first) {
        m_stage = progress.stage.id;
        m_first = fraction;
        m_since = now;
        m_said.reset();
    }
    const double spent = std::chrono::duration<double>(now - *m_since).count();
    const double did = fraction - m_first;
    if (did <= knownFrom || spent <= secondsFrom || fraction >= knownUpTo) {
        return unknown;
    }
    const double left = spent * (1.0 - fraction) / did;
    m_said = std::min(m_said.value_or(left), left);
    return *m_said < leastSaid || left > misleadingTimes * *m_said + 1.0 ? unknown : *m_said;
}

}  // namespace rubble
