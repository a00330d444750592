#pragma once

#include <QObject>
#include <vector>

#include "widgets/playback_clock.h"

namespace rubble {

class Computation;
namespace widgets {
class Timeline;
class Transport;
class ViewWidget;
}  // namespace widgets

/// Brings the one clock together with timeline, transport and views, follows a run as it grows, and in live mode its newest frame.
class Playback : public QObject {
    Q_OBJECT

public:
    Playback(Computation& computation, widgets::ViewWidget& view, widgets::Timeline& timeline, widgets::Transport& transport,
             QObject* parent = nullptr);

    widgets::PlaybackClock& clock() { return m_clock; }
    /// Another result was opened: starts at its first state.
    void reset();
    /// What can be shown has changed.
    void refresh(bool runStale);
    void step(int states);
    void jumpToFirst();
    void jumpToLast();
    void toggle();
    void scrub(double time);
    /// Live mode: the views show the newest frame as it comes.
    bool following() const { return m_following; }

signals:
    /// A frame was shown while playing (by its name: playback) or following a live run.
    void frameShown(bool live);

private:
    void runBegun();
    void runGrew(double time);
    void runEnded();
    void shown(double time);
    void leaveLive();
    std::vector<double> stops() const;

    Computation& m_computation;
    widgets::ViewWidget& m_view;
    widgets::Timeline& m_timeline;
    widgets::Transport& m_transport;
    widgets::PlaybackClock m_clock;
    bool m_following = false;
    bool m_runStale = false;
};

}  // namespace rubble
