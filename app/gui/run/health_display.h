#pragma once

#include <QObject>

#include "core/base/geometry.h"

namespace rubble {

class Computation;
class Session;
class PanelDeck;
class Playback;
class ViewArea;
namespace widgets {
class Timeline;
}

/// Shows the health of the last run on the timeline and in the Run panel, leads to the instant and the body of a breach, and passes
/// an acknowledgement on.
class HealthDisplay : public QObject {
    Q_OBJECT

public:
    HealthDisplay(Session& session, PanelDeck& deck, Playback& playback, ViewArea& area, widgets::Timeline& timeline,
                  QObject* parent = nullptr);

    /// Shows what is known now.
    void refresh();
    /// Goes to a breach: its instant, and in the views its body in the accent colour.
    /// @param near  also brings the cameras to the body
    void show(std::size_t breach, bool near);

private:
    /// The breaches that are known, also of a run that goes on.
    void showMarks();
    /// m, of the local frame.
    Vec3 origin() const;
    void acknowledged(const QString& complaint);
    void clearSelection();

    Session& m_session;
    Computation& m_computation;
    PanelDeck& m_deck;
    Playback& m_playback;
    ViewArea& m_area;
    widgets::Timeline& m_timeline;
};

}  // namespace rubble
