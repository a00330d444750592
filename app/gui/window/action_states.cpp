#include "app/gui/window/action_states.h"

#include <QComboBox>
#include <algorithm>

#include "app/gui/case/project_display.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "app/gui/window/window_rooms.h"
#include "widgets/figures/number_text.h"

namespace rubble {

namespace {

/// Need a model that can be seen.
constexpr ActionId ofTheViews[] = {
    ActionId::Play,          ActionId::PlayBackwards,    ActionId::Loop,         ActionId::LoopFrom,     ActionId::LoopTo,
    ActionId::Bookmark,      ActionId::PreviousBookmark, ActionId::NextBookmark, ActionId::Back,         ActionId::Forward,
    ActionId::BackTen,       ActionId::ForwardTen,       ActionId::First,        ActionId::Last,         ActionId::Fit,
    ActionId::Stacked,       ActionId::Beside,           ActionId::Overlay,      ActionId::Four,         ActionId::FeOnly,
    ActionId::FragmentsOnly, ActionId::OtherScenario,    ActionId::Link,         ActionId::ExportFigure, ActionId::ExportMovie,
    ActionId::ExportView,    ActionId::ImportView,       ActionId::DebrisMap};
/// Need a case.
constexpr ActionId ofTheCase[] = {ActionId::Save,        ActionId::SaveAs,    ActionId::Close,      ActionId::PresetDefault,
                                  ActionId::PresetPaper, ActionId::Terrain,   ActionId::Orthophoto, ActionId::Surroundings,
                                  ActionId::Site,        ActionId::AddSurvey, ActionId::SealCase};
/// Need a run that is complete.
constexpr ActionId ofTheRun[] = {ActionId::SharePage, ActionId::ExportFragments, ActionId::ExportSeries, ActionId::ExportVtkhdf,
                                 ActionId::ExportGltf};

/// Why there is nothing to do with a run; empty: it is complete.
QString whyNoRun(const RunRecord* record, bool interrupted) {
    if (record != nullptr && record->running) {
        return ActionStates::tr("The run is not through yet.");
    }
    if (record != nullptr && record->outcome == nullptr) {
        return (interrupted ? ActionStates::tr("The run was interrupted at %1: simulate it to its end first.")
                            : ActionStates::tr("The run was cancelled at %1: simulate it to its end first."))
            .arg(figures::timeText(record->newest));
    }
    return record == nullptr ? ActionStates::tr("Simulate first.") : QString();
}

/// What is done with the photograph that is chosen.
void offerPhotograph(const EvidenceDisplay& evidence, Actions& actions) {
    const bool chosen = evidence.chosen() >= 0;
    actions.enable(ActionId::AddPoint, chosen);
    actions.enable(ActionId::LookThrough, chosen && evidence.match().has_value());
}

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
    connect(rooms.evidence.get(), &EvidenceDisplay::changed, this, [this] { offerPhotograph(*m_rooms.evidence, m_actions); });
    connectUndo();
}

void ActionStates::connectUndo() {
    QUndoStack& stack = m_session.document().undoStack();
    connect(&m_actions[ActionId::Undo], &QAction::triggered, &stack, &QUndoStack::undo);
    connect(&m_actions[ActionId::Redo], &QAction::triggered, &stack, &QUndoStack::redo);
    connect(&stack, &QUndoStack::indexChanged, this, &ActionStates::nameUndo);
    nameUndo();
}

void ActionStates::nameUndo() {
    const QUndoStack& stack = m_session.document().undoStack();
    m_actions.enable(ActionId::Undo, stack.canUndo(), tr("Nothing was changed."));
    m_actions.enable(ActionId::Redo, stack.canRedo(), tr("Nothing was taken back."));
    const auto call = [](QAction& action, const QString& text, const QString& key) {
        action.setText(text);
        action.setIconText(text);
        action.setToolTip(QStringLiteral("%1 (%2)").arg(text, key));
    };
    call(m_actions[ActionId::Undo], stack.canUndo() ? tr("Undo %1").arg(stack.undoText()) : tr("Undo"), QStringLiteral("Ctrl+Z"));
    call(m_actions[ActionId::Redo], stack.canRedo() ? tr("Redo %1").arg(stack.redoText()) : tr("Redo"),
         QStringLiteral("Ctrl+Shift+Z"));
}

void ActionStates::offerColours() {
    const bool inFront = m_actions.viewsInFront();
    if (m_coloursTip.isEmpty()) {
        m_coloursTip = m_colours.toolTip();
    }
    m_colours.setEnabled(inFront && m_session.computation().inputs().fe != nullptr);
    m_colours.setToolTip(inFront ? m_coloursTip : m_coloursTip + u'\n' + viewsCovered());
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
    const QString noResult = tr("Open a result first.");
    const RunHistory& history = m_rooms.project->runs();
    const bool interrupted = history.shown() && history.runs()[*history.shown()].interrupted;
    const QString noRun = have ? whyNoRun(record, interrupted) : noResult;
    for (const ActionId id : ofTheViews) {
        m_actions.enable(id, have, noResult);
    }
    for (const ActionId id : ofTheCase) {
        m_actions.enable(id, !document.empty(), tr("Open a case or a result first."));
    }
    for (const ActionId id : ofTheRun) {
        m_actions.enable(id, finished, noRun);
    }
    const QString whyNot = !have     ? noResult
                           : !deaths ? tr("No element dies in this result, so there is nothing to simulate.")
                           : running ? tr("A run is being simulated.")
                                     : m_rooms.runs->costlyWork();
    m_actions.enable(ActionId::Refresh, have && !running, have ? tr("A run is being simulated.") : noResult);
    m_actions.enable(ActionId::Simulate, have && deaths && !running && !costly, whyNot);
    m_actions.enable(ActionId::Live, have && deaths && !running && !costly, whyNot);
    m_actions.enable(ActionId::Cancel, computation.busy() || costly, tr("Nothing runs."));
    m_actions.enable(ActionId::SaveRun, record != nullptr && !record->running, noRun);
    m_actions.enable(ActionId::ExportMap, have && record != nullptr && !record->running, noRun);
    m_actions.enable(ActionId::WriteReport, finished && !m_rooms.report->writing(),
                     noRun.isEmpty() ? tr("A report is being written.") : noRun);
    m_rooms.report->refresh();
    m_actions.enable(ActionId::ExportSelection, finished && !m_rooms.inspection->selection().fragments().empty(),
                     noRun.isEmpty() ? tr("Select fragments first.") : noRun);
    const auto has = [&inputs = document.theCase().inputs](InputRole role) {
        return std::any_of(inputs.begin(), inputs.end(), [role](const CaseInput& input) { return input.role == role; });
    };
    m_actions.enable(ActionId::NoTerrain, has(InputRole::Terrain));
    m_actions.enable(ActionId::NoSurroundings, has(InputRole::Orthophoto) || has(InputRole::Surroundings));
    m_actions.enable(ActionId::CompareSurvey, finished && has(InputRole::Survey),
                     noRun.isEmpty() ? tr("Add a survey first.") : noRun);
    m_rooms.cloudTools->refresh();
    offerPhotograph(*m_rooms.evidence, m_actions);
    offerColours();
    m_rooms.playback->refresh(record != nullptr && computation.runStale(document.scenario()));
    m_rooms.runs->showBusy();
}

}  // namespace rubble
