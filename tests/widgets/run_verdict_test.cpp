#include "widgets/case/run_verdict.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QListWidget>
#include <QTableWidget>

#include "widgets/case/scenario_comparison.h"
#include "widgets/figures/shown_units.h"
#include "widgets/run/run_list.h"

namespace rubble::widgets {
namespace {

RunEntry runOf(bool complete, std::int64_t limits, std::optional<HealthGrade> grade, bool acknowledged = false) {
    RunEntry run;
    run.when = "2024-05-31T08:15:30Z";
    run.complete = complete;
    run.endTime = 3.2;
    run.breaches = limits;
    run.grade = grade;
    run.acknowledged = acknowledged;
    return run;
}

const RunEntry taintedRun = runOf(true, 2, HealthGrade::Tainted);

TEST(RunVerdict, SaysWhatTheFiguresAreWorth) {
    EXPECT_EQ(runVerdict(runOf(true, 0, HealthGrade::Notice)), QStringLiteral("no limit passed"));
    EXPECT_EQ(runVerdict(runOf(true, 1, HealthGrade::Finding)), QStringLiteral("finding: 1 limit passed"));
    EXPECT_EQ(runVerdict(runOf(true, 1, HealthGrade::Notice)), QStringLiteral("notice: 1 limit passed"));
    EXPECT_EQ(runVerdict(taintedRun), QStringLiteral("tainted: 2 limits passed"));
    EXPECT_EQ(runVerdict(runOf(true, 2, HealthGrade::Tainted, true)), QStringLiteral("2 limits passed, acknowledged"));
    EXPECT_EQ(runVerdict(runOf(true, 2, std::nullopt)), QStringLiteral("2 limits passed")) << "of a history without grades";
    EXPECT_EQ(runVerdict(runOf(false, 0, HealthGrade::Notice)), QStringLiteral("cancelled at 3.20 s"));
    EXPECT_EQ(runVerdict(runOf(false, 1, HealthGrade::Tainted)), QStringLiteral("cancelled at 3.20 s · tainted: 1 limit passed"));
}

TEST(RunVerdict, NobodyCancelledWhatEndedWithItsProgram) {
    RunEntry run = runOf(false, 0, HealthGrade::Notice);
    run.interrupted = true;
    EXPECT_EQ(runVerdict(run), QStringLiteral("interrupted at 3.20 s"));
}

TEST(RunVerdict, UnitsOfComparedSettingsAreThoseOfThePanels) {
    Scenario moon;
    moon.simulation.gravity = 1.62;
    ScenarioComparison comparison;
    comparison.setContent({{QStringLiteral("a"), QStringLiteral("earth"), {}, Scenario(), taintedRun, false},
                           {QStringLiteral("b"), QStringLiteral("moon"), {}, moon, taintedRun, false}});
    ASSERT_EQ(comparison.settings().rowCount(), 1);
    EXPECT_EQ(comparison.settings().item(0, 2)->text(), QStringLiteral("1.62"));
    EXPECT_EQ(comparison.settings().item(0, 3)->text(), QStringLiteral("m/s²"));
    figures::chooseUnits(figures::UnitSet::UsCustomary);
    comparison.choose(QStringLiteral("a"), QStringLiteral("b"));
    EXPECT_EQ(comparison.settings().item(0, 2)->text(), QStringLiteral("5.31496"));
    EXPECT_EQ(comparison.settings().item(0, 3)->text(), QStringLiteral("ft/s²"));
    QStringList units;
    for (int row = 0; row < comparison.results().rowCount(); ++row) {
        units << comparison.results().item(row, 3)->text();
    }
    figures::chooseUnits(figures::UnitSet::Si);
    EXPECT_TRUE(units.contains(QStringLiteral("ft/s"))) << "feet were said to be metres";
}

TEST(RunVerdict, StandsInTheListOfRuns) {
    RunList list;
    list.setContent({{taintedRun, false, false}, {runOf(false, 0, HealthGrade::Notice), false, false}});
    const auto* rows = list.findChild<QListWidget*>();
    EXPECT_TRUE(rows->item(0)->text().contains(QStringLiteral("cancelled at 3.20 s"))) << "the newest first";
    EXPECT_TRUE(rows->item(1)->text().contains(QStringLiteral("tainted: 2 limits passed")));
}

TEST(RunVerdict, StandsWhereScenariosAreCompared) {
    ScenarioComparison comparison;
    comparison.setContent(
        {{QStringLiteral("a"), QStringLiteral("as built"), {}, Scenario(), taintedRun, false},
         {QStringLiteral("b"), QStringLiteral("repaired"), {}, Scenario(), runOf(true, 0, HealthGrade::Notice), false}});
    QStringList said;
    for (int row = 0; row < comparison.results().rowCount(); ++row) {
        said << comparison.results().item(row, 1)->text() + u'|' + comparison.results().item(row, 2)->text();
    }
    EXPECT_TRUE(said.contains(QStringLiteral("tainted: 2 limits passed|no limit passed"))) << qPrintable(said.join(u'\n'));
}

}  // namespace
}  // namespace rubble::widgets
