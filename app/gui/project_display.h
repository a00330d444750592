#pragma once

#include <QObject>
#include <memory>

#include "app/gui/autosave.h"

class QBoxLayout;
class QDockWidget;
class QMainWindow;
class QSplitter;

namespace rubble {

class Actions;
class Computation;
class DockArea;
class InputsDisplay;
class LayoutMemory;
class PanelDeck;
class Recovery;
class RunHistory;
class ScenariosDisplay;
class StartDisplay;
class ViewArea;
namespace widgets {
class Tour;
struct TourStop;
}  // namespace widgets

/// The case as a piece of work: start page, autosave and recovery, inputs that are missing, scenarios, history of runs and of
/// edits, and the layout of the window.
class ProjectDisplay : public QObject {
    Q_OBJECT

public:
    ProjectDisplay(Document& document, Computation& computation, PanelDeck& deck, ViewArea& area, Actions& actions,
                   QBoxLayout& notices, QSplitter& splitter, QMainWindow& window);
    ~ProjectDisplay() override;

    /// A user has started the program: offers what was left behind, and remembers what is opened.
    void begin();
    /// The layout of the last time, from now on kept when the window closes.
    void restoreLayout();
    /// The window closes.
    void saveLayout() const;
    /// Says in the language of the window what it had said in another.
    void retell();
    void setTourStops(const std::vector<widgets::TourStop>& stops);

    Autosave& autosave() { return *m_autosave; }
    Recovery& recovery() { return *m_recovery; }
    InputsDisplay& inputs() { return *m_inputs; }
    RunHistory& runs() { return *m_runs; }
    ScenariosDisplay& scenarios() { return *m_scenarios; }
    StartDisplay& start() { return *m_start; }
    QDockWidget& historyDock() { return *m_history; }

signals:
    void openRequested(const QString& path);
    void sampleRequested(const QString& path);
    void recoverRequested(const rubble::LeftWork& work);
    void told(const QString& what);
    void failed(const QString& what, const QString& remedy);

private:
    QDockWidget* buildHistory(Document& document, DockArea& docks);
    void connectActions(Document& document);

    Actions& m_actions;
    QMainWindow& m_window;
    Autosave* m_autosave;
    Recovery* m_recovery;
    InputsDisplay* m_inputs;
    RunHistory* m_runs;
    ScenariosDisplay* m_scenarios;
    StartDisplay* m_start;
    QDockWidget* m_history;
    widgets::Tour* m_tour = nullptr;
    std::unique_ptr<LayoutMemory> m_layout;
    bool m_keepsLayout = false;
};

}  // namespace rubble
