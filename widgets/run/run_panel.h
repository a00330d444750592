#pragma once

#include <memory>
#include <optional>

#include "core/simulation/run/simulation.h"
#include "widgets/basics/panel.h"
#include "widgets/run/health_list.h"
#include "widgets/run/run_list.h"

class QLabel;
class QPushButton;

namespace rubble::widgets {

/// Where the fragments go: the engine's settings, the buttons, and what the last run came to.
class RunPanel : public Panel {
    Q_OBJECT

public:
    explicit RunPanel(QWidget* parent = nullptr);

    /// What a finished run says about itself, with figures that only the window knows.
    struct Outcome {
        std::shared_ptr<const SimulationResult> result;
        SolverKind solver = SolverKind::SoftStep;
        double wallSeconds = 0.0;
        double liveMean = 0.0;   ///< FPS; 0: was not live
        double liveWorst = 0.0;  ///< FPS
        double fpsTarget = 0.0;
        RemedyGrounds grounds = {};  ///< what it was simulated with
    };
    void setOutcome(const Outcome& outcome);
    /// Nothing: no run to judge.
    void setHealth(const std::optional<HealthList::Content>& health);
    HealthList& health() { return *m_health; }
    RunList& runs() { return *m_runs; }
    /// Whether the run that is shown has other settings than the case: they can then be taken into it.
    void setOtherSettings(bool other);
    /// @param ready    there are clusters to simulate; @param why  else says what is missing
    /// @param running  only Cancel can be pushed; the buttons stand still
    void setReady(bool ready, bool running, const QString& why = {});
    void setScenario(const Scenario& scenario) override;
    /// Says how long a brief FE result lasts; nothing of others.
    void showBriefResult();

protected:
    bool event(QEvent* event) override;

signals:
    void simulateRequested();
    void liveRequested();
    void cancelRequested();
    /// The settings of the run that is shown are to be those of the case.
    void settingsRequested();

private:
    void buildSettings();
    void buildOutcome();
    void showFindings();
    void clearOutcome();

    QPushButton* m_simulate;
    QPushButton* m_live;
    QPushButton* m_cancel;
    QLabel* m_why;
    FindingList* m_notHeld;
    Notice* m_brief;
    PanelGroup* m_healthGroup;
    HealthList* m_health;
    RunList* m_runs;
    PanelGroup* m_outcome;
    Findings m_found;         ///< of the run, but for what its health says
    RemedyGrounds m_grounds;  ///< of the run
    QPushButton* m_take;
    QLabel* m_solver;
    QLabel* m_bodies;
    QLabel* m_awake;
    QLabel* m_asleep;
    QLabel* m_moving;
    QLabel* m_span;
    QLabel* m_wall;
    QLabel* m_step;
    QLabel* m_factor;
    QLabel* m_liveFps;
    QLabel* m_energy;
    QLabel* m_occupied;
    QLabel* m_overlap;
    QLabel* m_penetration;
    QLabel* m_released;
    QLabel* m_carried;
    QLabel* m_islands;
    QLabel* m_ledger;
    QLabel* m_bodyLedger;
    QLabel* m_hash;
    FindingList* m_findings;
};

}  // namespace rubble::widgets
