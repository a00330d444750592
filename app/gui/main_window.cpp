#include "app/gui/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QSettings>
#include <QThread>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/accuracy_display.h"
#include "app/gui/calibration_display.h"
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
#include "app/gui/new_case.h"
#include "app/gui/panel_deck.h"
#include "app/gui/picture_export.h"
#include "app/gui/playback.h"
#include "app/gui/project_display.h"
#include "app/gui/report_work.h"
#include "app/gui/run_history.h"
#include "app/gui/scenario_pane.h"
#include "app/gui/selection_display.h"
#include "app/gui/settings.h"
#include "app/gui/status_feed.h"
#include "app/gui/survey_display.h"
#include "app/gui/view_area.h"
#include "app/gui/view_tools.h"
#include "io/fe_reader.h"
#include "widgets/accuracy_page.h"
#include "widgets/evidence_page.h"
#include "widgets/status_line.h"
#include "widgets/theme.h"
#include "widgets/timeline.h"
#include "widgets/transport.h"
#include "widgets/wording.h"

namespace rubble {

namespace {

/// Whether what is seen of one result can be seen of another alike: the files around it may be others.
bool sameToSee(const std::shared_ptr<const FeResult>& a, const std::shared_ptr<const FeResult>& b) {
    return a != nullptr && b != nullptr && a->times() == b->times() && a->mesh().nodes == b->mesh().nodes;
}

widgets::RunPanel::Outcome outcomeOf(const RunRecord& record) {
    widgets::RunPanel::Outcome outcome;
    outcome.result = record.outcome;
    outcome.wallSeconds = record.wallSeconds;
    outcome.settings = record.scenario.simulation;
    outcome.fpsTarget = record.scenario.grid.fpsTarget;
    return outcome;
}

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      m_actions(*this),
      m_deck(new PanelDeck(m_document, m_computation, this)),
      m_area(new ViewArea),
      m_accuracyPage(new widgets::AccuracyPage),
      m_evidencePage(new widgets::EvidencePage),
      m_timeline(new widgets::Timeline),
      m_transport(new widgets::Transport),
      m_status(new widgets::StatusLine),
      m_playback(new Playback(m_computation, m_area->views(), *m_timeline, *m_transport, this)),
      m_feed(new StatusFeed(m_document, m_computation, *m_playback, *m_status, this)),
      m_health(new HealthDisplay(m_computation, *m_deck, *m_playback, *m_area, *m_timeline, this)),
      m_accuracy(new AccuracyDisplay(m_document, m_computation, *m_deck, *m_accuracyPage, this)),
      m_grid(new GridDisplay(m_document, m_computation, *m_deck, this)),
      m_calibration(new CalibrationDisplay(m_document, *m_deck, *this, this)),
      m_forecast(new ForecastDisplay(m_document, m_computation, *m_grid, m_calibration->work(), *m_deck, this)),
      m_errors(new ErrorDisplay(m_computation, *m_area, this)),
      m_scenarioPane(new ScenarioPane(m_document, m_computation, *m_area, this)),
      m_inspection(new Inspection(m_document, m_computation, *m_playback, *m_area, m_actions, this)),
      m_studies(new EvidenceStudies(m_document, m_computation, *m_deck, this)),
      m_evidence(new EvidenceDisplay(
          m_document, m_computation, *m_deck, *m_evidencePage, *m_playback, [this] { return sceneData(); }, this)),
      m_survey(new SurveyDisplay(m_document, m_computation, *m_deck, *m_evidencePage, this)),
      m_files(new FileCommands(m_document, m_computation, *this)),
      m_pictures(new PictureExport(m_document, m_computation, *this)),
      m_return(new FigureReturn(m_document, m_computation, this)),
      m_report(new ReportWork(
          m_document, m_computation, *m_deck, [this] { return sceneData(); }, *this)),
      m_colours(new QComboBox),
      m_title(new QLabel),
      m_help(new Help(*this)) {
    setAcceptDrops(true);
    setWindowIcon(QIcon(QStringLiteral(":/desktop/org.rubble.Rubble.svg")));
    resize(1280, 800);
    buildLayout();
    buildMenus();
    buildToolBar();
    connectFiles();
    connectViews();
    connectComputation();
    connectPlayback();
    connectAccuracy();
    connectCosts();
    connectProject();
    connectEvidence();
    connectStudies();
    connectExports();
    qApp->installEventFilter(this);
    QSettings settings;
    QStringList complaints;
    applyPreferences(readPreferences(settings, &complaints));
    render::View view = m_area->views().view();
    setView(view);
    m_playback->reset();
    showTitle();
    showState();
    if (!complaints.isEmpty()) {
        m_status->setMessage(
            tr("Preferences that could not be read are as delivered: %1").arg(complaints.join(QStringLiteral(", "))));
    }
}

MainWindow::~MainWindow() {
    qApp->removeEventFilter(this);
    // Work ends before anything that it tells goes; and what lies on members goes before them.
    m_computation.disconnect();
    m_computation.cancel();
    m_document.undoStack().disconnect();
    m_document.disconnect();
    delete m_newCase;
    delete m_project;
    delete m_feed;
    delete m_health;
    delete m_accuracy;
    delete m_forecast;
    delete m_calibration;
    delete m_grid;
    delete m_inspection;
    delete m_survey;
    delete m_evidence;
    delete m_studies;
    delete m_scenarioPane;
    delete m_report;
    delete m_return;
    delete m_errors;
    delete m_playback;
    delete m_deck;
}

void MainWindow::recover(const LeftWork& work) {
    if (m_files->mayLeave()) {
        m_askedToLeave = true;
        m_simulateWhenReady = false;
        m_area->setError({});
        m_deck->clearFailures();
        m_computation.reopen(work.theCase, work.path, work.base, true);
    }
}

void MainWindow::refreshResult() {
    const auto fe = m_computation.inputs().fe;
    if (fe == nullptr) {
        return;
    }
    const auto grown = std::make_shared<bool>(false);
    m_computation.write([fe, grown](const Execution&) { *grown = io::hasGrown(*fe); },
                        [this, fe, grown](const std::exception_ptr& thrown) {
                            if (const auto failure = failureOf(thrown)) {
                                showFailure(*failure);
                            } else if (!*grown) {
                                m_status->setMessage(tr("Nothing new: the result has %1 states").arg(fe->stateCount()));
                            } else if (m_computation.inputs().fe == fe) {
                                m_refreshed = fe;
                                m_computation.reopen(m_document.theCase(), m_document.path(), m_document.base());
                            }
                        });
}

void MainWindow::showRefreshed(const FeResult& before, const render::View& view, double time) {
    const FeResult& fe = *m_computation.inputs().fe;
    const io::FeGrowth growth = io::growthBetween(before, fe);
    setView(view);
    m_playback->scrub(std::clamp(time, fe.times().front(), fe.times().back()));
    m_status->setMessage(growth.states > 0 ? tr("%1 states more, to %2 s; %3 elements more are dead")
                                                 .arg(growth.states)
                                                 .arg(QLocale().toString(fe.times().back(), 'g', 4))
                                                 .arg(growth.deaths)
                                           : tr("The result was read again: %1 states").arg(fe.stateCount()));
}

Welcome MainWindow::welcomeFor(const Opened& opened) {
    // What a dialog or a menu asks for is meant for the case that was there when it came up.
    if (QApplication::activeModalWidget() != nullptr || QThread::currentThread()->loopLevel() > 1) {
        return Welcome::Later;
    }
    const bool same = !m_document.empty() && opened.base == m_document.base();
    // The case may have been edited since somebody agreed to leave it.
    if (same || m_askedToLeave || !opened.recognised()) {
        return Welcome::Now;
    }
    m_askedToLeave = m_files->mayLeave();
    if (m_askedToLeave) {
        return Welcome::Now;
    }
    m_simulateWhenReady = false;
    m_return->forget();
    showState();
    return Welcome::Never;
}

void MainWindow::takeOpened(const Opened& opened) {
    const auto before = std::exchange(m_refreshed, nullptr);
    const bool again =
        !opened.recovered && !m_document.empty() && opened.base == m_document.base() && m_document.standsOn(opened.theCase);
    const bool terrainFailed = opened.failure && opened.failure->id.starts_with("terrain.");
    if (!opened.recognised() || (again && opened.fe == nullptr && m_computation.inputs().fe != nullptr && !terrainFailed)) {
        // Not a result at all, or not with these settings: what was open stays.
        showFailure(*opened.failure);
        showState();
        return;
    }
    if (!again) {
        m_document.replace(opened.theCase, opened.path, opened.base, opened.recovered);
        m_askedToLeave = false;
    }
    const bool refreshed = again && before != nullptr && before == m_computation.inputs().fe && opened.fe != nullptr;
    const bool around = again && !refreshed && !m_simulateWhenReady && sameToSee(m_computation.inputs().fe, opened.fe);
    const render::View viewBefore = m_area->views().view();
    const double timeBefore = m_playback->clock().time();
    m_computation.take(opened, m_document.scenario());
    showScene();
    if (opened.fe != nullptr && !refreshed && !around) {
        render::View view = render::defaultView(m_shown, m_area->views().width(), m_area->views().height());
        view.theme = widgets::currentTheme();
        view.colourBy = viewBefore.colourBy;
        view.colourMap = viewBefore.colourMap;
        view.style = viewBefore.style;
        view.axes = viewBefore.axes;
        view.groundGrid = viewBefore.groundGrid;
        view.shading = viewBefore.shading;
        setView(view);
        m_area->views().keepFitted();
        m_inspection->refresh();
    }
    m_area->showViews(opened.fe != nullptr, true);
    m_health->refresh();
    m_playback->reset();
    if (opened.fe != nullptr && m_simulateWhenReady) {
        m_playback->clock().play();
    }
    if (refreshed) {
        showRefreshed(*before, viewBefore, timeBefore);
    } else if (around) {
        setView(viewBefore);
        m_playback->scrub(timeBefore);
    } else {
        m_deck->choose(opened.fe != nullptr && !opened.path.isEmpty() ? PanelDeck::Grid : PanelDeck::Case);
    }
    showState();
}

void MainWindow::scenarioChanged() {
    m_deck->showScenario();
    if (m_grid->dragging()) {
        // Clusters are counted meanwhile; the rest follows when the slider rests.
        return;
    }
    const bool reread = m_computation.inputs().fe == nullptr || m_computation.importStale(m_document.scenario());
    if (reread && !m_document.empty()) {
        m_computation.reopen(m_document.theCase(), m_document.path(), m_document.base());
    } else {
        m_computation.update(m_document.scenario());
    }
    m_playback->refresh(m_computation.runStale(m_document.scenario()));
    showScene();
    showState();
}

void MainWindow::prepared() {
    m_deck->showResults();
    m_deck->clearFailures();
    m_errors->refresh();
    m_area->setError({});
    if (m_computation.failure()) {
        showFailure(*m_computation.failure());
    }
    showScene();
    showState();
    const bool ready =
        m_computation.results().clustering != nullptr && !m_computation.stale(Stage::Clusters, m_document.scenario());
    if (m_simulateWhenReady && ready) {
        m_simulateWhenReady = false;
        simulate(false);
    }
}

render::SceneData MainWindow::sceneData() const {
    const RunRecord* record = m_computation.currentRun();
    const Results& from = record != nullptr ? record->results : m_computation.results();
    render::SceneData scene;
    scene.fe = m_computation.inputs().fe;
    scene.components = from.components;
    scene.fragments = from.fragments;
    scene.clustering = from.clustering;
    scene.trajectory = record != nullptr ? record->reader : nullptr;
    scene.reference = m_errors->reference();
    scene.setSurroundings(record != nullptr ? record->scenario : m_document.scenario(), m_computation.inputs().terrain,
                          record != nullptr ? record->outcome.get() : nullptr);
    const auto& map = m_studies->ensemble().groundPicture();
    scene.orthophoto = map != nullptr ? map : m_computation.terrain().orthophoto;
    scene.surroundings = m_computation.terrain().surroundings;
    return scene;
}

void MainWindow::showScene() {
    const render::SceneData scene = sceneData();
    if (!(scene == m_shown)) {
        m_shown = scene;
        m_area->views().setData(scene);
        m_inspection->refresh();
        m_evidence->refresh();
    }
}

void MainWindow::simulate(bool live) {
    const Results& results = m_computation.results();
    if (m_computation.inputs().fe == nullptr || (results.fragments != nullptr && results.fragments->list.empty()) ||
        !costlyWork().isEmpty()) {
        return;
    }
    m_forecast->runBegins();
    m_project->runs().begins();
    const CaseScenario* active = m_document.active();
    m_deck->clearFailures();
    m_deck->choose(PanelDeck::Run);
    m_computation.simulate(m_document.scenario(), active != nullptr ? QString::fromStdString(active->name) : QString(), live);
    showState();
}

void MainWindow::runEnded(bool complete) {
    const RunRecord* record = m_computation.currentRun();
    widgets::RunPanel::Outcome outcome;
    if (record != nullptr && complete) {
        outcome = outcomeOf(*record);
        if (record->live) {
            outcome.liveMean = m_feed->liveMean();
            outcome.liveWorst = m_feed->liveWorst();
        }
        // Live mode keeps the pace of the collapse: its wall time is none of the setting's.
        m_forecast->runEnded({record->live ? std::nan("") : record->wallSeconds, record->live ? m_feed->liveMean() : std::nan("")});
        m_status->setMessage(tr("Simulated in %1").arg(widgets::shownDuration(record->wallSeconds)));
    } else {
        m_status->setMessage(record != nullptr && record->reader != nullptr
                                 ? tr("Cancelled at %1 s; what is computed is kept").arg(QLocale().toString(record->newest, 'f', 2))
                                 : tr("Cancelled"));
    }
    m_deck->showOutcome(outcome);
    m_errors->refresh();
    m_area->views().update();
    showState();
    m_feed->refresh();
    // Edits that waited for the run are taken up now.
    if (m_computation.stale(Stage::Clusters, m_document.scenario()) && !m_computation.busy(Stage::Clusters)) {
        m_computation.update(m_document.scenario());
    }
}

void MainWindow::runReopened() {
    const RunRecord& record = *m_computation.currentRun();
    m_deck->showOutcome(outcomeOf(record));
    m_errors->refresh();
    m_health->refresh();
    showScene();
    m_area->views().update();
    showState();
    m_feed->refresh();
    m_status->setMessage(tr("Shown: the run %1").arg(QFileInfo(record.path).fileName()));
}

void MainWindow::showFailure(const Failure& failure) {
    m_simulateWhenReady = false;
    m_deck->showFailure(failure.what, failure.remedy, failure.id);
    m_area->setError(failure.what, failure.remedy);
    m_status->setMessage(failure.what);
}

void MainWindow::showState() {
    const bool have = m_computation.inputs().fe != nullptr;
    const RunRecord* record = m_computation.currentRun();
    const bool finished = record != nullptr && record->outcome != nullptr && !record->running;
    const bool running = m_computation.busy(Stage::Simulation);
    const bool costly = !costlyWork().isEmpty();
    const bool deaths = m_computation.results().fragments == nullptr || !m_computation.results().fragments->list.empty();
    m_deck->showState();
    static const QStringList views =
        QStringLiteral(
            "play play_backwards loop loop_from loop_to bookmark previous_bookmark next_bookmark back "
            "forward back_ten forward_ten first last fit stacked beside overlay four fe_only fragments_only "
            "other_scenario link export_figure export_movie export_view import_view")
            .split(u' ');
    for (const QString& id : views) {
        m_actions[id.toStdString()].setEnabled(have);
    }
    m_actions["refresh"].setEnabled(have && !running);
    m_actions["simulate"].setEnabled(have && deaths && !running && !costly);
    m_actions["live"].setEnabled(have && deaths && !running && !costly);
    m_actions["cancel"].setEnabled(m_computation.busy() || costly);
    m_actions["save_run"].setEnabled(record != nullptr && !record->running);
    m_actions["export_fragments"].setEnabled(finished);
    m_actions["write_report"].setEnabled(finished && !m_report->writing());
    m_report->refresh();
    m_actions["export_series"].setEnabled(finished);
    m_actions["export_vtkhdf"].setEnabled(finished);
    m_actions["export_gltf"].setEnabled(finished);
    m_actions["export_selection"].setEnabled(finished && !m_inspection->selection().fragments().empty());
    for (const char* id : {"save", "save_as", "close", "preset_default", "preset_paper", "terrain", "orthophoto", "surroundings",
                           "site", "add_survey"}) {
        m_actions[id].setEnabled(!m_document.empty());
    }
    const auto has = [&inputs = m_document.theCase().inputs](InputRole role) {
        return std::any_of(inputs.begin(), inputs.end(), [role](const CaseInput& input) { return input.role == role; });
    };
    m_actions["no_terrain"].setEnabled(has(InputRole::Terrain));
    m_actions["no_surroundings"].setEnabled(has(InputRole::Orthophoto) || has(InputRole::Surroundings));
    m_actions["compare_survey"].setEnabled(finished && has(InputRole::Survey));
    m_colours->setEnabled(have);
    m_playback->refresh(record != nullptr && m_computation.runStale(m_document.scenario()));
    showBusy();
}

void MainWindow::showTitle() {
    if (m_document.empty()) {
        m_title->clear();
        setWindowTitle(QStringLiteral("Rubble"));
        return;
    }
    const CaseScenario* active = m_document.active();
    const QString name = QString::fromStdString(m_document.theCase().title);
    const QString saved = m_document.modified() ? tr("changed")
                          : m_document.path().isEmpty()
                              ? tr("not saved")
                              : tr("saved %1").arg(QFileInfo(m_document.path()).lastModified().toString(QStringLiteral("HH:mm")));
    m_title->setText(QStringLiteral("<span style='color:%1'>%2 · %3 <b>%4</b> · %5</span>&nbsp;&nbsp;")
                         .arg(widgets::tints().muted.name(), name.toHtmlEscaped(), tr("scenario"),
                              active != nullptr ? QString::fromStdString(active->name).toHtmlEscaped() : QString(), saved));
    m_title->setFixedHeight(menuBar()->sizeHint().height() - 2);
    m_title->setAlignment(Qt::AlignVCenter | Qt::AlignRight);
    // The menu bar asks its corner for its size only when it is set.
    menuBar()->setCornerWidget(m_title);
    m_title->show();
    setWindowTitle(QStringLiteral("%1%2 – Rubble").arg(name, m_document.modified() ? QStringLiteral(" *") : QString()));
}

void MainWindow::setView(const render::View& view) {
    m_area->views().setView(view);
    const std::array<const char*, 7> layouts = {"beside",  "stacked", "fe_only",       "fragments_only",
                                                "overlay", "four",    "other_scenario"};
    m_actions[layouts[static_cast<std::size_t>(view.layout)]].setChecked(true);
    m_actions["link"].setChecked(view.camerasLinked);
    m_colours->setCurrentIndex(m_colours->findData(static_cast<int>(view.colourBy)));
    m_errors->setShown(view.colourBy == render::ColourBy::Error);
    m_scenarioPane->setShown(view.layout == render::Layout::Scenarios);
    m_inspection->tools().refresh();
}

QString MainWindow::costlyWork() const {
    return m_accuracy->work().simulatesHere() ? tr("Settings are being compared: work beside it would spoil the times.")
           : m_calibration->work().running()  ? tr("This machine is being calibrated: work beside it would spoil the times.")
           : m_errors->work().running()       ? tr("A reference is being computed.")
           : m_studies->work().running()      ? tr("Members of an ensemble are being simulated.")
                                              : QString();
}

void MainWindow::showBusy() {
    const bool simulating = m_computation.busy(Stage::Simulation);
    const QString run = tr("A run is being simulated.");
    const bool comparing = m_accuracy->work().running();
    m_accuracy->setBusy(comparing ? QString() : costlyWork());
    m_calibration->setBusy(m_calibration->work().running() ? QString() : simulating ? run : costlyWork());
    m_errors->setBusy(m_errors->work().running() ? QString() : simulating ? run : costlyWork());
    m_studies->setBusy(m_studies->work().running() ? QString() : costlyWork());
}

void MainWindow::showGrid() {
    render::View view = m_area->views().view();
    view.basicGrid = m_deck->rail().current() == PanelDeck::Grid ? m_grid->grid() : std::nullopt;
    m_area->views().setView(view);
}

void MainWindow::setLayoutOf(render::Layout layout) {
    render::View view = m_area->views().view();
    view.layout = layout;
    setView(view);
    m_area->views().fit();
}

void MainWindow::setTheme(const QString& name) {
    widgets::applyTheme(widgets::themeNamed(name));
    m_actions["theme_" + (name.isEmpty() ? std::string("system") : name.toStdString())].setChecked(true);
    render::View view = m_area->views().view();
    view.theme = widgets::currentTheme();
    m_area->views().setView(view);
    m_inspection->refresh();
    m_deck->showResults();
    m_accuracy->refresh();
    m_calibration->refresh();
    m_evidence->refresh();
    m_survey->refresh();
    m_studies->refresh();
    m_feed->refresh();
    showTitle();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!m_files->mayLeave()) {
        event->ignore();
        return;
    }
    m_project->saveLayout();
    m_computation.cancel();
    m_accuracy->work().cancel();
    m_calibration->work().cancel();
    m_errors->work().cancel();
    m_evidence->work().cancel();
    m_survey->cancel();
    m_studies->work().cancel();
    event->accept();
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_retellable) {
        retell();
    }
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    // Keys that mean something to the widget with the focus go to it, not to the action that has the same key.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const QWidget* focus = QApplication::focusWidget();
        const auto* button = qobject_cast<const QAbstractButton*>(focus);
        const bool pushes = key->key() == Qt::Key_Space && button != nullptr;
        const bool moves = (key->key() == Qt::Key_Left || key->key() == Qt::Key_Right || key->key() == Qt::Key_Home ||
                            key->key() == Qt::Key_End) &&
                           (qobject_cast<const QAbstractSlider*>(focus) != nullptr ||
                            qobject_cast<const QComboBox*>(focus) != nullptr || (button != nullptr && button->group() != nullptr));
        if (watched == focus && (pushes || moves)) {
            event->accept();
            return true;
        }
    }
    return QMainWindow::eventFilter(watched, event);
}

}  // namespace rubble
