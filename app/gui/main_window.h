#pragma once

#include <QMainWindow>
#include <QPointer>

#include "app/gui/actions.h"
#include "app/gui/computation.h"
#include "app/gui/document.h"
#include "widgets/preferences_dialog.h"
#include "widgets/render/scene_data.h"
#include "widgets/render/view.h"

class QBoxLayout;
class QComboBox;
class QLabel;
class QSplitter;
class QStackedWidget;

namespace rubble {

class AccuracyDisplay;
class CalibrationDisplay;
class ErrorDisplay;
class EvidenceDisplay;
class EvidenceStudies;
class FigureReturn;
class FileCommands;
class ForecastDisplay;
class GridDisplay;
class HealthDisplay;
class Help;
class Inspection;
class NewCase;
class PanelDeck;
class PictureExport;
class Playback;
class ProjectDisplay;
class ReportWork;
class ScenarioPane;
struct LeftWork;
class StatusFeed;
class SurveyDisplay;
class ViewArea;
namespace widgets {
class AccuracyPage;
class EvidencePage;
class StatusLine;
class Timeline;
class Transport;
}  // namespace widgets

/// The workbench: rail and panel left, views in the centre, timeline and status line below. Brings the document, what is computed
/// for it and the widgets together.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens a case or an FE result; with `simulate`, simulates it as soon as it is prepared.
    void open(const QString& path, bool simulate = false);
    void openSample();
    /// Makes a new case by the wizard, from a file that is asked for if none is named. What is open stays until the case is made.
    void newCase(const QString& path = {});
    /// Opens what an earlier session left unsaved.
    void recover(const LeftWork& work);
    /// Reads the FE result again if files of it have grown or come; scenario, time and camera stay.
    void refreshResult();
    void simulate(bool live);
    /// "system", "light" or "dark".
    void setTheme(const QString& name);
    void showInstant(double time);
    void showFailure(const Failure& failure);
    /// Looks at the model as a saved view does; the theme stays.
    void showView(render::View view);

    Document& document() { return m_document; }
    Computation& computation() { return m_computation; }
    Playback& playback() { return *m_playback; }
    PanelDeck& deck() { return *m_deck; }
    ViewArea& area() { return *m_area; }
    HealthDisplay& health() { return *m_health; }
    AccuracyDisplay& accuracy() { return *m_accuracy; }
    GridDisplay& grid() { return *m_grid; }
    CalibrationDisplay& calibration() { return *m_calibration; }
    ForecastDisplay& forecast() { return *m_forecast; }
    ErrorDisplay& errors() { return *m_errors; }
    ScenarioPane& scenarioPane() { return *m_scenarioPane; }
    Inspection& inspection() { return *m_inspection; }
    EvidenceDisplay& evidence() { return *m_evidence; }
    SurveyDisplay& survey() { return *m_survey; }
    EvidenceStudies& studies() { return *m_studies; }
    widgets::EvidencePage& evidencePage() { return *m_evidencePage; }
    widgets::AccuracyPage& accuracyPage() { return *m_accuracyPage; }
    widgets::Timeline& timeline() { return *m_timeline; }
    widgets::StatusLine& statusLine() { return *m_status; }
    FileCommands& files() { return *m_files; }
    ProjectDisplay& project() { return *m_project; }
    PictureExport& pictures() { return *m_pictures; }
    ReportWork& report() { return *m_report; }
    Actions& actions() { return m_actions; }
    Help& help() { return *m_help; }
    /// The case that is being made; null if none is.
    NewCase* caseInTheMaking() const;
    const widgets::Preferences& preferences() const { return m_preferences; }
    /// What the views show.
    render::SceneData sceneData() const;

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Opens a file that is no figure; false if what is open was not to be left.
    bool load(const QString& path, bool simulate);
    void buildLayout();
    void buildMenus();
    void buildToolBar();
    void connectFiles();
    void connectProject();
    void closeCase();
    void connectViews();
    void connectComputation();
    void connectPlayback();
    void connectAccuracy();
    void connectCosts();
    void connectEvidence();
    void connectStudies();
    void showCentre();
    void connectExports();
    /// What would spoil the times of other work, in words; empty: nothing runs that would.
    QString costlyWork() const;
    void showBusy();
    void showGrid();
    Welcome welcomeFor(const Opened& opened);
    void takeOpened(const Opened& opened);
    void showRefreshed(const FeResult& before, const render::View& view, double time);
    void showScene();
    void showState();
    void showTitle();
    void scenarioChanged();
    void prepared();
    void runEnded(bool complete);
    void runReopened();
    void setLayoutOf(render::Layout layout);
    void setView(const render::View& view);
    void showPreferences();
    void setPreferences(const widgets::Preferences& preferences);
    void applyPreferences(const widgets::Preferences& preferences);
    /// Says again what is put together from figures, in the language that is spoken now.
    void retell();
    void showAbout();

    Document m_document;
    Computation m_computation;
    Actions m_actions;
    PanelDeck* m_deck;
    ViewArea* m_area;
    widgets::AccuracyPage* m_accuracyPage;
    widgets::EvidencePage* m_evidencePage;
    widgets::Timeline* m_timeline;
    widgets::Transport* m_transport;
    widgets::StatusLine* m_status;
    Playback* m_playback;
    StatusFeed* m_feed;
    HealthDisplay* m_health;
    AccuracyDisplay* m_accuracy;
    GridDisplay* m_grid;
    CalibrationDisplay* m_calibration;
    ForecastDisplay* m_forecast;
    ErrorDisplay* m_errors;
    ScenarioPane* m_scenarioPane;
    Inspection* m_inspection;
    EvidenceStudies* m_studies;
    EvidenceDisplay* m_evidence;
    SurveyDisplay* m_survey;
    FileCommands* m_files;
    PictureExport* m_pictures;
    FigureReturn* m_return;
    ReportWork* m_report;
    ProjectDisplay* m_project = nullptr;
    QComboBox* m_colours;
    QLabel* m_title;
    QWidget* m_left = nullptr;
    QSplitter* m_splitter = nullptr;
    QBoxLayout* m_notices = nullptr;
    QStackedWidget* m_centre = nullptr;
    Help* m_help;
    QPointer<NewCase> m_newCase;
    widgets::Preferences m_preferences;
    bool m_retellable = false;  // everything is built
    bool m_simulateWhenReady = false;
    bool m_askedToLeave = false;                  ///< the case has not been edited since somebody agreed to leave it for another
    std::shared_ptr<const FeResult> m_refreshed;  // what is being read again
    render::SceneData m_shown;
};

}  // namespace rubble
