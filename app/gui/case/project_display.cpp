#include "app/gui/case/project_display.h"

#include <QDockWidget>
#include <QUndoView>

#include "app/gui/case/inputs_display.h"
#include "app/gui/case/kept_runs_display.h"
#include "app/gui/case/recovery.h"
#include "app/gui/case/scenarios_display.h"
#include "app/gui/case/start_display.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "app/gui/stage/dock_area.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/stage/view_area.h"
#include "widgets/case/case_panel.h"

namespace rubble {

ProjectDisplay::ProjectDisplay(Session& session, PanelDeck& deck, ViewArea& area, Actions& actions, QBoxLayout& notices,
                               DockArea& docks, QWidget& window)
    : m_actions(actions),
      m_files(session.part<ProjectFiles>()),
      m_recovery(new Recovery(session, notices, this)),
      m_inputs(new InputsDisplay(session, notices, window)),
      m_scenarios(new ScenariosDisplay(session, deck.casePanel().scenarios(), deck.run().runs(), window)),
      m_start(new StartDisplay(session, area, this)),
      m_keptRuns(new KeptRunsDisplay(session, window, this)),
      m_history(buildHistory(session.document(), docks)) {
    m_inputs->setParent(this);
    m_scenarios->setParent(this);
    connect(m_inputs, &InputsDisplay::withoutTerrainRequested, &actions[ActionId::NoTerrain], &QAction::trigger);
    connect(m_recovery, &Recovery::recoverRequested, this, &ProjectDisplay::recoverRequested);
    connect(m_start, &StartDisplay::openRequested, this, &ProjectDisplay::openRequested);
    connect(m_keptRuns, &KeptRunsDisplay::openRequested, this, &ProjectDisplay::openRequested);
    // A run is kept from its first step on: so is what it was made from.
    connect(&session.computation(), &Computation::runBegun, this, [this] {
        if (Autosave::chosenInterval() > 0) {
            autosave().saveNow();
        }
    });
    connect(m_start, &StartDisplay::sampleRequested, this, &ProjectDisplay::sampleRequested);
    connect(m_start, &StartDisplay::tourRequested, &actions[ActionId::Tour], &QAction::trigger);
    connectActions(session.document());
}

QDockWidget* ProjectDisplay::buildHistory(Document& document, DockArea& docks) {
    auto* list = new QUndoView(&document.undoStack());
    list->setEmptyLabel(tr("As opened"));
    list->setAccessibleName(tr("History of edits"));
    list->setToolTip(tr("Every edit since the case was opened; a click goes back or forward to it"));
    list->setMinimumWidth(200);
    QDockWidget* dock = docks.addDock(list, tr("History"), QStringLiteral("historyDock"));
    QAction& shown = m_actions[ActionId::History];
    connect(&shown, &QAction::toggled, this, [dock](bool show) {
        dock->setVisible(show);
        if (show) {
            dock->raise();
        }
    });
    connect(dock->toggleViewAction(), &QAction::toggled, &shown, &QAction::setChecked);
    return dock;
}

void ProjectDisplay::connectActions(Document& document) {
    const auto on = [this](ActionId id, auto slot) { connect(&m_actions[id], &QAction::triggered, this, slot); };
    on(ActionId::DuplicateScenario, [&document] {
        if (document.active() != nullptr) {
            document.duplicateScenario(document.active()->id);
        }
    });
    on(ActionId::CompareScenarios, [this] { m_scenarios->compare(); });
    on(ActionId::KeptRuns, [this] { m_keptRuns->show(); });
    const auto showState = [this, &document] {
        m_actions.enable(ActionId::DuplicateScenario, !document.empty());
        m_actions.enable(ActionId::CompareScenarios, document.theCase().scenarios.size() > 1);
    };
    connect(&document, &Document::replaced, this, showState);
    connect(&document, &Document::scenariosChanged, this, showState);
    showState();
}

void ProjectDisplay::begin() {
    m_start->remember();
    m_recovery->look();
}

}  // namespace rubble
