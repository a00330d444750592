#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "app/gui/session/worker.h"
#include "core/evidence/maps/motion_history.h"
#include "widgets/views/history_chart.h"

class QDockWidget;

namespace rubble {

class Computation;
class Playback;
class SelectionDisplay;
class Session;
class ViewArea;
namespace widgets {
class HistoryPanel;
}

/// Speed, height and energy over time of the fragments that are selected, or of all of them. Reads the run in the background, and
/// only while its dock is open.
class HistoryDisplay : public QObject {
    Q_OBJECT

public:
    HistoryDisplay(Session& session, Playback& playback, ViewArea& area, SelectionDisplay& selection, widgets::HistoryPanel& panel,
                   QDockWidget& dock, QObject* parent = nullptr);

    widgets::HistoryPanel& panel() { return m_panel; }
    /// The run is being read.
    bool reading() const { return m_reading; }
    void refresh();

private:
    /// What the curves are of.
    struct Order {
        std::shared_ptr<const FragmentSet> fragments;
        std::shared_ptr<const TrajectoryReader> trajectory;
        std::size_t frames = 0;
        std::vector<FragmentId> which;

        friend bool operator==(const Order&, const Order&) = default;
    };
    Order orderNow() const;
    QString whyNot() const;
    QString subjectOf(const std::vector<FragmentId>& which) const;
    void show();
    void showTime(double time);

    Computation& m_computation;
    Playback& m_playback;
    ViewArea& m_area;
    SelectionDisplay& m_selection;
    widgets::HistoryPanel& m_panel;
    QDockWidget& m_dock;
    Order m_order;
    widgets::HistoryChart::Content m_content;
    bool m_reading = false;
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
