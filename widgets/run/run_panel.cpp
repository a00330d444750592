#include "widgets/run/run_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <algorithm>

#include "core/evidence/cautions.h"
#include "core/simulation/effects/held_islands.h"
#include "core/simulation/health/passed_limits.h"
#include "widgets/basics/unit_label.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/number_text.h"
#include "widgets/run/effects_panel.h"

namespace rubble::widgets {

namespace {

/// The solver with its cost and its effect on the pile.
QString solverLine(SolverKind solver, const SimulationResult& result) {
    const QString cost = RunPanel::tr("mean %1 ms per step while debris is born").arg(shownNumber(result.stepTimes.meanMs, 2));
    const std::optional<Message> thin = thinPile(result.bulkingFactor, result.health.breaches);
    const QString factor = shownNumber(result.bulkingFactor);
    const QString pile = thin ? RunPanel::tr("bulking of the pile %1 (%2)").arg(factor, worded(*thin))
                              : RunPanel::tr("bulking of the pile %1").arg(factor);
    if (solver == SolverKind::Bullet) {
        return RunPanel::tr("Solver: bullet, %1, %2").arg(cost, pile);
    }
    // Files of earlier versions do not tell the substeps.
    return result.substeps > 0 ? RunPanel::tr("Solver: soft-step, %1 substeps or more, %2, %3").arg(result.substeps).arg(cost, pile)
                               : RunPanel::tr("Solver: soft-step, %1, %2").arg(cost, pile);
}

}  // namespace

RunPanel::RunPanel(QWidget* parent)
    : Panel(tr("Run"), tr("Where the fragments go."), parent),
      m_simulate(new QPushButton(tr("Simulate"))),
      m_live(new QPushButton(tr("Live"))),
      m_cancel(new QPushButton(tr("Cancel"))),
      m_why(new QLabel),
      m_notHeld(new FindingList),
      m_brief(new Notice),
      m_runs(new RunList),
      m_findings(new FindingList) {
    auto* buttons = new QWidget;
    auto* row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_simulate, 2);
    row->addWidget(m_live, 1);
    row->addWidget(m_cancel, 1);
    m_simulate->setObjectName(QStringLiteral("primary"));
    m_simulate->setToolTip(tr("Simulate the whole collapse as fast as it goes (Ctrl+R)"));
    m_live->setToolTip(
        tr("Simulate at the pace of the collapse and watch: each frame simulates one frame time and draws both views"));
    m_cancel->setToolTip(tr("Stop the run (Esc); what is computed so far stays in the views"));
    m_why->setObjectName(QStringLiteral("muted"));
    m_why->setWordWrap(true);
    addWide(buttons);
    addWide(m_why);
    connect(m_simulate, &QPushButton::clicked, this, &RunPanel::simulateRequested);
    connect(m_live, &QPushButton::clicked, this, &RunPanel::liveRequested);
    connect(m_cancel, &QPushButton::clicked, this, &RunPanel::cancelRequested);
    addPrediction();
    m_healthGroup = addGroup(tr("Health of the run"));
    m_health = new HealthList;
    m_healthGroup->addWide(m_health);
    connect(m_health, &HealthList::remedyChosen, this, &RunPanel::edited);
    buildOutcome();
    addGroup(tr("Runs of this case"))->addWide(m_runs);
    buildSettings();
    setReady(false, false, tr("Open a result first."));
    clearOutcome();
    setHealth(std::nullopt);
}

void RunPanel::setHealth(const std::optional<HealthList::Content>& health) {
    m_healthGroup->setVisible(health.has_value());
    const std::vector<RemedySetting> before = m_health->offered();
    m_health->setContent(health.value_or(HealthList::Content()));
    if (m_health->offered() != before) {
        showFindings();
    }
}

void RunPanel::showFindings() {
    m_findings->set(m_found, m_grounds, m_health->offered());
}

void RunPanel::buildSettings() {
    PanelGroup* engine = addGroup(tr("Engine"));
    for (const char* key : {"solver", "step_rate", "substeps", "iterations", "cluster_shape", "box_bulking", "gravity"}) {
        addParameter(engine, key);
    }
    addRemaining(Stage::Simulation, tr("Rest and recording"), isEffectParameter);
    addWide(m_notHeld);
    addWide(m_brief);
}

void RunPanel::setScenario(const Scenario& scenario) {
    Panel::setScenario(scenario);
    Findings found;
    if (const std::optional<Finding> finding = notHeld(scenario)) {
        found.add(finding->what, finding->remedy);
    }
    m_notHeld->set(found, {scenario, 0.0});
    showBriefResult();
}

bool RunPanel::event(QEvent* event) {
    if (event->type() == unitsChanged()) {
        showBriefResult();
    }
    return Panel::event(event);
}

// Debris of a blast flies on for seconds: nobody is to take these for the span of the FE result.
void RunPanel::showBriefResult() {
    const double span = figures::briefSpan();
    m_brief->setObjectName(QStringLiteral("briefResult"));
    m_brief->set(Notice::Kind::Note,
                 span > 0.0 ? tr("The FE result lasts %1. Its debris has at most the settle time to come to rest; each of the two "
                                 "has half of the timeline.")
                                  .arg(figures::timeText(span))
                            : QString(),
                 span > 0.0 ? tr("Steps per second are those of the settling: every state of the FE result is a step of its own. "
                                 "Times can be typed with a unit: 500 us, 20 ms, 2 s.")
                            : QString());
}

void RunPanel::setOtherSettings(bool other) {
    m_take->setEnabled(other);
    m_take->setToolTip(other ? tr("Settings of the case become those that this run was simulated with, in one step of undo")
                             : tr("The case has the settings of this run"));
}

void RunPanel::buildOutcome() {
    m_outcome = addGroup(tr("Last run"));
    m_take = new QPushButton(tr("Take its settings"));
    m_take->setObjectName(QStringLiteral("takeSettings"));
    connect(m_take, &QPushButton::clicked, this, &RunPanel::settingsRequested);
    m_outcome->addWide(m_take);
    setOtherSettings(false);
    m_solver = m_outcome->addNote({});
    m_solver->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_solver->setToolTip(
        tr("What the solver cost, and what it made of the pile: volume under its surface over volume of material. Broken "
           "rock has 1.3 to 1.7; below 1.15 the pile has squeezed into itself."));
    const QString single = worded(singleRunCaution().what);
    m_outcome->addNote(single.left(1).toUpper() + single.mid(1));
    m_bodies = m_outcome->addValue(
        tr("Bodies at most"), {},
        tr("Bodies that carry the fragments, at one instant. More than the clusters that were made where some broke up; loose "
           "structure is not among them"));
    m_awake = m_outcome->addValue(tr("Awake at most"), {},
                                  tr("Bodies that moved at one recorded instant; the others cost next to nothing"));
    m_asleep = m_outcome->addValue(tr("Asleep at the end"), {}, tr("Share of the bodies"));
    m_moving = m_outcome->addValue(tr("Still moving"), tr("bodies"));
    m_span = m_outcome->addValue(tr("The end"), {}, tr("When 99 % of the bodies slept, or the settle time was over"));
    m_wall = m_outcome->addValue(tr("Wall time"));
    m_step = m_outcome->addValue(tr("Step, mean and worst"), tr("ms"), tr("From the first to the last birth"));
    m_factor =
        m_outcome->addValue(tr("Real-time factor"), {}, tr("Simulated over wall time, first to last birth, recording included"));
    m_outcome->addNote(tr("Step and factor: from the first to the last birth, settling left out."));
    m_liveFps = m_outcome->addValue(tr("Live rate, mean and worst second"), tr("FPS"), tr("Measured in live mode"));
    m_energy =
        m_outcome->addValue(tr("Energy drift"), {}, tr("Largest gain beyond gravity, births and pieces, over gravity's work"));
    m_occupied = m_outcome->addValue(tr("Births in occupied space"), {}, tr("Bodies born inside older debris or pieces"));
    m_overlap = m_outcome->addValue(tr("Work of resolving overlap"));
    m_penetration = m_outcome->addValue(tr("Deepest contact"), tr("m"));
    m_released = m_outcome->addValue(
        tr("Loose structure, released"), {},
        tr("Live islands without a path to a support that became rigid bodies when the FE result ended, apart from fragments"));
    m_islands =
        m_outcome->addValue(tr("Live islands held"), {}, tr("Parts of the structure alive at the end without a path to a support"));
    m_carried =
        m_outcome->addValue(tr("Loose structure, carried"), {},
                            tr("Loose islands that the engine moved from when they came loose, before the FE result ended"));
    m_ledger = m_outcome->addValue(tr("Ledger, fragments"), {},
                                   tr("Largest relative error of mass, momentum, angular momentum against the FE result"));
    m_bodyLedger = m_outcome->addValue(tr("Ledger, bodies"), {}, tr("The same for the bodies, as read back from the engine"));
    m_hash = m_outcome->addValue(tr("Trajectory"), {}, tr("Hash of every recorded frame: equal runs have equal hashes"));
    addWide(m_findings);
}

void RunPanel::clearOutcome() {
    m_outcome->hide();
    m_found = {};
    showFindings();
}

void RunPanel::setOutcome(const Outcome& outcome) {
    if (outcome.result == nullptr) {
        clearOutcome();
        return;
    }
    const SimulationResult& r = *outcome.result;
    const auto sum = static_cast<double>(std::max<std::int64_t>(1, r.births.births));
    const auto pair = [](double a, double b) { return QStringLiteral("%1, %2").arg(shownNumber(a, 2), shownNumber(b, 2)); };
    m_solver->setText(solverLine(outcome.solver, r));
    m_bodies->setText(shownCount(r.bodiesPeak));
    m_awake->setText(shownCount(r.awakePeak));
    m_asleep->setText(shownShare(r.asleepAtEnd));
    m_moving->setText(shownCount(r.stillMoving));
    m_span->setText(figures::timeText(r.endTime));
    m_wall->setText(shownDuration(outcome.wallSeconds));
    m_step->setText(pair(r.stepTimes.meanMs, r.stepTimes.worstMs));
    m_factor->setText(shownNumber(r.stepTimes.realTimeFactor));
    m_liveFps->setText(outcome.liveMean > 0.0 ? QStringLiteral("%1, %2").arg(QLocale().toString(outcome.liveMean, 'f', 1),
                                                                             QLocale().toString(outcome.liveWorst, 'f', 0))
                                              : tr("not measured"));
    m_energy->setText(shownShare(r.energy.drift, 2));
    m_occupied->setText(
        QStringLiteral("%1 (%2)").arg(shownCount(r.births.occupied), shownShare(static_cast<double>(r.births.occupied) / sum, 0)));
    m_overlap->setText(shownEnergy(r.births.work));
    m_penetration->setText(shownIn(r.penetrationMax, "m", 2));
    const auto islands = [](std::int64_t count, std::int64_t elements) {
        return tr("%1 (%2 elements)").arg(shownCount(count), shownCount(elements));
    };
    m_released->setText(islands(r.islands.released, r.islands.releasedElements));
    m_released->setToolTip(
        tr("%1; %2 released inside debris or structure; %3 still move at the end")
            .arg(shownWith(r.islands.releasedMass, "kg"), shownCount(r.islands.occupied), shownCount(r.islands.stillMoving)));
    m_islands->setText(islands(r.islands.held(), r.islands.elements - r.islands.releasedElements));
    m_carried->setText(islands(r.carried.islands, r.carried.elements));
    m_carried->setToolTip(
        tr("%1; fragments born from them %2, of these after they had come to rest %3, by a blow twice as hard as in the engine %4; "
           "bodies left at the end %5")
            .arg(shownWith(r.carried.mass, "kg"), shownWith(r.carried.bornMass, "kg"), shownWith(r.carried.bornAtRestMass, "kg"),
                 shownWith(r.carried.bornSofterMass, "kg"), shownCount(r.carried.left)));
    m_ledger->setText(shownNumber(std::max({r.ledger.mass, r.ledger.momentum, r.ledger.angularMomentum}), 2));
    m_bodyLedger->setText(shownNumber(std::max({r.ledger.bodyMass, r.ledger.bodyMomentum, r.ledger.bodyAngularMomentum}), 2));
    m_hash->setText(QString::fromStdString(r.trajectoryHash.hex()).left(8));
    m_hash->setToolTip(QString::fromStdString(r.trajectoryHash.hex()));
    m_outcome->show();
    // What the health of the run says above is not said again.
    m_found = {};
    for (const Finding& finding : r.findings.list()) {
        if (!toldByHealth(finding)) {
            m_found.add(finding.what, finding.remedy, finding.example, finding.count);
        }
    }
    m_grounds = outcome.grounds;
    showFindings();
}

void RunPanel::setReady(bool ready, bool running, const QString& why) {
    m_simulate->setEnabled(ready && !running);
    m_live->setEnabled(ready && !running);
    m_cancel->setEnabled(running);
    m_why->setText(why);
    m_why->setVisible(!why.isEmpty());
}

}  // namespace rubble::widgets
