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
#include "app/gui/case/run_history.h"
#include "app/gui/window/opening.h"
#include "app/gui/window/run_control.h"
#include "io/base/files.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/case/run_verdict.h"
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
    /// A run that goes on for long has some frames.
    void beginRun() {
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
    }
    void cancelRun() {
        beginRun();
        session->computation().cancel();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    }

    QTemporaryDir folder;
};

TEST_F(KeptRun, WhatSimulatingWouldOnlyRepeatIsShown) {
    saveCase();
    simulateToEnd();
    ASSERT_EQ(runs().size(), 1U);
    const std::string kept = runs()[0].file;
    openIt(folder.filePath(QStringLiteral("small.exo")));
    window->rooms().opening->open(caseFile(), true);
    const auto shown = [&] {
        const RunRecord* record = session->computation().currentRun();
        return record != nullptr && record->outcome != nullptr && record->path.toStdString() == kept &&
               window->rooms().project->runs().shown() && !session->computation().busy();
    };
    ASSERT_TRUE(QTest::qWaitFor(shown, patience));
    EXPECT_EQ(runs().size(), 1U) << "not simulated again";
    // With another setting it is another run.
    session->document().setParameter(QStringLiteral("settle_time"), 0.5);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_FALSE(window->rooms().project->runs().sameAsNow());
    window->rooms().runs->showOrSimulate();
    awaitRun();
    EXPECT_EQ(runs().size(), 2U);
}

TEST_F(KeptRun, LiesBesideItsCaseAndIsShownAgainLater) {
    saveCase();
    simulateToEnd();
    const Digest hash = session->computation().currentRun()->outcome->trajectoryHash;
    const std::string first = session->computation().currentRun()->path.toStdString();
    const std::string digest = io::sha256OfFile(first);
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
    EXPECT_EQ(io::sha256OfFile(first), digest) << "a report names it by its digest";
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

// The new case knew nothing of the run that was made in it.
TEST_F(KeptRun, OfACaseThatWasSavedElsewhereMeanwhileIsKnownThereWhenTheProgramIsKilled) {
    saveCase();
    beginRun();
    const QString other = folder.filePath(QStringLiteral("west.rubble"));
    ASSERT_TRUE(window->rooms().files->saveTo(other));
    const QString run = QFileInfo(session->computation().currentRun()->path).absoluteFilePath();
    // What a kill leaves now: these histories, and a file without an end.
    const QStringList histories{caseFile() + QStringLiteral(".runs.json"), other + QStringLiteral(".runs.json")};
    QStringList left;
    for (const QString& history : histories) {
        ASSERT_TRUE(QFile::exists(history)) << qPrintable(history);
        left << history + QStringLiteral(".left");
        ASSERT_TRUE(QFile::copy(history, left.back()));
    }
    EXPECT_TRUE(runs().empty()) << "it is listed once it has ended";
    session->computation().cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    endProgram();
    for (int i = 0; i < 2; ++i) {
        ASSERT_TRUE(QFile::remove(histories[i]) && QFile::rename(left[i], histories[i]));
    }
    for (const QString& path : {other, caseFile()}) {
        startProgram();
        window->show();
        openIt(path);
        ASSERT_EQ(runs().size(), 1U) << qPrintable(path);
        EXPECT_EQ(QString::fromStdString(runs()[0].file), run);
        EXPECT_TRUE(runs()[0].interrupted);
        EXPECT_GT(runs()[0].endTime, 0.0);
        EXPECT_TRUE(widgets::runVerdict(runs()[0]).startsWith(QStringLiteral("interrupted at ")));
        endProgram();
    }
    startProgram();
}

TEST_F(KeptRun, OfACaseThatWasSavedElsewhereMeanwhileIsKnownInBothWithItsEnd) {
    saveCase();
    beginRun();
    const QString other = folder.filePath(QStringLiteral("west.rubble"));
    ASSERT_TRUE(window->rooms().files->saveTo(other));
    session->computation().cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    ASSERT_EQ(runs().size(), 1U);
    EXPECT_FALSE(runs()[0].interrupted) << "somebody cancelled it";
    const std::string file = runs()[0].file;
    openIt(other);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->document().path() == other && prepared(); }, patience));
    ASSERT_EQ(runs().size(), 1U);
    EXPECT_FALSE(runs()[0].interrupted);
    endProgram();
    startProgram();
    window->show();
    openIt(caseFile());
    ASSERT_EQ(runs().size(), 1U);
    EXPECT_EQ(runs()[0].file, file);
}

// A sample can be written by root, and runs lay among the files that were installed.
TEST_F(KeptRun, OfASampleLiesInTheStateFolder) {
    const QString sample =
        QFileInfo(QCoreApplication::applicationDirPath() + QStringLiteral("/../share/rubble/samples/river-arch.rubble"))
            .canonicalFilePath();
    ASSERT_FALSE(sample.isEmpty());
    window->open(sample);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->document().path() == sample && prepared(); }, patience));
    EXPECT_TRUE(session->document().readOnly());
    RunHistory& history = window->rooms().project->runs();
    EXPECT_FALSE(history.stateFolder().isEmpty());
    for (const QString& place : {history.runsFolder(), history.fileBeside(QStringLiteral(".report.json"))}) {
        EXPECT_TRUE(place.startsWith(history.stateFolder() + u'/')) << qPrintable(place);
    }
    EXPECT_FALSE(window->rooms().files->saveTo(sample)) << "it stays as it came";
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
