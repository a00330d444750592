#include "app/gui/window/window_rooms.h"

#include <QStackedWidget>
#include <QTimer>
#include <algorithm>
#include <vector>

#include "app/gui/case/kept_runs_display.h"
#include "app/gui/evidence/causes_display.h"
#include "app/gui/evidence/ensemble_display.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/stage/view_tools.h"
#include "app/gui/views/fragment_list.h"
#include "app/gui/views/history_display.h"
#include "widgets/accuracy/accuracy_chart.h"
#include "widgets/accuracy/accuracy_page.h"
#include "widgets/accuracy/calibration_chart.h"
#include "widgets/accuracy/calibration_view.h"
#include "widgets/case/case_panel.h"
#include "widgets/evidence/cause_chart.h"
#include "widgets/evidence/causes_page.h"
#include "widgets/run/health_list.h"
#include "widgets/views/history_panel.h"
#include "widgets/views/status_line.h"
#include "widgets/views/timeline.h"

namespace rubble {

namespace {

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

namespace {

/// Scrolls to a part of a panel, its top first.
void reach(widgets::Panel& panel, QWidget& part) {
    // A panel that comes into sight has its final size a little later.
    QTimer::singleShot(0, &part, [&panel, &part] {
        const int top = part.mapTo(panel.widget(), QPoint(0, 0)).y();
        panel.ensureVisible(0, top + part.height(), 0, 0);
        panel.ensureVisible(0, top, 0, 0);
    });
}

bool shows(const widgets::Panel& panel, const QWidget& part) {
    return part.isVisibleTo(&panel);
}

/// The next panel that has findings, from the one shown on.
void showFindings(PanelDeck& deck) {
    const std::vector<widgets::Panel*> panels = deck.panels();
    const auto shown = static_cast<std::size_t>(std::find(panels.begin(), panels.end(), deck.shownPanel()) - panels.begin());
    for (std::size_t step = 1; step <= panels.size(); ++step) {
        widgets::Panel& panel = *panels[(shown + step) % panels.size()];
        const std::vector<widgets::FindingList*> lists = widgets::findingLists(panel);
        if (!lists.empty()) {
            deck.choosePanel(panel);
            reach(panel, *lists.front());
            return;
        }
    }
}

/// What was passed; of a run that was stopped, which has no list of it, the first instant.
void showHealth(PanelDeck& deck, widgets::Timeline& timeline) {
    deck.choose(PanelDeck::Run);
    if (shows(deck.run(), deck.run().health())) {
        reach(deck.run(), deck.run().health());
    } else {
        emit timeline.markChosen(0);
    }
}

}  // namespace

WindowRooms::WindowRooms(Session& session, const WindowParts& parts)
    : deck(std::make_unique<PanelDeck>(session)),
      playback(std::make_unique<Playback>(session, parts.area.views(), parts.timeline, parts.transport, parts.actions)),
      scene(std::make_unique<SceneDisplay>(session, *playback, parts.area, parts.actions, parts.colours)),
      files(std::make_unique<FileCommands>(session, parts.actions, parts.window)),
      errors(std::make_unique<ErrorDisplay>(session, parts.area)),
      islands(std::make_unique<IslandDisplay>(session)),
      pictures(std::make_unique<PictureExport>(session, parts.window)),
      charts(std::make_unique<ChartExport>(session, parts.window)),
      sealing(std::make_unique<CaseSealing>(session, *files, parts.actions, parts.window)),
      bundles(std::make_unique<BundleOpening>(session, parts.actions, parts.window)),
      report(std::make_unique<ReportWork>(session, *deck, *scene, parts.actions, parts.window)),
      scenarioPane(std::make_unique<ScenarioPane>(session, parts.area, *islands)),
      studies(std::make_unique<EvidenceStudies>(session, *deck, parts.actions)),
      evidence(std::make_unique<EvidenceDisplay>(session, *deck, parts.evidencePage, *playback, *scene, parts.actions)),
      survey(std::make_unique<SurveyDisplay>(session, *deck, parts.evidencePage, parts.actions)),
      cloudPoints(std::make_unique<CloudPoints>(session, *deck, *scene, *survey, parts.area, parts.actions)),
      cloudTools(std::make_unique<CloudTools>(session, parts.actions, parts.area.views(), parts.window)),
      evidenceList(std::make_unique<EvidenceListDisplay>(session, *deck, *evidence, *survey)),
      inspection(std::make_unique<Inspection>(session, *playback, parts.area, parts.actions)),
      map(std::make_unique<MapDisplay>(session, *playback, inspection->docks(), parts.actions)),
      grid(std::make_unique<GridDisplay>(session, *deck)),
      calibration(std::make_unique<CalibrationDisplay>(session, *deck, parts.window)),
      validation(std::make_unique<ValidationDisplay>(session, parts.actions, parts.window)),
      forecast(std::make_unique<ForecastDisplay>(session, *grid, calibration->work(), *deck)),
      accuracy(std::make_unique<AccuracyDisplay>(session, *deck, parts.accuracyPage)),
      health(std::make_unique<HealthDisplay>(session, *deck, *playback, parts.area, parts.timeline)),
      feed(std::make_unique<StatusFeed>(session, *playback, *deck, parts.status)),
      opening(std::make_unique<Opening>(session, Opening::Shown{*deck, parts.area, *playback, *scene, *health, *inspection, *files},
                                        parts.actions, parts.window)),
      runs(std::make_unique<RunControl>(
          session,
          RunControl::Shown{*deck, *scene, *health, *forecast, *feed, *accuracy, *calibration, *validation, *errors, *studies},
          parts.actions)),
      project(std::make_unique<ProjectDisplay>(session, *deck, parts.area, parts.actions, parts.notices, inspection->docks(),
                                               parts.window)),
      timeline(std::make_unique<TimelineDisplay>(session.document(), *playback, parts.timeline, parts.transport, parts.actions)),
      cameraKeys(std::make_unique<CameraKeys>(session, *playback, parts.area, parts.timeline, parts.actions)),
      states(std::make_unique<ActionStates>(session, *this, parts.actions, parts.colours)) {
    connectViews(parts);
    connectFiles(parts);
    connectGrid(parts);
    report->setCauses(studies->causes());
    QObject::connect(&deck->casePanel(), &widgets::CasePanel::siteRequested, &parts.actions[ActionId::Site], &QAction::trigger);
    QObject::connect(&deck->casePanel(), &widgets::CasePanel::terrainRequested, &parts.actions[ActionId::Terrain],
                     &QAction::trigger);
    sealing->setReport(*report);
    QObject::connect(opening.get(), &Opening::simulateRequested, runs.get(), &RunControl::showOrSimulate);
    QObject::connect(opening.get(), &Opening::runChosen, &project->keptRuns(), &KeptRunsDisplay::openFile);
    QObject::connect(opening.get(), &Opening::sealedChosen, bundles.get(), &BundleOpening::open);
    QObject::connect(bundles.get(), &BundleOpening::opened, opening.get(), [this](const QString& path) { opening->open(path); });
    QObject::connect(project.get(), &ProjectDisplay::openRequested, opening.get(),
                     [this](const QString& path) { opening->open(path); });
    QObject::connect(project.get(), &ProjectDisplay::sampleRequested, opening.get(),
                     [this](const QString& path) { opening->open(path, true); });
    QObject::connect(project.get(), &ProjectDisplay::recoverRequested, opening.get(), &Opening::recover);
    QObject::connect(&parts.status, &widgets::StatusLine::cancelRequested, &session.computation(), &Computation::cancel);
    QObject::connect(&parts.status, &widgets::StatusLine::figureChosen, deck.get(),
                     [this, timeline = &parts.timeline](widgets::StatusLine::Figure figure) {
                         if (figure == widgets::StatusLine::Figure::Findings) {
                             showFindings(*deck);
                         } else {
                             showHealth(*deck, *timeline);
                         }
                     });
}

// The rooms end before the widgets that they fill, the last one first.
WindowRooms::~WindowRooms() = default;

void WindowRooms::connectViews(const WindowParts& parts) {
    QObject::connect(scene.get(), &SceneDisplay::changed, inspection.get(), &Inspection::refresh);
    QObject::connect(scene.get(), &SceneDisplay::changed, evidence.get(), &EvidenceDisplay::refresh);
    QObject::connect(scene.get(), &SceneDisplay::changed, cameraKeys.get(), &CameraKeys::refresh);
    QObject::connect(scene.get(), &SceneDisplay::viewSet, inspection.get(), [this](const render::View& view) {
        errors->setShown(view.colourBy == render::ColourBy::Error);
        islands->setShown(view.colourBy == render::ColourBy::Island);
        scenarioPane->setShown(view.layout == render::Layout::Scenarios);
        inspection->tools().refresh();
        inspection->list().showFilter();
    });
    QObject::connect(errors.get(), &ErrorDisplay::changed, scene.get(), [this] { scene->setReference(errors->reference()); });
    QObject::connect(islands.get(), &IslandDisplay::changed, scene.get(), [this] { scene->setLoose(islands->loose()); });
    const auto layGround = [this] {
        scene->setGround(map->groundPicture() != nullptr ? map->groundPicture() : studies->ensemble().groundPicture());
    };
    QObject::connect(&studies->ensemble(), &EnsembleDisplay::groundChanged, scene.get(), layGround);
    QObject::connect(map.get(), &MapDisplay::groundChanged, scene.get(), layGround);
    QObject::connect(evidence.get(), &EvidenceDisplay::lookThroughRequested, scene.get(),
                     [this, area = &parts.area](const render::Camera& camera) {
                         render::View view = area->views().view();
                         view.layout = render::Layout::FragmentsOnly;
                         view.camerasLinked = false;
                         view.cameras[1] = camera;
                         scene->setView(view);
                         deck->choose(PanelDeck::Run);
                     });
    QObject::connect(&deck->accuracy(), &widgets::AccuracyPanel::tolerancesChanged, scene.get(),
                     [this, area = &parts.area](const std::vector<double>& tolerances) {
                         render::View view = area->views().view();
                         view.errorSteps = errorStepsFor(tolerances);
                         scene->setView(view);
                     });
}

void WindowRooms::connectFiles(const WindowParts& parts) {
    const auto on = [&](ActionId id, auto slot) { QObject::connect(&parts.actions[id], &QAction::triggered, files.get(), slot); };
    on(ActionId::ExportSelection, [this] { files->exportSelection(inspection->selection().fragments()); });
    on(ActionId::ExportView, [this, area = &parts.area] { files->exportView(area->views().view()); });
    on(ActionId::ImportView, [this] {
        if (const auto view = files->importView()) {
            scene->look(*view);
        }
    });
    on(ActionId::ExportFigure, [this, area = &parts.area] { pictures->exportFigure(area->views().view(), scene->data()); });
    on(ActionId::ExportMovie, [this, area = &parts.area] { pictures->exportMovie(area->views().view(), scene->data()); });
    on(ActionId::SharePage, [this] { pictures->sharePage(scene->data()); });
    widgets::AccuracyPage* page = &parts.accuracyPage;
    QObject::connect(page, &widgets::AccuracyPage::saveTableRequested, files.get(),
                     [this] { files->saveSweep(accuracy->work().report()); });
    QObject::connect(page, &widgets::AccuracyPage::saveChartRequested, files.get(), [this, page] {
        if (const auto swept = accuracy->work().report()) {
            charts->save(page->chart(), QStringLiteral("-accuracy.svg"), charts->sweep(*swept, accuracy->work().machine()));
        }
    });
    widgets::CalibrationView* curves = &calibration->view();
    QObject::connect(curves, &widgets::CalibrationView::saveTableRequested, files.get(),
                     [this] { files->saveCalibration(calibration->work().calibration()); });
    QObject::connect(curves, &widgets::CalibrationView::saveChartRequested, files.get(), [this, curves] {
        if (const auto made = calibration->work().calibration()) {
            charts->save(curves->chart(), QStringLiteral("-calibration.svg"), ChartExport::calibration(*made));
        }
    });
    widgets::HistoryPanel* history = &inspection->history().panel();
    QObject::connect(history, &widgets::HistoryPanel::saveTableRequested, files.get(),
                     [this, history] { files->saveHistory(history->chart().content()); });
    QObject::connect(history, &widgets::HistoryPanel::saveChartRequested, files.get(),
                     [this, history] { charts->save(history->chart(), QStringLiteral("-history.svg"), charts->history()); });
    QObject::connect(studies.get(), &EvidenceStudies::saveChartRequested, files.get(), [this] {
        if (const auto made = studies->causes().made()) {
            charts->save(studies->causesPage().chart(), QStringLiteral("-causes.svg"), ChartExport::causes(*made));
        }
    });
}

void WindowRooms::connectGrid(const WindowParts& parts) {
    const auto showGrid = [this, area = &parts.area] {
        render::View view = area->views().view();
        view.basicGrid = deck->rail().current() == PanelDeck::Grid ? grid->grid() : std::nullopt;
        area->views().setView(view);
    };
    QObject::connect(grid.get(), &GridDisplay::changed, scene.get(), showGrid);
    QObject::connect(&deck->stack(), &QStackedWidget::currentChanged, scene.get(), showGrid);
}

void WindowRooms::goOn() {
    scene->goOn();
    playback->goOn();
    deck->goOn();
    errors->refresh();
    health->refresh();
    inspection->refresh();
    states->refresh();
    feed->refresh();
}

void WindowRooms::useTheme() {
    scene->useTheme();
    inspection->refresh();
    deck->showResults();
    accuracy->refresh();
    calibration->refresh();
    evidence->refresh();
    survey->refresh();
    studies->refresh();
    feed->refresh();
}

}  // namespace rubble
