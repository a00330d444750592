#include <gmock/gmock.h>

#include <QAction>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QTableWidget>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "app/gui/case/file_commands.h"
#include "app/gui/evidence/survey_display.h"
#include "app/gui/evidence/survey_reach.h"
#include "app/gui/evidence/survey_sections.h"
#include "app/gui/evidence/surveys/survey_pairs.h"
#include "io/case/case_file.h"
#include "io/site/point_pairs.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"
#include "widgets/basics/number_field.h"
#include "widgets/basics/panel.h"
#include "widgets/evidence/evidence_page.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/evidence/evidence_table.h"
#include "widgets/evidence/photo_view.h"
#include "widgets/evidence/survey_box.h"
#include "widgets/evidence/survey_view.h"
#include "widgets/evidence/surveys/place_pairs_dialog.h"
#include "widgets/evidence/surveys/removal_box.h"
#include "widgets/evidence/surveys/section_dialog.h"
#include "widgets/views/view_widget.h"

namespace rubble {

namespace {

class SurveyPlaces : public FreshWorkbench {
protected:
    /// Heights every metre around the arch.
    QString heights(const char* name, const std::function<double(double, double)>& height) {
        const io::AsciiGrid around{120, 60, -60.0, -30.0};
        return QString::fromStdString(around.write(m_folder / name, height));
    }
    static double pile(double x, double y) { return std::abs(x) < 15.0 && std::abs(y) < 5.0 ? 1.0 : 0.0; }
    SurveyDisplay& surveys() { return *window->rooms().survey; }
    widgets::SurveyBox& box() { return window->rooms().deck->evidence().survey(); }
    void compared() {
        openArch();
        makeCheap();
        simulateToEnd();
        ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
        surveys().add(heights("after.asc", pile));
        compare();
    }
    void compare() {
        surveys().compare();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !surveys().busy(); }, patience));
        ASSERT_NE(surveys().comparison(), nullptr);
    }
    void drawOnMap(const std::vector<Eigen::Vector2d>& corners) {
        auto& view = *window->findChild<widgets::SurveyView*>();
        ASSERT_TRUE(QTest::qWaitFor([&] { return view.isVisible(); }, patience));
        view.grab();
        for (const Eigen::Vector2d& corner : corners) {
            QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, view.toWidget(corner).toPoint());
        }
        if (view.drawing()) {
            QTest::keyClick(&view, Qt::Key_Return);
        }
    }
    io::TemporaryFolder m_folder;
};

TEST_F(SurveyPlaces, PairsAreClickedInSurveyAndModelAndTheirResidualsStandAtOnce) {
    openArch();
    surveys().add(heights("after.asc", pile));
    const auto pushed = [&](const char* text) {
        for (auto* each : box().findChildren<QPushButton*>()) {
            if (each->text() == QString::fromUtf8(text)) {
                return each;
            }
        }
        return static_cast<QPushButton*>(nullptr);
    };
    bool asked = false;
    whenAsked([&](QDialog& opened) {
        asked = true;
        auto& dialog = dynamic_cast<widgets::PlacePairsDialog&>(opened);
        auto* place = dialog.findChild<QPushButton*>();
        for (auto* each : dialog.findChildren<QPushButton*>()) {
            place = each->text() == QStringLiteral("Place survey") ? each : place;
        }
        // The first click by mouse in both views.
        widgets::PhotoView& plan = dialog.survey();
        QTest::mouseClick(&plan, Qt::LeftButton, {}, plan.toWidget({60.0, 30.0}).toPoint());
        ASSERT_TRUE(plan.content().pending);
        QTest::keyClick(&plan, Qt::Key_Escape);
        EXPECT_FALSE(plan.content().pending) << "Esc takes back what was begun";
        QTest::mouseClick(&plan, Qt::LeftButton, {}, plan.toWidget({60.0, 30.0}).toPoint());
        dialog.model().picture();
        std::optional<QPoint> there;
        for (int y = 20; y < dialog.model().height() - 20 && !there; y += 3) {
            for (int x = 20; x < dialog.model().width() - 20 && !there; x += 3) {
                if (dialog.model().hitAt(QPointF(x, y))) {
                    there = QPoint(x, y);
                }
            }
        }
        ASSERT_TRUE(there);
        QTest::mouseClick(&dialog.model(), Qt::LeftButton, {}, *there);
        EXPECT_EQ(dialog.pairs().size(), 1u);
        QTest::keyClick(&dialog, Qt::Key_Z, Qt::ControlModifier);
        EXPECT_TRUE(dialog.pairs().empty());
        EXPECT_TRUE(plan.content().pending) << "only the last click is taken back";
        dialog.clear();
        // Places that the survey has 2 m too far east and 1 m too high: pixel centres, so heights are those of the file.
        for (const auto& [column, row] : {std::pair(30, 10), std::pair(90, 12), std::pair(50, 50), std::pair(60, 30)}) {
            EXPECT_FALSE(dialog.fit() && dialog.pairs().size() < 3);
            dialog.placeSurveyed({column + 0.5, row + 0.5});
            const double x = column - 59.5;
            const double y = 29.5 - row;
            dialog.placeModel(Vec3(x - 2.0, y, pile(x, y) - 1.0));
        }
        ASSERT_TRUE(dialog.fit());
        EXPECT_NEAR(dialog.fit()->registration.pairsLeft, 0.0, 1e-9);
        EXPECT_TRUE(place->isEnabled());
        const auto* table = dialog.findChild<QTableWidget*>();
        ASSERT_EQ(table->rowCount(), 4);
        EXPECT_EQ(table->item(0, 4)->text(), QStringLiteral("0.000"));
        // What is stated of the places of the case is in the error, and kept with the pairs.
        const double without = dialog.fit()->registration.error.value();
        EXPECT_FALSE(dialog.fit()->registration.control);
        const auto state = [&](const QString& text) {
            dialog.deviation().setFocus();
            dialog.deviation().selectAll();
            QTest::keyClick(&dialog.deviation(), Qt::Key_Delete);
            QTest::keyClicks(&dialog.deviation(), text);
            QTest::keyClick(&dialog.deviation(), Qt::Key_Return);
        };
        state(QStringLiteral("0.04"));
        EXPECT_TRUE(dialog.isVisible()) << "Enter in the field leaves the dialog open";
        EXPECT_NEAR(dialog.fit()->registration.control.value_or(0.0), 0.04, 1e-12);
        EXPECT_NEAR(dialog.fit()->registration.error.value(), std::hypot(without, 0.04), 1e-9);
        // They can be kept, to be read again by the command line.
        dialog.setKeeper([&](const std::vector<PlacePair>& pairs) {
            io::writePlacePairs(m_folder / "pairs.csv", pairs, {}, {});
            return QStringLiteral("kept");
        });
        auto* keep = dialog.findChild<QPushButton*>();
        for (auto* each : dialog.findChildren<QPushButton*>()) {
            keep = each->text() == QString::fromUtf8("Keep as table…") ? each : keep;
        }
        EXPECT_TRUE(keep->isEnabled());
        keep->click();
        const std::vector<PlacePair> kept = io::readPlacePairs(m_folder / "pairs.csv").pairs;
        ASSERT_EQ(kept.size(), 4u);
        EXPECT_EQ(kept.back().deviation, 0.04);
        state({});
        EXPECT_FALSE(dialog.fit()->registration.control) << "nothing typed is not 0";
        // One that fits badly is told at once, and can be taken back.
        dialog.placeSurveyed({20.5, 40.5});
        dialog.placeModel(Vec3(20.0, 20.0, 0.0));
        EXPECT_GT(dialog.fit()->registration.pairsLeft, 1.0);
        EXPECT_FALSE(dialog.fit()->findings.empty());
        dialog.undo();
        dialog.undo();
        EXPECT_NEAR(dialog.fit()->registration.pairsLeft, 0.0, 1e-9);
        QTest::keyClick(&plan, Qt::Key_Escape);
        EXPECT_TRUE(dialog.isVisible()) << "pairs that were picked are not lost by Esc";
        QTest::mouseClick(place, Qt::LeftButton);
    });
    QTest::mouseClick(pushed("Pick pairs…"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session->document().theCase().inputs.back().registration.has_value(); }, patience));
    EXPECT_TRUE(asked);
    const Registration& placed = *session->document().theCase().inputs.back().registration;
    EXPECT_EQ(placed.pairs, 4);
    EXPECT_LT((placed(Vec3(0.0, 0.0, 1.0)) - Vec3(-2.0, 0.0, 0.0)).norm(), 1e-6);
    window->actions()[ActionId::Undo].trigger();
    EXPECT_FALSE(session->document().theCase().inputs.back().registration);
}

TEST_F(SurveyPlaces, WhatWasRemovedIsDrawnWithItsTimeAndLeavesLaterSurveysOut) {
    compared();
    const double all = surveys().comparison()->survey.area;
    widgets::RemovalBox& removals = box().removals();
    auto* since = removals.findChild<QLineEdit*>();
    auto* add = removals.findChildren<QToolButton*>().front();
    EXPECT_FALSE(add->isEnabled()) << "a removal has a time";
    QTest::keyClicks(since, QStringLiteral("2021-06-26 12:00"));
    EXPECT_TRUE(add->isEnabled());
    add->menu()->actions().front()->trigger();
    drawOnMap({{0.0, -6.0}, {16.0, -6.0}, {16.0, 6.0}, {0.0, 6.0}});
    ASSERT_EQ(session->document().theCase().removals.size(), 1u);
    EXPECT_EQ(session->document().theCase().removals.front().time, "2021-06-26 12:00:00");
    EXPECT_EQ(removals.findChild<QListWidget*>()->count(), 1);
    // When the survey was taken is not known: it counts, and that is a finding.
    compare();
    EXPECT_NEAR(surveys().comparison()->survey.area, all, 1.0);
    emit box().place().edited({"2021-06-27 08:00:00", false, std::nullopt, std::nullopt});
    EXPECT_TRUE(surveys().stale());
    compare();
    EXPECT_NEAR(surveys().comparison()->survey.area, 0.5 * all, 15.0);
    // A survey of before shows it still.
    removals.findChild<QListWidget*>()->setCurrentRow(0);
    emit removals.timeChosen(0, "2021-06-28 12:00:00");
    compare();
    EXPECT_NEAR(surveys().comparison()->survey.area, all, 1.0);
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    EXPECT_EQ(io::loadCase(m_folder / "case.rubble").removals, session->document().theCase().removals);
    window->actions()[ActionId::Undo].trigger();
    EXPECT_EQ(session->document().theCase().removals.front().time, "2021-06-26 12:00:00");
    emit removals.removeRequested(0);
    EXPECT_TRUE(session->document().theCase().removals.empty());
}

TEST_F(SurveyPlaces, ASectionIsDrawnCutMeasuredAndSaved) {
    compared();
    std::ofstream(m_folder / "after.asc.provenance.json")
        << R"({"build":"Rubble","fingerprint":"00112233445566778899aabbccddeeff"})";
    emit box().sectionRequested();
    drawOnMap({{-12.0, 0.0}, {12.0, 0.0}});
    SurveySections& sections = surveys().sections();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !sections.busy() && sections.section() != nullptr; }, 60'000));
    const SiteSection& cut = sections.section()->section;
    EXPECT_EQ(sections.section()->findings.list().front().what.id, "evidence.of_run") << "it is no evidence";
    EXPECT_NEAR(cut.line.length(), 24.0, 0.5);
    // One or two rows of heights within the width, a metre apart.
    EXPECT_GE(cut.points.size(), 22u);
    EXPECT_LE(cut.points.size(), 50u);
    EXPECT_NEAR(cut.measuredArea, 24.0, 2.5) << "a metre high over 24 m";
    ASSERT_NE(sections.dialog(), nullptr);
    EXPECT_TRUE(sections.dialog()->isVisible());
    bool told = false;
    for (const auto* notice : sections.dialog()->findChildren<widgets::Notice*>()) {
        told = told || notice->text().contains(QStringLiteral("one set of assumptions"));
    }
    EXPECT_TRUE(told) << "what must be known of the run stands beside its section";
    sections.saveTo(QString::fromStdString(m_folder / "section.png"));
    EXPECT_TRUE(std::filesystem::exists(m_folder / "section.png"));
    EXPECT_THAT(io::wholeFile(m_folder / "section.png.provenance.json"), testing::HasSubstr("made from a simulated run"));
    // Other settings make map and section stale: it is not saved.
    for (auto* each : box().findChildren<QComboBox*>()) {
        if (each->accessibleName() == QStringLiteral("Registration of the survey")) {
            each->setCurrentIndex(1);
        }
    }
    sections.saveTo(QString::fromStdString(m_folder / "stale.png"));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "stale.png"));
    sections.dialog()->reject();
    EXPECT_FALSE(sections.line()) << "the line goes with its profile";
}

TEST_F(SurveyPlaces, ASectionLeavesOutWhatIsMaskedAndHoldsMeasuredPointsToo) {
    compared();
    std::ofstream(m_folder / "station.csv") << "name,easting,northing,height\nA,-5,0.1,1.0\nB,5,0.1,1.0\nC,8,0.1,1.2\n";
    surveys().add(QString::fromStdString(m_folder / "station.csv"));
    const auto& list = window->rooms().deck->evidence().list();
    ASSERT_EQ(list.rowCount(), 2);
    EXPECT_TRUE(list.item(1, 1)->text().contains(QStringLiteral("sections"))) << qPrintable(list.item(1, 1)->text());
    EXPECT_EQ(session->document().theCase().inputs.back().kind, SurveyKind::Points);
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    EXPECT_EQ(io::loadCase(m_folder / "case.rubble").inputs.back().kind, SurveyKind::Points);
    surveys().choose(session->document().theCase().inputs[session->document().theCase().inputs.size() - 2].id);
    const auto cut = [&] {
        emit box().sectionRequested();
        drawOnMap({{-12.0, 0.0}, {12.0, 0.0}});
        SurveySections& sections = surveys().sections();
        EXPECT_TRUE(QTest::qWaitFor([&] { return !sections.busy() && sections.section() != nullptr; }, patience));
        return sections.section()->section.points;
    };
    const std::size_t all = cut().size();
    const std::vector<SectionSource>& sources = surveys().sections().section()->section.sources;
    ASSERT_EQ(sources.size(), 2u);
    EXPECT_EQ(sources[0].name, "after.asc");
    EXPECT_EQ(sources[1].name, "station.csv");
    EXPECT_EQ(sources[1].agreement.points, 3);
    const auto& labels = surveys().sections().dialog()->findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->text().contains(QStringLiteral("station.csv: 3 heights on it")) &&
               label->text().contains(QStringLiteral("All: "));
    })) << "how each agrees is told";
    surveys().sections().dialog()->reject();
    // The heights at the right end are left out; the points of the station have a scope of their own.
    const Outline right{{{{{0.0, -9.0}, {20.0, -9.0}, {20.0, 9.0}, {0.0, 9.0}}}}};
    surveys().edit([&](CaseInput& input) { input.scope.leftOut = right; }, [] { return QStringLiteral("left out"); });
    compare();
    const std::vector<SectionPoint> masked = cut();
    surveys().sections().dialog()->reject();
    EXPECT_LT(masked.size(), all);
    const auto east = std::count_if(masked.begin(), masked.end(), [](const SectionPoint& point) { return point.place.x() > 0.5; });
    EXPECT_EQ(east, 2) << "those of the station";
}

TEST_F(SurveyPlaces, EscAfterADrawingWasEndedLeavesThePageOpen) {
    compared();
    auto& view = *window->findChild<widgets::SurveyView*>();
    auto& page = *window->findChild<widgets::EvidencePage*>();
    const std::vector<Eigen::Vector2d> corners{{-12.0, -4.0}, {12.0, -4.0}, {12.0, 4.0}};
    const auto at = [&](const Eigen::Vector2d& corner) { return view.toWidget(corner).toPoint(); };
    const auto begin = [&] {
        emit box().scopeDrawRequested(ScopePart::Area);
        ASSERT_TRUE(QTest::qWaitFor([&] { return view.isVisible(); }, patience));
        view.grab();
        for (const Eigen::Vector2d& corner : corners) {
            QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, at(corner));
        }
        ASSERT_TRUE(view.drawing());
    };
    const auto escape = [] { QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape); };
    const auto areas = [&] { return session->document().theCase().inputs.back().scope.area.polygons.size(); };
    // By a double click, whose Esc comes a moment too late, and by Enter.
    begin();
    QTest::mouseDClick(&view, Qt::LeftButton, Qt::NoModifier, at(corners.back()));
    ASSERT_FALSE(view.drawing());
    ASSERT_EQ(areas(), 1u);
    escape();
    EXPECT_TRUE(page.isVisible());
    EXPECT_EQ(areas(), 1u);
    begin();
    QTest::keyClick(&view, Qt::Key_Return);
    ASSERT_EQ(areas(), 2u);
    escape();
    EXPECT_TRUE(page.isVisible());
    // One that goes on is given up first, whatever has the focus.
    begin();
    window->setFocus();
    escape();
    EXPECT_FALSE(view.drawing());
    EXPECT_TRUE(page.isVisible());
    EXPECT_EQ(areas(), 2u);
    escape();
    EXPECT_FALSE(page.isVisible()) << "the next one closes the page";
    // What was done between the drawing and Esc is not the drawing.
    window->rooms().deck->choose(PanelDeck::Evidence);
    begin();
    QTest::keyClick(&view, Qt::Key_Return);
    ASSERT_EQ(areas(), 3u);
    QTest::keyClick(window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(areas(), 2u);
    escape();
    EXPECT_FALSE(page.isVisible());
}

TEST_F(SurveyPlaces, OneThatLiesElsewhereIsSaidAsSoonAsItIsAdded) {
    openArch();
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    surveys().add(heights("near.asc", pile));
    const io::AsciiGrid far{120, 60, 8'000.0, -30.0};
    surveys().add(QString::fromStdString(far.write(m_folder / "far.asc", pile)));
    SurveyReach& reach = session->part<SurveyReach>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !reach.busy(); }, patience));
    const widgets::EvidenceTable& list = window->rooms().deck->evidence().list();
    ASSERT_EQ(list.rowCount(), 2);
    EXPECT_EQ(list.item(0, 2)->text(), QStringLiteral("not known"));
    EXPECT_EQ(list.item(1, 2)->text(), QStringLiteral("elsewhere"));
    EXPECT_TRUE(list.item(1, 0)->toolTip().contains(QStringLiteral("the structure stands at")));
    const auto said = [&] {
        QString all;
        for (const auto* notice : box().findChildren<widgets::Notice*>()) {
            all += notice->isVisibleTo(&box()) ? notice->text() : QString();
        }
        return all;
    };
    EXPECT_TRUE(said().contains(QStringLiteral("the structure stands at"))) << qPrintable(said());
    surveys().choose(session->document().theCase().inputs[session->document().theCase().inputs.size() - 2].id);
    EXPECT_FALSE(said().contains(QStringLiteral("the structure stands at"))) << "it is of the other one";
    // Placed where it belongs, it is looked at once more.
    surveys().choose(session->document().theCase().inputs.back().id);
    std::vector<CaseInput> inputs = session->document().theCase().inputs;
    inputs.back().registration.emplace().shift = Vec3(-8'060.0, 0.0, 0.0);
    session->document().setSurveys(std::move(inputs), [] { return QStringLiteral("placed"); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return !reach.busy(); }, patience));
    EXPECT_NE(list.item(1, 2)->text(), QStringLiteral("elsewhere"));
}

}  // namespace

}  // namespace rubble
