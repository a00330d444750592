#pragma once

#include <memory>

#include "app/gui/accuracy/accuracy_display.h"
#include "app/gui/accuracy/calibration_display.h"
#include "app/gui/accuracy/error_display.h"
#include "app/gui/accuracy/forecast_display.h"
#include "app/gui/accuracy/grid_display.h"
#include "app/gui/case/file_commands.h"
#include "app/gui/case/project_display.h"
#include "app/gui/evidence/cloud_points.h"
#include "app/gui/evidence/evidence_display.h"
#include "app/gui/evidence/evidence_list_display.h"
#include "app/gui/evidence/evidence_studies.h"
#include "app/gui/evidence/map_display.h"
#include "app/gui/evidence/survey_display.h"
#include "app/gui/evidence/surveys/cloud_tools.h"
#include "app/gui/evidence/validation_display.h"
#include "app/gui/exports/bundle_opening.h"
#include "app/gui/exports/case_sealing.h"
#include "app/gui/exports/chart_export.h"
#include "app/gui/exports/picture_export.h"
#include "app/gui/exports/report_work.h"
#include "app/gui/run/health_display.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/scene_display.h"
#include "app/gui/stage/status_feed.h"
#include "app/gui/stage/timeline_display.h"
#include "app/gui/views/camera_keys.h"
#include "app/gui/views/inspection.h"
#include "app/gui/views/island_display.h"
#include "app/gui/views/scenario_pane.h"
#include "app/gui/views/selection_display.h"
#include "app/gui/window/action_states.h"
#include "app/gui/window/opening.h"
#include "app/gui/window/run_control.h"

class QBoxLayout;
class QComboBox;

namespace rubble {

class Actions;
class Session;
class ViewArea;
namespace widgets {
class AccuracyPage;
class EvidencePage;
class StatusLine;
class Timeline;
class Transport;
}  // namespace widgets

/// The widgets of a window that its rooms fill.
struct WindowParts {
    QWidget& window;
    Actions& actions;
    ViewArea& area;
    widgets::AccuracyPage& accuracyPage;
    widgets::EvidencePage& evidencePage;
    widgets::Timeline& timeline;
    widgets::Transport& transport;
    widgets::StatusLine& status;
    QComboBox& colours;   ///< chooses what the colour of a fragment says
    QBoxLayout& notices;  ///< above the centre
};

/// The rooms of a window. Each connects itself to the session, to its widgets and to the rooms that it needs; what two of them have
/// to say to each other is connected here. They are made in this order and end in the opposite one.
struct WindowRooms {
    WindowRooms(Session& session, const WindowParts& parts);
    WindowRooms(const WindowRooms&) = delete;
    WindowRooms& operator=(const WindowRooms&) = delete;
    ~WindowRooms();

    /// Shows what the session holds: in a window that was made anew, what the earlier one showed.
    void goOn();
    /// Shows everything in the colours of another theme.
    void useTheme();

    std::unique_ptr<PanelDeck> deck;
    std::unique_ptr<Playback> playback;
    std::unique_ptr<SceneDisplay> scene;
    std::unique_ptr<FileCommands> files;
    std::unique_ptr<ErrorDisplay> errors;
    std::unique_ptr<IslandDisplay> islands;
    std::unique_ptr<PictureExport> pictures;
    std::unique_ptr<ChartExport> charts;
    std::unique_ptr<CaseSealing> sealing;
    std::unique_ptr<BundleOpening> bundles;
    std::unique_ptr<ReportWork> report;
    std::unique_ptr<ScenarioPane> scenarioPane;
    std::unique_ptr<EvidenceStudies> studies;
    std::unique_ptr<EvidenceDisplay> evidence;
    std::unique_ptr<SurveyDisplay> survey;
    std::unique_ptr<CloudPoints> cloudPoints;
    std::unique_ptr<CloudTools> cloudTools;
    std::unique_ptr<EvidenceListDisplay> evidenceList;
    std::unique_ptr<Inspection> inspection;
    std::unique_ptr<MapDisplay> map;
    std::unique_ptr<GridDisplay> grid;
    std::unique_ptr<CalibrationDisplay> calibration;
    std::unique_ptr<ValidationDisplay> validation;
    std::unique_ptr<ForecastDisplay> forecast;
    std::unique_ptr<AccuracyDisplay> accuracy;
    std::unique_ptr<HealthDisplay> health;
    std::unique_ptr<StatusFeed> feed;
    std::unique_ptr<Opening> opening;
    std::unique_ptr<RunControl> runs;
    std::unique_ptr<ProjectDisplay> project;
    std::unique_ptr<TimelineDisplay> timeline;
    std::unique_ptr<CameraKeys> cameraKeys;
    std::unique_ptr<ActionStates> states;

private:
    void connectViews(const WindowParts& parts);
    void connectFiles(const WindowParts& parts);
    void connectGrid(const WindowParts& parts);
};

}  // namespace rubble
