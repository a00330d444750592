#include "app/gui/session/watched_sink.h"

#include <algorithm>
#include <cmath>

namespace rubble {

bool LivePace::isNext(double time) {
    const std::lock_guard lock(m_mutex);
    const double from = m_last ? m_firstTime : time;
    // A step ends a little before or after its frame's time.
    const auto index = static_cast<std::int64_t>(std::floor((time - from) / m_interval + 1e-6));
    if (m_last && index <= m_lastIndex) {
        return false;
    }
    m_lastIndex = index;
    return true;
}

void LivePace::waitFor(double time, const Execution& execution) {
    std::unique_lock lock(m_mutex);
    if (!m_last) {
        m_start = Clock::now();
        m_firstTime = time;
    } else {
        const auto patience = Clock::now() + std::chrono::milliseconds(500);
        while (m_shown < *m_last && !execution.cancelled() && Clock::now() < patience) {
            m_wake.wait_for(lock, std::chrono::milliseconds(20));
        }
    }
    m_last = time;
    auto due = m_start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time - m_firstTime));
    // What is lost is lost: a stall is not made up for by running faster than the collapse.
    if (const auto late = Clock::now() - due; late > std::chrono::milliseconds(100)) {
        m_start += late;
        due += late;
    }
    while (Clock::now() < due && !execution.cancelled()) {
        m_wake.wait_until(lock, std::min(due, Clock::now() + std::chrono::milliseconds(50)));
    }
}

void LivePace::shown(double time) {
    {
        const std::lock_guard lock(m_mutex);
        m_shown = std::max(m_shown, time);
    }
    m_wake.notify_all();
}

WatchedSink::WatchedSink(TrajectorySink& inner, Listener listener, std::shared_ptr<LivePace> pace, Execution execution)
    : SinkRelay(&inner), m_listener(std::move(listener)), m_pace(std::move(pace)), m_execution(std::move(execution)) {}

void WatchedSink::begin(const RunDescription& description) {
    SinkRelay::begin(description);
    m_listener.begun(description);
}

void WatchedSink::commit(const TrajectoryFrame& frame) {
    // Waiting before the frame is handed on lets the next one be simulated while this one is drawn.
    const bool live = m_pace != nullptr && m_pace->isNext(frame.time);
    if (live) {
        m_pace->waitFor(frame.time, m_execution);
    }
    SinkRelay::commit(frame);
    m_listener.committed(frame.time, live);
}

}  // namespace rubble
