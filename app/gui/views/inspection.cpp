#include "app/gui/views/inspection.h"

#include <QDockWidget>
#include <QLineEdit>

#include "app/gui/case/component_display.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/dock_area.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/stage/view_tools.h"
#include "app/gui/views/fragment_list.h"
#include "app/gui/views/history_display.h"
#include "app/gui/views/selection_display.h"
#include "widgets/basics/wording.h"
#include "widgets/case/component_tree.h"
#include "widgets/views/fragment_table.h"
#include "widgets/views/history_panel.h"

namespace rubble {

Inspection::Inspection(Session& session, Playback& playback, ViewArea& area, Actions& actions, QObject* parent)
    : QObject(parent),
      m_actions(actions),
      m_area(area),
      m_docks(new DockArea),
      m_tree(new widgets::ComponentTree),
      m_inspector(new widgets::Inspector),
      m_form(new widgets::SelectForm),
      m_table(new widgets::FragmentTable),
      m_curves(new widgets::HistoryPanel),
      m_treeDock(m_docks->addDock(m_tree, tr("Components"), QStringLiteral("componentsDock"))),
      m_formDock(m_docks->addDock(m_form, tr("Select by"), QStringLiteral("selectDock"))),
      m_inspectorDock(m_docks->addDock(m_inspector, tr("Inspector"), QStringLiteral("inspectorDock"))),
      m_tableDock(m_docks->addDock(m_table, tr("Fragment table"), QStringLiteral("tableDock"), Qt::BottomDockWidgetArea)),
      m_curvesDock(m_docks->addDock(m_curves, tr("History curves"), QStringLiteral("curvesDock"))),
      m_components(new ComponentDisplay(session.document(), session.computation(), playback.clock(), area.views(), *m_tree, this)),
      m_selection(new SelectionDisplay(session, playback, area, *m_inspector, *m_form, this)),
      m_list(new FragmentList(playback, area, *m_selection, *m_table, *m_tableDock, this)),
      m_history(new HistoryDisplay(session, playback, area, *m_selection, *m_curves, *m_curvesDock, this)),
      m_tools(new ViewTools(actions, area, this)) {
    m_docks->floatWhereNarrow(*m_inspectorDock);
    connect(&area.views(), &widgets::ViewWidget::shadingEnded, this, [this, &session](double seconds) {
        m_tools->refresh();
        session.tell(tr("Shaded edges are off: a picture took %1 s with them").arg(widgets::shownNumber(seconds, 2)));
    });
    connectActions();
    connect(m_selection, &SelectionDisplay::changed, this, &Inspection::selectionChanged);
    connect(m_treeDock, &QDockWidget::visibilityChanged, this, [this](bool visible) {
        if (visible) {
            m_components->refresh();
        }
    });
    selectionChanged(false);
}

// Work on the way of a fragment ends before anything it tells goes.
Inspection::~Inspection() {
    delete m_history;
    delete m_list;
    delete m_selection;
    delete m_components;
}

QDockWidget& Inspection::dock(const char* name) const {
    return *m_docks->findChild<QDockWidget*>(QLatin1String(name));
}

void Inspection::connectActions() {
    const auto on = [this](ActionId id, auto slot) { connect(&m_actions[id], &QAction::triggered, this, slot); };
    on(ActionId::SelectNone, [this] { m_selection->clear(); });
    on(ActionId::SelectCluster, [this] { m_selection->growToClusters(); });
    on(ActionId::SelectComponent, [this] { m_selection->growToComponents(); });
    on(ActionId::Hide, [this] { m_selection->hide(); });
    on(ActionId::Isolate, [this] { m_selection->isolate(); });
    on(ActionId::ShowAll, [this] { m_components->showAll(); });
    on(ActionId::GoToBirth, [this] { m_selection->goToBirth(); });
    const std::pair<ActionId, QDockWidget*> docks[] = {{ActionId::Components, m_treeDock},
                                                       {ActionId::SelectBy, m_formDock},
                                                       {ActionId::Inspector, m_inspectorDock},
                                                       {ActionId::FragmentTable, m_tableDock},
                                                       {ActionId::HistoryCurves, m_curvesDock}};
    for (const auto& [id, dock] : docks) {
        QAction& action = m_actions[id];
        connect(&action, &QAction::triggered, dock, [dock = dock](bool visible) {
            dock->setVisible(visible);
            if (visible) {
                dock->widget()->setFocus();
            }
        });
        connect(dock, &QDockWidget::visibilityChanged, &action, [&action, dock = dock] { action.setChecked(!dock->isHidden()); });
    }
}

void Inspection::selectionChanged(bool something) {
    for (const ActionId id : {ActionId::SelectNone, ActionId::SelectCluster, ActionId::SelectComponent, ActionId::Hide,
                              ActionId::Isolate, ActionId::GoToBirth}) {
        m_actions.enable(id, something);
    }
    // It comes with a selection and goes with it; what the user closed meanwhile stays closed.
    if (something != m_something) {
        m_something = something;
        m_inspectorDock->setVisible(something);
    }
}

void Inspection::refresh() {
    m_components->refresh();
    m_selection->refresh();
    m_list->refresh();
    m_history->refresh();
    m_tools->refresh();
    const bool have = m_area.views().data().fe != nullptr;
    m_actions.enable(ActionId::ShowAll, have);
    for (const ActionId id : {ActionId::SelectBy, ActionId::FragmentTable, ActionId::HistoryCurves}) {
        m_actions.enable(id, have);
    }
}

}  // namespace rubble
