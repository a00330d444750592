#pragma once

#include <QMainWindow>
#include <memory>
#include <optional>

#include "app/gui/stage/actions.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/window/window_rooms.h"

class QLabel;
class QSplitter;
class QStackedWidget;
class QToolBar;

namespace rubble {

namespace widgets {
class Tour;
}

class FirstVisit;
class Help;
class KeyRules;
class LayoutMemory;

/// The workbench: rail and panel left, views in the centre, timeline and status line below. A window shows a session, and another
/// one can take its place; what it shows is the work of its rooms.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(Session& session, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens a case, an FE result or a figure; with `simulate`, simulates it as soon as it is prepared.
    void open(const QString& path, bool simulate = false);
    void showFailure(const Failure& failure);
    /// "system", "light" or "dark".
    void setTheme(const QString& name);
    void showPreferences();
    /// Opens once more what stood open beside the window that this one takes the place of. Once the window is shown: else such
    /// windows are not kept in front of it.
    void openAgain();
    /// The layout of the last time, from now on kept when the window closes.
    void restoreLayout();

    Session& session() { return m_session; }
    WindowRooms& rooms() { return *m_rooms; }
    Actions& actions() { return m_actions; }
    Help& help() { return *m_help; }
    ViewArea& area() { return *m_area; }
    FirstVisit& firstVisit() { return *m_visit; }

protected:
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    /// What outlives the window.
    struct Kept;

    void buildLayout();
    void buildMenus();
    void buildToolBar();
    void addTools(QToolBar& bar, ToolSection section);
    void connectSession();
    void connectActions();
    void prepareTour();
    void prepareKeys();
    void showCentre();
    void showTitle();
    void showAbout();
    void keepLook();
    void goOn();

    Session& m_session;
    /// A study runs that Esc cancels.
    bool studying() const;

    Kept& m_kept;
    int m_lastEntry = PanelDeck::Case;  ///< of the rail, the last one that leaves the centre to the views
    Actions m_actions;
    ViewArea* m_area;
    widgets::AccuracyPage* m_accuracyPage;
    widgets::EvidencePage* m_evidencePage;
    widgets::Timeline* m_timeline;
    widgets::Transport* m_transport;
    widgets::StatusLine* m_status;
    QComboBox* m_colours;
    QBoxLayout* m_notices;
    QLabel* m_title;
    QSplitter* m_splitter = nullptr;
    QStackedWidget* m_centre = nullptr;
    widgets::Tour* m_tour = nullptr;
    FirstVisit* m_visit = nullptr;
    KeyRules* m_keys = nullptr;
    std::unique_ptr<WindowRooms> m_rooms;
    std::unique_ptr<Help> m_help;
    std::unique_ptr<LayoutMemory> m_layout;
};

}  // namespace rubble
