#include "app/gui/views/scenario_pane.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "app/gui/stage/view_area.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/views/scenario_bar.h"

namespace rubble {

namespace {

/// The small collapse, simulated.
class ScenarioPanes : public Workbench {
protected:
    void SetUp() override {
        Workbench::SetUp();
        window->open(QString::fromStdString(cli::writeSmallCollapse(folder.filePath(QStringLiteral("small.exo")).toStdString())));
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        session->document().setParameter(QStringLiteral("settle_time"), 0.5);
        simulate();
    }
    void simulate() {
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        simulateToEnd();
    }
    widgets::ViewWidget& views() { return window->area().views(); }
    const std::vector<std::shared_ptr<const RunRecord>>& others() { return session->computation().otherRuns(); }
    void goOnWithACopy() {
        QTest::keyClick(window, Qt::Key_D, Qt::ControlModifier);
        session->document().setParameter(QStringLiteral("gravity"), 3.7);
        simulate();
    }

    QTemporaryDir folder;
};

TEST_F(ScenarioPanes, ShowAnotherScenarioBesideThisOne) {
    EXPECT_TRUE(others().empty());
    const QString first = session->computation().currentRun()->scenarioName;
    goOnWithACopy();
    ASSERT_EQ(others().size(), 1U);
    EXPECT_EQ(others().front()->scenarioName, first);
    QTest::keyClick(window, Qt::Key_7);
    EXPECT_EQ(views().view().layout, render::Layout::Scenarios);
    EXPECT_TRUE(window->area().scenarioBar().isVisible());
    EXPECT_EQ(window->area().scenarioBar().chosen(), first);
    window->rooms().playback->showInstant(0.5);
    ASSERT_TRUE(QTest::qWaitFor([&] { return views().status(render::PaneContent::Other).simulated; }, patience));
    EXPECT_DOUBLE_EQ(views().status(render::PaneContent::Other).time, views().status(render::PaneContent::Fragments).time);
    EXPECT_EQ(views().other().trajectory, others().front()->reader);
    EXPECT_NE(views().data().trajectory, views().other().trajectory);
    // One camera: turning one turns both, also when the FE view has one of its own.
    EXPECT_EQ(&render::cameraOf(views().view(), render::PaneContent::Other),
              &render::cameraOf(views().view(), render::PaneContent::Fragments));
}

TEST_F(ScenarioPanes, TellIslandsApartInBoth) {
    goOnWithACopy();
    QTest::keyClick(window, Qt::Key_7);
    EXPECT_EQ(views().other().loose, nullptr);
    render::View view = views().view();
    view.colourBy = render::ColourBy::Island;
    window->rooms().scene->setView(view);
    ASSERT_TRUE(QTest::qWaitFor([&] { return views().data().loose != nullptr && views().other().loose != nullptr; }, patience));
    EXPECT_EQ(views().other().loose, views().data().loose) << "gravity frees nothing";
    session->document().setParameter(QStringLiteral("revival"), std::string("follow"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return views().other().loose == nullptr; }, patience)) << "the other run has other islands";
}

TEST_F(ScenarioPanes, KeepOneRunOfEachScenario) {
    const QString firstFile = session->computation().currentRun()->path;
    goOnWithACopy();
    EXPECT_TRUE(QFile::exists(firstFile));
    simulate();
    EXPECT_EQ(others().size(), 1U) << "the same scenario anew takes the place of its own run";
    EXPECT_TRUE(QFile::exists(firstFile));
    session->document().undoStack().setClean();
    QTest::keyClick(window, Qt::Key_W, Qt::ControlModifier);
    EXPECT_TRUE(others().empty());
    EXPECT_TRUE(QFile::exists(firstFile)) << "what was computed is kept beside the case";
}

}  // namespace
}  // namespace rubble
