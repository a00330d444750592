#include "widgets/playback_clock.h"

#include <algorithm>

namespace rubble::widgets {

PlaybackClock::PlaybackClock(QObject* parent) : QObject(parent) {
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(12);
    connect(&m_timer, &QTimer::timeout, this, [this] { advance(static_cast<double>(m_wall.nsecsElapsed()) * 1e-9); });
}

void PlaybackClock::setRange(double first, double last) {
    last = std::max(first, last);
    if (first == m_first && last == m_last) {
        return;
    }
    m_first = first;
    m_last = last;
    emit rangeChanged(first, last);
    setTime(m_time);
}

void PlaybackClock::setTime(double time) {
    time = std::clamp(time, m_first, m_last);
    if (time != m_time) {
        m_time = time;
        emit timeChanged(time);
    }
}

void PlaybackClock::setRate(double rate) {
    if (rate > 0.0 && rate != m_rate) {
        m_rate = rate;
        emit rateChanged(rate);
    }
}

void PlaybackClock::play() {
    if (playing() || m_last <= m_first) {
        return;
    }
    if (m_time >= m_last && !m_newest) {
        setTime(m_first);
    }
    m_wall.start();
    m_timer.start();
    emit playingChanged(true);
}

void PlaybackClock::pause() {
    if (playing()) {
        m_timer.stop();
        emit playingChanged(false);
    }
}

void PlaybackClock::toggle() {
    playing() ? pause() : play();
}

void PlaybackClock::advance(double wallSeconds) {
    m_wall.start();
    double next = m_time + m_rate * wallSeconds;
    if (m_newest) {
        next = std::max(m_time, std::min(next, *m_newest));
    }
    setTime(next);
    if (m_time >= m_last && !m_newest) {
        pause();
    }
}

}  // namespace rubble::widgets
