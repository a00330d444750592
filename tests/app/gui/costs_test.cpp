#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTemporaryDir>
#include <fstream>
#include <sstream>

#include "app/gui/accuracy/accuracy_display.h"
#include "app/gui/accuracy/calibration_display.h"
#include "app/gui/accuracy/error_display.h"
#include "app/gui/accuracy/forecast_display.h"
#include "app/gui/accuracy/grid_display.h"
#include "app/gui/case/file_commands.h"
#include "app/gui/stage/view_area.h"
#include "core/analysis/accuracy/calibration_table.h"
#include "core/clusters/clustering.h"
#include "io/base/machine.h"
#include "io/run/study_files.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "widgets/accuracy/calibration_chart.h"
#include "widgets/accuracy/calibration_view.h"
#include "widgets/accuracy/error_bar.h"
#include "widgets/basics/language.h"
#include "widgets/basics/prediction_box.h"

namespace rubble {

namespace {

/// A window with a cache of its own.
class CostsWorkbench : public Workbench {
protected:
    void SetUp() override {
        qputenv("RUBBLE_CACHE", m_folder.filePath(QStringLiteral("cache")).toUtf8());
        Workbench::SetUp();
    }
    void TearDown() override {
        endProgram();
        qunsetenv("RUBBLE_CACHE");
    }
    void openSmall() {
        const std::string path = m_folder.filePath(QStringLiteral("small.exo")).toStdString();
        cli::writeSmallCollapse(path);
        window->open(QString::fromStdString(path));
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
        session->document().setParameter(QStringLiteral("settle_time"), 0.5);
        ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    }
    bool answered() const { return window->rooms().forecast->answer().has_value(); }
    QString predictionOf(widgets::Panel& panel) { return panel.prediction()->text(); }
    QTemporaryDir m_folder;
};

// The drag counts, draws and is undone as one; the computation waits until the slider rests.
TEST_F(CostsWorkbench, TheGridFollowsTheSliderAndIsOneStepOfUndo) {
    openArch();
    window->rooms().deck->choose(PanelDeck::Grid);
    const auto& views = window->area().views();
    ASSERT_TRUE(views.view().basicGrid.has_value()) << "the grid is drawn while its panel is open";
    const Scenario before = session->document().scenario();
    const int steps = session->document().undoStack().count();
    const auto clustering = session->computation().results().clustering;
    auto* slider = window->rooms().deck->grid().findChild<QSlider*>();
    slider->setSliderDown(true);
    for (const double multiple : {3.0, 6.0, 12.0}) {
        slider->setValue(widgets::GridPanel::positionOf(multiple));
        const double set = *session->document().scenario().grid.multiple;
        ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().grid->bodies().has_value(); }, patience));
        const Sizing& old = *session->computation().results().sizing;
        const BasicGrid grid{set * old.axis[0].meanDistance, set * old.axis[1].meanDistance, set * old.axis[2].meanDistance};
        const Results& results = session->computation().results();
        const Clustering counted = makeClusters(*results.fragments, session->computation().inputs().fe->mesh(), grid,
                                                session->document().scenario().grid, Execution());
        EXPECT_EQ(static_cast<std::size_t>(*window->rooms().grid->bodies()), counted.list.size());
        EXPECT_NEAR((*views.view().basicGrid)[0], grid.l, 1e-12);
        EXPECT_EQ(results.clustering, clustering) << "clusters are made when the slider rests";
    }
    slider->setSliderDown(false);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_NE(session->computation().results().clustering, clustering);
    EXPECT_EQ(static_cast<std::int64_t>(session->computation().results().clustering->list.size()), window->rooms().grid->bodies());
    EXPECT_EQ(session->document().undoStack().count(), steps + 1);
    session->document().undoStack().undo();
    EXPECT_EQ(session->document().scenario(), before);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    window->rooms().deck->choose(PanelDeck::Run);
    EXPECT_FALSE(views.view().basicGrid.has_value());
}

TEST_F(CostsWorkbench, ThePublishedMultiplesAreCounted) {
    openArch();
    window->rooms().deck->choose(PanelDeck::Grid);
    const Results& results = session->computation().results();
    GridSettings at;
    at.multiple = 2.5;
    const std::size_t clusters =
        sizeBasicGrid(*results.fragments, session->computation().inputs().fe->mesh(), *results.components, at, Execution())
            .clusters;
    const QString expected = QLocale().toString(static_cast<qlonglong>(clusters));
    const auto told = [&] {
        for (const QLabel* label : window->rooms().deck->grid().findChildren<QLabel*>()) {
            if (label->text() == expected) {
                return true;
            }
        }
        return false;
    };
    EXPECT_TRUE(QTest::qWaitFor(told, patience)) << expected.toStdString();
}

TEST_F(CostsWorkbench, WithoutPointsEveryPanelSaysThatItDoesNotKnow) {
    openSmall();
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered(); }, patience));
    for (const PanelDeck::Entry entry : {PanelDeck::Grid, PanelDeck::Effects, PanelDeck::Run, PanelDeck::Accuracy}) {
        widgets::Panel& panel = *window->rooms().deck->panels()[entry];
        ASSERT_NE(panel.prediction(), nullptr);
        EXPECT_TRUE(predictionOf(panel).contains(QStringLiteral("Not known"))) << predictionOf(panel).toStdString();
        // Of the wall time something is said from the first minute.
        EXPECT_TRUE(predictionOf(panel).contains(QStringLiteral("Wall time:"))) << predictionOf(panel).toStdString();
        EXPECT_TRUE(predictionOf(panel).contains(QStringLiteral("crude:"))) << predictionOf(panel).toStdString();
    }
    emit window->rooms().deck->run().prediction()->helpRequested();
    EXPECT_EQ(window->rooms().deck->rail().current(), PanelDeck::Accuracy);
}

// The very setting that has run is foretold by its run, whatever was learnt elsewhere since, and another language takes nothing of
// it.
TEST_F(CostsWorkbench, ARunForetellsItsOwnSettings) {
    openSmall();
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered(); }, patience));
    const auto wallTip = [&] {
        QString tip;
        for (const QLabel* label : window->rooms().deck->grid().prediction()->findChildren<QLabel*>()) {
            tip += label->toolTip() + QLatin1Char(' ');
        }
        return tip;
    };
    const QString own = QStringLiteral("From a run of these very settings on this machine.");
    EXPECT_FALSE(wallTip().contains(own));
    simulateToEnd();
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered() && wallTip().contains(own); }, patience));
    EXPECT_FALSE(predictionOf(window->rooms().deck->grid()).contains(QStringLiteral("crude:")));
    session->document().setParameter(QStringLiteral("friction"), 0.9);
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered() && prepared(); }, patience));
    EXPECT_FALSE(wallTip().contains(own)) << "another setting";
    renewed->speak(QStringLiteral("zh_CN"));
    QTest::qWait(50);
    renewed->speak(QStringLiteral("en"));
    session->document().undoStack().undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered() && wallTip().contains(own); }, patience));
}

TEST_F(CostsWorkbench, CalibratesAndSavesTheCurve) {
    openSmall();
    window->rooms().deck->choose(PanelDeck::Grid);
    CalibrationDisplay& calibration = (*window->rooms().calibration);
    calibration.open();
    EXPECT_TRUE(calibration.opened());
    calibration.work().setBodies({8});
    calibration.view().findChild<QPushButton*>(QStringLiteral("primary"))->click();
    ASSERT_TRUE(calibration.work().running());
    EXPECT_FALSE(window->actions()[ActionId::Simulate].isEnabled()) << "a run beside it would spoil the times";
    EXPECT_FALSE(window->rooms().deck->accuracy().findChild<QPushButton*>(QStringLiteral("primary"))->isEnabled());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !calibration.work().running(); }, patience));
    ASSERT_NE(calibration.work().calibration(), nullptr);
    EXPECT_TRUE(window->actions()[ActionId::Simulate].isEnabled());
    EXPECT_EQ(calibration.work().calibration()->points.size(), 2u) << "a typical and a worst pile";
    EXPECT_EQ(calibration.view().chart().content().curves.size(), 6u);

    const auto at = [this](const char* name) { return m_folder.filePath(QLatin1String(name)); };
    window->rooms().files->saveCalibrationTo(at("c.csv"), *calibration.work().calibration());
    std::stringstream expected;
    writeCalibrationCsv(*calibration.work().calibration(), expected);
    EXPECT_EQ(textOf(at("c.csv")), expected.str());
    EXPECT_TRUE(expected.str().starts_with("pile,bodies,physics_fps,drawing_fps,live_fps\ntypical,"));
    const ChartSource source = ChartExport::calibration(*calibration.work().calibration());
    window->rooms().charts->saveTo(at("c.svg"), calibration.view().chart(), source);
    EXPECT_NE(textOf(at("c.svg")).find("<svg"), std::string::npos);
    window->rooms().charts->saveTo(at("c.png"), calibration.view().chart(), source);
    EXPECT_FALSE(QImage(at("c.png")).isNull());
}

TEST_F(CostsWorkbench, EarlierPointsPredictAndTheRunStandsBesideIt) {
    openSmall();
    const Scenario& scenario = session->document().scenario();
    const Inputs& inputs = session->computation().inputs();
    const std::string machine = io::machineText();
    const Digest scene = sceneDigest(originOf(inputs, referenceScenario(scenario), 0, 0.0, machine), DebrisInstant::AtRest);
    io::StudyFiles files(io::cacheFolder());
    for (const std::int64_t bodies : {2, 3, 4, 6, 8}) {
        KnownPoint point = openPoint(scene, machine, Execution().threads(), scenario, cli::smallDead, bodies);
        point.setting = "multiple=" + std::to_string(bodies);
        point.values[static_cast<std::size_t>(Predicted::WallSeconds)] = 0.02 * static_cast<double>(bodies);
        point.values[static_cast<std::size_t>(Predicted::FootprintIou)] = 1.0 - 0.4 / static_cast<double>(bodies);
        files.keep(point);
    }
    window->rooms().forecast->pointsAdded();
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered(); }, patience));
    for (const PanelDeck::Entry entry : {PanelDeck::Grid, PanelDeck::Effects, PanelDeck::Run, PanelDeck::Accuracy}) {
        const QString said = predictionOf(*window->rooms().deck->panels()[entry]);
        EXPECT_TRUE(said.contains(QStringLiteral("Wall time:"))) << said.toStdString();
        EXPECT_TRUE(said.contains(QStringLiteral("Footprint overlap:"))) << said.toStdString();
        EXPECT_TRUE(said.contains(QStringLiteral("Not known: live rate"))) << said.toStdString();
    }
    const auto wordsOf = [&] {
        QStringList words;
        for (const QLabel* label : window->rooms().deck->grid().prediction()->findChildren<QLabel*>()) {
            words << label->text() << label->toolTip();
        }
        return words;
    };
    const QStringList english = wordsOf();
    renewed->speak(QStringLiteral("zh_CN"));
    QTest::qWait(50);
    EXPECT_FALSE(wordsOf().join(QLatin1Char(' ')).contains(QStringLiteral("Four runs in five")));
    renewed->speak(QStringLiteral("en"));
    QTest::qWait(50);
    EXPECT_EQ(wordsOf(), english) << "told anew, tooltips as well";
    simulateToEnd();
    const QString after = predictionOf(window->rooms().deck->run());
    EXPECT_TRUE(after.contains(QStringLiteral("Wall time:")) && after.contains(QStringLiteral("said:"))) << after.toStdString();
    EXPECT_FALSE(predictionOf(window->rooms().deck->grid()).contains(QStringLiteral("said:"))) << "that panel looks ahead";
    session->document().setParameter(QStringLiteral("friction"), 0.9);
    EXPECT_FALSE(predictionOf(window->rooms().deck->run()).contains(QStringLiteral("said:"))) << "of another setting";
    session->document().undoStack().undo();
    EXPECT_TRUE(predictionOf(window->rooms().deck->run()).contains(QStringLiteral("said:")));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
}

TEST_F(CostsWorkbench, ACalibrationIsCancelledAndAKeptOneIsFoundAgain) {
    openSmall();
    CalibrationDisplay& calibration = (*window->rooms().calibration);
    calibration.open();
    calibration.view().findChild<QPushButton*>(QStringLiteral("primary"))->click();
    ASSERT_TRUE(calibration.work().running());
    calibration.view().findChild<QPushButton*>(QStringLiteral("cancelCalibration"))->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !calibration.work().running(); }, patience));
    EXPECT_EQ(calibration.work().calibration(), nullptr) << "a curve that was broken off is none";
    Calibration kept;
    kept.machine = io::machineText();
    kept.threads = Execution().threads();
    kept.complete = true;
    for (const std::int64_t bodies : {100, 200, 400}) {
        const double fps = 6000.0 / static_cast<double>(bodies);
        kept.points.push_back({PileKind::Typical, bodies, 2.0 * fps, 2.0 * fps, fps});
        kept.points.push_back({PileKind::Worst, bodies, fps, fps, 0.5 * fps});
    }
    io::StudyFiles(io::cacheFolder()).keep(kept);
    startProgram();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().calibration->work().calibration() != nullptr; }, patience));
    // 6,000 bodies a second make 250 at 24 FPS; nobody is offered what no case can take.
    EXPECT_NEAR(window->rooms().calibration->work().plot().bodiesMax[0]->bodies, 250.0, 5.0);
    EXPECT_TRUE(window->rooms().calibration->view().findChild<QPushButton*>(QStringLiteral("useBodies"))->isHidden());
    openSmall();
    window->rooms().calibration->open();
    window->rooms().calibration->view().findChild<QPushButton*>(QStringLiteral("useBodies"))->click();
    const std::int64_t allowed = session->document().scenario().grid.bodiesMax;
    EXPECT_TRUE(allowed == 240 || allowed == 250) << allowed;
    session->document().undoStack().undo();
    EXPECT_EQ(session->document().scenario().grid.bodiesMax, 4500);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
}

TEST_F(CostsWorkbench, TheGridSaysThatItsBodiesAreFragmentsAlone) {
    openSmall();
    ASSERT_TRUE(QTest::qWaitFor([&] { return answered(); }, patience));
    const auto told = [this] {
        for (const widgets::Notice* notice : window->rooms().deck->grid().findChildren<widgets::Notice*>()) {
            if (!notice->isHidden() && notice->text().contains(QStringLiteral("fragments alone"))) {
                return true;
            }
        }
        return false;
    };
    EXPECT_TRUE(told());
    session->document().setParameter(QStringLiteral("loose_structure"), std::string("fe"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && answered() && !told(); }, patience)) << "the FE result moves it";
    session->document().undoStack().undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared() && answered() && told(); }, patience));
}

TEST_F(CostsWorkbench, StructureIsColouredByIsland) {
    openSmall();
    auto* colours = window->findChild<QComboBox*>(QStringLiteral("colourBy"));
    const auto colourBy = [&](render::ColourBy by) {
        colours->setCurrentIndex(colours->findData(static_cast<int>(by)));
        emit colours->activated(colours->currentIndex());
    };
    EXPECT_EQ(window->rooms().scene->data().loose, nullptr) << "nobody asked";
    colourBy(render::ColourBy::Island);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window->rooms().scene->data().loose != nullptr; }, patience));
    window->rooms().playback->showInstant(0.3);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window->area().views().status(render::PaneContent::Fe).islands.empty(); }, patience));
    const auto first = window->rooms().scene->data().loose;
    // Where the ground lies decides what stands on it.
    session->document().setParameter(QStringLiteral("ground_height"), -1.0);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            const auto now = window->rooms().scene->data().loose;
            return now != nullptr && now != first;
        },
        patience));
    colourBy(render::ColourBy::Speed);
    EXPECT_EQ(window->rooms().scene->data().loose, nullptr);
}

TEST_F(CostsWorkbench, FragmentsAreColouredByTheirErrorAgainstAReference) {
    openSmall();
    auto* colours = window->findChild<QComboBox*>(QStringLiteral("colourBy"));
    const auto colourBy = [&](render::ColourBy by) {
        colours->setCurrentIndex(colours->findData(static_cast<int>(by)));
        emit colours->activated(colours->currentIndex());
    };
    widgets::ErrorBar& bar = window->area().errorBar();
    EXPECT_TRUE(bar.isHidden());
    colourBy(render::ColourBy::Error);
    EXPECT_FALSE(bar.isHidden());
    EXPECT_EQ(bar.state(), widgets::ErrorBar::State::NoRun);
    simulateToEnd();
    ASSERT_TRUE(QTest::qWaitFor([&] { return bar.state() == widgets::ErrorBar::State::NoReference; }, patience));
    EXPECT_EQ(window->rooms().scene->data().reference, nullptr);
    bar.findChild<QPushButton*>(QStringLiteral("computeReference"))->click();
    ASSERT_TRUE(window->rooms().errors->work().running());
    EXPECT_FALSE(window->actions()[ActionId::Simulate].isEnabled());
    ASSERT_TRUE(QTest::qWaitFor([&] { return bar.state() == widgets::ErrorBar::State::Shown; }, patience));
    ASSERT_NE(window->rooms().scene->data().reference, nullptr);
    EXPECT_TRUE(window->rooms().scene->data().reference->complete());
    EXPECT_EQ(window->rooms().scene->data().reference->carriers().size(), static_cast<std::size_t>(cli::smallDead));
    window->rooms().playback->showInstant(0.5);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return !window->area().views().status(render::PaneContent::Fragments).errors.empty(); }, patience));
    const render::PaneStatus& status = window->area().views().status(render::PaneContent::Fragments);
    std::size_t counted = status.errorsUnknown;
    for (const std::size_t n : status.errors) {
        counted += n;
    }
    EXPECT_EQ(counted, status.fragments);
    EXPECT_EQ(status.errors.size(), 6u);
    // The tolerances of the panel decide where colours change.
    auto* tolerances = window->rooms().deck->accuracy().findChild<QLineEdit*>(QStringLiteral("tolerances"));
    tolerances->setText(QStringLiteral("0.05, 2"));
    emit tolerances->editingFinished();
    EXPECT_EQ(window->area().views().view().errorSteps, (std::vector<double>{0.05, 2.0, 3.0, 10.0}));
    // Another scene has another reference; the same one is found again.
    session->document().setParameter(QStringLiteral("gravity"), 5.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    simulateToEnd();
    ASSERT_TRUE(QTest::qWaitFor([&] { return bar.state() == widgets::ErrorBar::State::NoReference; }, patience));
    session->document().undoStack().undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    simulateToEnd();
    EXPECT_TRUE(QTest::qWaitFor([&] { return bar.state() == widgets::ErrorBar::State::Shown; }, patience));
    colourBy(render::ColourBy::Speed);
    EXPECT_TRUE(bar.isHidden());
    EXPECT_EQ(window->rooms().scene->data().reference, nullptr);
}

}  // namespace
}  // namespace rubble
