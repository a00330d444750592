#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace rubble::widgets {

/// The one clock of the window: views and timeline follow it, none of them owns time. Plays between `first` and `last` at a rate;
/// `last` may grow while playing (then it waits at the newest instant instead of stopping).
class PlaybackClock : public QObject {
    Q_OBJECT

public:
    explicit PlaybackClock(QObject* parent = nullptr);

    double time() const { return m_time; }  ///< s
    double first() const { return m_first; }
    double last() const { return m_last; }
    bool playing() const { return m_timer.isActive(); }
    double rate() const { return m_rate; }

    /// Sets what may be shown [s]; the time is kept inside.
    void setRange(double first, double last);
    /// While growing, playback waits at `last` for more.
    void setGrowing(bool growing) { m_growing = growing; }
    void setTime(double time);
    void setRate(double rate);
    void play();
    void pause();
    void toggle();
    /// Moves the time on by so many seconds of wall clock; what the timer does at every tick.
    void advance(double wallSeconds);

signals:
    void timeChanged(double time);
    void playingChanged(bool playing);
    void rateChanged(double rate);
    void rangeChanged(double first, double last);

private:
    QTimer m_timer;
    QElapsedTimer m_wall;
    double m_time = 0.0;
    double m_first = 0.0;
    double m_last = 0.0;
    double m_rate = 1.0;
    bool m_growing = false;
};

}  // namespace rubble::widgets
