#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "core/analysis/accuracy/run_time_left.h"
#include "core/pipeline/time_left.h"
#include "widgets/views/frame_meter.h"

namespace rubble {

class Computation;
class Document;
class Session;
class PanelDeck;
class Playback;
namespace widgets {
class StatusLine;
}

/// Feeds the status line: what runs and how long it still takes, live and playback frames per second, bodies, memory.
class StatusFeed : public QObject {
    Q_OBJECT

public:
    StatusFeed(Session& session, Playback& playback, const PanelDeck& deck, widgets::StatusLine& line, QObject* parent = nullptr);

    double liveMean() const { return m_kept.live.mean(); }
    double liveWorst() const { return m_kept.live.worstSecond(); }
    double playbackRecent() const;
    /// Shows all figures as of now.
    void refresh();

private:
    /// What outlives the window.
    struct Kept {
        Kept() { clock.start(); }
        widgets::FrameMeter live;
        widgets::FrameMeter shown;
        QElapsedTimer clock;
        QElapsedTimer sinceStart;  ///< of what runs
        double lastFraction = 0.0;
        TimeLeft left;
        const void* run = nullptr;  ///< that `ofRun` tells of
        RunTimeLeft ofRun;
    };
    double now() const { return static_cast<double>(m_kept.clock.nsecsElapsed()) * 1e-9; }
    /// s; not a number while nothing can be said.
    double secondsLeft(double fraction, double spent);
    void showProgress(const QString& what, double fraction);
    void showBodies();
    void showFindings();
    void showHealth();

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    Playback& m_playback;
    const PanelDeck& m_deck;
    widgets::StatusLine& m_line;
    Kept& m_kept;
    QTimer m_timer;
};

/// Resident memory of this process, bytes; 0 if the system does not say.
std::int64_t residentMemory();

}  // namespace rubble
