#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace rubble::widgets {

/// The time in large figures and the buttons that move it. Knows no clock: emits what the user asks for.
class Transport : public QWidget {
    Q_OBJECT

public:
    explicit Transport(QWidget* parent = nullptr);

    void setTime(double time);
    /// @param last   s, the latest instant that can be shown
    /// @param feEnd  s, end of the FE result
    /// @param looseBodies  there is none: it is when the last body of a table is let go
    void setSpan(double last, double feEnd, bool looseBodies = false);
    void setPlaying(bool playing);
    void setRate(double rate);
    void setAvailable(bool available);
    /// @param backwards  playback goes back in time
    void setBackwards(bool backwards);
    void setLooping(bool looping);
    /// Times are shown counted from here [s].
    void setTimeOrigin(double origin);

signals:
    void playToggled();
    void stepped(int states);
    void jumpedToFirst();
    void jumpedToLast();
    void ratePicked(double rate);
    void playBackToggled();
    void loopToggled(bool loop);
    void bookmarkRequested();

private:
    static double usualRate();
    void offerRates();

    QLabel* m_time;
    QLabel* m_span;
    QToolButton* m_play;
    QToolButton* m_playBack;
    QToolButton* m_loop;
    QComboBox* m_rate;
    double m_origin = 0.0;
    double m_shown = 0.0;
    double m_last = 0.0;
    double m_feEnd = 0.0;
    double m_offered = 1.0;  // the rate that the list is made around
    bool m_playing = false;
    bool m_backwards = false;
};

}  // namespace rubble::widgets
