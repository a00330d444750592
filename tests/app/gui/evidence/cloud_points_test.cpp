#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/gui/case/file_commands.h"
#include "app/gui/evidence/cloud_points.h"
#include "app/gui/evidence/survey_display.h"
#include "app/gui/exports/picture_export.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/stage/scene_display.h"
#include "app/gui/stage/view_area.h"
#include "io/base/files.h"
#include "io/exports/provenance.h"
#include "io/site/clouds/point_writer.h"
#include "tests/app/gui/workbench.h"
#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/temporary_folder.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/evidence/survey_box.h"
#include "widgets/evidence/surveys/distance_fields.h"
#include "widgets/evidence/surveys/point_box.h"
#include "widgets/views/view_widget.h"

namespace rubble {

namespace {

class PointsOfACloud : public FreshWorkbench {
protected:
    /// A level surface of points every 0.4 m around the arch, red at its left end and blue at its right one.
    QString scan(double height) {
        constexpr std::size_t side = 200;
        io::WrittenCloud cloud;
        cloud.points = side * side;
        cloud.box = Aabb(Vec3(-40.0, -40.0, height), Vec3(40.0, 40.0, height));
        const std::string path = m_folder / "scan.las";
        io::writePoints(path, cloud, [&](std::size_t k, io::WrittenPoint& point) {
            const auto x = static_cast<double>(k % side);
            point.place = Vec3(0.4 * x - 39.8, 0.4 * static_cast<double>(k / side) - 39.8, height);
            point.colour = {static_cast<std::uint8_t>(255.0 - x), 0, static_cast<std::uint8_t>(x)};
            point.kind = k % 2 == 0 ? 2 : 6;
        });
        return QString::fromStdString(path);
    }
    CloudPoints& points() { return *window->rooms().cloudPoints; }
    widgets::PointBox& box() { return window->rooms().deck->evidence().survey().points(); }
    widgets::ViewWidget& views() { return window->area().views(); }
    const render::SitePoints* drawn() { return views().data().points.get(); }
    void open() {
        openArch();
        ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
        window->rooms().survey->add(scan(5.0));
    }
    void settle() {
        ASSERT_TRUE(QTest::qWaitFor([&] { return !points().busy(); }, patience));
        QTest::qWait(50);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !points().busy(); }, patience));
    }
    io::TemporaryFolder m_folder;
};

TEST_F(PointsOfACloud, AreDrawnFromAnOctreeBesideIt) {
    open();
    views().setAnimated(false);
    EXPECT_TRUE(box().isVisibleTo(&window->rooms().deck->evidence()));
    const QImage before = views().grab().toImage();
    box().findChild<QCheckBox*>()->click();
    settle();
    ASSERT_NE(drawn(), nullptr);
    EXPECT_EQ(drawn()->all, 40'000U);
    EXPECT_GT(drawn()->shown, 1'000U);
    EXPECT_LE(drawn()->shown, 40'000U);
    EXPECT_EQ(drawn()->scale, render::SitePoints::Scale::Own);
    EXPECT_TRUE(std::filesystem::exists(m_folder / "scan.las.octree"));
    EXPECT_NE(views().grab().toImage(), before);
    // By class the same places have other colours, and both classes stand in the legend.
    box().findChild<QComboBox*>()->setCurrentIndex(2);
    settle();
    EXPECT_EQ(drawn()->scale, render::SitePoints::Scale::Class);
    ASSERT_EQ(drawn()->classes.size(), 2U);
    EXPECT_EQ(drawn()->classes[0].first, 2);
    EXPECT_EQ(drawn()->classes[1].first, 6);
    box().findChild<QCheckBox*>()->click();
    EXPECT_EQ(drawn(), nullptr);
    EXPECT_EQ(views().grab().toImage(), before) << "as it was";
}

TEST_F(PointsOfACloud, LieWhereTheCaseMovesThem) {
    open();
    points().setShown(true);
    settle();
    ASSERT_NE(drawn(), nullptr);
    EXPECT_NEAR(drawn()->patches.front()->places[2], 5.0, 1e-3);
    std::vector<CaseInput> inputs = session->document().theCase().inputs;
    inputs.back().registration = Registration{};
    inputs.back().registration->shift = Vec3(0.0, 0.0, 2.5);
    session->document().setSurveys(std::move(inputs), [] { return QStringLiteral("moved"); });
    settle();
    ASSERT_NE(drawn(), nullptr);
    EXPECT_NEAR(drawn()->patches.front()->places[2], 7.5, 1e-3);
}

TEST_F(PointsOfACloud, AreCutByThePlaneThatCutsTheModel) {
    open();
    views().setAnimated(false);
    points().setShown(true);
    settle();
    const auto red = [&] {
        const QImage image = views().grab().toImage();
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor colour = image.pixelColor(x, y);
                count += colour.red() > 200 && colour.green() == 0 ? 1 : 0;
            }
        }
        return count;
    };
    const int all = red();
    ASSERT_GT(all, 100) << "the left end is red";
    render::View view = views().view();
    view.clip = render::ClipPlane{Vec3::Zero(), -Vec3::UnitX()};  // what lies at x < 0 is cut away
    window->rooms().scene->setView(view);
    EXPECT_EQ(red(), 0);
    view.clip->normal = Vec3::UnitX();
    window->rooms().scene->setView(view);
    EXPECT_GT(red(), all / 2);
    // Points that come while it cuts are cut as well.
    view.clip->normal = -Vec3::UnitX();
    window->rooms().scene->setView(view);
    points().setShown(false);
    points().setShown(true);
    settle();
    EXPECT_EQ(red(), 0);
}

TEST_F(PointsOfACloud, OfTwoSystemsAreDrawnWhereTheCaseLies) {
    openArch();
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    // Most of them in a system of the land, and a field about the arch.
    constexpr std::size_t about = 10'000;
    io::WrittenCloud cloud;
    cloud.points = 4 * about;
    cloud.box = Aabb(Vec3(-20.0, -20.0, 5.0), Vec3(500'040.0, 5'400'040.0, 5.0));
    const std::string path = m_folder / "two.las";
    io::writePoints(path, cloud, [&](std::size_t k, io::WrittenPoint& point) {
        const Vec3 in(0.4 * static_cast<double>(k % 100), 0.4 * static_cast<double>(k / 100 % 100), 5.0);
        point.place = k < 3 * about ? Vec3(in + Vec3(500'000.0, 5'400'000.0, 0.0)) : Vec3(in - Vec3(20.0, 20.0, 0.0));
        point.kind = k < 3 * about ? 2 : 6;
    });
    window->rooms().survey->add(QString::fromStdString(path));
    points().setShown(true);
    settle();
    ASSERT_NE(drawn(), nullptr);
    EXPECT_GT(drawn()->shown, about / 4);
    EXPECT_LE(drawn()->shown, about);
    EXPECT_EQ(drawn()->source.far, 3 * about);
    for (const auto& patch : drawn()->patches) {
        EXPECT_LT(std::abs(patch->places[0]), 21.0F);
    }
    // The legend names the classes of what is looked at, and no others.
    box().findChild<QComboBox*>()->setCurrentIndex(2);
    settle();
    ASSERT_EQ(drawn()->classes.size(), 1U);
    EXPECT_EQ(drawn()->classes[0].first, 6);
    render::View there = views().view();
    for (render::Camera& camera : there.cameras) {
        camera.focalPoint += Vec3(500'000.0, 5'400'000.0, 0.0);
        camera.position += Vec3(500'000.0, 5'400'000.0, 0.0);
    }
    window->rooms().scene->setView(there);
    settle();
    EXPECT_EQ(drawn()->source.far, about);
    ASSERT_EQ(drawn()->classes.size(), 1U);
    EXPECT_EQ(drawn()->classes[0].first, 2);
}

TEST_F(PointsOfACloud, StandInTheProvenanceOfAFigureWithWhatTheCutCuts) {
    open();
    std::vector<CaseInput> inputs = session->document().theCase().inputs;
    inputs.back().registration = Registration{};
    inputs.back().registration->shift = Vec3(0.0, 0.0, 2.5);
    session->document().setSurveys(std::move(inputs), [] { return QStringLiteral("moved"); });
    points().setShown(true);
    settle();
    ASSERT_NE(drawn(), nullptr);
    render::View view = views().view();
    view.clip = render::ClipPlane{Vec3::Zero(), -Vec3::UnitX()};
    const std::string path = m_folder / "figure.png";
    const auto told = [&](bool shown) {
        std::filesystem::remove(path);
        view.cloud = shown ? views().view().cloud : std::string();
        window->rooms().pictures->exportFigureTo(QString::fromStdString(path), {{}, {320, 200}, 50}, view,
                                                 window->rooms().scene->data());
        EXPECT_TRUE(QTest::qWaitFor([&] { return !session->computation().busy(); }, patience));
        const auto carried = std::filesystem::exists(path) ? io::readProvenance(path) : std::nullopt;
        return carried ? nlohmann::json::parse(carried->text) : nlohmann::json();
    };
    nlohmann::json about = told(true);
    ASSERT_EQ(about["clouds"].size(), 1U);
    EXPECT_EQ(about["clouds"][0]["sha256"], io::sha256OfFile(m_folder / "scan.las"));
    EXPECT_EQ(about["clouds"][0]["registration"]["shift_m"][2], 2.5);
    EXPECT_EQ(about["clouds"][0]["points_shown"], drawn()->shown);
    EXPECT_EQ(about["clouds"][0]["points"], 40'000);
    EXPECT_GT(about["clouds"][0]["finest_cells_m"], 0.0);
    EXPECT_EQ(about["settings_of_export"]["cut"]["cuts"].back(), "points of the cloud");
    EXPECT_EQ(about["settings_of_export"]["cut"]["leaves_whole"][0], "ground");
    about = told(false);
    EXPECT_TRUE(about["clouds"].empty());
    EXPECT_NE(about["settings_of_export"]["cut"]["cuts"].back(), "points of the cloud");
    EXPECT_EQ(about["settings_of_export"]["cut"]["cuts"][0], "structure");
    view.clip.reset();
    EXPECT_FALSE(told(false)["settings_of_export"].contains("cut"));
    // Another file by now: the figure would name what it does not show.
    std::ofstream(m_folder / "scan.las", std::ios::app) << "more";
    EXPECT_TRUE(told(true).is_null());
}

TEST_F(PointsOfACloud, ItsPhotographsAreAddedInTheBackgroundAndOnceMoreAfterUndo) {
    openArch();
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    const std::string scan = m_folder / "scan.e57";
    io::layCloud(scan, io::cloudWithPictures());
    window->rooms().survey->add(QString::fromStdString(scan));
    settle();
    auto* add = box().findChild<QPushButton*>("addPhotographs");
    auto* cancel = box().findChild<QPushButton*>("cancelPhotographs");
    const auto photographs = [&] { return session->document().theCase().photographs.size(); };
    ASSERT_TRUE(add->isVisibleTo(&box()));
    EXPECT_FALSE(cancel->isVisibleTo(&box()));
    // Given up: nothing is added, and it can be asked for again.
    QTest::mouseClick(add, Qt::LeftButton);
    EXPECT_TRUE(cancel->isVisibleTo(&box()));
    EXPECT_FALSE(add->isEnabled());
    EXPECT_EQ(photographs(), 0U) << "not on the thread of the window";
    QTest::mouseClick(cancel, Qt::LeftButton);
    settle();
    EXPECT_EQ(photographs(), 0U);
    EXPECT_TRUE(add->isEnabled());
    QTRY_VERIFY(!std::filesystem::exists(m_folder / "scan.e57-photographs"));
    QTest::mouseClick(add, Qt::LeftButton);
    settle();
    EXPECT_EQ(photographs(), 1U);
    EXPECT_TRUE(std::filesystem::exists(m_folder / "scan.e57-photographs"));
    EXPECT_FALSE(add->isVisibleTo(&box())) << "all are there";
    session->document().undoStack().undo();
    EXPECT_EQ(photographs(), 0U);
    QTest::mouseClick(add, Qt::LeftButton);
    settle();
    EXPECT_EQ(photographs(), 1U);
}

TEST_F(PointsOfACloud, OfAnotherCaseAreNotDrawnUnasked) {
    open();
    points().setShown(true);
    settle();
    ASSERT_NE(drawn(), nullptr);
    // Else it is asked whether to keep the changes.
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    openArch();
    EXPECT_TRUE(views().view().cloud.empty());
    settle();
    EXPECT_EQ(drawn(), nullptr);
}

TEST_F(PointsOfACloud, AreColouredByWhatDiffersFromTheRunBeyondTheLevelOfDetection) {
    open();
    EXPECT_FALSE(box().findChildren<QPushButton*>().empty());
    makeCheap();
    simulateToEnd();
    window->rooms().survey->refresh();
    box().distances().setSettings({2.0, 1.0, 4.0, 0.05, false});
    points().measure();
    settle();
    ASSERT_NE(drawn(), nullptr);
    const render::SitePoints& told = *drawn();
    EXPECT_EQ(told.scale, render::SitePoints::Scale::Distance);
    EXPECT_EQ(views().view().pointColour, render::PointColour::Distance);
    EXPECT_TRUE(told.registered);
    EXPECT_GE(told.detection, 0.05);
    EXPECT_GT(told.shown, 0U);
    EXPECT_LE(told.significant + told.unknown, told.shown);
    EXPECT_EQ(told.patches.front()->rgb.size(), told.patches.front()->places.size());
    // Grey is what is not significant: as many as are neither red nor blue.
    const std::vector<std::uint8_t>& rgb = told.patches.front()->rgb;
    std::uint64_t grey = 0;
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
        grey += rgb[i] == 160 && rgb[i + 1] == 160 && rgb[i + 2] == 160 ? 1 : 0;
    }
    EXPECT_EQ(grey + told.significant + told.unknown, told.shown);
}

}  // namespace

}  // namespace rubble
