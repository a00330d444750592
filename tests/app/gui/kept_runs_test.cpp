#include "app/gui/session/kept_runs.h"

#include <gtest/gtest.h>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QListWidget>
#include <QLockFile>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSysInfo>
#include <QTemporaryDir>
#include <QTest>

#include "app/gui/case/file_commands.h"
#include "app/gui/case/project_display.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/run/run_list.h"

namespace rubble {

namespace {

/// A file of some bytes, written so many seconds ago.
void writeOld(const QString& path, qint64 bytes, qint64 secondsAgo) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    ASSERT_TRUE(file.resize(bytes));
    ASSERT_TRUE(file.setFileTime(QDateTime::currentDateTime().addSecs(-secondsAgo), QFileDevice::FileModificationTime));
}

}  // namespace

TEST(KeptRuns, TheOldestMakeRoomAndThoseInUseStay) {
    const QTemporaryDir folder;
    for (int i = 0; i < 4; ++i) {
        writeOld(folder.filePath(QStringLiteral("%1.run.h5").arg(i)), 1000, 400 - 100 * i);
    }
    const auto held = holdFile(folder.filePath(QStringLiteral("1.run.h5.lock")));
    ASSERT_NE(held, nullptr);
    const DroppedRuns dropped = dropOldestRuns(folder.path(), 2000, {folder.filePath(QStringLiteral("0.run.h5"))});
    EXPECT_EQ(dropped.count, 2);
    EXPECT_EQ(dropped.bytes, 2000);
    EXPECT_EQ(QDir(folder.path()).entryList({QStringLiteral("*.run.h5")}), QStringList({"0.run.h5", "1.run.h5"}));
}

TEST(KeptRuns, TemporaryFoldersOfDeadProgramsAreFoundAndThoseOfLivingOnesStay) {
    const QTemporaryDir temporary;
    const auto make = [&](const char* name) {
        const QString folder = temporary.filePath(QLatin1String(name));
        QDir().mkpath(folder);
        return folder;
    };
    const QString mine = make("rubble-mine00");
    const auto held = holdFile(mine + u'/' + scratchLock);
    const QString dead = make("rubble-dead00");
    // As a program that was killed leaves it: its lock names a process that is no more.
    QProcess gone;
    gone.start(QStringLiteral("true"), QStringList());
    ASSERT_TRUE(gone.waitForStarted());
    const qint64 pid = gone.processId();
    ASSERT_TRUE(gone.waitForFinished());
    QFile lock(dead + u'/' + scratchLock);
    ASSERT_TRUE(lock.open(QIODevice::WriteOnly));
    lock.write(QByteArray::number(pid) + "\nrubble\n" + QSysInfo::machineHostName().toUtf8() + "\n");
    lock.close();
    writeOld(dead + QStringLiteral("/run-1.run.h5"), 3000, 10);
    const QString older = make("rubble-older0");
    writeOld(older + QStringLiteral("/run-1.run.h5"), 500, 200'000);
    const QString fresh = make("rubble-fresh0");
    writeOld(fresh + QStringLiteral("/run-1.run.h5"), 500, 10);
    const QString others = make("rubble-others");
    writeOld(others + QStringLiteral("/notes.txt"), 10, 200'000);
    const DroppedRuns dropped = dropDeadScratch(temporary.path());
    EXPECT_EQ(dropped.count, 2);
    EXPECT_EQ(dropped.bytes, 3500);
    EXPECT_TRUE(!QDir(dead).exists() && !QDir(older).exists());
    EXPECT_TRUE(QDir(mine).exists() && QDir(fresh).exists() && QDir(others).exists());
}

/// A saved case of the small collapse.
class KeptRun : public FreshWorkbench {
protected:
    void SetUp() override {
        FreshWorkbench::SetUp();
        const std::string fe = cli::writeSmallCollapse(folder.filePath(QStringLiteral("small.exo")).toStdString());
        openIt(QString::fromStdString(fe));
    }
    void openIt(const QString& path) {
        window->open(path);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && !session->document().empty(); }, patience));
    }
    QString caseFile() const { return folder.filePath(QStringLiteral("small.rubble")); }
    void saveCase() { ASSERT_TRUE(window->rooms().files->saveTo(caseFile())); }
    const std::vector<RunEntry>& runs() { return window->rooms().project->runs().runs(); }
    void cancelRun() {
        // Without a ground nothing comes to rest.
        session->document().setParameter(QStringLiteral("ground"), std::string("off"));
        session->document().setParameter(QStringLiteral("settle_time"), 3600.0);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        window->rooms().runs->simulate(false);
        const auto grown = [&] {
            const RunRecord* record = session->computation().currentRun();
            return record != nullptr && record->running && record->reader->frameCount() > 5;
        };
        ASSERT_TRUE(QTest::qWaitFor(grown, patience));
        session->computation().cancel();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    }

    QTemporaryDir folder;
};

TEST_F(KeptRun, LiesBesideItsCaseAndIsShownAgainLater) {
    saveCase();
    simulateToEnd();
    const Digest hash = session->computation().currentRun()->outcome->trajectoryHash;
    cancelRun();
    ASSERT_EQ(runs().size(), 2U);
    EXPECT_FALSE(runs()[1].complete);
    EXPECT_GT(runs()[1].wallSeconds, 0.0) << "a cancelled run took time as well";
    for (const RunEntry& run : runs()) {
        EXPECT_TRUE(QString::fromStdString(run.file).startsWith(caseFile() + QStringLiteral(".runs/"))) << run.file;
        EXPECT_TRUE(QFile::exists(QString::fromStdString(run.file)));
    }
    saveCase();
    endProgram();
    startProgram();
    window->show();
    openIt(caseFile());
    ASSERT_EQ(runs().size(), 2U);
    window->rooms().deck->choose(PanelDeck::Run);
    auto* list = window->rooms().deck->run().runs().findChild<QListWidget*>();
    auto* show = window->rooms().deck->run().runs().findChild<QPushButton*>(QStringLiteral("showRun"));
    for (const int row : {0, 1}) {
        list->setCurrentRow(row);
        ASSERT_TRUE(show->isEnabled()) << row;
        show->click();
        const std::size_t place = row == 0 ? 1 : 0;
        ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().project->runs().shown() == place; }, patience));
        EXPECT_GT(session->computation().currentRun()->reader->frameCount(), 5U);
    }
    EXPECT_EQ(session->computation().currentRun()->outcome->trajectoryHash, hash);
}

TEST_F(KeptRun, OfACaseThatWasNeverSavedComesBackWithItsResult) {
    simulateToEnd();
    ASSERT_EQ(runs().size(), 1U);
    EXPECT_TRUE(QFile::exists(QString::fromStdString(runs()[0].file)));
    endProgram();
    startProgram();
    window->show();
    openIt(folder.filePath(QStringLiteral("small.exo")));
    ASSERT_EQ(runs().size(), 1U);
    EXPECT_TRUE(QFile::exists(QString::fromStdString(runs()[0].file)));
}

TEST_F(KeptRun, OfAProgramThatWasKilledIsListedToo) {
    saveCase();
    simulateToEnd();
    const QString file = QString::fromStdString(runs()[0].file);
    endProgram();
    // What a killed program leaves: the file of its run, and no entry.
    ASSERT_TRUE(QFile::remove(caseFile() + QStringLiteral(".runs.json")));
    startProgram();
    window->show();
    openIt(caseFile());
    ASSERT_EQ(runs().size(), 1U);
    EXPECT_EQ(runs()[0].file, file.toStdString());
    EXPECT_EQ(runs()[0].scenarioId, session->document().active()->id);
    EXPECT_TRUE(runs()[0].complete);
}

TEST_F(KeptRun, IsAskedAboutOnlyWhereItWouldGo) {
    saveCase();
    simulateToEnd();
    EXPECT_TRUE(window->rooms().files->mayLeave()) << "it stays";
    widgets::Preferences preferences = session->preferences();
    preferences.keepRunsGib = 0;
    session->setPreferences(preferences);
    simulateToEnd();
    EXPECT_FALSE(session->computation().currentRun()->kept);
    bool asked = false;
    whenAsked([&](QDialog& dialog) {
        asked = true;
        QTest::mouseClick(dynamic_cast<QMessageBox&>(dialog).button(QMessageBox::Cancel), Qt::LeftButton);
    });
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(asked);
    EXPECT_TRUE(window->isVisible());
    whenAsked([&](QDialog& dialog) {
        QTest::mouseClick(dynamic_cast<QMessageBox&>(dialog).button(QMessageBox::Discard), Qt::LeftButton);
    });
    EXPECT_TRUE(window->close());
}

TEST_F(KeptRun, GoesWhereThePreferencesSay) {
    saveCase();
    const QTemporaryDir elsewhere;
    widgets::Preferences preferences = session->preferences();
    preferences.runsFolder = elsewhere.path();
    session->setPreferences(preferences);
    simulateToEnd();
    ASSERT_EQ(runs().size(), 1U);
    EXPECT_TRUE(QString::fromStdString(runs()[0].file).startsWith(elsewhere.path()));
}

TEST_F(KeptRun, ARemedyIsOneStepOfUndo) {
    session->document().setParameter(QStringLiteral("ground"), std::string("off"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    const Scenario before = session->document().scenario();
    emit window->rooms().deck->run().health().remedyChosen(QStringLiteral("auto_remedy"), true);
    EXPECT_TRUE(session->document().scenario().simulation.autoRemedy);
    QTest::keyClick(window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(session->document().scenario(), before);
}

}  // namespace rubble
