#include "app/gui/window/action_states.h"

#include <QComboBox>
#include <algorithm>

#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "app/gui/window/window_rooms.h"

namespace rubble {

namespace {

/// Need a model that can be seen.
constexpr const char* ofTheViews[] = {"play",
                                      "play_backwards",
                                      "loop",
                                      "loop_from",
                                      "loop_to",
                                      "bookmark",
                                      "previous_bookmark",
                                      "next_bookmark",
                                      "back",
                                      "forward",
                                      "back_ten",
                                      "forward_ten",
                                      "first",
                                      "last",
                                      "fit",
                                      "stacked",
                                      "beside",
                                      "overlay",
                                      "four",
                                      "fe_only",
                                      "fragments_only",
                                      "other_scenario",
                                      "link",
                                      "export_figure",
                                      "export_movie",
                                      "export_view",
                                      "import_view"};
/// Need a case.
constexpr const char* ofTheCase[] = {"save",    "save_as",    "close",        "preset_default", "preset_paper",
                                     "terrain", "orthophoto", "surroundings", "site",           "add_survey"};
/// Need a run that is complete.
constexpr const char* ofTheRun[] = {"export_fragments", "export_series", "export_vtkhdf", "export_gltf"};

}  // namespace

ActionStates::ActionStates(Session& session, WindowRooms& rooms, Actions& actions, QComboBox& colours, QObject* parent)
    : QObject(parent), m_session(session), m_rooms(rooms), m_actions(actions), m_colours(colours) {
    connect(rooms.opening.get(), &Opening::changed, this, &ActionStates::refresh);
    connect(rooms.runs.get(), &RunControl::changed, this, &ActionStates::refresh);
    connect(&rooms.inspection->selection(), &SelectionDisplay::changed, this, &ActionStates::refresh);
    connect(&session.document(), &Document::scenariosChanged, this, &ActionStates::refresh);
    connect(&session.document(), &Document::surveysChanged, this, &ActionStates::refresh);
    connect(&session.document(), &Document::replaced, this, [this] {
        m_rooms.deck->showScenario();
        refresh();
    });
    connectUndo();
}

void ActionStates::connectUndo() {
    QUndoStack& stack = m_session.document().undoStack();
    connect(&m_actions["undo"], &QAction::triggered, &stack, &QUndoStack::undo);
    connect(&m_actions["redo"], &QAction::triggered, &stack, &QUndoStack::redo);
    connect(&stack, &QUndoStack::indexChanged, this, &ActionStates::nameUndo);
    nameUndo();
}

void ActionStates::nameUndo() {
    const QUndoStack& stack = m_session.document().undoStack();
    m_actions["undo"].setEnabled(stack.canUndo());
    m_actions["redo"].setEnabled(stack.canRedo());
    const auto call = [](QAction& action, const QString& text, const QString& key) {
        action.setText(text);
        action.setIconText(text);
        action.setToolTip(QStringLiteral("%1 (%2)").arg(text, key));
    };
    call(m_actions["undo"], stack.canUndo() ? tr("Undo %1").arg(stack.undoText()) : tr("Undo"), QStringLiteral("Ctrl+Z"));
    call(m_actions["redo"], stack.canRedo() ? tr("Redo %1").arg(stack.redoText()) : tr("Redo"), QStringLiteral("Ctrl+Shift+Z"));
}

void ActionStates::refresh() {
    Computation& computation = m_session.computation();
    const Document& document = m_session.document();
    const bool have = computation.inputs().fe != nullptr;
    const RunRecord* record = computation.currentRun();
    const bool finished = record != nullptr && record->outcome != nullptr && !record->running;
    const bool running = computation.busy(Stage::Simulation);
    const bool costly = !m_rooms.runs->costlyWork().isEmpty();
    const bool deaths = computation.results().fragments == nullptr || !computation.results().fragments->list.empty();
    m_rooms.deck->showState();
    for (const char* id : ofTheViews) {
        m_actions[id].setEnabled(have);
    }
    for (const char* id : ofTheCase) {
        m_actions[id].setEnabled(!document.empty());
    }
    for (const char* id : ofTheRun) {
        m_actions[id].setEnabled(finished);
    }
    m_actions["refresh"].setEnabled(have && !running);
    m_actions["simulate"].setEnabled(have && deaths && !running && !costly);
    m_actions["live"].setEnabled(have && deaths && !running && !costly);
    m_actions["cancel"].setEnabled(computation.busy() || costly);
    m_actions["save_run"].setEnabled(record != nullptr && !record->running);
    m_actions["write_report"].setEnabled(finished && !m_rooms.report->writing());
    m_rooms.report->refresh();
    m_actions["export_selection"].setEnabled(finished && !m_rooms.inspection->selection().fragments().empty());
    const auto has = [&inputs = document.theCase().inputs](InputRole role) {
        return std::any_of(inputs.begin(), inputs.end(), [role](const CaseInput& input) { return input.role == role; });
    };
    m_actions["no_terrain"].setEnabled(has(InputRole::Terrain));
    m_actions["no_surroundings"].setEnabled(has(InputRole::Orthophoto) || has(InputRole::Surroundings));
    m_actions["compare_survey"].setEnabled(finished && has(InputRole::Survey));
    m_colours.setEnabled(have);
    m_rooms.playback->refresh(record != nullptr && computation.runStale(document.scenario()));
    m_rooms.runs->showBusy();
}

}  // namespace rubble
