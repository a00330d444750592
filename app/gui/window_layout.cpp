#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QResizeEvent>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolBar>
#include <QToolButton>

#include "app/gui/accuracy_display.h"
#include "app/gui/calibration_display.h"
#include "app/gui/causes_display.h"
#include "app/gui/dock_area.h"
#include "app/gui/done_notice.h"
#include "app/gui/ensemble_display.h"
#include "app/gui/error_display.h"
#include "app/gui/evidence_display.h"
#include "app/gui/evidence_studies.h"
#include "app/gui/figure_return.h"
#include "app/gui/file_commands.h"
#include "app/gui/forecast_display.h"
#include "app/gui/grid_display.h"
#include "app/gui/health_display.h"
#include "app/gui/help.h"
#include "app/gui/inspection.h"
#include "app/gui/main_window.h"
#include "app/gui/mnemonics.h"
#include "app/gui/panel_deck.h"
#include "app/gui/picture_export.h"
#include "app/gui/playback.h"
#include "app/gui/project_display.h"
#include "app/gui/report_work.h"
#include "app/gui/run_history.h"
#include "app/gui/selection_display.h"
#include "app/gui/settings.h"
#include "app/gui/survey_display.h"
#include "app/gui/timeline_display.h"
#include "app/gui/view_area.h"
#include "app/gui/window_focus.h"
#include "core/base/build.h"
#include "widgets/accuracy_chart.h"
#include "widgets/accuracy_page.h"
#include "widgets/calibration_chart.h"
#include "widgets/calibration_view.h"
#include "widgets/causes_page.h"
#include "widgets/ensemble_page.h"
#include "widgets/evidence_page.h"
#include "widgets/evidence_tabs.h"
#include "widgets/figures/export_record.h"
#include "widgets/page_stack.h"
#include "widgets/start_page.h"
#include "widgets/status_line.h"

#include "widgets/timeline.h"
#include "widgets/tour.h"
#include "widgets/transport.h"

namespace rubble {

namespace {

constexpr int compactBelow = 1440;
constexpr int panelWidth = 336;
// Below it the tables and buttons of the panels would be cut off.
constexpr int leastPanelWidth = 306;

/// Where the colours of an error change: at the tolerances, and at two lengths beyond them.
std::vector<double> errorStepsFor(const std::vector<double>& tolerances) {
    std::vector<double> steps = tolerances;
    for (const double beyond : {1.0, 3.0, 10.0, 30.0, 100.0, 300.0}) {
        if (steps.size() < tolerances.size() + 2 && beyond > steps.back()) {
            steps.push_back(beyond);
        }
    }
    return steps;
}

}  // namespace

void MainWindow::buildLayout() {
    new WindowFocus(this);
    auto* centre = new QWidget;
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* upper = new QHBoxLayout;
    upper->setSpacing(0);
    m_splitter = new QSplitter(Qt::Horizontal);
    m_splitter->setObjectName(QStringLiteral("mainSplitter"));
    m_splitter->setHandleWidth(1);
    m_splitter->setChildrenCollapsible(false);
    m_deck->stack().setMinimumWidth(leastPanelWidth);
    m_splitter->addWidget(&m_deck->stack());
    m_centre = new widgets::PageStack;
    m_centre->addWidget(m_area);
    m_centre->addWidget(m_accuracyPage);
    m_centre->addWidget(m_evidencePage);
    m_centre->addWidget(&m_studies->ensemblePage());
    m_centre->addWidget(&m_studies->causesPage());
    auto* middle = new QWidget;
    auto* stacked = new QVBoxLayout(middle);
    stacked->setContentsMargins(0, 0, 0, 0);
    stacked->setSpacing(0);
    m_notices = new QVBoxLayout;
    stacked->addLayout(m_notices);
    stacked->addWidget(m_centre, 1);
    m_inspection->docks().setCentralWidget(middle);
    m_splitter->addWidget(&m_inspection->docks());
    m_splitter->setStretchFactor(1, 1);
    m_splitter->setSizes({panelWidth, 1000});
    upper->addWidget(&m_deck->rail());
    upper->addWidget(m_splitter, 1);
    column->addLayout(upper, 1);

    auto* bottom = new QWidget;
    bottom->setObjectName(QStringLiteral("bottom"));
    bottom->setAttribute(Qt::WA_StyledBackground);
    auto* lower = new QHBoxLayout(bottom);
    lower->setContentsMargins(0, 1, 0, 0);
    lower->setSpacing(0);
    lower->addWidget(m_transport);
    lower->addWidget(m_timeline, 1);
    column->addWidget(bottom);
    column->addWidget(m_status);
    setCentralWidget(centre);
}

void MainWindow::buildMenus() {
    QMenu* menu = nullptr;
    QString title;
    for (const ActionRow& row : actionTable()) {
        if (const QString name = QCoreApplication::translate("actions", row.menu); name != title) {
            title = name;
            menu = menuBar()->addMenu(title);
            menu->menuAction()->setProperty("source", QString::fromUtf8(row.menu));
        }
        for (const char* first : {"save", "close", "preset_default", "preferences", "clip", "components", "look_side", "parallel",
                                  "turn_left", "map_standard", "theme_system", "hide", "play"}) {
            if (row.id == first) {
                menu->addSeparator();
            }
        }
        menu->addAction(&m_actions[row.id]);
    }
    menuBar()->setCornerWidget(m_title);
    giveMnemonics(*menuBar());
    for (const auto& ids :
         {std::vector<const char*>{"stacked", "beside", "overlay", "four", "fe_only", "fragments_only", "other_scenario"},
          std::vector<const char*>{"map_standard", "map_viridis", "map_cividis", "map_grey"},
          std::vector<const char*>{"theme_system", "theme_light", "theme_dark"}}) {
        auto* group = new QActionGroup(this);
        for (const char* id : ids) {
            group->addAction(&m_actions[id]);
        }
    }
}

void MainWindow::buildToolBar() {
    auto* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("toolBar"));
    bar->setMovable(false);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    bar->setIconSize({16, 16});
    const auto add = [&](const char* id, Qt::ToolButtonStyle style) {
        auto* button = new QToolButton;
        button->setDefaultAction(&m_actions[id]);
        button->setToolButtonStyle(style);
        button->setFocusPolicy(Qt::TabFocus);
        bar->addWidget(button);
        return button;
    };
    add("open", Qt::ToolButtonTextOnly);
    add("undo", Qt::ToolButtonIconOnly);
    add("redo", Qt::ToolButtonIconOnly);
    bar->addSeparator();
    for (const char* id : {"stacked", "beside", "overlay", "four"}) {
        add(id, Qt::ToolButtonTextOnly);
    }
    bar->addSeparator();
    for (const char* id : {"link", "fit", "measure_distance", "clip", "components"}) {
        add(id, Qt::ToolButtonTextOnly);
    }
    bar->addSeparator();
    auto* label = new QLabel(tr(" Colour by "));
    label->setObjectName(QStringLiteral("muted"));
    bar->addWidget(label);
    const std::array<std::pair<QString, render::ColourBy>, 6> choices = {{{tr("highlight"), render::ColourBy::Highlight},
                                                                          {tr("component"), render::ColourBy::Component},
                                                                          {tr("birth time"), render::ColourBy::BirthTime},
                                                                          {tr("speed"), render::ColourBy::Speed},
                                                                          {tr("cluster"), render::ColourBy::Cluster},
                                                                          {tr("error"), render::ColourBy::Error}}};
    for (const auto& [name, by] : choices) {
        m_colours->addItem(name, static_cast<int>(by));
    }
    m_colours->setToolTip(tr("What the colour of a fragment says"));
    m_colours->setAccessibleName(tr("Colour by"));
    m_colours->setObjectName(QStringLiteral("colourBy"));
    m_colours->setFocusPolicy(Qt::TabFocus);
    bar->addWidget(m_colours);
    auto* space = new QWidget;
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(space);
    add("live", Qt::ToolButtonTextOnly);
    add("simulate", Qt::ToolButtonTextOnly)->setObjectName(QStringLiteral("primary"));
}

void MainWindow::connectFiles() {
    const auto on = [this](const char* id, auto slot) { connect(&m_actions[id], &QAction::triggered, this, slot); };
    on("open", [this] {
        if (const QString path = m_files->askForInput(); !path.isEmpty()) {
            open(path);
        }
    });
    on("new_case", [this] { newCase(); });
    on("sample", [this] { openSample(); });
    on("refresh", [this] { refreshResult(); });
    on("keep_copies", [this](bool keep) {
        widgets::Preferences preferences = m_preferences;
        preferences.keepCopies = keep;
        setPreferences(preferences);
    });
    on("terrain", [this] { m_files->chooseTerrain(); });
    on("no_terrain", [this] { m_files->dropTerrain(); });
    on("orthophoto", [this] { m_files->chooseOrthophoto(); });
    on("surroundings", [this] { m_files->chooseSurroundings(); });
    on("no_surroundings", [this] { m_files->dropSurroundings(); });
    on("site", [this] { m_files->editSite(); });
    on("save", [this] { m_files->save(); });
    on("save_as", [this] { m_files->saveAs(); });
    on("save_run", [this] { m_files->saveRun(); });
    on("export_fragments", [this] { m_files->exportFragments(); });
    on("export_series", [this] { m_files->exportSeries(); });
    on("export_vtkhdf", [this] { m_files->exportVtkHdf(); });
    on("export_gltf", [this] { m_files->exportGltf(); });
    on("export_selection", [this] { m_files->exportSelection(m_inspection->selection().fragments()); });
    on("export_view", [this] { m_files->exportView(m_area->views().view()); });
    on("import_view", [this] {
        if (const auto view = m_files->importView()) {
            showView(*view);
        }
    });
    on("close", [this] {
        if (m_files->mayLeave()) {
            closeCase();
        }
    });
    on("quit", [this] { close(); });
    on("undo", [this] { m_document.undoStack().undo(); });
    on("redo", [this] { m_document.undoStack().redo(); });
    on("preset_default", [this] { m_document.applyPreset(QStringLiteral("default")); });
    on("preset_paper", [this] { m_document.applyPreset(QStringLiteral("paper")); });
    on("preferences", [this] { showPreferences(); });
    on("manual", [this] { m_help->showAbout(QApplication::focusWidget()); });
    on("manual_search", [this] { m_help->search(); });
    on("about", [this] { showAbout(); });
    connect(m_files, &FileCommands::done, m_status, &widgets::StatusLine::setMessage);
    connect(m_files, &FileCommands::failed, this,
            [this](const QString& what, const QString& remedy) { showFailure({what, remedy, "gui.write"}); });
    connect(&m_area->startPage(), &widgets::StartPage::openRequested, &m_actions["open"], &QAction::trigger);
    connect(&m_area->startPage(), &widgets::StartPage::newRequested, &m_actions["new_case"], &QAction::trigger);

    QUndoStack& stack = m_document.undoStack();
    const auto name = [this, &stack] {
        m_actions["undo"].setEnabled(stack.canUndo());
        m_actions["redo"].setEnabled(stack.canRedo());
        const auto call = [](QAction& action, const QString& text, const QString& key) {
            action.setText(text);
            action.setIconText(text);
            action.setToolTip(QStringLiteral("%1 (%2)").arg(text, key));
        };
        call(m_actions["undo"], stack.canUndo() ? tr("Undo %1").arg(stack.undoText()) : tr("Undo"), QStringLiteral("Ctrl+Z"));
        call(m_actions["redo"], stack.canRedo() ? tr("Redo %1").arg(stack.redoText()) : tr("Redo"), QStringLiteral("Ctrl+Shift+Z"));
    };
    connect(&stack, &QUndoStack::indexChanged, this, name);
    name();
    connect(&m_document, &Document::scenarioChanged, this, &MainWindow::scenarioChanged);
    connect(&m_document, &Document::inputsChanged, this,
            [this] { m_computation.reopen(m_document.theCase(), m_document.path(), m_document.base()); });
    connect(&m_document, &Document::titleChanged, this, &MainWindow::showTitle);
    connect(&m_document, &Document::replaced, this, [this] {
        m_deck->showScenario();
        showState();
    });
}

void MainWindow::closeCase() {
    m_inspection->selection().clear();
    m_computation.clear();
    m_document.close();
    showScene();
    m_area->showViews(false);
    m_area->setError({});
    m_playback->reset();
    m_health->refresh();
    m_deck->showOutcome({});
    m_deck->clearFailures();
    m_deck->choose(PanelDeck::Case);
}

void MainWindow::connectProject() {
    m_project = new ProjectDisplay(m_document, m_computation, *m_deck, *m_area, m_actions, *m_notices, *m_splitter, *this);
    m_project->setTourStops(
        {{&m_deck->rail(), tr("The order of work"),
          tr("From the file to the debris, top to bottom. Each entry shows its state: up to date, stale after a change, running, "
             "or "
             "with a finding.")},
         {&m_deck->stack(), tr("The panel of a stage"),
          tr("One question per panel, its settings, and what they cost. Every change can be undone with Ctrl+Z.")},
         {m_centre, tr("The views"),
          tr("The conventional FE result and the fragments, from the same camera. Left button orbits, Shift and left pans, the "
             "wheel "
             "zooms. Keys 1 to 4 choose the layout.")},
         {findChild<QToolButton*>(QStringLiteral("primary")), tr("Simulate"),
          tr("Computes where the fragments go (Ctrl+R); the views play what is computed meanwhile. Live runs at the pace of the "
             "collapse.")},
         {m_timeline, tr("The timeline"),
          tr("Deaths over time and how far the run has got. Drag to scrub, Space plays, the arrow keys go from state to state.")}});
    new TimelineDisplay(m_document, *m_playback, *m_timeline, *m_transport, m_actions, m_project);
    connect(m_project, &ProjectDisplay::openRequested, this, [this](const QString& path) { open(path); });
    connect(m_project, &ProjectDisplay::sampleRequested, this, [this](const QString& path) { open(path, true); });
    connect(m_project, &ProjectDisplay::recoverRequested, this, &MainWindow::recover);
    connect(m_project, &ProjectDisplay::told, m_status, &widgets::StatusLine::setMessage);
    connect(m_project, &ProjectDisplay::failed, this,
            [this](const QString& what, const QString& remedy) { showFailure({what, remedy, "gui.project"}); });
    connect(m_files, &FileCommands::runSaved, &m_project->runs(), &RunHistory::keptAt);
    connect(&m_document, &Document::scenariosChanged, this, &MainWindow::showState);
}

void MainWindow::connectViews() {
    const auto on = [this](const char* id, auto slot) { connect(&m_actions[id], &QAction::triggered, this, slot); };
    on("stacked", [this] { setLayoutOf(render::Layout::Stacked); });
    on("beside", [this] { setLayoutOf(render::Layout::Beside); });
    on("overlay", [this] { setLayoutOf(render::Layout::OverlayOnly); });
    on("four", [this] { setLayoutOf(render::Layout::Four); });
    on("fe_only", [this] { setLayoutOf(render::Layout::FeOnly); });
    on("fragments_only", [this] { setLayoutOf(render::Layout::FragmentsOnly); });
    on("other_scenario", [this] { setLayoutOf(render::Layout::Scenarios); });
    on("link", [this](bool linked) {
        render::View view = m_area->views().view();
        // Unlinked, the fragments start from where both looked; linked, both look as the FE view does.
        view.cameras[1] = view.cameras[2] = view.cameras[0];
        view.camerasLinked = linked;
        setView(view);
    });
    on("fit", [this] { m_area->views().fit(); });
    for (const char* theme : {"system", "light", "dark"}) {
        on(("theme_" + std::string(theme)).c_str(), [this, theme] {
            widgets::Preferences preferences = m_preferences;
            preferences.theme = QLatin1String(theme);
            setPreferences(preferences);
        });
    }
    connect(&m_inspection->selection(), &SelectionDisplay::changed, this, &MainWindow::showState);
    connect(m_colours, &QComboBox::activated, this, [this] {
        render::View view = m_area->views().view();
        view.colourBy = static_cast<render::ColourBy>(m_colours->currentData().toInt());
        setView(view);
    });
}

void MainWindow::connectComputation() {
    const auto on = [this](const char* id, auto slot) { connect(&m_actions[id], &QAction::triggered, this, slot); };
    on("simulate", [this] { simulate(false); });
    on("live", [this] { simulate(true); });
    on("cancel", [this] {
        // What runs in front first.
        if (m_computation.busy()) {
            m_computation.cancel();
        } else {
            m_accuracy->work().cancel();
            m_calibration->work().cancel();
            m_errors->work().cancel();
            m_studies->work().cancel();
        }
    });
    connect(m_deck, &PanelDeck::simulateRequested, this, [this] { simulate(false); });
    connect(m_deck, &PanelDeck::liveRequested, this, [this] { simulate(true); });
    connect(m_deck, &PanelDeck::cancelRequested, this, [this] { m_computation.cancel(); });
    connect(m_status, &widgets::StatusLine::cancelRequested, this, [this] { m_computation.cancel(); });
    m_computation.welcomeBy([this](const Opened& opened) { return welcomeFor(opened); });
    connect(&m_computation, &Computation::opened, this, &MainWindow::takeOpened);
    connect(&m_document.undoStack(), &QUndoStack::indexChanged, this, [this] { m_askedToLeave = false; });
    connect(&m_computation, &Computation::prepared, this, &MainWindow::prepared);
    connect(&m_computation, &Computation::decided, m_deck, &PanelDeck::showState);
    connect(&m_computation, &Computation::failed, this, &MainWindow::showFailure);
    connect(&m_computation, &Computation::stateChanged, this, &MainWindow::showState);
    connect(&m_computation, &Computation::runBegun, this, [this] {
        m_deck->showOutcome({});
        m_errors->refresh();
        showScene();
    });
    connect(&m_computation, &Computation::runGrew, this, [this] { m_area->views().update(); });
    connect(&m_computation, &Computation::runEnded, this, &MainWindow::runEnded);
    connect(&m_computation, &Computation::runReopened, this, &MainWindow::runReopened);
    connect(&m_computation, &Computation::progressed, this,
            [this](const QString& what) { m_area->setActivity(what.isEmpty() ? QString() : what + QStringLiteral(" …")); });
}

void MainWindow::connectPlayback() {
    const auto on = [this](const char* id, auto slot) { connect(&m_actions[id], &QAction::triggered, this, slot); };
    on("play", [this] { m_playback->toggle(); });
    on("back", [this] { m_playback->step(-1); });
    on("forward", [this] { m_playback->step(1); });
    on("back_ten", [this] { m_playback->step(-10); });
    on("forward_ten", [this] { m_playback->step(10); });
    on("first", [this] { m_playback->jumpToFirst(); });
    on("last", [this] { m_playback->jumpToLast(); });
}

void MainWindow::connectAccuracy() {
    connect(&m_deck->stack(), &QStackedWidget::currentChanged, this, &MainWindow::showCentre);
    connect(&m_deck->evidenceTabs(), &widgets::EvidenceTabs::currentChanged, this, &MainWindow::showCentre);
    connect(m_accuracy, &AccuracyDisplay::changed, this, &MainWindow::showState);
    connect(m_accuracy, &AccuracyDisplay::told, m_status, &widgets::StatusLine::setMessage);
    connect(m_accuracyPage, &widgets::AccuracyPage::saveTableRequested, this,
            [this] { m_files->saveSweep(m_accuracy->work().report()); });
    connect(m_accuracyPage, &widgets::AccuracyPage::saveChartRequested, this,
            [this] { m_files->saveChart(m_accuracyPage->chart(), QStringLiteral("-accuracy.svg")); });
    connect(&m_deck->accuracy(), &widgets::AccuracyPanel::tolerancesChanged, this, [this](const std::vector<double>& tolerances) {
        render::View view = m_area->views().view();
        view.errorSteps = errorStepsFor(tolerances);
        setView(view);
    });
}

void MainWindow::connectCosts() {
    connect(m_deck, &PanelDeck::gridSettled, this, &MainWindow::scenarioChanged);
    connect(m_grid, &GridDisplay::changed, this, &MainWindow::showGrid);
    connect(&m_deck->stack(), &QStackedWidget::currentChanged, this, &MainWindow::showGrid);
    connect(&m_accuracy->work(), &AccuracyWork::ended, m_forecast, &ForecastDisplay::pointsAdded);
    connect(m_calibration, &CalibrationDisplay::changed, this, &MainWindow::showState);
    connect(m_calibration, &CalibrationDisplay::told, m_status, &widgets::StatusLine::setMessage);
    widgets::CalibrationView& calibration = m_calibration->view();
    connect(&calibration, &widgets::CalibrationView::saveTableRequested, this,
            [this] { m_files->saveCalibration(m_calibration->work().calibration()); });
    connect(&calibration, &widgets::CalibrationView::saveChartRequested, this,
            [this] { m_files->saveChart(m_calibration->view().chart(), QStringLiteral("-calibration.svg")); });
    connect(m_errors, &ErrorDisplay::changed, this, [this] {
        showScene();
        showState();
    });
}

void MainWindow::connectEvidence() {
    const auto on = [this](const char* id, auto slot) { connect(&m_actions[id], &QAction::triggered, this, slot); };
    on("add_photographs", [this] { m_evidence->chooseFiles(); });
    using widgets::PhotoView;
    const std::array<std::pair<const char*, PhotoView::Show>, 5> shows{{{"photo_alone", PhotoView::Show::Photograph},
                                                                        {"photo_swipe", PhotoView::Show::Swipe},
                                                                        {"photo_blend", PhotoView::Show::Blend},
                                                                        {"photo_blink", PhotoView::Show::Blink},
                                                                        {"photo_outline", PhotoView::Show::Outline}}};
    for (const auto& [id, show] : shows) {
        on(id, [this, show] {
            m_deck->chooseEvidence(PanelDeck::Photographs);
            m_evidencePage->setShow(m_evidence->match() ? show : PhotoView::Show::Photograph);
        });
    }
    on("photo_beside", [this] {
        m_deck->chooseEvidence(PanelDeck::Photographs);
        m_evidencePage->setBeside(!m_evidencePage->beside());
    });
    on("add_point", [this] {
        if (m_evidence->chosen() >= 0) {
            m_deck->chooseEvidence(PanelDeck::Photographs);
            m_evidencePage->setTool(PhotoView::Tool::Point);
        }
    });
    on("compare_photo", [this] {
        m_deck->chooseEvidence(PanelDeck::Photographs);
        m_evidence->compare();
    });
    on("look_through", [this] { m_evidence->lookThrough(); });
    on("add_survey", [this] { m_survey->chooseFile(); });
    on("compare_survey", [this] {
        m_deck->choose(PanelDeck::Evidence);
        m_survey->compare();
    });
    connect(m_evidence, &EvidenceDisplay::told, m_status, &widgets::StatusLine::setMessage);
    connect(&m_document, &Document::surveysChanged, this, &MainWindow::showState);
    connect(m_survey, &SurveyDisplay::told, m_status, &widgets::StatusLine::setMessage);
    connect(m_survey, &SurveyDisplay::failed, this,
            [this](const QString& what, const QString& remedy) { m_status->setMessage(what + QLatin1Char(' ') + remedy); });
    connect(m_evidence, &EvidenceDisplay::lookThroughRequested, this, [this](const render::Camera& camera) {
        render::View view = m_area->views().view();
        view.layout = render::Layout::FragmentsOnly;
        view.camerasLinked = false;
        view.cameras[1] = camera;
        setView(view);
        m_deck->choose(PanelDeck::Run);
    });
}

void MainWindow::connectStudies() {
    const auto on = [this](const char* id, auto slot) { connect(&m_actions[id], &QAction::triggered, this, slot); };
    on("show_ensemble", [this] { m_deck->chooseEvidence(PanelDeck::Ensemble); });
    on("show_causes", [this] { m_deck->chooseEvidence(PanelDeck::Causes); });
    on("simulate_ensemble", [this] {
        m_deck->chooseEvidence(PanelDeck::Ensemble);
        m_studies->ensemble().simulate();
    });
    on("compare_causes", [this] {
        m_deck->chooseEvidence(PanelDeck::Causes);
        m_studies->causes().compare();
    });
    connect(m_studies, &EvidenceStudies::changed, this, &MainWindow::showState);
    connect(&m_studies->ensemble(), &EnsembleDisplay::groundChanged, this, &MainWindow::showScene);
    connect(m_studies, &EvidenceStudies::told, m_status, &widgets::StatusLine::setMessage);
    new DoneNotice(*this);
    connect(m_studies, &EvidenceStudies::failed, this,
            [this](const QString& what, const QString& remedy) { showFailure({what, remedy, "gui.write"}); });
    connect(m_studies, &EvidenceStudies::saveChartRequested, this,
            [this] { m_files->saveChart(m_studies->causesPage().chart(), QStringLiteral("-causes.svg")); });
}

void MainWindow::showCentre() {
    const int entry = m_deck->stack().currentIndex();
    const int page = m_deck->evidenceTabs().current();
    m_centre->setCurrentIndex(entry == PanelDeck::Accuracy ? 1 : entry == PanelDeck::Evidence ? 2 + page : 0);
}

void MainWindow::connectExports() {
    const auto on = [this](const char* id, auto slot) { connect(&m_actions[id], &QAction::triggered, this, slot); };
    on("export_figure", [this] { m_pictures->exportFigure(m_area->views().view(), sceneData()); });
    on("export_movie", [this] { m_pictures->exportMovie(m_area->views().view(), sceneData()); });
    on("write_report", [this] {
        m_deck->choose(PanelDeck::Report);
        m_report->write();
    });
    connect(m_pictures, &PictureExport::done, m_status, &widgets::StatusLine::setMessage);
    connect(m_report, &ReportWork::told, m_status, &widgets::StatusLine::setMessage);
    connect(m_return, &FigureReturn::told, m_status, &widgets::StatusLine::setMessage);
    connect(m_return, &FigureReturn::openRequested, this, [this](const QString& path) {
        if (!load(path, false)) {
            m_return->forget();
        }
    });
    connect(m_return, &FigureReturn::viewRequested, this, [this](const render::View& view, double aspect) {
        showView(figures::reshaped(view, aspect, m_area->views().width(), m_area->views().height()));
    });
    const auto fail = [this](const QString& what, const QString& remedy) { showFailure({what, remedy, "gui.write"}); };
    connect(m_pictures, &PictureExport::failed, this, fail);
    connect(m_return, &FigureReturn::failed, this, fail);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    m_deck->rail().setCompact(event->size().width() < compactBelow);
    m_transport->setFixedWidth(m_deck->rail().sizeHint().width() + panelWidth);
}

void MainWindow::showAbout() {
    QMessageBox::about(
        this, tr("About Rubble"),
        tr("<h3>Rubble %1</h3><p>Turns the elements that a collapse analysis deactivates into rigid fragments and shows where "
           "they go.</p><p>Method: Xu, Lu, Guan, Ren: Physics engine-driven visualization of deactivated elements and its "
           "application in bridge collapse simulation. Automation in Construction 35 (2013) 471-481.</p>")
            .arg(QString::fromUtf8(versionText().data(), static_cast<qsizetype>(versionText().size()))));
}

}  // namespace rubble
