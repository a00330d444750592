#include <QComboBox>
#include <QDialog>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <QTimer>
#include <cmath>
#include <fstream>
#include <functional>
#include <utility>

#include "app/gui/case/file_commands.h"
#include "app/gui/evidence/survey_display.h"
#include "app/gui/stage/view_area.h"
#include "io/case/case_file.h"
#include "io/site/site_place.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/temporary_folder.h"
#include "widgets/case/case_panel.h"
#include "widgets/case/site_dialog.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/evidence/evidence_table.h"
#include "widgets/evidence/survey_box.h"
#include "widgets/evidence/survey_view.h"
#include "widgets/views/view_widget.h"

namespace rubble {
namespace {

class SiteAndSurvey : public Workbench {
protected:
    void simulated() {
        openArch();
        makeCheap();
        simulateToEnd();
    }
    /// Heights every metre around the arch.
    QString heights(const char* name, const std::function<double(double, double)>& height) {
        const io::AsciiGrid around{120, 60, -60.0, -30.0};
        return QString::fromStdString(around.write(m_folder / name, height));
    }
    void compare() {
        window->rooms().survey->compare();
        ASSERT_TRUE(window->rooms().survey->busy());
        ASSERT_TRUE(QTest::qWaitFor([&] { return !window->rooms().survey->busy(); }, patience));
    }
    QPushButton* compareButton() {
        for (auto* each : window->rooms().deck->evidence().survey().findChildren<QPushButton*>()) {
            if (each->text() == QStringLiteral("Compare with survey")) {
                return each;
            }
        }
        return nullptr;
    }
    io::TemporaryFolder m_folder;
};

TEST_F(SiteAndSurvey, ASurveyIsAddedComparedSavedAndUndone) {
    simulated();
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    const QString survey =
        heights("after.asc", [](double x, double y) { return std::abs(x) < 15.0 && std::abs(y) < 5.0 ? 1.0 : 0.0; });
    EXPECT_FALSE(window->actions()[ActionId::CompareSurvey].isEnabled());
    window->rooms().survey->add(survey);
    EXPECT_EQ(window->rooms().deck->rail().current(), PanelDeck::Evidence);
    EXPECT_TRUE(window->actions()[ActionId::CompareSurvey].isEnabled());
    ASSERT_EQ(session->document().theCase().inputs.back().role, InputRole::Survey);
    EXPECT_FALSE(session->computation().stale(Stage::Simulation, session->document().scenario())) << "no result stands on a survey";
    QTest::mouseClick(compareButton(), Qt::LeftButton);
    ASSERT_TRUE(window->rooms().survey->busy());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window->rooms().survey->busy(); }, patience));
    ASSERT_NE(window->rooms().survey->comparison(), nullptr);
    const SurveyComparison& made = *window->rooms().survey->comparison();
    EXPECT_NEAR(made.survey.area, 300.0, 45.0);
    EXPECT_NEAR(made.survey.volume, 300.0, 45.0);
    EXPECT_GT(made.simulated.area, 10.0);
    EXPECT_GT(made.iou, 0.0);
    EXPECT_LT(made.iou, 1.0);

    // Saved as a raster and as a picture; both say what they were made from.
    for (const char* name : {"difference.tif", "difference.png"}) {
        window->rooms().survey->saveTo(QString::fromStdString(m_folder / name));
        EXPECT_TRUE(std::filesystem::exists(m_folder / name)) << name;
        EXPECT_TRUE(std::filesystem::exists(m_folder / (std::string(name) + ".provenance.json"))) << name;
    }
    // Other settings make it stale, and a stale one is not saved.
    auto& box = window->rooms().deck->evidence().survey();
    for (auto* each : box.findChildren<QComboBox*>()) {
        if (each->accessibleName() == QStringLiteral("Registration of the survey")) {
            each->setCurrentIndex(1);
        }
    }
    window->rooms().survey->saveTo(QString::fromStdString(m_folder / "stale.tif"));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "stale.tif"));
    compare();
    EXPECT_EQ(window->rooms().survey->comparison()->settings.fit, SurveyFit::Ground);

    // What the survey shows is kept in the case and said on the result.
    for (auto* each : box.findChildren<QComboBox*>()) {
        if (each->accessibleName() == QStringLiteral("Whether the survey shows fallen structure")) {
            each->setCurrentIndex(1);
        }
    }
    EXPECT_EQ(session->document().theCase().inputs.back().showsFallen, std::optional<bool>(true));
    window->rooms().survey->saveTo(QString::fromStdString(m_folder / "stale.tif"));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "stale.tif"));
    compare();
    EXPECT_EQ(window->rooms().survey->comparison()->surveyShowsFallen, std::optional<bool>(true));

    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    EXPECT_EQ(io::loadCase(m_folder / "case.rubble").inputs.back().path, "after.asc");
    EXPECT_EQ(io::loadCase(m_folder / "case.rubble").inputs.back().showsFallen, std::optional<bool>(true));
    window->actions()[ActionId::Undo].trigger();
    EXPECT_EQ(session->document().theCase().inputs.back().showsFallen, std::nullopt);
    // How it is compared belongs to the case too.
    EXPECT_EQ(io::loadCase(m_folder / "case.rubble").evidence.fit, SurveyFit::Ground);
    window->actions()[ActionId::Undo].trigger();
    EXPECT_EQ(session->document().theCase().evidence.fit, SurveyFit::None);
    EXPECT_EQ(box.settings().fit, SurveyFit::None) << "the field follows";
    window->actions()[ActionId::Undo].trigger();
    EXPECT_NE(session->document().theCase().inputs.back().role, InputRole::Survey);
    EXPECT_FALSE(window->actions()[ActionId::CompareSurvey].isEnabled());
    window->actions()[ActionId::Redo].trigger();
    EXPECT_EQ(session->document().theCase().inputs.back().role, InputRole::Survey);
}

TEST_F(SiteAndSurvey, WhatIsComparedIsDrawnKeptAndUndone) {
    simulated();
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    // Debris over the site and something that is none beside it.
    window->rooms().survey->add(heights("after.asc", [](double x, double y) {
        const bool lorry = x > 30.0 && x < 42.0 && y > 15.0 && y < 20.0;
        return lorry ? 3.0 : std::abs(x) < 15.0 && std::abs(y) < 5.0 ? 1.0 : 0.0;
    }));
    compare();
    const double all = window->rooms().survey->comparison()->survey.area;
    EXPECT_NEAR(all, 360.0, 60.0);
    auto& view = *window->findChild<widgets::SurveyView*>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view.isVisible(); }, patience));
    emit window->rooms().deck->evidence().survey().scopeDrawRequested(ScopePart::LeftOut);
    ASSERT_TRUE(view.drawing());
    view.grab();
    for (const Eigen::Vector2d& corner :
         {Eigen::Vector2d(28.0, 13.0), Eigen::Vector2d(44.0, 13.0), Eigen::Vector2d(44.0, 22.0), Eigen::Vector2d(28.0, 22.0)}) {
        QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, view.toWidget(corner).toPoint());
    }
    QTest::keyClick(&view, Qt::Key_Return);
    const auto leftOut = [&] { return session->document().theCase().inputs.back().scope.leftOut.polygons.size(); };
    ASSERT_EQ(leftOut(), 1u);
    window->rooms().survey->saveTo(QString::fromStdString(m_folder / "stale.tif"));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "stale.tif")) << "it is of another scope";
    compare();
    EXPECT_NEAR(window->rooms().survey->comparison()->survey.area, all - 60.0, 25.0);
    EXPECT_GT(window->rooms().survey->comparison()->leftOut.surveyedArea, 40.0);
    // From a file, kept in the case, and undone.
    const std::string path = m_folder / "area.geojson";
    std::ofstream(path)
        << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":{"type":"Polygon",)"
        << R"("coordinates":[[[-500,-500],[500,-500],[500,500],[-500,500],[-500,-500]]]}}]})";
    window->rooms().survey->addScope(ScopePart::Area, QString::fromStdString(path));
    EXPECT_EQ(session->document().theCase().inputs.back().scope.area.polygons.size(), 1u);
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    EXPECT_EQ(io::loadCase(m_folder / "case.rubble").inputs.back().scope, session->document().theCase().inputs.back().scope);
    window->actions()[ActionId::Undo].trigger();
    EXPECT_TRUE(session->document().theCase().inputs.back().scope.area.empty());
    window->actions()[ActionId::Undo].trigger();
    EXPECT_EQ(leftOut(), 0u);
    window->actions()[ActionId::Redo].trigger();
    EXPECT_EQ(leftOut(), 1u);
}

TEST_F(SiteAndSurvey, ASurveyThatIsNoneIsToldInPlace) {
    simulated();
    const std::string path = m_folder / "notes.txt";
    std::ofstream(path) << "no heights here";
    window->rooms().survey->add(QString::fromStdString(path));
    compare();
    EXPECT_EQ(window->rooms().survey->comparison(), nullptr);
    EXPECT_TRUE(compareButton()->isEnabled()) << "it can be tried again";
    const std::size_t before = session->document().theCase().inputs.size();
    window->rooms().survey->add(QString::fromStdString(m_folder / "missing.tif"));
    EXPECT_EQ(session->document().theCase().inputs.size(), before);
}

TEST_F(SiteAndSurvey, TheSiteIsAskedForAndReadAnew) {
    openArch();
    const QString plateau = heights("terrain.asc", [](double, double) { return 5.0; });
    std::vector<CaseInput> inputs = session->document().theCase().inputs;
    inputs.push_back({"terrain-1", InputRole::Terrain, plateau.toStdString(), ""});
    session->document().setInputs(inputs, [] { return QStringLiteral("terrain"); });
    const auto height = [&] {
        const auto& terrain = session->computation().inputs().terrain;
        return terrain && prepared() ? terrain->height(0.0, 0.0) : NAN;
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(height() - 5.0) < 1e-6; }, patience));
    whenAsked([](QDialog& dialog) {
        auto* site = qobject_cast<widgets::SiteDialog*>(&dialog);
        ASSERT_NE(site, nullptr);
        Site content = site->site();
        content.heightShift = -7.0;
        site->setContent(content, QStringLiteral("EPSG:25832"));
        QTest::keyClick(site, Qt::Key_Return);
    });
    window->actions()[ActionId::Site].trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(height() + 2.0) < 1e-6; }, patience));
    EXPECT_EQ(session->document().theCase().frame.crs, "EPSG:25832");
    window->actions()[ActionId::Undo].trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(height() - 5.0) < 1e-6; }, patience));
    EXPECT_EQ(session->document().theCase().frame.crs, "");
}

TEST_F(SiteAndSurvey, AMeshOfTheSurroundingsIsDrawnAndLeftOutAgain) {
    widgets::ViewWidget& views = window->area().views();
    views.setAnimated(false);
    openArch();
    window->actions()[ActionId::FragmentsOnly].trigger();
    // With every detail: a busy machine draws the views simplified until they have rested for a while.
    QImage without;
    const auto settled = [&] {
        const QImage before = std::exchange(without, views.picture());
        return before == without;
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return views.isVisible() && settled(); }, patience));
    const std::string path = m_folder / "house.obj";
    std::ofstream(path) << "v -10 12 0\nv 10 12 0\nv 10 12 15\nv -10 12 15\nf 1 2 3 4\n";
    std::vector<CaseInput> inputs = session->document().theCase().inputs;
    inputs.push_back({"surroundings-1", InputRole::Surroundings, path, ""});
    session->document().setInputs(inputs, [] { return QStringLiteral("house"); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().terrain().surroundings != nullptr && prepared(); }, patience));
    EXPECT_TRUE(window->actions()[ActionId::NoSurroundings].isEnabled());
    EXPECT_EQ(views.view().layout, render::Layout::FragmentsOnly) << "the view stays when the files around the result change";
    EXPECT_TRUE(QTest::qWaitFor([&] { return views.picture() != without; }, patience));
    window->actions()[ActionId::NoSurroundings].trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->computation().terrain().surroundings == nullptr && prepared(); }, patience));
    EXPECT_TRUE(QTest::qWaitFor([&] { return views.picture() == without; }, patience));
}

TEST_F(SiteAndSurvey, OneListHoldsAllEvidenceWithItsPlaceAndScore) {
    simulated();
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    // A pile of 30 m by 10 m that the survey shows 4 m too far north and 1 m too high.
    const QString survey =
        heights("after.asc", [](double x, double y) { return std::abs(x) < 15.0 && std::abs(y - 4.0) < 5.0 ? 2.0 : 1.0; });
    window->rooms().survey->add(survey);
    const widgets::EvidenceTable& list = window->rooms().deck->evidence().list();
    ASSERT_EQ(list.rowCount(), 1);
    EXPECT_EQ(list.item(0, 0)->text(), QStringLiteral("after.asc"));
    EXPECT_EQ(list.item(0, 2)->text(), QStringLiteral("not known"));
    const std::string pairs = m_folder / "pairs.csv";
    const io::SitePlace place(session->computation().inputs().frame, Site());
    {
        std::ofstream out(pairs);
        out << "survey_x,survey_y,survey_z,x_m,y_m,z_m\n";
        for (const Vec3& at : {Vec3(-15.0, 0.0, 1.0), Vec3(15.0, 9.0, 1.01), Vec3(3.0, -1.0, 1.99), Vec3(-8.0, 20.0, 1.0)}) {
            const Vec3 surveyed = place.toWorld(at);
            const Vec3 placed = place.toWorld(at + Vec3(0.0, -4.0, -1.0));
            out << surveyed.x() << ',' << surveyed.y() << ',' << surveyed.z() << ',' << placed.x() << ',' << placed.y() << ','
                << placed.z() << '\n';
        }
    }
    window->rooms().survey->placeByPairs(QString::fromStdString(pairs));
    ASSERT_TRUE(session->document().theCase().inputs.back().registration);
    EXPECT_NE(list.item(0, 2)->text(), QStringLiteral("not known"));
    compare();
    ASSERT_NE(window->rooms().survey->comparison(), nullptr);
    const SurveyComparison& made = *window->rooms().survey->comparison();
    EXPECT_NEAR(made.survey.area, 300.0, 45.0);
    EXPECT_NEAR(made.survey.centroid.y(), 0.0, 0.3);
    EXPECT_NEAR(list.item(0, 3)->text().toDouble(), made.iou, 0.001);
    // Taken out again, it lies where it lay, and its score is of something else.
    window->actions()[ActionId::Undo].trigger();
    EXPECT_FALSE(session->document().theCase().inputs.back().registration);
    EXPECT_EQ(list.item(0, 3)->text(), QStringLiteral("–"));
}

}  // namespace
}  // namespace rubble
