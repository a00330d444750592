#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

#include "app/gui/exports/picture_export.h"
#include "app/gui/exports/report_work.h"
#include "app/gui/stage/view_area.h"
#include "io/case/case_file.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"
#include "widgets/basics/language.h"
#include "widgets/basics/panel.h"
#include "widgets/evidence/figure_dialog.h"
#include "widgets/evidence/movie_dialog.h"
#include "widgets/evidence/report_panel.h"
#include "widgets/views/status_line.h"

namespace rubble {
namespace {

class Exports : public Workbench {
protected:
    void simulated() {
        Case theCase = io::caseForFe(cli::writeSmallCollapse(m_folder / "small.exo"), m_folder / "small.rubble");
        setParameterText(theCase.scenarios[0].scenario, "settle_time", "0.5");
        io::saveCase(m_folder / "small.rubble", theCase);
        window->open(QString::fromStdString(m_folder / "small.rubble"), true);
        awaitRun();
    }
    bool idle() {
        return QTest::qWaitFor([&] { return !session->computation().busy(); }, patience);
    }

    /// Small pictures from 0 s on, at the pace of the collapse.
    static widgets::MovieChoice smallMovie(double to, double picturesPerSecond) {
        widgets::MovieChoice choice;
        choice.settings = {0.0, to, picturesPerSecond, 1.0};
        choice.pixels = {320, 200};
        choice.encoded = false;
        return choice;
    }

    io::TemporaryFolder m_folder;
};

TEST_F(Exports, AMovieIsWrittenInTheBackground) {
    simulated();
    const widgets::MovieChoice choice = smallMovie(0.4, 10.0);
    window->rooms().pictures->exportMovieTo(QString::fromStdString(m_folder / "frames"), choice, window->area().views().view(),
                                            window->rooms().scene->data());
    ASSERT_TRUE(idle());
    EXPECT_TRUE(QFile::exists(QString::fromStdString(m_folder / "frames/frame-00005.png")));
    EXPECT_FALSE(QFile::exists(QString::fromStdString(m_folder / "frames/frame-00006.png")));
}

TEST_F(Exports, AFigureWaitsForTheMovieBeforeItAndBothAreWritten) {
    simulated();
    const widgets::MovieChoice choice = smallMovie(0.4, 100.0);
    const render::View view = window->area().views().view();
    window->rooms().pictures->exportMovieTo(QString::fromStdString(m_folder / "frames"), choice, view,
                                            window->rooms().scene->data());
    const QString figure = QString::fromStdString(m_folder / "figure.png");
    window->rooms().pictures->exportFigureTo(figure, {{}, {640, 400}, 100}, view, window->rooms().scene->data());
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return window->findChild<widgets::StatusLine*>()->activityText().contains(QStringLiteral("1 waiting")); }, patience));
    ASSERT_TRUE(idle());
    EXPECT_TRUE(QFile::exists(QString::fromStdString(m_folder / "frames/frame-00041.png")));
    EXPECT_TRUE(QFile::exists(figure));
}

/// What is half written goes with the window.
TEST_F(Exports, ClosingWhileAMovieIsWrittenLeavesNoHalfOfIt) {
    simulated();
    const widgets::MovieChoice choice = smallMovie(0.5, 1000.0);
    window->rooms().pictures->exportMovieTo(QString::fromStdString(m_folder / "frames"), choice, window->area().views().view(),
                                            window->rooms().scene->data());
    ASSERT_TRUE(session->computation().busy());
    session->document().undoStack().setClean();
    endProgram();
    QTest::qWait(50);
    EXPECT_FALSE(QFile::exists(QString::fromStdString(m_folder / "frames/frame-00001.png")));
}

TEST_F(Exports, ARunIsSharedAsAPageOnceItIsFinished) {
    QAction& share = window->actions()[ActionId::SharePage];
    EXPECT_FALSE(share.isEnabled()) << "nothing is open";
    simulated();
    EXPECT_TRUE(share.isEnabled());
    const QString page = QString::fromStdString(m_folder / "small.html");
    window->rooms().pictures->sharePageAt(page, window->rooms().scene->data());
    ASSERT_TRUE(idle());
    const std::string html = textOf(page);
    EXPECT_NE(html.find(session->computation().currentRun()->outcome->trajectoryHash.hex()), std::string::npos);
    EXPECT_NE(html.find("<figure data-time="), std::string::npos) << "pictures for browsers without WebGL";
    EXPECT_NE(html.find("\"kind\":\"map\""), std::string::npos);
    EXPECT_EQ(html.find("{{"), std::string::npos);
}

TEST_F(Exports, AReportIsMadeOfTheRunAndNotOfAStaleOne) {
    widgets::ReportPanel& panel = window->rooms().deck->report();
    auto* write = panel.findChild<QPushButton*>(QStringLiteral("writeReport"));
    EXPECT_FALSE(write->isEnabled()) << "nothing is open";
    simulated();
    EXPECT_TRUE(write->isEnabled());
    panel.findChild<QSpinBox*>(QStringLiteral("reportRepeats"))->setValue(0);
    auto* selfTest = panel.findChild<QComboBox*>(QStringLiteral("reportSelfTest"));
    selfTest->setCurrentIndex(selfTest->findData(QStringLiteral("none")));
    window->rooms().report->writeTo(QString::fromStdString(m_folder / "report"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window->rooms().report->writing(); }, patience));
    const std::string html = textOf(QString::fromStdString(m_folder / "report/report.html"));
    EXPECT_NE(html.find(session->computation().currentRun()->outcome->trajectoryHash.hex()), std::string::npos);
    EXPECT_TRUE(QFile::exists(QString::fromStdString(m_folder / "report/report.pdf")));
    session->document().setParameter(QStringLiteral("friction"), 0.3);
    ASSERT_TRUE(idle());
    EXPECT_FALSE(write->isEnabled()) << "the run does not have this setting";
    session->document().undoStack().setClean();
}

// A report is made in the language of the window: its own words, names of settings, materials and effects.
TEST_F(Exports, AReportSpeaksTheLanguageOfTheWindow) {
    widgets::speak(QStringLiteral("zh_CN"));
    simulated();
    widgets::ReportPanel& panel = window->rooms().deck->report();
    panel.findChild<QSpinBox*>(QStringLiteral("reportRepeats"))->setValue(0);
    auto* selfTest = panel.findChild<QComboBox*>(QStringLiteral("reportSelfTest"));
    selfTest->setCurrentIndex(selfTest->findData(QStringLiteral("none")));
    window->rooms().report->writeTo(QString::fromStdString(m_folder / "report"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window->rooms().report->writing(); }, patience));
    const std::string html = textOf(QString::fromStdString(m_folder / "report/report.html"));
    widgets::speak(QStringLiteral("en"));
    EXPECT_NE(html.find("<html lang=\"zh-CN\">"), std::string::npos);
    for (const char* english : {"simulation report", "Contents", "Made on", "Trajectory hash", "Table 1", "Figure 1", "Settle time",
                                "Contact of", "masonry", "Scenario<"}) {
        EXPECT_EQ(html.find(english), std::string::npos) << english;
    }
    for (const char* chinese : {"目录", "砌体", "构件"}) {
        EXPECT_NE(html.find(chinese), std::string::npos) << chinese;
    }
}

TEST(FigureDialog, SaysTheSizeInPrintAndAsksForAPreviewOnceItRests) {
    widgets::FigureDialog dialog({});
    int asked = 0;
    QObject::connect(&dialog, &widgets::FigureDialog::previewRequested, &dialog, [&](const widgets::FigureChoice& choice) {
        ++asked;
        EXPECT_EQ(choice.preset, figures::FigurePreset::Stages);
    });
    auto* preset = dialog.findChild<QComboBox*>(QStringLiteral("figurePreset"));
    for (int i = 0; i < preset->count(); ++i) {
        preset->setCurrentIndex(i);
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return asked > 0; }, 10'000));
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(dialog.choice().pixels, QSize(1600, 0));
}

TEST(FigureDialog, TakesTheSizeOfTheArrangementUntilOneIsChosen) {
    widgets::FigureDialog dialog({});
    auto* preset = dialog.findChild<QComboBox*>(QStringLiteral("figurePreset"));
    const auto choose = [&](int which) { preset->setCurrentIndex(preset->findData(which)); };
    choose(static_cast<int>(figures::FigurePreset::Pairs));
    EXPECT_EQ(dialog.choice().pixels, QSize(1600, 0)) << "as the pictures need";
    choose(-1);
    EXPECT_EQ(dialog.choice().pixels, QSize(1600, 1000));
    dialog.findChild<QSpinBox*>(QStringLiteral("figureHeight"))->setValue(900);
    choose(static_cast<int>(figures::FigurePreset::Pairs));
    EXPECT_EQ(dialog.choice().pixels, QSize(1600, 900));
}

TEST(MovieDialog, OffersNothingBeyondTheEndAndSaysWhereThatIs) {
    widgets::MovieChoice choice;
    choice.settings.from = 0.0;
    choice.settings.to = 3.2167;
    widgets::MovieDialog dialog(choice, false);
    auto* to = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("movieTo"));
    EXPECT_LE(to->maximum(), 3.2167) << "not a thousandth beyond it";
    EXPECT_EQ(dialog.choice().settings.to, 3.2167) << "as far as there is something";
    to->setValue(99.0);
    EXPECT_EQ(dialog.choice().settings.to, 3.2167);
    const QList<QLabel*> labels = dialog.findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(),
                            [](const QLabel* label) { return label->text().contains(QStringLiteral("up to 3.22 s")); }));
    auto* line = dialog.findChild<widgets::Notice*>(QStringLiteral("pictureCautions"));
    ASSERT_NE(line, nullptr);
    EXPECT_TRUE(line->isHidden());
    dialog.setCautions(QStringLiteral("12 of 40 bodies still move"));
    EXPECT_FALSE(line->isHidden());
    EXPECT_TRUE(line->text().contains(QStringLiteral("12 of 40 bodies still move")));
    EXPECT_EQ(line->property("kind"), QStringLiteral("finding")) << "amber";
}

TEST(MovieDialog, RefusesASpanWithoutLength) {
    widgets::MovieChoice choice;
    choice.settings.from = 0.0;
    choice.settings.to = 10.0;
    widgets::MovieDialog dialog(choice, false);
    EXPECT_FALSE(dialog.choice().encoded) << "without ffmpeg there is no MP4";
    auto* save = dialog.findChild<QPushButton*>(QStringLiteral("primary"));
    EXPECT_TRUE(save->isEnabled());
    dialog.findChild<QDoubleSpinBox*>(QStringLiteral("movieFrom"))->setValue(10.0);
    EXPECT_FALSE(save->isEnabled());
}

}  // namespace
}  // namespace rubble
