#include "app/gui/stage/panel_deck.h"

#include <algorithm>
#include <array>

#include "app/gui/session/regrouping_edit.h"
#include "app/gui/session/session.h"
#include "widgets/basics/evidence_tabs.h"
#include "widgets/basics/parameter_editor.h"
#include "widgets/basics/wording.h"
#include "widgets/case/case_panel.h"
#include "widgets/case/fragments_panel.h"
#include "widgets/evidence/causes_panel.h"
#include "widgets/evidence/ensemble_panel.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/evidence/report_panel.h"
#include "widgets/run/effects_panel.h"
#include "widgets/run/health_list.h"

namespace rubble {

namespace {

using widgets::StageState;

/// Of several stages under one entry: running over stale over not yet over up to date.
StageState worst(StageState a, StageState b) {
    for (const StageState state : {StageState::Running, StageState::Stale, StageState::NotYet}) {
        if (a == state || b == state) {
            return state;
        }
    }
    return StageState::UpToDate;
}

/// The file of the terrain as the case names it; empty: it has none.
QString terrainNamed(const Case& theCase) {
    for (const CaseInput& input : theCase.inputs) {
        if (input.role == InputRole::Terrain) {
            return QString::fromStdString(input.path);
        }
    }
    return {};
}

/// The names in quotes of a remedy that lists what a file holds.
QStringList offeredNames(const QString& remedy) {
    QStringList names;
    const QStringList parts = remedy.split(u'"');
    for (qsizetype i = 1; i < parts.size(); i += 2) {
        names << parts[i];
    }
    return names;
}

}  // namespace

PanelDeck::PanelDeck(Session& session, QObject* parent)
    : QObject(parent),
      m_kept(session.part<Kept>()),
      m_document(session.document()),
      m_computation(session.computation()),
      m_rail(new widgets::StageRail(entries())),
      m_stack(new QStackedWidget),
      m_case(new widgets::CasePanel),
      m_fragments(new widgets::FragmentsPanel),
      m_grid(new widgets::GridPanel),
      m_effects(new widgets::EffectsPanel),
      m_run(new widgets::RunPanel),
      m_accuracy(new widgets::AccuracyPanel),
      m_evidence(new widgets::EvidencePanel),
      m_ensemble(new widgets::EnsemblePanel),
      m_causes(new widgets::CausesPanel),
      m_evidenceTabs(new widgets::EvidenceTabs),
      m_report(new widgets::ReportPanel) {
    m_stack->setObjectName(QStringLiteral("panelStack"));
    m_evidenceTabs->addPage(tr("Photographs"), tr("What photographs show, and how far the simulated debris agrees."), m_evidence);
    m_evidenceTabs->addPage(tr("Ensemble"), tr("How sure it is where debris lies, with what is not known drawn anew."), m_ensemble);
    m_evidenceTabs->addPage(tr("Causes"), tr("Which of several supposed causes explains what was found."), m_causes);
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_case, m_fragments, m_grid, m_effects, m_run, m_accuracy, m_evidenceTabs, m_report}) {
        m_stack->addWidget(widget);
    }
    for (widgets::Panel* panel : panels()) {
        connect(panel, &widgets::Panel::edited, this, &PanelDeck::edit);
        connect(panel, &widgets::Panel::predictionHelpRequested, this, [this] { choose(Accuracy); });
    }
    connect(m_rail, &widgets::StageRail::chosen, this, [this](int entry) { choose(static_cast<Entry>(entry)); });
    connect(m_evidenceTabs, &widgets::EvidenceTabs::chosen, this, &PanelDeck::asked);
    connect(m_case, &widgets::CasePanel::regroupRequested, this, &PanelDeck::regroup);
    connect(m_case, &widgets::CasePanel::regroupingCleared, this, &PanelDeck::clearRegrouping);
    connect(m_grid, &widgets::GridPanel::draggingStarted, &m_document, &Document::beginGesture);
    connect(m_grid, &widgets::GridPanel::draggingEnded, this, [this] {
        m_document.endGesture();
        emit gridSettled();
    });
    connect(m_run, &widgets::RunPanel::simulateRequested, this, &PanelDeck::simulateRequested);
    connect(m_run, &widgets::RunPanel::liveRequested, this, &PanelDeck::liveRequested);
    connect(m_run, &widgets::RunPanel::cancelRequested, this, &PanelDeck::cancelRequested);
    choose(static_cast<Entry>(m_kept.entry));
    m_evidenceTabs->setCurrent(m_kept.page);
    showScenario();
}

PanelDeck::~PanelDeck() {
    m_kept.entry = m_stack->currentIndex();
    m_kept.page = m_evidenceTabs->current();
}

std::vector<widgets::RailEntry> PanelDeck::entries() {
    return {{tr("Case"), tr("What was computed, and of what the structure is made."), widgets::Glyph::Case},
            {tr("Fragments"), tr("What became debris, when, and with which mass."), widgets::Glyph::Fragments},
            {tr("Basic Grid"), tr("Which fragments move together, and what that costs."), widgets::Glyph::Grid},
            {tr("Effects"), tr("What acts on the fragments, why, and what it costs."), widgets::Glyph::Effects},
            {tr("Run"), tr("Where the fragments go."), widgets::Glyph::Run},
            {tr("Accuracy"),
             tr("Agreement with the reference (verification, no validation), what it costs in time, and which differences mean "
                "something."),
             widgets::Glyph::Accuracy},
            {tr("Evidence"), tr("What photographs show, and how far the simulated debris agrees."), widgets::Glyph::Evidence},
            {tr("Report"), tr("What was asked, what was found, and how sure that is."), widgets::Glyph::Report}};
}

void PanelDeck::goOn() {
    if (const std::optional<Failure> failure = m_kept.failure) {
        const int entry = m_stack->currentIndex();
        showFailure(*failure);
        choose(static_cast<Entry>(entry));
    }
    showResults();
    showOutcome(m_kept.outcome);
    showState();
}

std::vector<widgets::Panel*> PanelDeck::panels() const {
    return {m_case, m_fragments, m_grid, m_effects, m_run, m_accuracy, m_evidence, m_ensemble, m_causes, m_report};
}

std::int64_t PanelDeck::findingsIn(const QWidget& panel) {
    std::int64_t found = 0;
    for (const widgets::FindingList* list : widgets::findingLists(panel)) {
        found += list->count();
    }
    return found;
}

std::int64_t PanelDeck::findings() const {
    std::int64_t found = 0;
    for (const widgets::Panel* panel : panels()) {
        found += findingsIn(*panel);
    }
    return found;
}

void PanelDeck::choose(Entry entry) {
    m_rail->setCurrent(entry);
    m_stack->setCurrentIndex(entry);
    emit asked();
}

QWidget* PanelDeck::shownPanel() const {
    const std::array<QWidget*, 3> pages{m_evidence, m_ensemble, m_causes};
    return m_stack->currentIndex() == Evidence ? pages[static_cast<std::size_t>(m_evidenceTabs->current())]
                                               : m_stack->currentWidget();
}

void PanelDeck::chooseEvidence(EvidencePage page) {
    choose(Evidence);
    m_evidenceTabs->setCurrent(page);
    emit asked();
}

void PanelDeck::choosePanel(const widgets::Panel& panel) {
    const std::array<const widgets::Panel*, 3> pages{m_evidence, m_ensemble, m_causes};
    if (const auto page = std::find(pages.begin(), pages.end(), &panel); page != pages.end()) {
        chooseEvidence(static_cast<EvidencePage>(page - pages.begin()));
    } else {
        choose(static_cast<Entry>(m_stack->indexOf(&panel)));
    }
}

void PanelDeck::choosePage(int page) {
    if (page > Report) {
        chooseEvidence(static_cast<EvidencePage>(page - Report));
    } else {
        choose(static_cast<Entry>(page));
    }
}

void PanelDeck::edit(const QString& key, const ParameterValue& value) {
    if (m_document.empty()) {
        showScenario();
        return;
    }
    try {
        m_document.setParameter(key, value);
    } catch (...) {
        if (const auto failure = failureOf(std::current_exception())) {
            showFailure(*failure);
        }
        showScenario();
    }
}

void PanelDeck::regroup(const RegroupStep& step) {
    m_document.edit([step] { return widgets::regroupText(step); }, withRegrouping(m_document.scenario(), step));
}

void PanelDeck::clearRegrouping() {
    std::vector<std::string> parts;
    if (m_computation.inputs().fe != nullptr) {
        for (const Part& part : m_computation.inputs().fe->mesh().parts) {
            parts.push_back(part.name);
        }
    }
    m_document.edit([] { return tr("regrouping dropped"); }, withoutRegrouping(m_document.scenario(), parts));
}

void PanelDeck::showResults() {
    const Results& results = m_computation.results();
    const auto& fe = m_computation.inputs().fe;
    const io::TerrainInput& terrain = m_computation.terrain();
    const bool failed = m_computation.terrainFailed();
    m_case->setTerrain(terrain.grid, failed ? terrainNamed(m_computation.content().theCase) : QString::fromStdString(terrain.path),
                       io::openingFindings(m_computation.content()));
    m_case->setSurroundings(terrain.orthophoto != nullptr, terrain.surroundings ? terrain.surroundings->size() : 0,
                            terrain.collided);
    m_case->setContent(fe, results.components);
    offerFlags(fe.get());
    m_fragments->setContent(results.fragments, fe.get());
    // While the slider is held, counts for its place are shown.
    if (!m_grid->dragging()) {
        m_grid->setContent(
            {results.sizing, results.clustering, results.fragments, results.components, fe != nullptr ? &fe->mesh() : nullptr});
    }
    showEffects(true);
    showRail();
}

// A result that does not say what is dead opens all the same: what could be its flag is there to choose.
void PanelDeck::offerFlags(const FeResult* fe) {
    auto* const editor = m_case->editor(QStringLiteral("status_variable"));
    if (fe == nullptr || editor == nullptr) {
        return;
    }
    for (const Finding& finding : fe->contents().findings.list()) {
        if (finding.remedy.id == "fe.no_deaths.choices") {
            editor->offer(offeredNames(widgets::worded(finding.remedy)));
        }
    }
}

void PanelDeck::showEffects(bool anew) {
    const Scenario& scenario = m_document.scenario();
    const RunRecord* record = m_computation.currentRun();
    widgets::EffectsPanel::Content content;
    content.decisions = m_computation.decisions();
    content.stale = m_computation.decisionsStale(scenario);
    content.run = record != nullptr ? record->outcome : nullptr;
    content.runStale = record != nullptr && m_computation.runStale(scenario);
    content.components = m_computation.results().components;
    // Progress comes many times a second.
    if (anew || !(content == m_effects->content())) {
        m_effects->setContent(content);
    }
}

void PanelDeck::showScenario() {
    for (widgets::Panel* panel : panels()) {
        panel->setScenario(m_document.scenario());
        panel->setEditable(!m_document.empty());
    }
}

void PanelDeck::showRail() {
    const Scenario& scenario = m_document.scenario();
    const auto of = [&](Stage stage) { return m_computation.state(stage, scenario); };
    const auto fraction = [&](Stage a, Stage b) { return std::max(m_computation.fraction(a), m_computation.fraction(b)); };
    m_rail->setState(Case, worst(of(Stage::Import), of(Stage::Components)), findingsIn(*m_case),
                     fraction(Stage::Import, Stage::Components));
    m_rail->setState(Fragments, of(Stage::Fragments), findingsIn(*m_fragments), m_computation.fraction(Stage::Fragments));
    m_rail->setState(Grid, worst(of(Stage::Sizing), of(Stage::Clusters)), findingsIn(*m_grid),
                     fraction(Stage::Sizing, Stage::Clusters));
    m_rail->setState(Effects, m_computation.decisions() == nullptr     ? StageState::NotYet
                              : m_computation.decisionsStale(scenario) ? StageState::Stale
                                                                       : StageState::UpToDate);
    const RunRecord* record = m_computation.currentRun();
    const std::int64_t limits = record != nullptr && !record->acknowledged ? widgets::limitsIn(record->health()) : 0;
    const std::int64_t found = findingsIn(*m_run) + limits;
    m_rail->setState(Run, of(Stage::Simulation), found, m_computation.fraction(Stage::Simulation));
}

void PanelDeck::showState() {
    const Scenario& scenario = m_document.scenario();
    const Results& results = m_computation.results();
    const auto& fe = m_computation.inputs().fe;
    const RunRecord* record = m_computation.currentRun();
    showRail();
    showEffects();
    const bool running = m_computation.simulating();
    const bool waits = !running && m_computation.busy(Stage::Simulation);
    const bool none = results.fragments != nullptr && results.fragments->list.empty();
    QString why;
    if (fe == nullptr) {
        why = tr("Open a result first.");
    } else if (none) {
        why = tr("No element dies in this result, so there is nothing to simulate.");
    }
    m_run->setReady(fe != nullptr && !none, running || waits, why);
    const bool ended = record != nullptr && !record->running;
    Scenario now = scenario;
    if (ended && record->live) {
        // Live mode records as the screen needs it.
        now.simulation.frameRate = record->scenario.simulation.frameRate;
    }
    const bool other = ended && !(record->scenario == now);
    m_run->setOtherSettings(other);
    m_run->setStale(
        ended && record->outcome != nullptr && m_computation.runStale(scenario),
        other ? tr("The case has other settings than this run: it is shown as it was. Simulate to bring it up to date, or take its "
                   "settings.")
              : tr("What this run stands on has changed: it is shown as it was. Simulate to bring it up to date."));
    const bool sizeStale = m_computation.stale(Stage::Sizing, scenario) || m_computation.stale(Stage::Clusters, scenario);
    m_grid->setStale(sizeStale && running, tr("The sizes are counted anew when the simulation is through."));
}

void PanelDeck::showOutcome(const widgets::RunPanel::Outcome& outcome) {
    m_kept.outcome = outcome;
    m_run->setOutcome(outcome);
    showRail();
}

void PanelDeck::showFailure(const Failure& failure) {
    clearFailures();
    m_kept.failure = failure;
    const std::string& id = failure.id;
    widgets::Panel* where = m_case;
    Entry entry = Case;
    if (m_computation.currentRun() != nullptr && id.starts_with("io.run")) {
        where = m_run;
        entry = Run;
    }
    if (id.ends_with(".unknown_status")) {
        if (auto* editor = m_case->editor(QStringLiteral("status_variable"))) {
            editor->offer(offeredNames(failure.remedy()));
        }
    }
    where->setError(failure.what(), failure.remedy());
    choose(entry);
}

void PanelDeck::clearFailures() {
    m_kept.failure.reset();
    for (widgets::Panel* panel : panels()) {
        panel->setError({});
    }
}

}  // namespace rubble
