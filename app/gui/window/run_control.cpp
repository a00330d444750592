#include "app/gui/window/run_control.h"

#include <QFileInfo>
#include <cmath>

#include "app/gui/accuracy/accuracy_display.h"
#include "app/gui/accuracy/calibration_display.h"
#include "app/gui/accuracy/error_display.h"
#include "app/gui/accuracy/forecast_display.h"
#include "app/gui/case/project_files.h"
#include "app/gui/evidence/evidence_studies.h"
#include "app/gui/evidence/validation_display.h"
#include "app/gui/run/health_display.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/stage/scene_display.h"
#include "app/gui/stage/status_feed.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/number_text.h"

namespace rubble {

namespace {

widgets::RunPanel::Outcome outcomeOf(const RunRecord& record) {
    widgets::RunPanel::Outcome outcome;
    outcome.result = record.outcome;
    outcome.wallSeconds = record.wallSeconds;
    outcome.solver = record.scenario.simulation.solver;
    outcome.fpsTarget = record.scenario.grid.fpsTarget;
    outcome.grounds = record.grounds();
    return outcome;
}

}  // namespace

RunControl::RunControl(Session& session, const Shown& shown, Actions& actions, QObject* parent)
    : QObject(parent), m_session(session), m_document(session.document()), m_computation(session.computation()), m_shown(shown) {
    connect(&actions[ActionId::Simulate], &QAction::triggered, this, [this] { simulate(false); });
    connect(&actions[ActionId::Live], &QAction::triggered, this, [this] { simulate(true); });
    connect(&actions[ActionId::Cancel], &QAction::triggered, this, &RunControl::cancel);
    connect(&m_shown.deck, &PanelDeck::simulateRequested, this, [this] { simulate(false); });
    connect(&m_shown.deck, &PanelDeck::liveRequested, this, [this] { simulate(true); });
    connect(&m_shown.deck.run(), &widgets::RunPanel::settingsRequested, this, &RunControl::takeSettings);
    connect(&m_shown.deck, &PanelDeck::cancelRequested, &m_computation, &Computation::cancel);
    connect(&m_computation, &Computation::decided, &m_shown.deck, &PanelDeck::showState);
    connect(&m_computation, &Computation::stateChanged, this, &RunControl::changed);
    connect(&m_computation, &Computation::prepared, &m_shown.errors, &ErrorDisplay::refresh);
    connect(&m_computation, &Computation::runBegun, this, &RunControl::runBegun);
    connect(&m_computation, &Computation::runEnded, this, &RunControl::runEnded);
    connect(&m_computation, &Computation::runReopened, this, &RunControl::runReopened);
    const auto judge = [this] { m_computation.judgeRun(m_document.scenario()); };
    connect(&m_document, &Document::replaced, this, judge);
    connect(&m_document, &Document::scenarioChanged, this, judge);
    connect(&m_computation, &Computation::prepared, this, judge);
    connect(&m_computation, &Computation::runEnded, this, judge);
    connect(&m_computation, &Computation::runReopened, this, judge);
    connect(&m_shown.accuracy, &AccuracyDisplay::changed, this, &RunControl::changed);
    connect(&m_shown.calibration, &CalibrationDisplay::changed, this, &RunControl::changed);
    connect(&m_shown.validation, &ValidationDisplay::changed, this, &RunControl::changed);
    connect(&m_shown.errors, &ErrorDisplay::changed, this, &RunControl::changed);
    connect(&m_shown.studies, &EvidenceStudies::changed, this, &RunControl::changed);
    connect(&m_shown.accuracy.work(), &AccuracyWork::ended, &m_shown.forecast, &ForecastDisplay::pointsAdded);
}

void RunControl::cancel() {
    // What runs in front first.
    if (m_computation.busy()) {
        m_computation.cancel();
    } else {
        m_shown.accuracy.work().cancel();
        m_shown.calibration.work().cancel();
        m_shown.validation.work().cancel();
        m_shown.errors.work().cancel();
        m_shown.studies.work().cancel();
    }
}

void RunControl::takeSettings() {
    if (const RunRecord* record = m_computation.currentRun()) {
        Scenario scenario = record->scenario;
        if (record->live) {
            // It ran at the rate of the screen.
            scenario.simulation.frameRate = m_document.scenario().simulation.frameRate;
        }
        m_document.edit([] { return tr("take the settings of the run"); }, scenario);
    }
}

void RunControl::showOrSimulate() {
    RunHistory& history = m_session.part<ProjectFiles>().runs;
    if (const std::optional<std::size_t> same = history.sameAsNow()) {
        m_shown.deck.choose(PanelDeck::Run);
        history.show(*same);
        m_session.tell(tr("This very run was kept: it is shown, and not simulated again."));
    } else {
        simulate(false);
    }
}

void RunControl::simulate(bool live) {
    const Results& results = m_computation.results();
    if (m_computation.inputs().fe == nullptr || (results.fragments != nullptr && results.fragments->list.empty()) ||
        !costlyWork().isEmpty()) {
        return;
    }
    m_shown.forecast.runBegins();
    m_session.part<ProjectFiles>().runs.begins();
    const CaseScenario* active = m_document.active();
    m_shown.deck.clearFailures();
    m_shown.deck.choose(PanelDeck::Run);
    m_computation.simulate(m_document.scenario(), active != nullptr ? QString::fromStdString(active->name) : QString(), live);
    emit changed();
}

void RunControl::runBegun() {
    m_shown.deck.showOutcome({});
    m_shown.errors.refresh();
    m_shown.scene.show();
}

void RunControl::runEnded(bool complete) {
    const RunRecord* record = m_computation.currentRun();
    widgets::RunPanel::Outcome outcome;
    if (record != nullptr && complete) {
        outcome = outcomeOf(*record);
        if (record->live) {
            outcome.liveMean = m_shown.feed.liveMean();
            outcome.liveWorst = m_shown.feed.liveWorst();
        }
        // Live mode keeps the pace of the collapse: its wall time is none of the setting's.
        m_shown.forecast.runEnded(
            {record->live ? std::nan("") : record->wallSeconds, record->live ? m_shown.feed.liveMean() : std::nan("")});
        m_session.tell(tr("Simulated in %1").arg(widgets::shownDuration(record->wallSeconds)));
    } else if (record != nullptr && record->reader != nullptr) {
        const QString words = record->kept ? tr("Cancelled at %1 after %2; what is computed is kept")
                                           : tr("Cancelled at %1 after %2; what is computed goes with the case: no runs are kept");
        m_session.tell(words.arg(figures::timeText(record->newest), widgets::shownDuration(record->wallSeconds)));
    } else {
        m_session.tell(tr("Cancelled"));
    }
    m_shown.deck.showOutcome(outcome);
    m_shown.errors.refresh();
    emit changed();
    m_shown.feed.refresh();
    // Edits that waited for the run are taken up now.
    if (m_computation.stale(Stage::Clusters, m_document.scenario()) && !m_computation.busy(Stage::Clusters)) {
        m_computation.update(m_document.scenario());
    }
}

void RunControl::runReopened() {
    const RunRecord& record = *m_computation.currentRun();
    m_shown.deck.showOutcome(outcomeOf(record));
    m_shown.errors.refresh();
    m_shown.health.refresh();
    m_shown.scene.show();
    emit changed();
    m_shown.feed.refresh();
    const QString name = QFileInfo(record.path).fileName();
    m_session.tell(record.scenario == m_document.scenario()
                       ? tr("Shown: the run %1").arg(name)
                       : tr("Shown: the run %1. It has other settings than the case; Run > Take its settings").arg(name));
}

QString RunControl::costlyWork() const {
    if (m_shown.accuracy.work().simulatesHere()) {
        return tr("Settings are being compared: work beside it would spoil the times.");
    }
    if (m_shown.calibration.work().running()) {
        return tr("This machine is being calibrated: work beside it would spoil the times.");
    }
    if (m_shown.validation.work().running()) {
        return tr("Measured falls are being simulated.");
    }
    if (m_shown.errors.work().running()) {
        return tr("A reference is being computed.");
    }
    if (m_shown.studies.work().comparing()) {
        return tr("Causes are being compared: members of their ensembles are being simulated.");
    }
    return m_shown.studies.work().running() ? tr("Members of an ensemble are being simulated.") : QString();
}

void RunControl::showBusy() {
    const bool simulating = m_computation.busy(Stage::Simulation);
    const QString others = costlyWork();
    const QString all = simulating ? tr("A run is being simulated.") : others;
    m_shown.accuracy.setBusy(m_shown.accuracy.work().running() ? QString() : others);
    m_shown.calibration.setBusy(m_shown.calibration.work().running() ? QString() : all);
    m_shown.validation.setBusy(m_shown.validation.work().running() ? QString() : all);
    m_shown.errors.setBusy(m_shown.errors.work().running() ? QString() : all);
    m_shown.studies.setBusy(m_shown.studies.work().running() ? QString() : others);
}

}  // namespace rubble
