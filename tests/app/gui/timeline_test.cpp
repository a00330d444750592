#include "widgets/views/timeline.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <algorithm>

#include "app/gui/case/file_commands.h"
#include "app/gui/case/project_display.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/timeline_display.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/views/inspection.h"
#include "app/gui/views/selection_display.h"
#include "io/case/case_file.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/views/bookmark_editor.h"
#include "widgets/views/inspector.h"
#include "widgets/views/status_line.h"
#include "widgets/views/view_widget.h"

namespace rubble {

namespace {

class TimelineKeys : public Workbench {
protected:
    void SetUp() override {
        QSettings().clear();
        Workbench::SetUp();
        window->open(QString::fromStdString(cli::writeSmallCollapse(folder.filePath(QStringLiteral("small.exo")).toStdString())));
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    }
    widgets::PlaybackClock& clock() { return window->rooms().playback->clock(); }
    QPoint at(double time, int y = 24) { return {static_cast<int>(window->findChild<widgets::Timeline*>()->toX(time)), y}; }

    QTemporaryDir folder;
};

TEST_F(TimelineKeys, BookmarksAreMadeNamedFoundAndUndone) {
    TimelineDisplay* display = window->rooms().timeline.get();
    window->rooms().playback->showInstant(0.2);
    QTest::keyClick(window, Qt::Key_B);
    QLineEdit& note = display->editor().note();
    ASSERT_TRUE(display->editor().isVisible());
    QTest::keyClicks(&note, QStringLiteral("crown goes"));
    QTest::keyClick(&note, Qt::Key_Return);
    EXPECT_FALSE(display->editor().isVisible());
    window->rooms().playback->showInstant(0.4);
    QTest::keyClick(window, Qt::Key_B);
    QTest::keyClick(&note, Qt::Key_Escape);
    ASSERT_EQ(session->document().theCase().bookmarks, (std::vector<Bookmark>{{0.2, "crown goes"}, {0.4, ""}}));
    QTest::keyClick(window, Qt::Key_Comma);
    EXPECT_DOUBLE_EQ(clock().time(), 0.2);
    QTest::keyClick(window, Qt::Key_Period);
    EXPECT_DOUBLE_EQ(clock().time(), 0.4);
    QTest::mouseClick(window->findChild<widgets::Timeline*>(), Qt::LeftButton, {},
                      window->findChild<widgets::Timeline*>()->flagOf(0).toPoint() + QPoint(3, 0));
    EXPECT_DOUBLE_EQ(clock().time(), 0.2);
    QTest::mouseDClick(window->findChild<widgets::Timeline*>(), Qt::LeftButton, {},
                       window->findChild<widgets::Timeline*>()->flagOf(1).toPoint() + QPoint(3, 0));
    ASSERT_TRUE(display->editor().isVisible());
    QTest::mouseClick(display->editor().findChild<QPushButton*>(QStringLiteral("removeBookmark")), Qt::LeftButton);
    EXPECT_EQ(session->document().theCase().bookmarks.size(), 1U);
    const QString path = folder.filePath(QStringLiteral("small.rubble"));
    ASSERT_TRUE(window->rooms().files->saveTo(path));
    EXPECT_EQ(io::loadCase(path.toStdString()).bookmarks, (std::vector<Bookmark>{{0.2, "crown goes"}}));
    while (session->document().undoStack().canUndo()) {
        session->document().undoStack().undo();
    }
    EXPECT_TRUE(session->document().theCase().bookmarks.empty());
}

TEST_F(TimelineKeys, PlaysBackwardsAndStopsAtTheFirstInstant) {
    window->rooms().playback->showInstant(0.3);
    QTest::keyClick(window, Qt::Key_Space, Qt::ShiftModifier);
    EXPECT_TRUE(clock().playing());
    EXPECT_TRUE(clock().backwards());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !clock().playing(); }, patience));
    EXPECT_DOUBLE_EQ(clock().time(), clock().first());
    auto* button = window->findChild<QToolButton*>(QStringLiteral("playBack"));
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_TRUE(clock().playing()) << "from the first instant it begins at the last";
    QTest::keyClick(window, Qt::Key_Space);
    EXPECT_TRUE(clock().playing());
    EXPECT_FALSE(clock().backwards()) << "Space turns it round";
    QTest::keyClick(window, Qt::Key_Space);
    EXPECT_FALSE(clock().playing());
}

TEST_F(TimelineKeys, ARangeDraggedWithShiftIsPlayedRoundAndRound) {
    QTest::mousePress(window->findChild<widgets::Timeline*>(), Qt::LeftButton, Qt::ShiftModifier, at(0.1));
    QTest::mouseMove(window->findChild<widgets::Timeline*>(), at(0.2));
    QTest::mouseRelease(window->findChild<widgets::Timeline*>(), Qt::LeftButton, Qt::ShiftModifier, at(0.3));
    ASSERT_TRUE(window->rooms().playback->loopRange().has_value());
    EXPECT_NEAR(window->rooms().playback->loopRange()->first, 0.1, 0.005);
    EXPECT_NEAR(window->rooms().playback->loopRange()->second, 0.3, 0.005);
    EXPECT_TRUE(window->actions()[ActionId::Loop].isChecked());
    EXPECT_TRUE(window->findChild<QToolButton*>(QStringLiteral("loop"))->isChecked());
    clock().play();
    for (int i = 0; i < 50; ++i) {
        clock().advance(0.037);
        EXPECT_GE(clock().time(), 0.09);
        EXPECT_LE(clock().time(), 0.31);
    }
    EXPECT_TRUE(clock().playing());
    clock().pause();
    window->rooms().playback->showInstant(0.4);
    QTest::keyClick(window, Qt::Key_BracketRight);
    EXPECT_NEAR(window->rooms().playback->loopRange()->second, 0.4, 1e-9);
    QTest::mouseClick(window->findChild<widgets::Timeline*>(), Qt::LeftButton, Qt::ShiftModifier, at(0.25));
    EXPECT_FALSE(window->rooms().playback->looping()) << "a range without length ends it";
}

TEST_F(TimelineKeys, ScrubbingSnapsToStatesAndTimesCountFromZero) {
    window->actions()[ActionId::Snap].trigger();
    QTest::mouseClick(window->findChild<widgets::Timeline*>(), Qt::LeftButton, {}, at(0.234));
    EXPECT_DOUBLE_EQ(clock().time(), 0.2);
    QTest::mouseClick(window->findChild<widgets::Timeline*>(), Qt::LeftButton, {}, at(0.271));
    EXPECT_DOUBLE_EQ(clock().time(), session->computation().inputs().fe->times()[3]);
    window->actions()[ActionId::Snap].trigger();
    QTest::mouseClick(window->findChild<widgets::Timeline*>(), Qt::LeftButton, {}, at(0.234));
    EXPECT_NE(clock().time(), 0.2);

    io::ExodusBuilder later = cli::smallCollapse();
    for (double& time : later.times) {
        time += 1.5;
    }
    const QString path = folder.filePath(QStringLiteral("later.exo"));
    later.write(path.toStdString());
    window->open(path);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().inputs().fe->times().front() > 1.0 && prepared(); }, patience));
    window->rooms().playback->showInstant(1.7);
    auto* figures = window->findChild<QLabel*>(QStringLiteral("timeFigures"));
    EXPECT_EQ(figures->text(), QStringLiteral("1.70 s"));
    window->actions()[ActionId::TimeFromZero].trigger();
    EXPECT_EQ(figures->text(), QStringLiteral("0.20 s"));
    EXPECT_DOUBLE_EQ(clock().time(), 1.7) << "the clock is the file's";
    window->actions()[ActionId::TimeFromZero].trigger();
    EXPECT_EQ(figures->text(), QStringLiteral("1.70 s"));
}

TEST_F(TimelineKeys, AnIslandThatTheEngineCarriesIsSeen) {
    session->document().setParameter(QStringLiteral("settle_time"), 0.5);
    session->document().setParameter(QStringLiteral("loose_structure"), std::string("at_once"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    simulateToEnd();
    const std::vector<IslandRecord> islands = session->computation().currentRun()->reader->islands();
    ASSERT_EQ(islands.size(), 1u) << "one cube of a falling block lives on";
    const double since = session->computation().currentRun()->reader->bodies()[rubble::at(islands[0].body)].from;
    window->rooms().playback->showInstant(session->computation().currentRun()->outcome->endTime);
    const std::int64_t peak = session->computation().currentRun()->outcome->bodiesPeak;
    const QString bodies = window->findChild<widgets::StatusLine*>()->figureText(widgets::StatusLine::Figure::Bodies);
    EXPECT_TRUE(bodies.contains(QStringLiteral(">%1<").arg(peak)) || bodies.contains(QStringLiteral(" %1").arg(peak)))
        << qPrintable(bodies) << ": as the Run panel counts, without the island";
    auto* timeline = window->findChild<widgets::Timeline*>();
    ASSERT_TRUE(timeline->handOverAt(QPointF(at(since)) + QPointF(0, timeline->tickOf(0).y() - 24.0)));
    QTest::mouseClick(timeline, Qt::LeftButton, {}, timeline->tickOf(0).toPoint());
    EXPECT_DOUBLE_EQ(clock().time(), since);
    window->rooms().inspection->selection().select({islands[0].elements.front()});
    const auto texts = window->rooms().inspection->inspector().findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(texts.begin(), texts.end(), [](const QLabel* label) {
        return label->text().startsWith(QStringLiteral("Carried by the engine since 0."));
    }));
    window->area().views().grabFramebuffer();
    EXPECT_EQ(window->area().views().status(render::PaneContent::Fragments).released, 1u);
}

}  // namespace
}  // namespace rubble
