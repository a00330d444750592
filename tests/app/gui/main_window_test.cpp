#include "app/gui/window/main_window.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QCompleter>
#include <QDockWidget>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <fstream>

#include "app/gui/case/file_commands.h"
#include "app/gui/stage/dock_area.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/views/inspection.h"
#include "io/case/case_file.h"
#include "tests/app/gui/window/box_answer.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/basics/parameter_editor.h"
#include "widgets/case/case_panel.h"
#include "widgets/views/status_line.h"
#include "widgets/views/timeline.h"

namespace rubble {

TEST_F(Workbench, StartsEmptyAndSaysHowToBegin) {
    EXPECT_EQ(window->area().currentIndex(), 0);
    EXPECT_FALSE(window->actions()[ActionId::Simulate].isEnabled());
    EXPECT_EQ(rail(PanelDeck::Case), widgets::StageState::NotYet);
}

TEST_F(Workbench, OpensAnFeResultPlaysAndSteps) {
    openArch();
    EXPECT_EQ(window->area().currentIndex(), 1);
    EXPECT_EQ(rail(PanelDeck::Fragments), widgets::StageState::UpToDate);
    EXPECT_EQ(rail(PanelDeck::Run), widgets::StageState::NotYet);
    const auto& times = session->computation().inputs().fe->times();
    widgets::PlaybackClock& clock = window->rooms().playback->clock();
    EXPECT_DOUBLE_EQ(clock.time(), times.front());
    QTest::keyClick(window, Qt::Key_Right);
    EXPECT_DOUBLE_EQ(clock.time(), times[1]);
    QTest::keyClick(window, Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_DOUBLE_EQ(clock.time(), times[11]);
    QTest::keyClick(window, Qt::Key_Left);
    EXPECT_DOUBLE_EQ(clock.time(), times[10]);
    QTest::keyClick(window, Qt::Key_End);
    EXPECT_DOUBLE_EQ(clock.time(), times.back());
    QTest::keyClick(window, Qt::Key_Home);
    EXPECT_DOUBLE_EQ(clock.time(), times.front());
    QTest::keyClick(window, Qt::Key_Space);
    EXPECT_TRUE(clock.playing());
    ASSERT_TRUE(QTest::qWaitFor([&] { return clock.time() > times.front(); }, patience));
    QTest::keyClick(window, Qt::Key_Space);
    EXPECT_FALSE(clock.playing());
    QTest::keyClick(window, Qt::Key_5);
    EXPECT_EQ(window->area().views().view().layout, render::Layout::FeOnly);
}

TEST_F(Workbench, TheMouseMovesTheCamera) {
    openArch();
    widgets::ViewWidget& views = window->area().views();
    const render::Camera before = views.view().cameras[0];
    const QPoint from(views.width() / 4, views.height() / 4);
    QTest::mousePress(&views, Qt::LeftButton, {}, from);
    QTest::mouseMove(&views, from + QPoint(40, 10));
    QTest::mouseRelease(&views, Qt::LeftButton, {}, from + QPoint(40, 10));
    const render::Camera turned = views.view().cameras[0];
    EXPECT_NE(turned, before);
    EXPECT_NEAR((turned.position - turned.focalPoint).norm(), (before.position - before.focalPoint).norm(), 1e-6);
}

TEST_F(Workbench, AnEditIsCountedAnewAndUndone) {
    openArch();
    const std::size_t clusters = session->computation().results().clustering->list.size();
    session->document().setParameter(QStringLiteral("multiple"), 12.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_LT(session->computation().results().clustering->list.size(), clusters);
    QTest::keyClick(window, Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_EQ(session->computation().results().clustering->list.size(), clusters);
}

TEST_F(Workbench, SimulatesPlaysMeanwhileAndGoesStale) {
    openArch();
    makeCheap();
    // Long enough to be looked at.
    session->document().setParameter(QStringLiteral("settle_time"), 20.0);
    window->rooms().runs->simulate(false);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().simulating(); }, patience));
    EXPECT_EQ(rail(PanelDeck::Run), widgets::StageState::Running);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    const RunRecord* record = session->computation().currentRun();
    ASSERT_NE(record, nullptr);
    ASSERT_NE(record->outcome, nullptr);
    EXPECT_TRUE(record->reader->complete());
    EXPECT_EQ(rail(PanelDeck::Run), widgets::StageState::UpToDate);
    EXPECT_EQ(record->outcome->fragments.size(), record->results.fragments->size());
    session->document().setParameter(QStringLiteral("friction"), 0.7);
    EXPECT_EQ(rail(PanelDeck::Run), widgets::StageState::Stale);
    EXPECT_NE(window->rooms().scene->data().trajectory, nullptr) << "a stale result stays visible";
    session->document().undoStack().undo();
    EXPECT_EQ(rail(PanelDeck::Run), widgets::StageState::UpToDate);
}

TEST_F(Workbench, CancelKeepsWhatIsComputed) {
    openArch();
    window->rooms().runs->simulate(false);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            const RunRecord* record = session->computation().currentRun();
            return record != nullptr && record->reader->frameCount() > 3;
        },
        patience));
    QTest::keyClick(window, Qt::Key_Escape);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    const RunRecord* record = session->computation().currentRun();
    ASSERT_NE(record, nullptr);
    EXPECT_EQ(record->outcome, nullptr);
    EXPECT_FALSE(record->running);
    EXPECT_GT(record->reader->frameCount(), 3U);
    EXPECT_FALSE(session->computation().failure().has_value());
    EXPECT_TRUE(window->actions()[ActionId::Simulate].isEnabled());
}

TEST_F(Workbench, LiveModeDrawsEveryFrame) {
    openArch();
    makeCheap();
    window->rooms().runs->simulate(true);
    int followed = 0;
    QObject::connect(&(*window->rooms().playback), &Playback::frameShown, window, [&](bool live) { followed += live ? 1 : 0; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return followed >= 10; }, patience));
    EXPECT_TRUE(window->rooms().playback->following());
    EXPECT_DOUBLE_EQ(session->computation().currentRun()->scenario.simulation.frameRate,
                     session->document().scenario().grid.fpsTarget);
    // Scrubbing leaves the newest frame; the run goes on without it.
    window->rooms().playback->scrub(0.1);
    EXPECT_FALSE(window->rooms().playback->following());
    const double newest = session->computation().currentRun()->newest;
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().currentRun()->newest > newest + 0.1; }, patience));
    EXPECT_DOUBLE_EQ(window->rooms().playback->clock().time(), 0.1);
    session->computation().cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
}

TEST_F(Workbench, ClosingWhileItSimulatesIsClean) {
    openArch();
    window->rooms().runs->simulate(false);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().simulating(); }, patience));
    const QString scratch = session->computation().currentRun()->path;
    EXPECT_TRUE(QFile::exists(scratch));
    {
        const BoxAnswer stay(QMessageBox::Cancel);
        EXPECT_FALSE(window->close());
        EXPECT_TRUE(stay.asked()) << "a simulation does not end by accident";
        EXPECT_TRUE(session->computation().simulating());
        // Nor does it by opening something else.
        window->open(wholeArch());
        EXPECT_TRUE(session->computation().simulating());
    }
    const BoxAnswer leave(QMessageBox::Discard);
    EXPECT_TRUE(window->close());
    endProgram();
    QTest::qWait(50);
    EXPECT_TRUE(QFile::exists(scratch)) << "what was computed is kept";
    EXPECT_FALSE(QFile::exists(scratch + QStringLiteral(".lock")));
}

TEST_F(Workbench, ClosingWhileItOpensIsClean) {
    window->open(arch());
    endProgram();
    QTest::qWait(50);
}

TEST_F(Workbench, AFileThatIsNoResultSaysSoAndLeavesWhatIsOpen) {
    openArch();
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("notes.txt"));
    std::ofstream(path.toStdString()) << "These are notes about the bridge, not a result of an analysis.\n";
    window->open(path);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return !session->computation().busy() && !window->findChild<widgets::StatusLine*>()->activityText().isEmpty(); },
        patience));
    EXPECT_TRUE(window->findChild<widgets::StatusLine*>()->activityText().contains(QStringLiteral("notes.txt")))
        << window->findChild<widgets::StatusLine*>()->activityText().toStdString();
    EXPECT_NE(session->computation().inputs().fe, nullptr);
    EXPECT_EQ(window->area().currentIndex(), 1);
}

TEST_F(Workbench, AnActiveFlagThatIsNotThereIsAnErrorInPlaceAndCostsNothing) {
    openArch();
    session->document().setParameter(QStringLiteral("status_variable"), std::string("NOPE"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    bool told = false;
    for (const widgets::Notice* notice : window->rooms().deck->stack().findChildren<widgets::Notice*>()) {
        told = told || (notice->text().contains(QStringLiteral("NOPE")) && notice->text().contains(QStringLiteral("STATUS")));
    }
    EXPECT_TRUE(told) << "the error names what was asked for and what there is";
    EXPECT_NE(session->computation().inputs().fe, nullptr) << "what was open stays";
    EXPECT_EQ(rail(PanelDeck::Case), widgets::StageState::Stale);
    session->document().undoStack().undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_EQ(rail(PanelDeck::Case), widgets::StageState::UpToDate);
    session->document().setParameter(QStringLiteral("status_variable"), std::string("STATUS"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_EQ(rail(PanelDeck::Fragments), widgets::StageState::UpToDate);
}

// A result whose flag goes by a name that nobody knows.
QString writeUnflagged(const QTemporaryDir& folder) {
    io::ExodusBuilder builder = cli::smallCollapse();
    builder.element.front().first = "GONE_OR_NOT";
    builder.element.emplace_back("PRESSURE", [](std::size_t, std::size_t) { return 3.5; });
    const QString path = folder.filePath(QStringLiteral("unknown.exo"));
    builder.write(path.toStdString());
    return path;
}

TEST_F(Workbench, AResultInWhichNothingDiesOpensAndSaysWhyThereIsNothingToSimulate) {
    const QTemporaryDir folder;
    window->open(writeUnflagged(folder));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    const auto fe = session->computation().inputs().fe;
    EXPECT_EQ(session->computation().findings().count("fe.no_deaths"), static_cast<std::int64_t>(fe->mesh().elementCount()));
    EXPECT_EQ(rail(PanelDeck::Fragments), widgets::StageState::UpToDate);
    EXPECT_FALSE(window->actions()[ActionId::Simulate].isEnabled());
    const QList<QLabel*> labels = window->findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->text().contains(QStringLiteral("No element dies in this result"));
    }));
    QTest::keyClick(window, Qt::Key_End);
    EXPECT_DOUBLE_EQ(window->rooms().playback->clock().time(), fe->times().back());
    for (const Qt::Key layout : {Qt::Key_4, Qt::Key_5, Qt::Key_6}) {
        QTest::keyClick(window, layout);
        EXPECT_FALSE(pictureOf(*window).isNull());
    }
}

TEST_F(Workbench, WhatCouldBeTheFlagIsOfferedAndTakesItsPlace) {
    const QTemporaryDir folder;
    window->open(writeUnflagged(folder));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    const auto* panel = window->findChild<widgets::CasePanel*>();
    ASSERT_NE(panel, nullptr);
    const auto* field = panel->editor(QStringLiteral("status_variable"))->findChild<QLineEdit*>();
    ASSERT_NE(field, nullptr);
    ASSERT_NE(field->completer(), nullptr);
    EXPECT_EQ(field->completer()->model()->rowCount(), 2);
    session->document().setParameter(QStringLiteral("status_variable"), std::string("GONE_OR_NOT"));
    const auto born = [&] {
        const auto fragments = session->computation().results().fragments;
        return fragments && !fragments->list.empty() && window->actions()[ActionId::Simulate].isEnabled();
    };
    ASSERT_TRUE(QTest::qWaitFor(born, patience));
    EXPECT_EQ(session->computation().findings().count("fe.no_deaths"), 0);
}

TEST_F(Workbench, ADroppedFileOpens) {
    QMimeData mime;
    mime.setUrls({QUrl::fromLocalFile(arch())});
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window, &drop);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().inputs().fe != nullptr; }, patience));
}

TEST_F(Workbench, ASavedCaseOpensAgainWithItsSettings) {
    openArch();
    session->document().setParameter(QStringLiteral("friction"), 0.65);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("case.rubble"));
    ASSERT_TRUE(window->rooms().files->saveTo(path));
    EXPECT_FALSE(session->document().modified());
    window->open(path);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->document().path() == path && prepared(); }, patience));
    EXPECT_EQ(session->document().scenario().simulation.friction, 0.65);
    EXPECT_TRUE(io::isCaseFile(path.toStdString()));
}

TEST_F(Workbench, NothingIsClippedAtTheSmallestSize) {
    openArch();
    EXPECT_TRUE(window->rooms().deck->rail().compact());
    EXPECT_EQ(window->size(), QSize(1280, 800));
    EXPECT_LE(window->minimumSizeHint().width(), 1280);
    EXPECT_LE(window->minimumSizeHint().height(), 800);
}

TEST_F(Workbench, ADockMakesNoPanelsWindowWider) {
    QTest::keyClick(window, Qt::Key_T);
    EXPECT_EQ(window->size(), QSize(1280, 800)) << "the start page";
    openArch();
    EXPECT_TRUE(std::ranges::any_of(window->rooms().inspection->docks().findChildren<QDockWidget*>(), &QDockWidget::isVisible));
    for (const auto entry : {PanelDeck::Case, PanelDeck::Accuracy, PanelDeck::Evidence, PanelDeck::Report}) {
        window->rooms().deck->choose(entry);
        QTest::qWait(50);
        EXPECT_EQ(window->size(), QSize(1280, 800)) << entry;
    }
    for (const auto page : {PanelDeck::Photographs, PanelDeck::Ensemble, PanelDeck::Causes}) {
        window->rooms().deck->chooseEvidence(page);
        QTest::qWait(50);
        EXPECT_EQ(window->size(), QSize(1280, 800)) << page;
    }
}

}  // namespace rubble
