#include <gtest/gtest.h>

#include <QDir>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>
#include <QTreeView>
#include <set>

#include "app/gui/case/file_commands.h"
#include "app/gui/case/new_case.h"
#include "app/gui/case/project_display.h"
#include "io/run/run_history.h"
#include "tests/app/gui/window/hour_of_use.h"
#include "tests/support/ascii_grid.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/parameter_editor.h"
#include "widgets/basics/prediction_box.h"
#include "widgets/basics/unit_label.h"
#include "widgets/case/case_panel.h"
#include "widgets/case/new_case_wizard.h"
#include "widgets/case/preferences_dialog.h"
#include "widgets/evidence/report_panel.h"
#include "widgets/figures/number_text.h"
#include "widgets/run/run_list.h"
#include "widgets/run/run_panel.h"
#include "widgets/views/status_line.h"

namespace rubble {

namespace {

/// What somebody met who saw the window for the first time, with a result of microseconds and with runs that were cancelled.
class ThirdHour : public HourOfUse {
protected:
    /// The small collapse in 70 microseconds, this far [m] above its ground.
    QString blast(double lift = 0.0) { return timedAs("blast.exo", 1.4e-4, lift); }
    QString small() { return smallAs("small.exo"); }
    /// The sentence of a panel that holds these words; empty: there is none.
    static QString noticeWith(const QWidget& panel, const QString& words) {
        for (const auto* notice : panel.findChildren<widgets::Notice*>()) {
            if (notice->text().contains(words)) {
                return notice->text();
            }
        }
        return {};
    }
    static QPushButton* buttonWith(const QWidget& panel, const QString& words) {
        for (auto* button : panel.findChildren<QPushButton*>()) {
            if (button->text().contains(words) && button->isVisible()) {
                return button;
            }
        }
        return nullptr;
    }
    void cancelARun() {
        session->document().setParameter(QStringLiteral("ground"), std::string("off"));
        session->document().setParameter(QStringLiteral("settle_time"), 3600.0);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        window->rooms().runs->simulate(false);
        begun();
        session->computation().cancel();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    }
    void begun() {
        ASSERT_TRUE(QTest::qWaitFor(
            [&] {
                const RunRecord* record = session->computation().currentRun();
                return record != nullptr && record->running && record->reader != nullptr && record->reader->frameCount() > 5;
            },
            patience));
    }
};

TEST_F(ThirdHour, BirthsOfABlastThatAreJoinedAreAFindingAndOneClickPartsThem) {
    openAndAwait(blast());
    clickPanel(PanelDeck::Fragments);
    QWidget& panel = *window->rooms().deck->shownPanel();
    const QString said = noticeWith(panel, QStringLiteral("birth window"));
    EXPECT_TRUE(said.contains(QStringLiteral("100.0\u00A0ms"))) << qPrintable(said);
    EXPECT_TRUE(said.contains(QStringLiteral("µs early"))) << qPrintable(said);
    const auto births = [&] {
        std::set<double> times;
        for (const Fragment& fragment : session->computation().results().fragments->list) {
            times.insert(fragment.handOverTime);
        }
        return times.size();
    };
    EXPECT_EQ(births(), 1U);
    const Scenario before = session->document().scenario();
    QPushButton* button = buttonWith(panel, QStringLiteral("Set “Birth window” to"));
    ASSERT_NE(button, nullptr);
    EXPECT_TRUE(button->text().endsWith(QStringLiteral("µs"))) << qPrintable(button->text());
    QTest::mouseClick(button, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && session->document().scenario() != before; }, patience));
    EXPECT_LT(session->document().scenario().fragments.birthWindow, 1e-6);
    EXPECT_GT(births(), 1U);
    EXPECT_TRUE(noticeWith(panel, QStringLiteral("birth window")).isEmpty());
    QTest::keyClick(window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(session->document().scenario(), before) << "one step of undo";
}

TEST_F(ThirdHour, TheWizardTellsAGroundBelowASmallModelAndItsTimes) {
    window->rooms().opening->newCase(blast(0.0064));
    NewCase& making = *window->rooms().opening->caseInTheMaking();
    ASSERT_TRUE(QTest::qWaitFor([&] { return making.settled() && making.computation().results().fragments != nullptr; }, patience));
    widgets::NewCaseWizard& wizard = making.wizard();
    wizard.go(widgets::NewCaseWizard::Ground);
    const auto* clock = wizard.findChild<QLabel*>(QStringLiteral("previewTime"));
    EXPECT_EQ(clock->text(), QStringLiteral("0.00 µs"));
    for (QAbstractButton* button : wizard.findChildren<QToolButton*>()) {
        if (button->toolTip() == QStringLiteral("Forward one state")) {
            QTest::mouseClick(button, Qt::LeftButton);
        }
    }
    EXPECT_TRUE(clock->text().endsWith(QStringLiteral("µs")) && !clock->text().startsWith(QStringLiteral("0.00")))
        << qPrintable(clock->text());
    EXPECT_TRUE(noticeWith(wizard.ground(), QStringLiteral("above this ground")).contains(QStringLiteral("0.0064")))
        << qPrintable(noticeWith(wizard.ground(), QStringLiteral("ground")));
    QTest::mouseClick(buttonWith(wizard.ground(), QStringLiteral("lowest point")), Qt::LeftButton);
    EXPECT_NEAR(making.document().scenario().simulation.groundHeight, 0.0064, 1e-3);
    EXPECT_TRUE(noticeWith(wizard.ground(), QStringLiteral("above this ground")).isEmpty());
    // A terrain is told as the level ground is.
    const std::vector<CaseInput> before = making.document().theCase().inputs;
    for (const auto& [height, words] : {std::pair(-1.5, "above this terrain"), std::pair(0.5, "below this terrain")}) {
        io::AsciiGrid().writeLevel(folder.filePath(QStringLiteral("level.asc")).toStdString(), height);
        std::vector<CaseInput> inputs = before;
        inputs.push_back({"terrain-1", InputRole::Terrain, folder.filePath(QStringLiteral("level.asc")).toStdString(), {}});
        making.document().setInputs(inputs, [] { return QStringLiteral("terrain level.asc"); });
        ASSERT_TRUE(QTest::qWaitFor([&] { return !noticeWith(wizard.ground(), QString::fromLatin1(words)).isEmpty(); }, patience))
            << words;
        EXPECT_TRUE(noticeWith(wizard.ground(), QStringLiteral("this ground")).isEmpty());
        making.document().setInputs(before, [] { return QStringLiteral("terrain left out"); });
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return noticeWith(wizard.ground(), QStringLiteral("this terrain")).isEmpty(); }, patience));
    }
    wizard.reject();
}

// A field takes what is typed in the unit that stands beside it.
TEST_F(ThirdHour, UnitsBesideFieldsAreThoseOfTheResultThatIsTold) {
    const auto units = [&] {
        int brief = 0;
        for (const auto* label : window->findChildren<widgets::UnitLabel*>()) {
            brief += label->text() == QStringLiteral("µs") ? 1 : 0;
        }
        return brief;
    };
    EXPECT_EQ(units(), 0);
    openAndAwait(blast());
    const int all = units();
    EXPECT_GT(all, 0);
    window->rooms().opening->newCase(small());
    NewCase& making = *window->rooms().opening->caseInTheMaking();
    ASSERT_TRUE(QTest::qWaitFor([&] { return making.settled() && making.computation().results().fragments != nullptr; }, patience));
    EXPECT_EQ(units(), 0);
    EXPECT_EQ(figures::timeUnit().name, QStringLiteral("s"));
    making.wizard().reject();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().opening->caseInTheMaking() == nullptr; }, patience));
    EXPECT_EQ(units(), all);
}

TEST_F(ThirdHour, UndoInAFieldThatNobodyTypedIntoIsThatOfTheCase) {
    openAndAwait(small());
    clickPanel(PanelDeck::Run);
    widgets::RunPanel& panel = window->rooms().deck->run();
    auto* field = panel.editor(QStringLiteral("settle_time"))->findChild<QLineEdit*>();
    panel.ensureWidgetVisible(field);
    const Scenario before = session->document().scenario();
    QTest::mouseClick(field, Qt::LeftButton);
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("0.5"));
    // What is half typed is taken back first.
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(session->document().scenario(), before);
    EXPECT_TRUE(field->hasFocus());
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("0.5"));
    QTest::keyClick(field, Qt::Key_Tab);
    ASSERT_TRUE(session->document().scenario() != before);
    auto* next = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    ASSERT_NE(next, nullptr) << "the next field has the focus";
    QTest::keyClick(next, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(session->document().scenario(), before);
    QTest::keyClick(next, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(session->document().scenario().simulation.settleTime, 0.5);
}

TEST_F(ThirdHour, AKeyThatCannotBeUsedSaysWhy) {
    QStringList told;
    QObject::connect(session.get(), &Session::told, session.get(), [&](const QString& words) { told << words; });
    QTest::keyClick(window, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(told, QStringList(QStringLiteral("Report: Open a result first.")));
    openAndAwait(small());
    cancelARun();
    told.clear();
    QTest::keyClick(window, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told[0].startsWith(QStringLiteral("Report: The run was cancelled at "))) << qPrintable(told[0]);
    EXPECT_TRUE(window->actions()[ActionId::WriteReport].toolTip().contains(QStringLiteral("was cancelled")));
    told.clear();
    QTest::keyClick(window, Qt::Key_Z, Qt::NoModifier);
    EXPECT_TRUE(told.isEmpty()) << "plain letters have meanings of their own";
}

TEST_F(ThirdHour, KeepingNoRunsTakesHoldAtOnceAndIsSaid) {
    openAndAwait(small());
    const QString caseFile = folder.filePath(QStringLiteral("small.rubble"));
    ASSERT_TRUE(window->rooms().files->saveTo(caseFile));
    session->document().setParameter(QStringLiteral("ground"), std::string("off"));
    session->document().setParameter(QStringLiteral("settle_time"), 3600.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    window->rooms().runs->simulate(false);
    begun();
    const QString file = session->computation().currentRun()->path;
    EXPECT_TRUE(session->computation().currentRun()->kept);
    QStringList told;
    QObject::connect(session.get(), &Session::told, session.get(), [&](const QString& words) { told << words; });
    window->actions()[ActionId::Preferences].trigger();
    auto* dialog = window->findChild<widgets::PreferencesDialog*>();
    ASSERT_NE(dialog, nullptr);
    auto* box = dialog->findChild<QSpinBox*>(QStringLiteral("keepRuns"));
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, QStringLiteral("0"));
    QTest::keyClick(box, Qt::Key_Return);
    EXPECT_EQ(box->text(), QStringLiteral("none"));
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told[0].contains(QStringLiteral("goes with the case as well"))) << qPrintable(told[0]);
    EXPECT_FALSE(session->computation().currentRun()->kept);
    session->computation().cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    EXPECT_TRUE(told.last().contains(QStringLiteral("no runs are kept"))) << qPrintable(told.last());
    const auto& runs = window->rooms().project->runs().runs();
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_TRUE(runs[0].file.empty());
    EXPECT_TRUE(QFile::exists(file)) << "it is in the views";
    session->document().setParameter(QStringLiteral("settle_time"), 0.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    simulateToEnd();
    EXPECT_FALSE(QFile::exists(file)) << "gone with the next one";
    EXPECT_FALSE(session->computation().currentRun()->kept);
}

// Of the list of the case and that of all cases.
TEST_F(ThirdHour, AnotherCaseShowsNothingOfTheRunBefore) {
    openAndAwait(small());
    simulateToEnd();
    clickPanel(PanelDeck::Run);
    const auto group = [&] { return window->rooms().deck->run().findChild<QPushButton*>(QStringLiteral("takeSettings")); };
    ASSERT_NE(group(), nullptr);
    ASSERT_TRUE(group()->isVisible());
    const auto said = [&] {
        const auto* box = window->rooms().deck->run().findChild<widgets::PredictionBox*>();
        const auto* heading = box->findChild<QLabel*>(QStringLiteral("groupHeading"));
        return heading->text();
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return said() == QStringLiteral("Said before the run, and measured"); }, patience));
    session->document().undoStack().setClean();
    openAndAwait(blast());
    clickPanel(PanelDeck::Run);
    EXPECT_FALSE(group()->isVisible()) << "no figures of another case's run";
    EXPECT_TRUE(QTest::qWaitFor([&] { return said() != QStringLiteral("Said before the run, and measured"); }, patience));
    for (const auto* list : window->rooms().deck->run().findChildren<widgets::FindingList*>()) {
        EXPECT_EQ(list->count(), 0) << "nor its findings";
    }
}

TEST_F(ThirdHour, ARunThatIsTaintedIsSoInItsLists) {
    openAndAwait(small());
    ASSERT_TRUE(window->rooms().files->saveTo(folder.filePath(QStringLiteral("small.rubble"))));
    simulateToEnd();
    ASSERT_EQ(window->rooms().project->runs().runs().size(), 1U);
    RunEntry run = window->rooms().project->runs().runs()[0];
    EXPECT_TRUE(run.grade.has_value());
    run.breaches = 2;
    run.grade = HealthGrade::Tainted;
    run.acknowledged = false;
    window->actions()[ActionId::Close].trigger();
    io::writeRunHistory(folder.filePath(QStringLiteral("small.rubble.runs.json")).toStdString(), {run});
    const QString caseFile = folder.filePath(QStringLiteral("small.rubble"));
    window->open(caseFile);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && session->document().path() == caseFile; }, patience));
    const auto* list = window->findChild<QListWidget*>(QStringLiteral("runList"));
    EXPECT_TRUE(list->item(0)->text().contains(QStringLiteral("tainted: 2 limits passed"))) << qPrintable(list->item(0)->text());
    window->actions()[ActionId::KeptRuns].trigger();
    const auto* kept = window->findChild<QDialog*>(QStringLiteral("keptRuns"));
    ASSERT_NE(kept, nullptr);
    const auto* table = kept->findChild<QTableWidget*>();
    ASSERT_EQ(table->rowCount(), 1);
    EXPECT_TRUE(table->item(0, 3)->text().contains(QStringLiteral("tainted: 2 limits passed")));
}

TEST_F(ThirdHour, FileDialogsShowSizesAndDatesWhole) {
    small();
    bool seen = false;
    whenAsked([&](QDialog& dialog) {
        auto* tree = dialog.findChild<QTreeView*>(QStringLiteral("treeView"));
        ASSERT_NE(tree, nullptr);
        ASSERT_TRUE(QTest::qWaitFor([&] { return tree->model()->rowCount(tree->rootIndex()) > 0; }, 10'000));
        QTest::qWait(200);
        int all = tree->header()->sectionSize(0);
        for (const int column : {1, 3}) {
            const int needed = qobject_cast<QAbstractItemView*>(tree)->sizeHintForColumn(column);
            EXPECT_GE(tree->header()->sectionSize(column), needed) << column;
            EXPECT_GT(needed, 0);
        }
        for (int column = 1; column < tree->header()->count(); ++column) {
            all += tree->header()->sectionSize(column);
        }
        EXPECT_LE(all, tree->viewport()->width() + 2) << "nothing is scrolled out of sight";
        EXPECT_GT(tree->header()->sectionSize(0), 150) << "the names keep their room";
        seen = true;
        dialog.reject();
    });
    QFileDialog dialog(window, QString(), folder.path());
    dialog.setOption(QFileDialog::DontUseNativeDialog);
    dialog.setViewMode(QFileDialog::Detail);
    dialog.exec();
    EXPECT_TRUE(seen);
}

}  // namespace

}  // namespace rubble
