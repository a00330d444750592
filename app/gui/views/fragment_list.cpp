#include "app/gui/views/fragment_list.h"

#include <QDockWidget>

#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/views/selection_display.h"
#include "widgets/views/fragment_table.h"

namespace rubble {

namespace {

constexpr int speedsEvery = 150;  // ms

}  // namespace

FragmentList::FragmentList(Playback& playback, ViewArea& area, SelectionDisplay& selection, widgets::FragmentTable& table,
                           QDockWidget& dock, QObject* parent)
    : QObject(parent), m_playback(playback), m_area(area), m_selection(selection), m_table(table), m_dock(dock) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(speedsEvery);
    connect(&m_rest, &QTimer::timeout, this, &FragmentList::takeSpeeds);
    connect(&table, &widgets::FragmentTable::selectionRequested, &selection, &SelectionDisplay::select);
    connect(&table, &widgets::FragmentTable::birthRequested, &selection, &SelectionDisplay::goToBirth);
    connect(&table, &widgets::FragmentTable::filterEdited, this, &FragmentList::setFilter);
    connect(&selection, &SelectionDisplay::changed, this, [this] {
        if (seen()) {
            m_table.setSelection(m_selection.selection());
        }
    });
    connect(&playback.clock(), &widgets::PlaybackClock::timeChanged, this, [this] {
        if (seen() && !m_rest.isActive()) {
            m_rest.start();
        }
    });
    connect(&dock, &QDockWidget::visibilityChanged, this, [this](bool visible) {
        if (visible) {
            refresh();
        }
    });
}

const render::SceneData& FragmentList::data() const {
    return m_area.views().data();
}

bool FragmentList::seen() const {
    return !m_dock.isHidden();
}

void FragmentList::setFilter(const render::FragmentFilter& filter) {
    render::View view = m_area.views().view();
    view.filter = filter;
    m_area.views().setView(view);
}

void FragmentList::showFilter() {
    m_table.setFilter(m_area.views().view().filter);
}

void FragmentList::refresh() {
    showFilter();
    if (seen()) {
        m_table.setData(data());
        takeSpeeds();
        m_table.setSelection(m_selection.selection());
    }
}

void FragmentList::takeSpeeds() {
    if (!seen() || data().fragments == nullptr) {
        return;
    }
    try {
        const bool run = data().trajectory != nullptr && data().trajectory->frameCount() > 0;
        if (run) {
            const TrajectoryFrame frame = frameAtTime(*data().trajectory, m_playback.clock().time());
            m_table.setSpeeds(render::speedsShown(data(), &frame));
        } else {
            m_table.setSpeeds(render::speedsShown(data(), nullptr));
        }
    } catch (const std::exception&) {
        // The views say what is wrong with the run file.
    }
}

}  // namespace rubble
