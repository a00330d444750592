#include "widgets/views/playback_clock.h"

#include <algorithm>
#include <cmath>

namespace rubble::widgets {

PlaybackClock::PlaybackClock(QObject* parent) : QObject(parent) {
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(12);
    connect(&m_timer, &QTimer::timeout, &m_turn, &PictureTurn::ask);
    connect(&m_turn, &PictureTurn::due, this, [this] { advance(static_cast<double>(m_wall.nsecsElapsed()) * 1e-9); });
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

void PlaybackClock::setLoop(std::optional<std::pair<double, double>> range) {
    if (range && !(range->second > range->first)) {
        range.reset();
    }
    if (range != m_loop) {
        m_loop = range;
        emit loopChanged();
    }
}

std::pair<double, double> PlaybackClock::round() const {
    if (!m_loop) {
        return {m_first, m_last};
    }
    const double from = std::clamp(m_loop->first, m_first, m_last);
    return {from, std::clamp(m_loop->second, from, m_last)};
}

void PlaybackClock::play(bool backwards) {
    if (m_last <= m_first || (playing() && backwards == m_backwards)) {
        return;
    }
    m_backwards = backwards;
    const auto [from, to] = round();
    const bool outside = m_loop && (m_time < from || m_time > to);
    if (!backwards && ((m_time >= to && !m_newest) || outside)) {
        setTime(from);
    } else if (backwards && (m_time <= from || outside)) {
        setTime(to);
    }
    m_wall.start();
    m_timer.start();
    emit playingChanged(true);
}

void PlaybackClock::pause() {
    if (playing()) {
        m_timer.stop();
        m_turn.drop();
        emit playingChanged(false);
    }
}

void PlaybackClock::toggle() {
    playing() ? pause() : play();
}

void PlaybackClock::advance(double wallSeconds) {
    m_wall.start();
    const auto [from, to] = round();
    double next = m_time + (m_backwards ? -m_rate : m_rate) * wallSeconds;
    if (m_loop && to > from && (next > to || next < from)) {
        // What goes beyond one end comes in at the other.
        next = m_backwards ? to - std::fmod(from - next, to - from) : from + std::fmod(next - from, to - from);
    }
    if (m_newest && !m_backwards) {
        next = std::max(std::min(m_time, next), std::min(next, *m_newest));
    }
    setTime(next);
    if (!m_loop && ((m_backwards && m_time <= m_first) || (!m_backwards && m_time >= m_last && !m_newest))) {
        pause();
    }
}

}  // namespace rubble::widgets
