#include "app/gui/case/recovery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QDir>
#include <QMessageBox>
#include <QProcess>
#include <QProcessEnvironment>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <fstream>

#include "app/gui/case/file_commands.h"
#include "app/gui/case/layout_memory.h"
#include "app/gui/case/project_display.h"
#include "core/base/error.h"
#include "io/case/autosave_file.h"
#include "io/case/case_file.h"
#include "tests/app/gui/left_session.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/basics/notice_bar.h"

namespace rubble {

namespace {

Case plainCase() {
    Case theCase;
    theCase.title = "arch";
    theCase.scenarios.push_back({"scenario-1", "As computed", {}, {}, {}});
    theCase.activeScenario = "scenario-1";
    return theCase;
}

QStringList keptIn(const QString& folder) {
    return QDir(folder).entryList({QStringLiteral("*.unsaved.json")}, QDir::Files);
}

}  // namespace

TEST(Autosave, KeepsChangesUntilTheyAreSaved) {
    const QTemporaryDir folder;
    Document document;
    Autosave autosave(document, folder.path());
    autosave.setInterval(1);
    document.replace(plainCase(), {}, QStringLiteral("/a/b.rubble"));
    QTest::qWait(1200);
    EXPECT_TRUE(autosave.file().isEmpty()) << "there is nothing to keep";
    document.setParameter(QStringLiteral("friction"), 0.5);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !keptIn(folder.path()).isEmpty(); }, 10'000));
    const io::AutosavedCase kept = io::readAutosave(autosave.file().toStdString());
    EXPECT_EQ(kept.theCase, document.theCase());
    EXPECT_EQ(kept.base, "/a/b.rubble");
    EXPECT_EQ(kept.path, "");
    EXPECT_TRUE(autosave.leftWork().empty()) << "one's own work is not left behind";
    document.saved(document.theCase(), QStringLiteral("/a/b.rubble"));
    EXPECT_TRUE(keptIn(folder.path()).isEmpty());
}

TEST(Autosave, UndoingEverythingLeavesNothingAndNeitherDoesTheEnd) {
    const QTemporaryDir folder;
    Document document;
    {
        Autosave autosave(document, folder.path());
        document.replace(plainCase(), {}, QStringLiteral("/a/b.rubble"));
        document.setParameter(QStringLiteral("friction"), 0.5);
        autosave.saveNow();
        EXPECT_EQ(keptIn(folder.path()).size(), 1);
        document.undoStack().undo();
        EXPECT_TRUE(keptIn(folder.path()).isEmpty());
        document.undoStack().redo();
        autosave.saveNow();
        EXPECT_EQ(keptIn(folder.path()).size(), 1);
    }
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST(Autosave, TwoWindowsOnOneCaseKeepTheirOwn) {
    const QTemporaryDir folder;
    Document first, second;
    Autosave one(first, folder.path()), two(second, folder.path());
    for (Document* each : {&first, &second}) {
        each->replace(plainCase(), {}, QStringLiteral("/a/b.rubble"));
    }
    first.setParameter(QStringLiteral("friction"), 0.5);
    second.setParameter(QStringLiteral("friction"), 0.6);
    one.saveNow();
    two.saveNow();
    EXPECT_NE(one.file(), two.file());
    EXPECT_EQ(io::readAutosave(one.file().toStdString()).theCase.scenarios[0].scenario.simulation.friction, 0.5);
    EXPECT_EQ(io::readAutosave(two.file().toStdString()).theCase.scenarios[0].scenario.simulation.friction, 0.6);
}

TEST(Autosave, WhatCannotBeReadIsSetAsideAndTold) {
    const QTemporaryDir folder;
    const QString broken = folder.filePath(QStringLiteral("0123-0.unsaved.json"));
    std::ofstream(broken.toStdString()) << R"({"format": "rubble-autosave", "version": 1, "path)";
    const QString foreign = folder.filePath(QStringLiteral("0123-1.unsaved.json"));
    std::ofstream(foreign.toStdString()) << "[1, 2]";
    Document document;
    Autosave autosave(document, folder.path());
    QStringList told;
    QObject::connect(&autosave, &Autosave::setAside, [&](const Failure& what, const QString& where) {
        told << what.what();
        EXPECT_TRUE(QFile::exists(where)) << where.toStdString();
    });
    EXPECT_TRUE(autosave.leftWork().empty());
    ASSERT_EQ(told.size(), 2);
    EXPECT_TRUE(told[0].contains(QStringLiteral("0123-0.unsaved.json"))) << told[0].toStdString();
    EXPECT_TRUE(keptIn(folder.path()).isEmpty());
}

TEST(Autosave, AFolderThatCannotBeWrittenIsToldOnce) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("in-the-way"));
    std::ofstream(file.toStdString()) << "x";
    Document document;
    Autosave autosave(document, file + QStringLiteral("/unsaved"));
    int told = 0;
    QObject::connect(&autosave, &Autosave::failed, [&] { ++told; });
    document.replace(plainCase(), {}, QStringLiteral("/a/b.rubble"));
    document.setParameter(QStringLiteral("friction"), 0.5);
    autosave.saveNow();
    autosave.saveNow();
    EXPECT_EQ(told, 1);
}

TEST(AutosaveFile, SurvivesDamageAtEveryByte) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("a.json")).toStdString();
    const io::AutosavedCase before{"/a/b.rubble", "/a/b.rubble", "2024-05-31T08:15:30Z", plainCase()};
    io::writeAutosave(path, before);
    EXPECT_EQ(io::readAutosave(path), before);
    const std::string text = textOf(QString::fromStdString(path));
    for (std::size_t length = 0; length < text.size() - 2; length += 7) {
        std::ofstream(path, std::ios::binary) << text.substr(0, length);
        EXPECT_THROW(io::readAutosave(path), Error) << length;
    }
}

TEST(Settings, AFileThatIsNoneIsSetAside) {
    const QString path = QSettings().fileName();
    QSettings().setValue(QStringLiteral("theme"), QStringLiteral("dark"));
    QSettings().sync();
    EXPECT_TRUE(setDamagedSettingsAside().isEmpty());
    const std::string good = textOf(path);
    std::ofstream(path.toStdString(), std::ios::binary) << "[General]\n\x01\x02 no assignment here\n%%%\n";
    const QString kept = setDamagedSettingsAside();
    EXPECT_FALSE(kept.isEmpty());
    EXPECT_TRUE(QFile::exists(kept));
    EXPECT_FALSE(QFile::exists(path));
    QFile::remove(kept);
}

/// A session in a process of its own that opens a result and changes a setting, and a window that comes after it.
class LeftSession : public Workbench {
protected:
    void SetUp() override {
        Workbench::SetUp();
        fe = QString::fromStdString(cli::writeSmallCollapse(folder.filePath(QStringLiteral("small.exo")).toStdString()));
    }
    /// @param display  that it opens its window on; empty: this one
    void begin(const QString& display = {}) {
        leftProgram.setProcessChannelMode(QProcess::ForwardedChannels);
        if (!display.isEmpty()) {
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert(QStringLiteral("DISPLAY"), display);
            leftProgram.setProcessEnvironment(environment);
        }
        leftProgram.start(QCoreApplication::applicationFilePath(), {leftSessionWord, fe, QStringLiteral("friction=0.37")});
        ASSERT_TRUE(leftProgram.waitForStarted(patience));
        ASSERT_TRUE(QTest::qWaitFor([&] { return !keptIn(unsaved).isEmpty(); }, patience));
    }
    /// What it left is offered, and comes back by a click.
    void recover() {
        window->rooms().project->recovery().look();
        ASSERT_EQ(window->rooms().project->recovery().offered(), 1U);
        EXPECT_TRUE(window->rooms().project->recovery().text().contains(QStringLiteral("small")))
            << window->rooms().project->recovery().text().toStdString();
        auto* bar = window->findChild<widgets::NoticeBar*>();
        auto* recover = bar->findChild<QPushButton*>(QStringLiteral("primary"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return recover->isVisible(); }, patience));
        QTest::mouseClick(recover, Qt::LeftButton);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        EXPECT_EQ(session->document().scenario().simulation.friction, 0.37);
        EXPECT_TRUE(session->document().modified()) << "it is still not saved";
        EXPECT_EQ(window->rooms().project->recovery().offered(), 0U);
        EXPECT_EQ(keptIn(unsaved).size(), 1) << "kept by this session now";
        ASSERT_TRUE(window->rooms().files->saveTo(folder.filePath(QStringLiteral("small.rubble"))));
        EXPECT_TRUE(keptIn(unsaved).isEmpty());
    }

    const QTemporaryDir folder;
    QString fe;
    QProcess leftProgram;
    const QString unsaved = qEnvironmentVariable("RUBBLE_STATE") + QStringLiteral("/unsaved");
};

TEST_F(LeftSession, ThatWasKilledComesBack) {
    begin();
    window->rooms().project->begin();
    EXPECT_EQ(window->rooms().project->recovery().offered(), 0U) << "the session is alive: its work is its own";
    ::kill(static_cast<pid_t>(leftProgram.processId()), SIGKILL);
    ASSERT_TRUE(leftProgram.waitForFinished(patience));
    recover();
}

TEST_F(LeftSession, ThatWasGivenUpAfterAllLeavesTheNextCaseUnchanged) {
    begin();
    ::kill(static_cast<pid_t>(leftProgram.processId()), SIGKILL);
    ASSERT_TRUE(leftProgram.waitForFinished(patience));
    window->rooms().project->recovery().look();
    auto* recoverButton = window->findChild<widgets::NoticeBar*>()->findChild<QPushButton*>(QStringLiteral("primary"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return recoverButton->isVisible(); }, patience));
    QTest::mouseClick(recoverButton, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && session->document().modified(); }, patience));
    whenAsked([](QDialog& dialog) {
        QTest::mouseClick(dynamic_cast<QMessageBox&>(dialog).button(QMessageBox::Discard), Qt::LeftButton);
    });
    QTest::keyClick(window, Qt::Key_W, Qt::ControlModifier);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->document().empty(); }, patience));
    window->open(fe);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && !session->document().empty(); }, patience));
    EXPECT_FALSE(session->document().modified());
    EXPECT_FALSE(window->windowTitle().contains(u'*')) << qPrintable(window->windowTitle());
    EXPECT_TRUE(window->rooms().files->mayLeave()) << "nobody is asked about what nobody changed";
}

TEST_F(LeftSession, ThatLostItsDisplayEndsByItselfAndComesBack) {
    QProcess display;
    display.start(QStringLiteral("Xvfb"), QStringLiteral("-displayfd 1 -screen 0 1280x800x24 -nolisten tcp").split(u' '));
    ASSERT_TRUE(display.waitForReadyRead(patience)) << display.errorString().toStdString();
    begin(QStringLiteral(":") + QString::fromLatin1(display.readAllStandardOutput().trimmed()));
    display.kill();
    ASSERT_TRUE(display.waitForFinished(patience));
    ASSERT_TRUE(leftProgram.waitForFinished(patience)) << "it goes on without a display";
    EXPECT_EQ(leftProgram.exitStatus(), QProcess::NormalExit);
    EXPECT_NE(leftProgram.exitCode(), 0);
    recover();
}

}  // namespace rubble
