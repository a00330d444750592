#include "app/gui/views/history_display.h"

#include <QDockWidget>
#include <algorithm>

#include "app/gui/session/session.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/views/selection_display.h"
#include "core/base/standard_gravity.h"
#include "core/fe/frame_transform.h"
#include "widgets/basics/wording.h"
#include "widgets/views/history_panel.h"

namespace rubble {

HistoryDisplay::HistoryDisplay(Session& session, Playback& playback, ViewArea& area, SelectionDisplay& selection,
                               widgets::HistoryPanel& panel, QDockWidget& dock, QObject* parent)
    : QObject(parent),
      m_computation(session.computation()),
      m_playback(playback),
      m_area(area),
      m_selection(selection),
      m_panel(panel),
      m_dock(dock) {
    connect(&selection, &SelectionDisplay::changed, this, &HistoryDisplay::refresh);
    connect(&m_computation, &Computation::runBegun, this, &HistoryDisplay::refresh);
    connect(&m_computation, &Computation::runEnded, this, &HistoryDisplay::refresh);
    connect(&m_computation, &Computation::runReopened, this, &HistoryDisplay::refresh);
    connect(&dock, &QDockWidget::visibilityChanged, this, &HistoryDisplay::refresh);
    connect(&playback.clock(), &widgets::PlaybackClock::timeChanged, this, &HistoryDisplay::showTime);
    connect(&panel.chart(), &widgets::HistoryChart::timeRequested, this, [this](double time) { m_playback.showInstant(time); });
}

HistoryDisplay::Order HistoryDisplay::orderNow() const {
    const render::SceneData& data = m_area.views().data();
    Order order{data.fragments, data.trajectory, data.trajectory != nullptr ? data.trajectory->frameCount() : 0,
                m_selection.fragments()};
    if (order.fragments != nullptr && m_selection.selection().empty()) {
        for (std::size_t f = 0; f < order.fragments->size(); ++f) {
            order.which.push_back(idAt<FragmentId>(f));
        }
    }
    return order;
}

QString HistoryDisplay::whyNot() const {
    if (m_order.trajectory == nullptr || m_order.frames == 0) {
        return tr("Simulate first: there are no curves without a run.");
    }
    return m_order.which.empty() ? tr("Nothing of what is selected becomes a fragment: it stays active to the end.") : QString();
}

QString HistoryDisplay::subjectOf(const std::vector<FragmentId>& which) const {
    const render::SceneData& data = m_area.views().data();
    const QString count = widgets::shownCount(static_cast<std::int64_t>(which.size()));
    if (which.size() == 1) {
        return tr("Fragment %1").arg(widgets::shownCount(static_cast<std::int64_t>(at(which.front()))));
    }
    if (which.size() == data.fragments->size()) {
        return tr("All %1 fragments").arg(count);
    }
    const auto& list = data.fragments->list;
    if (data.clustering != nullptr && !which.empty()) {
        const ClusterId cluster = data.clustering->of[at(which.front())];
        const bool one =
            std::all_of(which.begin(), which.end(), [&](FragmentId f) { return data.clustering->of[at(f)] == cluster; });
        if (one && data.clustering->list[at(cluster)].memberCount == which.size()) {
            return tr("Cluster %1: %2 fragments").arg(widgets::shownCount(static_cast<std::int64_t>(at(cluster))), count);
        }
    }
    const auto component = [&](FragmentId f) { return list[at(f)].component; };
    const bool alike =
        std::all_of(which.begin(), which.end(), [&](FragmentId f) { return component(f) == component(which.front()); });
    if (alike && data.components != nullptr && !which.empty()) {
        const QString name = QString::fromStdString(data.components->list[at(component(which.front()))].name);
        return tr("%1 selected fragments of %2").arg(count, name);
    }
    return tr("%1 selected fragments").arg(count);
}

void HistoryDisplay::refresh() {
    if (m_dock.isHidden()) {
        return;
    }
    Order order = orderNow();
    if (order == m_order && (m_reading || !m_content.points.empty())) {
        return;
    }
    m_order = std::move(order);
    m_worker.cancel();
    m_reading = false;
    m_content.points.clear();
    if (!whyNot().isEmpty()) {
        show();
        return;
    }
    m_reading = true;
    show();
    const RunRecord* record = m_computation.currentRun();
    const double gravity = record != nullptr ? record->scenario.simulation.gravity : standardGravity;
    const render::SceneData& data = m_area.views().data();
    const double lift = FrameTransform(data.fe->contents().frame).localZero().z();
    auto points = std::make_shared<std::vector<HistoryPoint>>();
    m_worker.start({Worker::Kind::Study,
                    [points, order = m_order, gravity, lift, level = data.groundHeight](const Execution& execution) {
                        *points = fragmentHistory(*order.fragments, *order.trajectory, order.which, gravity, level, execution);
                        for (HistoryPoint& point : *points) {
                            point.height += lift;
                        }
                    },
                    [this, points, order = m_order](const std::exception_ptr& thrown) {
                        if (thrown == nullptr && order == m_order) {
                            m_reading = false;
                            m_content.points = std::move(*points);
                            show();
                        }
                    }});
}

void HistoryDisplay::show() {
    const render::SceneData& data = m_area.views().data();
    const QString why = whyNot();
    m_content.subject = why.isEmpty() ? subjectOf(m_order.which) : QString();
    m_content.timeOrigin = m_playback.timeOrigin();
    if (data.fe != nullptr) {
        m_content.from = data.fe->times().front();
        m_content.to = data.fe->times().back();
    }
    if (m_order.frames > 0) {
        m_content.to = std::max(m_content.to, m_order.trajectory->frameTime(m_order.frames - 1));
    }
    m_panel.setContent(m_content, why, m_reading);
    m_panel.setTime(m_playback.clock().time());
}

void HistoryDisplay::showTime(double time) {
    if (m_dock.isHidden()) {
        return;
    }
    if (m_content.timeOrigin != m_playback.timeOrigin()) {
        show();
    }
    m_panel.setTime(time);
}

}  // namespace rubble
