#include "app/gui/project_display.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QUndoView>

#include "app/gui/actions.h"
#include "app/gui/computation.h"
#include "app/gui/dock_area.h"
#include "app/gui/document.h"
#include "app/gui/inputs_display.h"
#include "app/gui/layout_memory.h"
#include "app/gui/panel_deck.h"
#include "app/gui/recovery.h"
#include "app/gui/run_history.h"
#include "app/gui/scenarios_display.h"
#include "app/gui/start_display.h"
#include "app/gui/view_area.h"
#include "io/machine.h"
#include "widgets/case_panel.h"
#include "widgets/tour.h"

namespace rubble {

namespace {

/// A folder in the state folder; empty where there is none, and then nothing is kept.
QString stateFolder(const char* name) {
    try {
        return QString::fromStdString(io::stateFolder()) + u'/' + QLatin1String(name);
    } catch (...) {
        return {};
    }
}

}  // namespace

ProjectDisplay::ProjectDisplay(Document& document, Computation& computation, PanelDeck& deck, ViewArea& area, Actions& actions,
                               QBoxLayout& notices, QSplitter& splitter, QMainWindow& window)
    : QObject(&window),
      m_actions(actions),
      m_window(window),
      m_autosave(new Autosave(document, stateFolder("unsaved"), this)),
      m_recovery(new Recovery(document, *m_autosave, notices, this)),
      m_inputs(new InputsDisplay(document, computation, notices, window)),
      m_runs(new RunHistory(document, computation, stateFolder("runs"), this)),
      m_scenarios(new ScenariosDisplay(document, computation, *m_runs, deck.casePanel().scenarios(), deck.run().runs(), window)),
      m_start(new StartDisplay(document, computation, area, stateFolder("pictures"), this)),
      m_history(buildHistory(document, *window.findChild<DockArea*>())) {
    connect(m_autosave, &Autosave::failed, this, &ProjectDisplay::failed);
    connect(m_autosave, &Autosave::setAside, this, [this](const QString& what, const QString& where) {
        emit failed(tr("Unsaved work of an earlier session cannot be read. %1").arg(what),
                    where.isEmpty() ? QString() : tr("It was set aside as %1.").arg(where));
    });
    connect(m_recovery, &Recovery::recoverRequested, this, &ProjectDisplay::recoverRequested);
    connect(m_recovery, &Recovery::told, this, &ProjectDisplay::told);
    connect(m_inputs, &InputsDisplay::told, this, &ProjectDisplay::told);
    connect(m_inputs, &InputsDisplay::failed, this, &ProjectDisplay::failed);
    connect(m_runs, &RunHistory::failed, this, &ProjectDisplay::failed);
    connect(m_start, &StartDisplay::openRequested, this, &ProjectDisplay::openRequested);
    connect(m_start, &StartDisplay::sampleRequested, this, &ProjectDisplay::sampleRequested);
    connect(m_start, &StartDisplay::tourRequested, &actions["tour"], &QAction::trigger);
    connectActions(document);
    m_layout = std::make_unique<LayoutMemory>(window, *window.findChild<DockArea*>(), splitter);
}

ProjectDisplay::~ProjectDisplay() = default;

QDockWidget* ProjectDisplay::buildHistory(Document& document, DockArea& docks) {
    auto* list = new QUndoView(&document.undoStack());
    list->setEmptyLabel(tr("As opened"));
    list->setAccessibleName(tr("History of edits"));
    list->setToolTip(tr("Every edit since the case was opened; a click goes back or forward to it"));
    list->setMinimumWidth(200);
    QDockWidget* dock = docks.addDock(list, tr("History"), QStringLiteral("historyDock"));
    QAction& shown = m_actions["history"];
    connect(&shown, &QAction::toggled, this, [dock](bool show) {
        dock->setVisible(show);
        if (show) {
            dock->raise();
        }
    });
    connect(dock->toggleViewAction(), &QAction::toggled, &shown, &QAction::setChecked);
    return dock;
}

void ProjectDisplay::retell() {
    static_cast<QUndoView*>(m_history->widget())->setEmptyLabel(tr("As opened"));
    emit m_runs->changed();
    m_start->refresh();
}

void ProjectDisplay::connectActions(Document& document) {
    const auto on = [this](const char* id, auto slot) { connect(&m_actions[id], &QAction::triggered, this, slot); };
    on("duplicate_scenario", [&document] {
        if (document.active() != nullptr) {
            document.duplicateScenario(document.active()->id);
        }
    });
    on("compare_scenarios", [this] { m_scenarios->compare(); });
    on("reset_layout", [this] { m_layout->reset(); });
    on("tour", [this] {
        if (m_tour != nullptr) {
            m_tour->start();
        }
    });
    const auto showState = [this, &document] {
        m_actions["duplicate_scenario"].setEnabled(!document.empty());
        m_actions["compare_scenarios"].setEnabled(document.theCase().scenarios.size() > 1);
    };
    connect(&document, &Document::replaced, this, showState);
    connect(&document, &Document::scenariosChanged, this, showState);
    showState();
}

void ProjectDisplay::begin() {
    m_start->remember();
    m_recovery->look();
}

void ProjectDisplay::restoreLayout() {
    m_keepsLayout = true;
    m_layout->restore();
    // It comes with a selection, and there is none yet.
    m_window.findChild<QDockWidget*>(QStringLiteral("inspectorDock"))->hide();
}

void ProjectDisplay::saveLayout() const {
    if (m_keepsLayout) {
        m_layout->save();
    }
}

void ProjectDisplay::setTourStops(const std::vector<widgets::TourStop>& stops) {
    m_tour = new widgets::Tour(stops, &m_window);
}

}  // namespace rubble
