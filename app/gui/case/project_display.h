#pragma once

#include <QObject>

#include "app/gui/case/project_files.h"

class QBoxLayout;
class QDockWidget;
class QWidget;

namespace rubble {

class Actions;
class DockArea;
class InputsDisplay;
class KeptRunsDisplay;
class PanelDeck;
class Recovery;
class ScenariosDisplay;
class Session;
class StartDisplay;
class ViewArea;

/// The case as a piece of work: start page, autosave and recovery, inputs that are missing, scenarios, history of runs and of
/// edits.
class ProjectDisplay : public QObject {
    Q_OBJECT

public:
    ProjectDisplay(Session& session, PanelDeck& deck, ViewArea& area, Actions& actions, QBoxLayout& notices, DockArea& docks,
                   QWidget& window);

    /// A user has started the program: offers what was left behind, and remembers what is opened.
    void begin();

    Autosave& autosave() { return m_files.autosave; }
    Recovery& recovery() { return *m_recovery; }
    InputsDisplay& inputs() { return *m_inputs; }
    RunHistory& runs() { return m_files.runs; }
    KeptRunsDisplay& keptRuns() { return *m_keptRuns; }
    ScenariosDisplay& scenarios() { return *m_scenarios; }
    StartDisplay& start() { return *m_start; }
    QDockWidget& historyDock() { return *m_history; }

signals:
    void openRequested(const QString& path);
    void sampleRequested(const QString& path);
    void recoverRequested(const rubble::LeftWork& work);

private:
    QDockWidget* buildHistory(Document& document, DockArea& docks);
    void connectActions(Document& document);

    Actions& m_actions;
    ProjectFiles& m_files;
    Recovery* m_recovery;
    InputsDisplay* m_inputs;
    ScenariosDisplay* m_scenarios;
    StartDisplay* m_start;
    KeptRunsDisplay* m_keptRuns;
    QDockWidget* m_history;
};

}  // namespace rubble
