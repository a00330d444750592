#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "widgets/frame_meter.h"

namespace rubble {

class Computation;
class Document;
class Playback;
namespace widgets {
class StatusLine;
}

/// Feeds the status line: what runs and how long it still takes, live and playback frames per second, bodies, memory.
class StatusFeed : public QObject {
    Q_OBJECT

public:
    StatusFeed(Document& document, Computation& computation, Playback& playback, widgets::StatusLine& line,
               QObject* parent = nullptr);

    double liveMean() const { return m_live.mean(); }
    double liveWorst() const { return m_live.worstSecond(); }
    double playbackRecent() const;
    /// Shows all figures as of now.
    void refresh();

private:
    double now() const { return static_cast<double>(m_clock.nsecsElapsed()) * 1e-9; }
    void showProgress(const QString& what, double fraction);
    void showBodies();
    void showFindings();
    void showHealth();

    Document& m_document;
    Computation& m_computation;
    Playback& m_playback;
    widgets::StatusLine& m_line;
    widgets::FrameMeter m_live;
    widgets::FrameMeter m_shown;
    QElapsedTimer m_clock;
    QElapsedTimer m_sinceStart;
    double m_lastFraction = 0.0;
    QTimer m_timer;
};

/// Resident memory of this process, bytes; 0 if the system does not say.
std::int64_t residentMemory();

}  // namespace rubble
