#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <fstream>
#include <sstream>

#include "app/gui/accuracy/accuracy_display.h"
#include "app/gui/accuracy/comparison_memory.h"
#include "app/gui/case/file_commands.h"
#include "app/gui/stage/view_area.h"
#include "core/analysis/accuracy/sweep_table.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/accuracy/accuracy_chart.h"
#include "widgets/accuracy/accuracy_page.h"
#include "widgets/accuracy/accuracy_table.h"

namespace rubble {

namespace {

/// A window with a collapse of nine cubes, and a cache of its own.
class AccuracyWorkbench : public Workbench {
protected:
    void SetUp() override {
        qputenv("RUBBLE_CACHE", m_folder.filePath(QStringLiteral("cache")).toUtf8());
        Workbench::SetUp();
        const std::string path = m_folder.filePath(QStringLiteral("small.exo")).toStdString();
        cli::writeSmallCollapse(path);
        window->open(QString::fromStdString(path));
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        session->document().setParameter(QStringLiteral("settle_time"), 0.5);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        window->rooms().deck->choose(PanelDeck::Accuracy);
        panel().findChild<QLineEdit*>(QStringLiteral("multiples"))->setText(QStringLiteral("auto, 1, 2.5"));
    }
    void TearDown() override {
        endProgram();
        qunsetenv("RUBBLE_CACHE");
    }
    widgets::AccuracyPanel& panel() { return window->rooms().deck->accuracy(); }
    widgets::AccuracyPage& page() { return (*window->findChild<widgets::AccuracyPage*>()); }
    const AccuracyReport& report() { return *window->rooms().accuracy->work().report(); }
    void compare() {
        panel().findChild<QPushButton*>(QStringLiteral("primary"))->click();
        ASSERT_TRUE(window->rooms().accuracy->work().running());
        ASSERT_TRUE(QTest::qWaitFor([&] { return !window->rooms().accuracy->work().running(); }, patience));
    }
    QTemporaryDir m_folder;
};

TEST_F(AccuracyWorkbench, ComparesShowsAndUsesASettingWhichUndoTakesBack) {
    EXPECT_TRUE(page().isVisible()) << "the page takes the centre";
    EXPECT_FALSE(window->area().isVisible());
    EXPECT_EQ(rail(PanelDeck::Accuracy), widgets::StageState::NotYet);
    compare();
    ASSERT_TRUE(report().complete);
    ASSERT_EQ(report().points.size(), 4u);
    EXPECT_EQ(rail(PanelDeck::Accuracy), widgets::StageState::UpToDate);
    for (const AccuracyPoint& point : report().points) {
        EXPECT_TRUE(point.done && point.cost.timed()) << point.setting;
        EXPECT_GT(point.cost.fps, 0.0) << point.setting << ": live FPS are drawn off screen";
    }
    EXPECT_EQ(page().table().rowCount(), 6);
    widgets::AccuracyChart& chart = page().chart();
    ASSERT_EQ(chart.content().points.size() + chart.content().left, 5u);
    const auto inUse = [&chart]() -> int {
        for (const auto& point : chart.content().points) {
            if (point.inUse) {
                return point.row;
            }
        }
        return -2;
    };
    EXPECT_EQ(inUse(), 0) << "auto is what the case has";

    // A click on the point of another setting.
    const Scenario before = session->document().scenario();
    const int edits = session->document().undoStack().count();
    std::size_t other = 0;
    while (chart.content().points[other].row != 3) {
        ++other;
    }
    QTest::mouseMove(&chart, chart.placeOf(other).toPoint());
    QTest::mouseClick(&chart, Qt::LeftButton, {}, chart.placeOf(other).toPoint());
    EXPECT_EQ(session->document().undoStack().count(), edits + 1);
    EXPECT_NE(session->document().scenario(), before);
    EXPECT_EQ(rail(PanelDeck::Accuracy), widgets::StageState::UpToDate) << "the points still hold";
    ASSERT_GE(inUse(), 0);
    EXPECT_EQ(session->document().scenario(), report().points[static_cast<std::size_t>(inUse())].scenario);
    EXPECT_TRUE(session->document().undoStack().undoText().contains(QStringLiteral("setting")));
    QTest::keyClick(window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(session->document().scenario(), before);
    EXPECT_EQ(inUse(), 0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
}

TEST_F(AccuracyWorkbench, TheNextWindowAsksForTheSameComparison) {
    widgets::AccuracyPanel::Request asked = panel().request();
    asked.multiples = {"auto", "2"};
    asked.varied = {{"friction", {"0.3"}}, {"cluster_shape", {"axis_box", "hull"}}};
    asked.repeats = 1;
    asked.settingRepeats = 3;
    asked.tolerances = {0.05, 1.2345678};
    asked.liveFps = false;
    panel().setRequest(asked);
    compare();
    Session later;
    MainWindow next(later);
    const widgets::AccuracyPanel::Request found = next.rooms().deck->accuracy().request();
    EXPECT_EQ(found.multiples, asked.multiples);
    ASSERT_EQ(found.varied.size(), 2u);
    EXPECT_EQ(found.varied[1].key, "cluster_shape");
    EXPECT_EQ(found.varied[1].values, asked.varied[1].values);
    EXPECT_EQ(found.repeats, 1);
    EXPECT_EQ(found.settingRepeats, 3);
    EXPECT_EQ(found.tolerances, asked.tolerances);
    EXPECT_FALSE(found.liveFps);

    QSettings().setValue(QStringLiteral("comparison/tolerances_m"), QStringLiteral("nan"));
    QSettings().setValue(QStringLiteral("comparison/words"), QStringList{QStringLiteral("--repeats"), QStringLiteral("many")});
    const widgets::AccuracyPanel::Request standard;
    const widgets::AccuracyPanel::Request read = rememberedComparison(standard);
    EXPECT_EQ(read.tolerances, standard.tolerances) << "what does not read is as delivered";
    EXPECT_EQ(read.repeats, standard.repeats);
}

TEST_F(AccuracyWorkbench, PointsOfAnotherCaseOfAffairsAreStaleAndCannotBeUsed) {
    compare();
    session->document().setParameter(QStringLiteral("friction"), 0.9);
    EXPECT_EQ(rail(PanelDeck::Accuracy), widgets::StageState::Stale);
    const Scenario before = session->document().scenario();
    window->rooms().accuracy->adopt(1);
    EXPECT_EQ(session->document().scenario(), before);
    session->document().undoStack().undo();
    EXPECT_EQ(rail(PanelDeck::Accuracy), widgets::StageState::UpToDate);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
}

TEST_F(AccuracyWorkbench, FilesHoldTableAndChart) {
    compare();
    const auto at = [this](const char* name) { return m_folder.filePath(QLatin1String(name)); };
    window->rooms().files->saveSweepTo(at("a.csv"), report());
    std::stringstream expected;
    writeSweepCsv(report(), expected);
    EXPECT_EQ(textOf(at("a.csv")), expected.str());
    EXPECT_TRUE(textOf(at("a.csv")).starts_with("setting,multiple_x,multiple_y,multiple_z,grid_l_m"));
    const ChartSource source = window->rooms().charts->sweep(report(), "a machine");
    window->rooms().charts->saveTo(at("a.svg"), page().chart(), source);
    EXPECT_NE(textOf(at("a.svg")).find("<svg"), std::string::npos);
    window->rooms().charts->saveTo(at("a.png"), page().chart(), source);
    EXPECT_EQ(QImage(at("a.png")).size(), QSize(1920, 1280));
    // It says of what it is, what must be known, and on what machine; the file beside it says the rest.
    EXPECT_FALSE(source.note.subject.isEmpty());
    EXPECT_TRUE(source.note.foot.contains(QStringLiteral("a machine")));
    const auto told = io::readProvenance(at("a.svg").toStdString());
    ASSERT_TRUE(told);
    EXPECT_EQ(told->kind, "chart");
    EXPECT_NE(told->text.find("\"settings\""), std::string::npos);
    EXPECT_NE(told->text.find(report().points[1].setting), std::string::npos);
    QString complaint;
    QObject::connect(session.get(), &Session::failed, window, [&complaint](const Failure& failure) { complaint = failure.what(); });
    window->rooms().charts->saveTo(at("nowhere/a.svg"), page().chart(), source);
    EXPECT_TRUE(complaint.contains(QStringLiteral("nowhere")));
}

TEST_F(AccuracyWorkbench, WhatIsKeptIsNotSimulatedAgain) {
    compare();
    const Digest hash = report().points[1].trajectoryHash;
    EXPECT_FALSE(report().points[1].kept);
    compare();
    EXPECT_TRUE(report().points[1].kept);
    EXPECT_EQ(report().points[1].trajectoryHash, hash);
}

TEST_F(AccuracyWorkbench, SettingsThatCannotBeComparedAreRefusedInPlace) {
    panel().findChild<QLineEdit*>(QStringLiteral("varied"))->setText(QStringLiteral("gravity=1,2"));
    panel().findChild<QPushButton*>(QStringLiteral("primary"))->click();
    EXPECT_FALSE(window->rooms().accuracy->work().running());
    bool told = false;
    for (const widgets::Notice* notice : panel().findChildren<widgets::Notice*>()) {
        told = told || notice->text().contains(QStringLiteral("gravity"));
    }
    EXPECT_TRUE(told);
}

TEST_F(AccuracyWorkbench, CancelKeepsWhatIsDoneAndSimulateWaits) {
    panel().findChild<QSpinBox*>()->setValue(60);
    panel().findChild<QPushButton*>(QStringLiteral("primary"))->click();
    EXPECT_FALSE(window->actions()[ActionId::Simulate].isEnabled()) << "a run beside it would spoil the times";
    EXPECT_TRUE(window->actions()[ActionId::Cancel].isEnabled());
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return window->rooms().accuracy->work().report() != nullptr && report().reference.done; }, patience));
    if (window->rooms().accuracy->work().running()) {
        window->rooms().accuracy->work().cancel();
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window->rooms().accuracy->work().running(); }, patience));
    EXPECT_TRUE(report().reference.done);
    EXPECT_TRUE(window->actions()[ActionId::Simulate].isEnabled());
    // Another result has points of its own.
    session->document().undoStack().setClean();
    openArch();
    EXPECT_EQ(window->rooms().accuracy->work().report(), nullptr);
}

TEST_F(AccuracyWorkbench, NothingIsClippedAtTheSmallestSize) {
    compare();
    EXPECT_EQ(window->size(), QSize(1280, 800));
    EXPECT_LE(window->minimumSizeHint().width(), 1280);
    EXPECT_LE(window->minimumSizeHint().height(), 800);
}

}  // namespace
}  // namespace rubble
