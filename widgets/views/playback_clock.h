#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>
#include <utility>

#include "widgets/views/picture_turn.h"

namespace rubble::widgets {

/// The one clock of the window: views and timeline follow it, none of them owns time. Plays between `first` and `last` at a rate,
/// forwards or backwards, once or round a range.
class PlaybackClock : public QObject {
    Q_OBJECT

public:
    explicit PlaybackClock(QObject* parent = nullptr);

    /// Input goes before its ticks.
    const PictureTurn& turn() const { return m_turn; }
    double time() const { return m_time; }  ///< s
    double first() const { return m_first; }
    double last() const { return m_last; }
    bool playing() const { return m_timer.isActive(); }
    double rate() const { return m_rate; }
    bool backwards() const { return m_backwards; }
    /// s; unset: playback ends where the range ends.
    const std::optional<std::pair<double, double>>& loop() const { return m_loop; }

    /// Sets what may be shown [s]; the time is kept inside.
    void setRange(double first, double last);
    /// While something is being computed, playback waits at the newest instant [s] for more; scrubbing may go beyond.
    void setNewest(std::optional<double> newest) { m_newest = newest; }
    void setTime(double time);
    void setRate(double rate);
    /// Playback goes round in this range [s]; one without length is none.
    void setLoop(std::optional<std::pair<double, double>> range);
    void play(bool backwards = false);
    void pause();
    void toggle();
    /// Moves the time on by so many seconds of wall clock; what the timer does at every tick.
    void advance(double wallSeconds);

signals:
    void timeChanged(double time);
    void playingChanged(bool playing);
    void rateChanged(double rate);
    void rangeChanged(double first, double last);
    void loopChanged();

private:
    /// Where playback turns over [s]: the loop inside what may be shown.
    std::pair<double, double> round() const;

    QTimer m_timer;
    PictureTurn m_turn;
    QElapsedTimer m_wall;
    double m_time = 0.0;
    double m_first = 0.0;
    double m_last = 0.0;
    double m_rate = 1.0;
    bool m_backwards = false;
    std::optional<std::pair<double, double>> m_loop;
    std::optional<double> m_newest;
};

}  // namespace rubble::widgets
