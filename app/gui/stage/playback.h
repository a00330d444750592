#pragma once

#include <QObject>
#include <optional>
#include <utility>
#include <vector>

#include "widgets/views/playback_clock.h"

namespace rubble {

class Actions;
class Computation;
class Session;
namespace widgets {
class Timeline;
class Transport;
class ViewWidget;
}  // namespace widgets

/// Brings the one clock together with timeline, transport and views, follows a run as it grows, and in live mode its newest frame.
class Playback : public QObject {
    Q_OBJECT

public:
    Playback(Session& session, widgets::ViewWidget& view, widgets::Timeline& timeline, widgets::Transport& transport,
             Actions& actions, QObject* parent = nullptr);

    widgets::PlaybackClock& clock() { return m_clock; }
    /// Another result was opened: starts at its first state.
    void reset();
    /// Pauses and goes to an instant, s.
    void showInstant(double time);
    /// Shows in a new window what an earlier one showed.
    void goOn();
    /// What can be shown has changed.
    void refresh(bool runStale);
    void step(int states);
    void jumpToFirst();
    void jumpToLast();
    void toggle();
    void scrub(double time);
    /// Backwards from here on, or stops that.
    void toggleBackwards();
    /// Playback goes round: the range that was set, else all there is.
    void setLooping(bool loop);
    bool looping() const { return m_kept.looping; }
    /// The range that playback goes round [s]; one without length is all there is.
    void setLoopRange(double from, double to);
    const std::optional<std::pair<double, double>>& loopRange() const { return m_kept.loopRange; }
    /// Scrubbing stops at the nearest state or frame.
    void setSnapping(bool snap) { m_kept.snapping = snap; }
    /// Times are shown counted from the first state rather than as the file has them.
    void setFromZero(bool fromZero);
    /// s, on the file's clock: what shown times count from.
    double timeOrigin() const;
    /// Live mode: the views show the newest frame as it comes.
    bool following() const { return m_kept.following; }
    /// The views are seen: something else may stand in front of them.
    bool picturesSeen() const;

signals:
    /// A frame was shown while playing (by its name: playback) or following a live run.
    void frameShown(bool live);
    void loopChanged();

private:
    /// What outlives the window.
    struct Kept {
        widgets::PlaybackClock clock;
        bool following = false;
        bool runStale = false;
        bool looping = false;
        std::optional<std::pair<double, double>> loopRange;
        bool snapping = false;
        bool fromZero = false;
    };
    void runReopened();
    void runBegun();
    void runGrew(double time);
    void runEnded();
    void shown(double time);
    void leaveLive();
    std::vector<double> stops() const;
    void connectActions(Actions& actions);
    void showLoop();
    void showDeaths();
    void showIslands();

    Computation& m_computation;
    widgets::ViewWidget& m_view;
    widgets::Timeline& m_timeline;
    widgets::Transport& m_transport;
    Kept& m_kept;
    widgets::PlaybackClock& m_clock;
    widgets::PictureTurn m_growth;  ///< of a run that is followed
};

}  // namespace rubble
