#include <gtest/gtest.h>

#include <QDir>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>

#include "app/gui/case/file_commands.h"
#include "app/gui/case/project_display.h"
#include "app/gui/session/kept_runs.h"
#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/run/kept_runs_dialog.h"

namespace rubble {

namespace {

/// Two cases of the small collapse with a run each; the second one is open.
class KeptRunList : public FreshWorkbench {
protected:
    void SetUp() override {
        FreshWorkbench::SetUp();
        for (const char* name : {"east", "west"}) {
            const QString fe = folder.filePath(QLatin1String(name) + QStringLiteral(".exo"));
            window->open(QString::fromStdString(cli::writeSmallCollapse(fe.toStdString())));
            ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && session->document().openPath() == fe; }, patience));
            ASSERT_TRUE(window->rooms().files->saveTo(caseOf(name)));
            simulateToEnd();
        }
        window->actions()[ActionId::KeptRuns].trigger();
        ASSERT_NE(dialog(), nullptr);
        // Shortcuts need an active window, and a bare X server has no window manager to make one.
        QApplication::setActiveWindow(dialog());
    }
    QString caseOf(const char* name) const { return folder.filePath(QLatin1String(name) + QStringLiteral(".rubble")); }
    QStringList filesOf(const char* name) const {
        return QDir(caseOf(name) + QStringLiteral(".runs")).entryList(QDir::Files | QDir::Hidden);
    }
    widgets::KeptRunsDialog* dialog() { return window->findChild<widgets::KeptRunsDialog*>(); }
    QTableWidget& table() { return *dialog()->findChild<QTableWidget*>(); }
    QPushButton& button(const char* name) { return *dialog()->findChild<QPushButton*>(QLatin1String(name)); }
    QString total() { return dialog()->findChild<QLabel*>(QStringLiteral("keptTotal"))->text(); }
    /// Selects the only run of a case.
    void choose(const char* name) {
        const auto found = table().findItems(QLatin1String(name) + QStringLiteral(".rubble"), Qt::MatchExactly);
        ASSERT_EQ(found.size(), 1);
        table().selectionModel()->setCurrentIndex(table().indexFromItem(found.front()),
                                                  QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    }
    /// Presses Delete and answers what is asked.
    void remove(bool agree) {
        whenAsked([agree](QDialog& asked) {
            for (QAbstractButton* each : dynamic_cast<QMessageBox&>(asked).buttons()) {
                if ((each->text() == QStringLiteral("Remove")) == agree) {
                    QTest::mouseClick(each, Qt::LeftButton);
                    return;
                }
            }
        });
        QApplication::setActiveWindow(dialog());
        QTest::keyClick(&table(), Qt::Key_Delete);
    }

    QTemporaryDir folder;
};

TEST_F(KeptRunList, SaysWhatIsKeptOfAllCasesAndHowMuchRoomItTakes) {
    EXPECT_EQ(table().rowCount(), 2);
    EXPECT_TRUE(total().contains(QStringLiteral("runs: 2, cases: 2. Preferences allow 20 GiB a case."))) << qPrintable(total());
    choose("east");
    EXPECT_EQ(table().item(table().currentRow(), 3)->text(), QStringLiteral("no limit passed"));
    EXPECT_TRUE(button("openRun").isEnabled() && button("removeRun").isEnabled());
    choose("west");
    EXPECT_TRUE(table().item(table().currentRow(), 3)->text().contains(QStringLiteral("shown")));
    EXPECT_FALSE(button("openRun").isEnabled() || button("removeRun").isEnabled()) << "it is in the views";
    widgets::Preferences preferences = session->preferences();
    preferences.keepRunsGib = 3;
    session->setPreferences(preferences);
    EXPECT_TRUE(total().contains(QStringLiteral("allow 3 GiB"))) << qPrintable(total());
}

TEST_F(KeptRunList, RemovesOnlyWhatIsAgreedToAndBringsItBack) {
    const QStringList before = filesOf("east");
    choose("east");
    remove(false);
    EXPECT_EQ(filesOf("east"), before);
    remove(true);
    EXPECT_EQ(table().rowCount(), 1);
    EXPECT_TRUE(button("undoRemove").isEnabled());
    QApplication::setActiveWindow(dialog());
    QTest::keyClick(&table(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(table().rowCount(), 2);
    EXPECT_EQ(filesOf("east"), before);
    EXPECT_FALSE(button("undoRemove").isEnabled());
    choose("east");
    remove(true);
    QTest::keyClick(dialog(), Qt::Key_Escape);
    EXPECT_TRUE(filesOf("east").isEmpty()) << "gone once the list is closed";
    EXPECT_EQ(filesOf("west").size(), 1);
}

TEST_F(KeptRunList, OpensARunOfAnotherCase) {
    const QString file = session->computation().currentRun()->path;
    choose("east");
    QTest::keyClick(&table(), Qt::Key_Return);
    const auto shown = [&] {
        const RunRecord* record = session->computation().currentRun();
        return session->document().path() == caseOf("east") && record != nullptr && record->path != file && record->kept &&
               !session->computation().busy();
    };
    ASSERT_TRUE(QTest::qWaitFor(shown, patience));
    EXPECT_TRUE(session->computation().currentRun()->path.startsWith(caseOf("east")));
    EXPECT_TRUE(window->rooms().project->runs().shown().has_value());
}

TEST_F(KeptRunList, BringsBackWhatAProgramThatEndedHadSetAside) {
    QTest::keyClick(dialog(), Qt::Key_Escape);
    const QStringList before = filesOf("east");
    ASSERT_EQ(before.size(), 1);
    ASSERT_TRUE(setRunAside(caseOf("east") + QStringLiteral(".runs/") + before.front()));
    QTest::qWait(10);
    window->actions()[ActionId::KeptRuns].trigger();
    EXPECT_EQ(table().rowCount(), 2);
    EXPECT_EQ(filesOf("east"), before);
}

TEST_F(KeptRunList, IsReachedFromThePreferences) {
    QTest::keyClick(dialog(), Qt::Key_Escape);
    QTest::qWait(10);
    EXPECT_EQ(dialog(), nullptr);
    window->showPreferences();
    QTest::mouseClick(window->findChild<QPushButton*>(QStringLiteral("listKeptRuns")), Qt::LeftButton);
    EXPECT_NE(dialog(), nullptr);
}

}  // namespace

}  // namespace rubble
