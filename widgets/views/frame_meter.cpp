#include "widgets/views/frame_meter.h"

#include <algorithm>
#include <cmath>

namespace rubble::widgets {

void FrameMeter::reset() {
    *this = FrameMeter();
}

void FrameMeter::closeSeconds(double instant) {
    const long second = static_cast<long>(std::floor(instant - m_first));
    while (m_second < second) {
        m_worst = m_worst < 0 ? m_inSecond : std::min(m_worst, m_inSecond);
        m_inSecond = 0;
        ++m_second;
    }
}

void FrameMeter::frame(double instant) {
    if (m_frames == 0) {
        m_first = instant;
    }
    closeSeconds(instant);
    m_last = instant;
    ++m_frames;
    ++m_inSecond;
    m_recent.push_back(instant);
    while (m_recent.front() < instant - 1.0) {
        m_recent.pop_front();
    }
}

double FrameMeter::recent(double now) const {
    const auto from = std::lower_bound(m_recent.begin(), m_recent.end(), now - 1.0);
    const auto count = static_cast<double>(m_recent.end() - from);
    // A clock that has just started covers less than a second.
    const double covered = std::min(1.0, now - m_first);
    return count < 2.0 || covered <= 0.0 ? 0.0 : (count - (covered < 1.0 ? 1.0 : 0.0)) / covered;
}

double FrameMeter::mean() const {
    return m_frames < 2 || m_last <= m_first ? 0.0 : static_cast<double>(m_frames - 1) / (m_last - m_first);
}

double FrameMeter::worstSecond() const {
    return m_worst < 0 ? mean() : static_cast<double>(m_worst);
}

}  // namespace rubble::widgets
