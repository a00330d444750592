#include "app/gui/case/scenarios_display.h"

#include <QDialog>
#include <QFileInfo>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/case/project_files.h"
#include "app/gui/session/session.h"
#include "widgets/basics/wording.h"
#include "widgets/case/run_verdict.h"
#include "widgets/case/scenario_comparison.h"
#include "widgets/case/scenario_list.h"
#include "widgets/run/run_list.h"

namespace rubble {

ScenariosDisplay::ScenariosDisplay(Session& session, widgets::ScenarioList& scenarios, widgets::RunList& runs, QWidget& window)
    : m_document(session.document()),
      m_computation(session.computation()),
      m_history(session.part<ProjectFiles>().runs),
      m_scenarios(scenarios),
      m_runs(runs),
      m_window(window),
      m_kept(session.part<Kept>()) {
    connectList();
    connect(&m_document, &Document::replaced, this, &ScenariosDisplay::refresh);
    connect(&m_document, &Document::scenariosChanged, this, &ScenariosDisplay::refresh);
    connect(&m_document, &Document::scenarioChanged, this, &ScenariosDisplay::fillComparison);
    connect(&m_history, &RunHistory::changed, this, &ScenariosDisplay::refresh);
    connect(&m_computation, &Computation::stateChanged, this, [this] { m_runs.setSimulating(m_computation.simulating()); });
    m_runs.setSimulating(m_computation.simulating());
    refresh();
    if (m_kept.comparing) {
        compare();
    }
}

ScenariosDisplay::~ScenariosDisplay() {
    m_kept.comparing = m_dialog != nullptr && m_dialog->isVisible();
}

void ScenariosDisplay::connectList() {
    using widgets::ScenarioList;
    connect(&m_scenarios, &ScenarioList::activated, this,
            [this](const QString& id) { m_document.activateScenario(id.toStdString()); });
    connect(&m_scenarios, &ScenarioList::duplicateRequested, this,
            [this](const QString& id) { m_document.duplicateScenario(id.toStdString()); });
    connect(&m_scenarios, &ScenarioList::renamed, this,
            [this](const QString& id, const QString& name) { m_document.renameScenario(id.toStdString(), name); });
    connect(&m_scenarios, &ScenarioList::noteEdited, this,
            [this](const QString& id, const QString& note) { m_document.setScenarioNote(id.toStdString(), note); });
    connect(&m_scenarios, &ScenarioList::removeRequested, this,
            [this](const QString& id) { m_document.removeScenario(id.toStdString()); });
    connect(&m_scenarios, &ScenarioList::compareRequested, this, &ScenariosDisplay::compare);
    connect(&m_runs, &widgets::RunList::showRequested, &m_history, &RunHistory::show);
}

void ScenariosDisplay::refresh() {
    std::vector<widgets::ScenarioLine> lines;
    for (const CaseScenario& each : m_document.theCase().scenarios) {
        const RunEntry* run = m_history.newestOf(each.id);
        lines.push_back({QString::fromStdString(each.id), QString::fromStdString(each.name), QString::fromStdString(each.note),
                         run == nullptr
                             ? tr("No complete run yet")
                             : tr("Last run: %1 bodies, %2").arg(widgets::shownCount(run->bodies), widgets::runVerdict(*run))});
    }
    const CaseScenario* active = m_document.active();
    m_scenarios.setContent(lines, active != nullptr ? QString::fromStdString(active->id) : QString());
    std::vector<widgets::RunList::Line> runs;
    for (std::size_t i = 0; i < m_history.runs().size(); ++i) {
        const RunEntry& run = m_history.runs()[i];
        runs.push_back({run, !run.file.empty() && QFileInfo::exists(QString::fromStdString(run.file)), m_history.shown() == i});
    }
    m_runs.setContent(std::move(runs));
    fillComparison();
}

void ScenariosDisplay::fillComparison() {
    if (m_dialog.isNull() || !m_dialog->isVisible()) {
        return;
    }
    std::vector<widgets::ScenarioSide> sides;
    for (const CaseScenario& each : m_document.theCase().scenarios) {
        widgets::ScenarioSide side{QString::fromStdString(each.id),
                                   QString::fromStdString(each.name),
                                   QString::fromStdString(each.note),
                                   each.scenario,
                                   std::nullopt,
                                   false};
        if (const RunEntry* run = m_history.newestOf(each.id)) {
            side.run = *run;
            Scenario now = each.scenario;
            if (run->live) {
                // Live mode records each of its frames, whatever the setting says.
                now.simulation.frameRate = now.grid.fpsTarget;
            }
            side.runStale = m_computation.inputs().fe == nullptr ||
                            stageKey(m_computation.inputs(), now, Stage::Simulation) != run->fingerprint;
        }
        sides.push_back(std::move(side));
    }
    m_comparison->setContent(std::move(sides));
}

void ScenariosDisplay::compare() {
    if (m_document.theCase().scenarios.size() < 2) {
        return;
    }
    if (m_dialog.isNull()) {
        m_dialog = new QDialog(&m_window);
        m_dialog->setObjectName(QStringLiteral("scenarioComparison"));
        m_dialog->setWindowTitle(tr("Scenarios compared"));
        m_dialog->resize(680, 600);
        m_comparison = new widgets::ScenarioComparison;
        auto* column = new QVBoxLayout(m_dialog);
        column->setContentsMargins(0, 0, 0, 0);
        column->addWidget(m_comparison);
    }
    m_dialog->show();
    m_dialog->raise();
    fillComparison();
}

}  // namespace rubble
