#pragma once

#include <QStackedWidget>
#include <QWidget>
#include <optional>

#include "app/gui/session/worker.h"
#include "widgets/accuracy/accuracy_panel.h"
#include "widgets/accuracy/grid_panel.h"
#include "widgets/basics/panel.h"
#include "widgets/run/run_panel.h"
#include "widgets/views/stage_rail.h"

namespace rubble {

class Computation;
class Document;
class Session;
namespace widgets {
class CasePanel;
class CausesPanel;
class EffectsPanel;
class EnsemblePanel;
class EvidencePanel;
class EvidenceTabs;
class FragmentsPanel;
class ReportPanel;
}  // namespace widgets

/// The rail and its panels, kept in step with document and computation. What the user edits becomes undoable edits of the document.
class PanelDeck : public QObject {
    Q_OBJECT

public:
    enum Entry { Case, Fragments, Grid, Effects, Run, Accuracy, Evidence, Report };
    /// Panels of the entry Evidence.
    enum EvidencePage { Photographs, Ensemble, Causes };

    explicit PanelDeck(Session& session, QObject* parent = nullptr);
    ~PanelDeck() override;

    widgets::StageRail& rail() { return *m_rail; }
    widgets::CasePanel& casePanel() { return *m_case; }
    widgets::GridPanel& grid() { return *m_grid; }
    widgets::EffectsPanel& effects() { return *m_effects; }
    widgets::RunPanel& run() { return *m_run; }
    widgets::AccuracyPanel& accuracy() { return *m_accuracy; }
    widgets::EvidencePanel& evidence() { return *m_evidence; }
    widgets::EnsemblePanel& ensemble() { return *m_ensemble; }
    widgets::CausesPanel& causes() { return *m_causes; }
    widgets::EvidenceTabs& evidenceTabs() { return *m_evidenceTabs; }
    widgets::ReportPanel& report() { return *m_report; }
    QStackedWidget& stack() { return *m_stack; }
    /// The panel in use: for evidence that of its page.
    QWidget* shownPanel() const;
    std::vector<widgets::Panel*> panels() const;
    /// Findings in the boxes of a panel, and of all: what rail and status line count.
    static std::int64_t findingsIn(const QWidget& panel);
    std::int64_t findings() const;
    void choose(Entry entry);
    void chooseEvidence(EvidencePage page);
    /// Brings one of panels() to the front.
    void choosePanel(const widgets::Panel& panel);
    /// An entry by its number, or behind the last one a page of the entry Evidence: the ensemble, the causes.
    void choosePage(int page);
    /// Results have changed: shows them.
    void showResults();
    /// Settings or the state of the stages have changed.
    void showState();
    void showScenario();
    void showOutcome(const widgets::RunPanel::Outcome& outcome);
    /// Effects have been decided, or a run has measured them.
    /// @param anew  also where nothing has changed, for other colours
    void showEffects(bool anew = false);
    void showFailure(const Failure& failure);
    /// What is shown of them; unset: none.
    const std::optional<Failure>& failure() const { return m_kept.failure; }
    void clearFailures();
    /// Shows in a new window what an earlier one showed.
    void goOn();

signals:
    void simulateRequested();
    void liveRequested();
    void cancelRequested();
    /// An entry or a page of evidence was asked for, also the one that is shown already: the centre goes to it.
    void asked();
    /// The slider of the Basic Grid came to rest.
    void gridSettled();

private:
    /// What outlives the window.
    struct Kept {
        int entry = Case;
        int page = Photographs;
        widgets::RunPanel::Outcome outcome;
        std::optional<Failure> failure;
    };
    void edit(const QString& key, const ParameterValue& value);
    void regroup(const RegroupStep& step);
    void clearRegrouping();
    void showRail();
    void offerFlags(const FeResult* fe);
    static std::vector<widgets::RailEntry> entries();

    Kept& m_kept;
    Document& m_document;
    Computation& m_computation;
    widgets::StageRail* m_rail;
    QStackedWidget* m_stack;
    widgets::CasePanel* m_case;
    widgets::FragmentsPanel* m_fragments;
    widgets::GridPanel* m_grid;
    widgets::EffectsPanel* m_effects;
    widgets::RunPanel* m_run;
    widgets::AccuracyPanel* m_accuracy;
    widgets::EvidencePanel* m_evidence;
    widgets::EnsemblePanel* m_ensemble;
    widgets::CausesPanel* m_causes;
    widgets::EvidenceTabs* m_evidenceTabs;
    widgets::ReportPanel* m_report;
};

}  // namespace rubble
