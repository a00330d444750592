#include <QComboBox>
#include <QFileInfo>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <fstream>

#include "app/gui/case/file_commands.h"
#include "app/gui/evidence/cause_choice.h"
#include "app/gui/evidence/pairs_table.h"
#include "app/gui/evidence/survey_display.h"
#include "app/gui/evidence/survey_reach.h"
#include "app/gui/evidence/survey_sections.h"
#include "app/gui/stage/panel_deck.h"
#include "io/case/case_file.h"
#include "io/case/case_surveys.h"
#include "tests/app/gui/workbench.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/temporary_folder.h"
#include "widgets/basics/number_field.h"
#include "widgets/evidence/evidence_page.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/evidence/evidence_table.h"
#include "widgets/evidence/survey_box.h"
#include "widgets/evidence/survey_view.h"
#include "widgets/evidence/surveys/section_dialog.h"

namespace rubble {

namespace {

/// Points of a total station around a rectangle of 30 m by 10 m.
class HeldPoints : public FreshWorkbench {
protected:
    void added() {
        openArch();
        makeCheap();
        simulateToEnd();
        ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
        m_station = m_folder / "station.csv";
        std::ofstream(m_station) << "name,easting,northing,height\nA,-15,-5,0.4\nB,15,-5,0.4\nC,15,5,0.6\nD,-15,5,0.4\n";
        surveys().add(QString::fromStdString(m_station));
    }
    SurveyDisplay& surveys() { return *window->rooms().survey; }
    const widgets::EvidenceTable& list() { return window->rooms().deck->evidence().list(); }
    const CaseInput& points() { return session->document().theCase().inputs.back(); }
    /// Chooses in the row by keyboard, as a person does.
    void hold(PointsHeld as) {
        window->rooms().deck->choose(PanelDeck::Evidence);
        auto* choice = qobject_cast<QComboBox*>(list().cellWidget(0, 1));
        ASSERT_NE(choice, nullptr);
        choice->setFocus();
        const int steps = static_cast<int>(as) - choice->currentIndex();
        for (int step = 0; step < std::abs(steps); ++step) {
            QTest::keyClick(choice, steps > 0 ? Qt::Key_Down : Qt::Key_Up);
        }
        ASSERT_EQ(points().held, as);
    }
    io::TemporaryFolder m_folder;
    std::string m_station;
};

TEST_F(HeldPoints, AreChosenInTheirRowKeptUndoneAndCompared) {
    added();
    EXPECT_EQ(points().held, PointsHeld::Section) << "unless something else is chosen";
    EXPECT_TRUE(list().item(0, 1)->text().contains(QStringLiteral("sections")));
    // The list and the report give them no overlap, and neither does a comparison.
    surveys().compare();
    EXPECT_FALSE(surveys().busy());
    EXPECT_EQ(surveys().comparison(), nullptr);
    hold(PointsHeld::Outline);
    EXPECT_TRUE(list().item(0, 1)->text().contains(QStringLiteral("edge of the debris")));
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    EXPECT_EQ(io::loadCase(m_folder / "case.rubble").inputs.back().held, PointsHeld::Outline);
    // The edge is compared as every outline is, and its score stands in the row.
    surveys().compare();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !surveys().busy(); }, patience));
    ASSERT_NE(surveys().comparison(), nullptr);
    EXPECT_TRUE(surveys().comparison()->isFootprint);
    EXPECT_NEAR(surveys().comparison()->survey.area, 300.0, 1.0);
    EXPECT_NEAR(list().item(0, 3)->text().toDouble(), surveys().comparison()->iou, 0.001);
    QTest::keyClick(window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(points().held, PointsHeld::Section);
    EXPECT_EQ(list().item(0, 3)->text(), QStringLiteral("–")) << "the score was of something else";
    window->actions()[ActionId::Redo].trigger();
    EXPECT_EQ(points().held, PointsHeld::Outline);
}

TEST_F(HeldPoints, AsControlShowNoDebrisAndNameThePlacesOfPairs) {
    added();
    hold(PointsHeld::Control);
    const auto& box = window->rooms().deck->evidence().survey();
    bool refused = false;
    for (const auto* label : box.findChildren<QLabel*>()) {
        refused = refused || label->text().contains(QStringLiteral("held as control"));
    }
    EXPECT_TRUE(refused) << "why nothing is compared is said in place";
    surveys().compare();
    EXPECT_EQ(surveys().comparison(), nullptr);
    // Pairs that name their points find them in the case, and nobody is asked for a file.
    std::ofstream(m_folder / "pairs.csv") << "picture_x_px,picture_y_px,name\n10,20,C\n30,40,A\n";
    std::vector<PointPair> pairs;
    EXPECT_EQ(addPairsOfTable(window, QString::fromStdString(m_folder / "pairs.csv"), *session, pairs), 2u);
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_LT((pairs[0].model - Vec3(15.0, 5.0, 0.6)).norm(), 1e-9);
}

TEST_F(HeldPoints, StandInSectionsOnlyWhileTheyAreHeldForThem) {
    added();
    const io::AsciiGrid around{120, 60, -60.0, -30.0};
    surveys().add(QString::fromStdString(around.write(m_folder / "after.asc", [](double, double) { return 0.2; })));
    const auto named = [&] {
        surveys().choose(session->document().theCase().inputs.back().id);
        surveys().compare();
        EXPECT_TRUE(QTest::qWaitFor([&] { return !surveys().busy(); }, patience));
        emit window->rooms().deck->evidence().survey().sectionRequested();
        auto& view = *window->findChild<widgets::SurveyView*>();
        EXPECT_TRUE(QTest::qWaitFor([&] { return view.isVisible(); }, patience));
        view.grab();
        for (const Eigen::Vector2d& corner : {Eigen::Vector2d(-20.0, -5.0), Eigen::Vector2d(20.0, -5.0)}) {
            QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, view.toWidget(corner).toPoint());
        }
        SurveySections& sections = surveys().sections();
        EXPECT_TRUE(QTest::qWaitFor([&] { return !sections.busy() && sections.section() != nullptr; }, patience));
        QStringList names;
        for (const SectionSource& source : sections.section()->section.sources) {
            names << QString::fromStdString(source.name);
        }
        sections.dialog()->reject();
        return names;
    };
    EXPECT_EQ(named(), QStringList({QStringLiteral("after.asc"), QStringLiteral("station.csv")}));
    surveys().choose(session->document().theCase().inputs[session->document().theCase().inputs.size() - 2].id);
    surveys().edit([](CaseInput& input) { input.held = PointsHeld::Outline; }, [] { return QStringLiteral("held"); });
    EXPECT_EQ(named(), QStringList(QStringLiteral("after.asc")));
}

/// A case that has nothing but a measured line: no map can be drawn on, and none is needed.
TEST_F(HeldPoints, AreCutAlongThemselvesWithoutAMap) {
    added();
    std::ofstream(m_folder / "line.csv")
        << "name,easting,northing,height\nA,-9,0.5,0.4\nB,0,0.5,0.4\nC,9,0.5,0.6\nD,0,0.9,0.4\nE,2,1.4,1\n";
    surveys().add(QString::fromStdString(m_folder / "line.csv"));
    window->rooms().deck->choose(PanelDeck::Evidence);
    auto& box = window->rooms().deck->evidence().survey();
    // As a surface they are not compared, in words that say what to do.
    surveys().compare();
    EXPECT_FALSE(surveys().busy());
    EXPECT_EQ(surveys().comparison(), nullptr);
    EXPECT_TRUE(box.content().noComparison.contains(QStringLiteral("cut a section along them")));
    QPushButton* cut = nullptr;
    for (auto* button : box.findChildren<QPushButton*>()) {
        cut = button->text() == QStringLiteral("Section…") ? button : cut;
    }
    ASSERT_NE(cut, nullptr);
    ASSERT_FALSE(cut->isHidden());
    QTest::mouseClick(cut, Qt::LeftButton);
    SurveySections& sections = surveys().sections();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !sections.busy() && sections.section() != nullptr; }, patience));
    const auto section = sections.section();
    EXPECT_EQ(section->section.points.size(), 4u);
    EXPECT_EQ(section->findings.count("section.beside"), 1);
    ASSERT_TRUE(sections.line());
    // Another end, typed: the line is the user's from then on.
    auto* dialog = sections.dialog();
    const auto fields = dialog->findChildren<widgets::NumberField*>();
    const auto east = std::find_if(fields.begin(), fields.end(), [](const auto* field) {
        return field->accessibleName() == QStringLiteral("Easting of the second end");
    });
    ASSERT_NE(east, fields.end());
    EXPECT_NEAR((*east)->number().value_or(0.0), 9.5, 0.3);
    (*east)->selectAll();
    QTest::keyClicks(*east, QStringLiteral("30"));
    QTest::keyClick(*east, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !sections.busy() && sections.section() != nullptr && sections.section() != section; },
                                patience));
    EXPECT_NEAR(sections.line()->to.x(), 30.0, 1e-6);
    EXPECT_EQ(sections.section()->findings.count("section.beside"), 0) << "the line is not sought any more";
    sections.saveTo(QString::fromStdString(m_folder / "section.png"));
    EXPECT_TRUE(std::filesystem::exists(m_folder / "section.png"));
    // Held to say something else they are no section, and what was cut is stale.
    surveys().edit([](CaseInput& input) { input.held = PointsHeld::Outline; }, [] { return QStringLiteral("held"); });
    EXPECT_TRUE(dialog->content().stale);
    EXPECT_TRUE(cut->isHidden());
}

TEST_F(HeldPoints, OfAnOldCaseAreCalledByTheirNameUntilSomebodyLooks) {
    added();
    std::vector<CaseInput> inputs = session->document().theCase().inputs;
    inputs.back().kind.reset();
    session->document().setSurveys(std::move(inputs), [] { return QStringLiteral("as of old"); });
    SurveyReach& reach = session->part<SurveyReach>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !reach.busy(); }, patience));
    EXPECT_EQ(list().cellWidget(0, 1), nullptr) << "by its ending it is a cloud";
    EXPECT_TRUE(list().item(0, 0)->toolTip().contains(QStringLiteral("by the ending of its name")));
    EXPECT_EQ(reach.odd(points()).count("evidence.other_kind"), 1);
    EXPECT_EQ(window->rooms().deck->evidence().survey().content().findings.count("evidence.other_kind"), 1);
    // The remedy: the same file once more.
    surveys().add(QString::fromStdString(m_station));
    EXPECT_EQ(points().kind, SurveyKind::Points);
    EXPECT_NE(list().cellWidget(0, 1), nullptr);
}

}  // namespace

}  // namespace rubble
