#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMessageBox>
#include <QMimeData>
#include <QTest>
#include <QTimer>
#include <filesystem>
#include <fstream>

#include "app/gui/exports/picture_export.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "io/case/case_file.h"
#include "io/exports/provenance.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"
#include "widgets/evidence/figure_dialog.h"
#include "widgets/figures/view_json.h"
#include "widgets/render/basics/camera.h"
#include "widgets/render/panes.h"
#include "widgets/render/scene.h"
#include "widgets/views/status_line.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A case with a run, figures of it, and a window that they are dropped on.
class FigureDrop : public FreshWorkbench {
protected:
    void SetUp() override {
        FreshWorkbench::SetUp();
        Case theCase = io::caseForFe(cli::writeSmallCollapse(m_folder / "site/small.exo"), m_case);
        setParameterText(theCase.scenarios[0].scenario, "settle_time", "0.5");
        io::saveCase(m_case, theCase);
        m_look = render::View();
        m_look.layout = render::Layout::FragmentsOnly;
        m_look.camerasLinked = true;
        for (render::Camera& camera : m_look.cameras) {
            camera.position = Vec3(11.0, -42.0, 13.0);
        }
        m_look.time = 0.3;
    }
    /// Opens the case, simulates it and gives the window the view that figures are made in.
    void simulated() {
        window->open(QString::fromStdString(m_case), true);
        awaitRun();
        window->rooms().playback->showInstant(0.3);
        window->rooms().scene->look(m_look);
    }
    void figureOfTheWindow(const std::string& path) {
        const widgets::FigureChoice choice{{}, {640, 400}, 100};
        window->rooms().pictures->exportFigureTo(QString::fromStdString(path), choice, window->area().views().view(),
                                                 window->rooms().scene->data());
        ASSERT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
    }
    /// A figure of a run that is kept beside the case, by the command line.
    void figureOfTheCommandLine(const std::string& path) {
        std::ofstream(m_folder / "view.json") << figures::toJson(m_look);
        ASSERT_EQ(cli::cli({"run", m_case, "--out", m_folder / "site/small.run.h5"}).exitCode, 0);
        const cli::Outcome made =
            cli::cli({"figure", m_folder / "site/small.run.h5", "--case", m_case, "--view", m_folder / "view.json", "--time", "0.3",
                      "--size", "640x400", "--dpi", "100", "--out", path});
        ASSERT_EQ(made.exitCode, 0) << made.err;
    }
    void drop(const std::string& path) {
        QMimeData dropped;
        dropped.setUrls({QUrl::fromLocalFile(QString::fromStdString(path))});
        QDragEnterEvent enter(QPoint(640, 400), Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window, &enter);
        ASSERT_TRUE(enter.isAccepted());
        QDropEvent drop(QPointF(640, 400), Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window, &drop);
        EXPECT_TRUE(drop.isAccepted());
    }
    void close() {
        session->document().undoStack().setClean();
        window->actions()[ActionId::Close].trigger();
        ASSERT_TRUE(session->document().empty());
    }
    bool looksAsTheFigure() {
        const render::View& view = window->area().views().view();
        return session->document().path() == QString::fromStdString(m_case) && !session->computation().busy() &&
               view.cameras[0].position == m_look.cameras[0].position && view.layout == render::Layout::FragmentsOnly &&
               std::abs(window->rooms().playback->clock().time() - 0.3) < 1e-9;
    }
    /// What the window says once it has looked for the source of a figure.
    std::string toldAfter(const std::string& path, const char* what) {
        drop(path);
        const auto told = [&] { return window->findChild<widgets::StatusLine*>()->activityText(); };
        EXPECT_TRUE(
            QTest::qWaitFor([&] { return !session->computation().busy() && told().contains(QLatin1String(what)); }, patience))
            << told().toStdString();
        return told().toStdString();
    }
    /// The figure with a part of what it carries in other words of the same length.
    std::string altered(const std::string& path, const std::string& before, const std::string& after, const std::string& name) {
        std::string text = textOf(QString::fromStdString(path));
        const std::size_t at = text.find(before);
        EXPECT_NE(at, std::string::npos) << before;
        EXPECT_EQ(before.size(), after.size());
        text.replace(at, before.size(), after);
        const std::string changed = m_folder / name;
        std::ofstream(changed, std::ios::binary) << text;
        return changed;
    }

    io::TemporaryFolder m_folder;
    const bool m_site = fs::create_directories(m_folder / "site");
    std::string m_case = m_folder / "site/small.rubble";
    render::View m_look;
};

TEST_F(FigureDrop, OneOfTheWindowFindsItsCaseAndItsView) {
    simulated();
    for (const char* name : {"figure.png", "figure.svg", "figure.pdf"}) {
        figureOfTheWindow(m_folder / name);
        const auto carried = io::readProvenance(m_folder / name);
        ASSERT_TRUE(carried) << name;
        EXPECT_EQ(carried->casePath, m_case);
    }
    for (const char* name : {"figure.png", "figure.svg", "figure.pdf"}) {
        close();
        drop(m_folder / name);
        EXPECT_TRUE(QTest::qWaitFor([&] { return looksAsTheFigure(); }, patience)) << name;
    }
    // Dropped on its own case it only looks as before.
    render::View other = m_look;
    other.cameras[0].position = Vec3(-9.0, -30.0, 5.0);
    window->rooms().scene->look(other);
    ASSERT_FALSE(looksAsTheFigure());
    drop(m_folder / "figure.png");
    EXPECT_TRUE(QTest::qWaitFor([&] { return looksAsTheFigure(); }, patience));
}

TEST_F(FigureDrop, OneOfTheCommandLineBringsItsRunAlong) {
    figureOfTheCommandLine(m_folder / "figure.png");
    const std::string run = m_folder / "site/small.run.h5";
    EXPECT_THAT(toldAfter(m_folder / "figure.png", "Shown as in figure.png"), HasSubstr("Shown as in"));
    EXPECT_TRUE(looksAsTheFigure());
    const RunRecord* shown = session->computation().currentRun();
    ASSERT_NE(shown, nullptr);
    EXPECT_EQ(shown->reader->path(), run);
    // Without the run the view is restored all the same, and it is said what is missing.
    close();
    fs::remove(run);
    toldAfter(m_folder / "figure.png", "its run is not kept here");
    EXPECT_TRUE(looksAsTheFigure());
}

TEST_F(FigureDrop, APresetShowsAllThatItShowedAtItsInstant) {
    const std::string run = m_folder / "site/small.run.h5";
    ASSERT_EQ(cli::cli({"run", m_case, "--out", run}).exitCode, 0);
    // A picture far wider than the panes of the window.
    const cli::Outcome made =
        cli::cli({"figure", run, "--case", m_case, "--preset", "12", "--size", "2400x500", "--out", m_folder / "end.png"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    toldAfter(m_folder / "end.png", "Shown as in end.png");
    EXPECT_DOUBLE_EQ(window->rooms().playback->clock().time(), session->computation().currentRun()->outcome->endTime)
        << "not the FE end";
    const render::View& view = window->area().views().view();
    const QSize pixels = window->area().views().size();
    const double aspect = render::panesOf(view.layout, pixels.width(), pixels.height()).front().aspect();
    const Aabb bounds = render::boundsOf(window->rooms().scene->data());
    for (int corner = 0; corner < 8; ++corner) {
        const auto seen = render::project(view.cameras[0], bounds.corner(static_cast<Aabb::CornerType>(corner)), aspect);
        ASSERT_TRUE(seen);
        EXPECT_TRUE(seen->u > 0.0 && seen->u < 1.0 && seen->v > 0.0 && seen->v < 1.0) << seen->u << ' ' << seen->v;
    }
}

TEST_F(FigureDrop, ACaseThatMovedAwayIsNamed) {
    figureOfTheCommandLine(m_folder / "figure.png");
    const io::TemporaryFolder far;
    fs::rename(m_folder / "site", far / "site");
    const std::string told = toldAfter(m_folder / "figure.png", "was not found");
    EXPECT_THAT(told, HasSubstr("small.rubble"));
    EXPECT_TRUE(session->document().empty());
    EXPECT_EQ(session->computation().inputs().fe, nullptr);
    // Beside its case it finds it again.
    fs::copy_file(m_folder / "figure.png", far / "site/figure.png");
    drop(far / "site/figure.png");
    m_case = far / "site/small.rubble";
    EXPECT_TRUE(QTest::qWaitFor([&] { return looksAsTheFigure(); }, patience));
}

TEST_F(FigureDrop, OneThatWasAlteredIsNotBelieved) {
    simulated();
    figureOfTheWindow(m_folder / "figure.svg");
    const std::string sha = io::readProvenance(m_folder / "figure.svg")->feSha256;
    close();
    toldAfter(altered(m_folder / "figure.svg", sha, std::string(64, '0'), "other.svg"), "was not found");
    EXPECT_TRUE(session->document().empty());
    // A view that is none any more: the case opens, and it is said why it does not look as the figure.
    toldAfter(altered(m_folder / "figure.svg", "\"layout\":\"fragments_only\"", "\"layout\":\"fragments_0nly\"", "view.svg"),
              "the view's layout is none of its choices");
    EXPECT_FALSE(looksAsTheFigure());
}

TEST_F(FigureDrop, WhatIsOpenIsNotLeftWithoutAsking) {
    figureOfTheCommandLine(m_folder / "figure.png");
    openArch();
    session->document().setParameter(QStringLiteral("friction"), 0.61);
    bool asked = false;
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, window, [&] {
        if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
            asked = true;
            box->button(QMessageBox::Cancel)->click();
        }
    });
    answer.start(50);
    drop(m_folder / "figure.png");
    ASSERT_TRUE(QTest::qWaitFor([&] { return asked; }, patience));
    ASSERT_TRUE(QTest::qWaitFor([&] { return prepared(); }, patience));
    EXPECT_EQ(session->document().scenario().simulation.friction, 0.61);
    EXPECT_NE(window->area().views().view().cameras[0].position, m_look.cameras[0].position);
    session->document().undoStack().setClean();
}

}  // namespace
}  // namespace rubble
