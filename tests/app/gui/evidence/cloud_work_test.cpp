#include <QCheckBox>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <filesystem>
#include <fstream>

#include "app/gui/case/file_commands.h"
#include "app/gui/evidence/cloud_points.h"
#include "app/gui/evidence/evidence_work.h"
#include "app/gui/evidence/survey_display.h"
#include "app/gui/evidence/survey_reach.h"
#include "app/gui/evidence/surveys/cloud_placing.h"
#include "app/gui/evidence/surveys/cloud_tools.h"
#include "app/gui/stage/panel_deck.h"
#include "core/evidence/scanned_site.h"
#include "io/case/case_file.h"
#include "io/site/clouds/run_scan.h"
#include "tests/app/gui/workbench.h"
#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/level_table.h"
#include "tests/support/temporary_folder.h"
#include "widgets/basics/number_field.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/evidence_panel.h"
#include "widgets/evidence/evidence_table.h"
#include "widgets/evidence/photo_view.h"
#include "widgets/evidence/survey_box.h"
#include "widgets/evidence/survey_place.h"
#include "widgets/evidence/surveys/cloud_pair_dialog.h"
#include "widgets/evidence/surveys/distance_fields.h"
#include "widgets/evidence/surveys/fit_dialog.h"
#include "widgets/evidence/surveys/point_box.h"
#include "widgets/evidence/surveys/reading_box.h"
#include "widgets/evidence/surveys/scan_dialog.h"
#include "widgets/evidence/surveys/scanner_dialog.h"
#include "widgets/evidence/surveys/scanner_field.h"
#include "widgets/views/view_widget.h"

namespace rubble {

namespace {

/// The arch, simulated, and a scan of what is left of it that lies 0.2 m out of place.
class CloudWork : public FreshWorkbench {
protected:
    static inline const Vec3 misplaced{0.12, -0.1, 0.12};

    void scanned(const QString& path = arch()) {
        openArch(path);
        makeCheap();
        simulateToEnd();
        ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
        const Computation& computation = session->computation();
        const EvidenceRun run(computation.inputs(), computation.currentRun());
        io::RunScan scan = io::scanRun(scannedSite(run.mapped(), std::nullopt, 1.0, Execution()),
                                       {.scanners = {}, .step = 8e-3, .range = 60.0}, Execution());
        ASSERT_GT(scan.scan.places.size(), 5'000U);
        for (std::vector<Vec3>* places : {&scan.scan.places, &scan.settings.scanners}) {
            for (Vec3& place : *places) {
                place += misplaced;
            }
        }
        const std::string file = m_folder / "scan.las";
        io::writeScan(file, scan, io::SitePlace(computation.inputs().frame, {}));
        window->rooms().survey->add(QString::fromStdString(file));
    }
    widgets::SurveyBox& box() { return window->rooms().deck->evidence().survey(); }
    CloudPoints& points() { return *window->rooms().cloudPoints; }
    const CaseInput& survey() { return session->document().theCase().inputs.back(); }
    static QPushButton* button(QWidget& in, const char* text) {
        for (auto* each : in.findChildren<QPushButton*>()) {
            if (each->text() == QString::fromUtf8(text)) {
                return each;
            }
        }
        ADD_FAILURE() << text;
        return nullptr;
    }
    static void type(widgets::NumberField& field, const QString& text) {
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }
    static widgets::NumberField& field(QWidget& in, const char* name) {
        for (auto* each : in.findChildren<widgets::NumberField*>()) {
            if (each->accessibleName() == QString::fromUtf8(name)) {
                return *each;
            }
        }
        throw std::runtime_error(name);
    }
    void settle() {
        ASSERT_TRUE(QTest::qWaitFor([&] { return !points().busy(); }, patience));
    }
    io::TemporaryFolder m_folder;
};

TEST_F(CloudWork, IsFittedToWhatDidNotMoveInADrawnArea) {
    // A strip of the bridge has no walls that hold a cloud across it.
    scanned(wholeArch());
    bool asked = false;
    whenAsked([&](QDialog& opened) {
        asked = true;
        auto& dialog = dynamic_cast<widgets::FitDialog&>(opened);
        auto* fit = button(dialog, "Fit");
        auto* place = button(dialog, "Place survey");
        EXPECT_FALSE(fit->isEnabled()) << "nobody said what did not move";
        // Around nearly all that was surveyed, by clicks.
        widgets::PhotoView& plan = dialog.plan();
        const QSizeF size = plan.content().size;
        for (const auto& [x, y] : {std::pair(0.02, 0.02), std::pair(0.98, 0.02), std::pair(0.98, 0.98), std::pair(0.02, 0.98)}) {
            QTest::mouseClick(&plan, Qt::LeftButton, {}, plan.toWidget({x * size.width(), y * size.height()}).toPoint());
        }
        QTest::keyClick(&plan, Qt::Key_Return);
        ASSERT_TRUE(dialog.stable());
        ASSERT_EQ(dialog.stable()->polygons.size(), 1U);
        EXPECT_EQ(dialog.stable()->polygons[0][0].size(), 4U);
        EXPECT_TRUE(dialog.isVisible()) << "Enter closes the area alone";
        ASSERT_TRUE(fit->isEnabled());
        EXPECT_FALSE(place->isEnabled());
        QTest::mouseClick(fit, Qt::LeftButton);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog.content().fitting; }, patience));
        ASSERT_TRUE(dialog.content().found) << dialog.content().complaint.toStdString();
        EXPECT_GT(dialog.content().found->fit.pairs, 100);
        EXPECT_LT(dialog.content().found->fit.after, 0.5 * dialog.content().found->fit.before);
        EXPECT_FALSE(survey().registration) << "nothing changes before it is accepted";
        ASSERT_TRUE(place->isEnabled());
        // Another radius is another fit.
        type(field(dialog, "Radius of the fit"), QStringLiteral("0.8"));
        EXPECT_FALSE(place->isEnabled());
        QTest::mouseClick(fit, Qt::LeftButton);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog.content().fitting; }, patience));
        ASSERT_TRUE(place->isEnabled()) << dialog.content().complaint.toStdString();
        QTest::mouseClick(place, Qt::LeftButton);
    });
    QTest::mouseClick(button(box(), "Fit to what did not move…"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return asked && survey().registration.has_value(); }, patience));
    const Registration placed = *survey().registration;
    EXPECT_GT(placed.fitted, 100);
    EXPECT_LT((placed(misplaced)).norm(), 0.03) << placed(misplaced).transpose();
    ASSERT_TRUE(placed.error);
    EXPECT_LT(*placed.error, 0.2);
    // It is part of the case, and taken back like every other edit.
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    EXPECT_EQ(io::loadCase(m_folder / "case.rubble").inputs.back().registration, placed);
    window->actions()[ActionId::Undo].trigger();
    EXPECT_FALSE(survey().registration);
}

TEST_F(CloudWork, AFitThatLeavesADirectionOpenIsRefusedAndCanBeLeft) {
    openArch();
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    window->rooms().survey->add(QString::fromStdString(layLevelTable(m_folder / "level.csv", 0.1)));
    bool asked = false;
    whenAsked([&](QDialog& opened) {
        auto& dialog = dynamic_cast<widgets::FitDialog&>(opened);
        dialog.findChild<QCheckBox*>()->click();
        ASSERT_TRUE(dialog.stable());
        EXPECT_TRUE(dialog.stable()->polygons.empty()) << "all of it";
        QTest::mouseClick(button(dialog, "Fit"), Qt::LeftButton);
        EXPECT_TRUE(QTest::qWaitFor([&] { return !dialog.content().fitting; }, patience));
        EXPECT_FALSE(dialog.content().complaint.isEmpty()) << "level ground tells nothing of easting and northing";
        EXPECT_FALSE(button(dialog, "Place survey")->isEnabled());
        asked = true;
        QTest::keyClick(&dialog.plan(), Qt::Key_Escape);
    });
    QTest::mouseClick(button(box(), "Fit to what did not move…"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return asked && !window->rooms().survey->fitting().busy(); }, patience));
    EXPECT_FALSE(survey().registration);
}

TEST_F(CloudWork, DistancesAndVolumesAreToldAndSavedAsCloudAndTable) {
    scanned();
    widgets::PointBox& about = box().points();
    about.distances().setSettings({1.0, 0.5, 2.0, std::nullopt, false});
    type(field(about, "Cells of the volumes"), QStringLiteral("0.5"));
    auto* save = about.findChild<QPushButton*>(QStringLiteral("saveDistances"));
    EXPECT_FALSE(save->isVisibleTo(&about)) << "nothing was measured";
    QTest::mouseClick(button(about, "Measure distances"), Qt::LeftButton);
    settle();
    const auto said = [&] {
        QString all;
        for (const auto* label : about.findChildren<QLabel*>()) {
            all += label->isVisibleTo(&about) ? label->text() + u'\n' : QString();
        }
        return all;
    };
    EXPECT_TRUE(said().contains(QStringLiteral("Fill "))) << qPrintable(said());
    EXPECT_TRUE(said().contains(QStringLiteral("± not known systematic"))) << "nobody stated the registration error";
    EXPECT_TRUE(said().contains(QStringLiteral("of roughness alone")));
    ASSERT_TRUE(save->isVisibleTo(&about));
    for (const char* name : {"distances.las", "distances.ply", "distances.csv"}) {
        points().saveDistancesTo(QString::fromStdString(m_folder / name));
        EXPECT_TRUE(std::filesystem::exists(m_folder / name)) << name;
        EXPECT_TRUE(std::filesystem::exists(m_folder / (std::string(name) + ".provenance.json"))) << name;
    }
    std::ifstream table(m_folder / "distances.csv");
    std::string heading;
    std::getline(table, heading);
    EXPECT_EQ(heading.substr(0, 43), "x,y,z,state,distance,level_of_detection,sig");
    EXPECT_GT(io::readCloud(m_folder / "distances.las").points.size(), 100U);
    // Stated errors have an interval; what was measured before is of other settings.
    type(field(about, "Registration error"), QStringLiteral("0.05"));
    window->rooms().survey->refresh();
    EXPECT_FALSE(save->isVisibleTo(&about));
    points().saveDistancesTo(QString::fromStdString(m_folder / "stale.las"));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "stale.las"));
    QTest::mouseClick(button(about, "Measure distances"), Qt::LeftButton);
    settle();
    EXPECT_FALSE(said().contains(QStringLiteral("not known systematic"))) << qPrintable(said());
}

TEST_F(CloudWork, ControlPointsOfATableHaveAnErrorThatIsStated) {
    openArch();
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    std::ofstream(m_folder / "points.csv") << "x,y,z\n1,2,0\n10,3,0\n4,9,1\n2,2,2\n";
    window->rooms().survey->add(QString::fromStdString(m_folder / "points.csv"));
    std::ofstream(m_folder / "pairs.csv") << "survey_x,survey_y,survey_z,x_m,y_m,z_m\n0,0,0,1,0,0\n10,0,0,11,0,0\n0,8,1,1,8,1\n"
                                             "4,4,3,5,4,3.01\n";
    type(field(box().place(), "Error of control points in a table"), QStringLiteral("0.03"));
    window->rooms().survey->placeByPairs(QString::fromStdString(m_folder / "pairs.csv"));
    ASSERT_TRUE(survey().registration);
    EXPECT_EQ(survey().registration->control, 0.03);
    type(field(box().place(), "Error of control points in a table"), QString());
}

TEST_F(CloudWork, ARemedyIsDoneByTheButtonBelowIt) {
    openArch();
    makeCheap();
    simulateToEnd();
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    window->rooms().survey->add(QString::fromStdString(layLevelTable(m_folder / "level.csv", 0.1)));
    points().measure();
    settle();
    window->rooms().deck->choose(PanelDeck::Evidence);
    auto* give = button(box().points(), "Give the scanners");
    ASSERT_NE(give, nullptr);
    QTest::mouseClick(give, Qt::LeftButton);
    const auto typed = [] {
        const auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
        return field != nullptr && field->accessibleName() == QStringLiteral("Places of the scanners");
    };
    EXPECT_TRUE(QTest::qWaitFor(typed, patience));
}

TEST_F(CloudWork, ATableWithoutAHeadingIsAskedForItsColumns) {
    openArch();
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    std::ofstream(m_folder / "points.txt") << "7 1 2 0.5\n7 10 3 0.5\n7 4 9 1.5\n7 2 2 2.5\n7 3 5 1.0\n";
    const auto field = [](QWidget& in, const char* name) {
        for (auto* each : in.findChildren<QLineEdit*>()) {
            if (each->accessibleName() == QString::fromUtf8(name)) {
                return each;
            }
        }
        throw std::runtime_error(name);
    };
    bool asked = false;
    whenAsked([&](QDialog& opened) {
        auto& dialog = dynamic_cast<widgets::ReadingDialog&>(opened);
        QLineEdit& columns = *field(dialog, "Columns of the table");
        QTest::keyClicks(&columns, QStringLiteral("skip,x,y,height_of_mine"));
        QTest::mouseClick(button(dialog, "Add survey"), Qt::LeftButton);
        EXPECT_TRUE(dialog.isVisible()) << "it says why it cannot be read so";
        columns.selectAll();
        QTest::keyClicks(&columns, QStringLiteral("skip,x,y,z"));
        asked = true;
        QTest::mouseClick(button(dialog, "Add survey"), Qt::LeftButton);
    });
    window->rooms().survey->add(QString::fromStdString(m_folder / "points.txt"));
    ASSERT_TRUE(asked);
    const std::vector<std::string> stated{"skip", "x", "y", "z"};
    EXPECT_EQ(survey().read.columns, stated);
    EXPECT_EQ(survey().kind, SurveyKind::Cloud);
    // It stands in the panel, is changed there, and what cannot be meant is said there.
    QLineEdit& columns = *field(box(), "Columns of the table");
    EXPECT_EQ(columns.text(), QStringLiteral("skip,x,y,z"));
    columns.setFocus();
    columns.selectAll();
    QTest::keyClicks(&columns, QStringLiteral("x,y"));
    QTest::keyClick(&columns, Qt::Key_Return);
    EXPECT_EQ(survey().read.columns, stated);
    EXPECT_EQ(columns.text(), QStringLiteral("x,y")) << "what was typed stays beside what is wrong with it";
    columns.selectAll();
    QTest::keyClicks(&columns, QStringLiteral("skip,y,x,z"));
    QTest::keyClick(&columns, Qt::Key_Return);
    EXPECT_EQ(survey().read.columns[1], "y");
    window->actions()[ActionId::Undo].trigger();
    EXPECT_EQ(survey().read.columns, stated);
    EXPECT_EQ(columns.text(), QStringLiteral("skip,x,y,z"));
    // One whose heading names them is not asked about.
    std::ofstream(m_folder / "named.csv") << "x,y,z\n1,2,3\n4,5,6\n";
    window->rooms().survey->add(QString::fromStdString(m_folder / "named.csv"));
    EXPECT_TRUE(survey().read.empty());
}

TEST_F(CloudWork, OneWithoutASystemIsAskedForItInACaseThatHasOne) {
    openArch();
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    session->document().setSite({}, "EPSG:25832", {}, [] { return QStringLiteral("site"); });
    std::ofstream(m_folder / "named.csv") << "x,y,z\n1,2,3\n4,5,6\n";
    whenAsked([&](QDialog& opened) {
        auto& dialog = dynamic_cast<widgets::ReadingDialog&>(opened);
        for (auto* each : dialog.findChildren<QLineEdit*>()) {
            if (each->accessibleName() == QStringLiteral("Coordinate system of the cloud")) {
                QTest::keyClicks(each, QStringLiteral("EPSG:25833"));
            }
        }
        QTest::mouseClick(button(dialog, "Add survey"), Qt::LeftButton);
    });
    window->rooms().survey->add(QString::fromStdString(m_folder / "named.csv"));
    EXPECT_EQ(survey().read.crs, "EPSG:25833");
    // Given up: nothing is added.
    const std::size_t before = session->document().theCase().inputs.size();
    std::ofstream(m_folder / "other.csv") << "x,y,z\n1,2,3\n4,5,6\n";
    whenAsked([&](QDialog& opened) { QTest::keyClick(&opened, Qt::Key_Escape); });
    window->rooms().survey->add(QString::fromStdString(m_folder / "other.csv"));
    EXPECT_EQ(session->document().theCase().inputs.size(), before);
}

TEST_F(CloudWork, WhereScannersStoodIsGivenAndKept) {
    scanned();
    QLineEdit* places = nullptr;
    for (auto* each : box().points().findChildren<QLineEdit*>()) {
        places = each->accessibleName() == QStringLiteral("Places of the scanners") ? each : places;
    }
    ASSERT_NE(places, nullptr);
    places->setFocus();
    QTest::keyClicks(places, QStringLiteral("1,2"));
    QTest::keyClick(places, Qt::Key_Return);
    EXPECT_TRUE(survey().scanners.empty());
    places->selectAll();
    QTest::keyClicks(places, QStringLiteral("30,-20,1.8; -30,20,1.8"));
    QTest::keyClick(places, Qt::Key_Return);
    const std::vector<Vec3> given{Vec3(30.0, -20.0, 1.8), Vec3(-30.0, 20.0, 1.8)};
    EXPECT_EQ(survey().scanners, given);
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    EXPECT_EQ(io::loadCase(m_folder / "case.rubble").inputs.back().scanners, given);
    points().measure();
    settle();
    QString said;
    for (const auto* label : box().points().findChildren<QLabel*>()) {
        said += label->text();
    }
    EXPECT_TRUE(said.contains(QStringLiteral("Seen from the scanners that were given: 2."))) << qPrintable(said);
    window->actions()[ActionId::Undo].trigger();
    EXPECT_TRUE(survey().scanners.empty());
}

TEST_F(CloudWork, TheRunIsScannedToAFileFromScannersThatAreTyped) {
    openArch();
    makeCheap();
    EXPECT_FALSE(window->actions()[ActionId::ScanRun].isEnabled()) << "there is no debris yet";
    simulateToEnd();
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    ASSERT_TRUE(window->actions()[ActionId::ScanRun].isEnabled());
    const std::string path = m_folder / "scan.las";
    bool asked = false;
    whenAsked([&](QDialog& opened) {
        auto& dialog = dynamic_cast<widgets::ScanDialog&>(opened);
        for (auto* each : dialog.scanners().findChildren<QLineEdit*>()) {
            QTest::keyClicks(each, QStringLiteral("30,-20,1.8"));
        }
        type(field(dialog, "Step between rays"), QStringLiteral("1"));
        type(field(dialog, "Noise along a ray"), QStringLiteral("0"));
        CloudTools& tools = *window->rooms().cloudTools;
        tools.scanTo(dialog, QString::fromStdString(m_folder / "scan.xls"));
        EXPECT_FALSE(dialog.content().complaint.isEmpty());
        tools.scanTo(dialog, QString::fromStdString(path));
        EXPECT_TRUE(QTest::qWaitFor([&] { return !dialog.content().scanning; }, patience));
        EXPECT_TRUE(dialog.content().said.contains(QStringLiteral("scan.las"))) << qPrintable(dialog.content().complaint);
        EXPECT_TRUE(QTest::qWaitFor([&] { return dialog.height() >= dialog.layout()->totalHeightForWidth(dialog.width()); }, 2000))
            << "what is said now takes no room from the fields";
        asked = true;
        dialog.reject();
    });
    window->actions()[ActionId::ScanRun].trigger();
    ASSERT_TRUE(asked);
    EXPECT_TRUE(std::filesystem::exists(path + ".provenance.json"));
    const io::WholeCloud cloud = io::readCloud(path);
    EXPECT_GT(cloud.points.size(), 100U);
    ASSERT_EQ(cloud.head.scans.size(), 1U);
}

TEST_F(CloudWork, ScannersAreClickedInTheModelListedChangedAndUndone) {
    scanned();
    bool asked = false;
    std::vector<Vec3> taken;
    whenAsked([&](QDialog& opened) {
        asked = true;
        auto& dialog = dynamic_cast<widgets::ScannerDialog&>(opened);
        dialog.model().picture();
        std::optional<QPoint> there;
        for (int y = 20; y < dialog.model().height() - 20 && !there; y += 3) {
            for (int x = 20; x < dialog.model().width() - 20 && !there; x += 3) {
                there = dialog.model().hitAt(QPointF(x, y)) ? std::optional(QPoint(x, y)) : std::nullopt;
            }
        }
        ASSERT_TRUE(there);
        const Vec3 hit = dialog.model().hitAt(QPointF(*there))->point;
        type(dialog.above(), QStringLiteral("2"));
        QTest::mouseClick(&dialog.model(), Qt::LeftButton, {}, *there);
        ASSERT_EQ(dialog.places().size(), 1u);
        EXPECT_LT((dialog.places()[0] - hit - Vec3(0.0, 0.0, 2.0)).norm(), 1e-6);
        dialog.pick(Vec3(10.0, 20.0, 0.0));
        auto* table = dialog.findChild<QTableWidget*>();
        ASSERT_EQ(table->rowCount(), 2);
        EXPECT_EQ(table->item(1, 1)->text(), QStringLiteral("10.000"));
        // A number is typed anew; a word is no number.
        table->item(1, 1)->setText(QStringLiteral("12.5"));
        EXPECT_EQ(dialog.places()[1], Vec3(12.5, 20.0, 2.0));
        table->item(1, 2)->setText(QStringLiteral("north"));
        EXPECT_EQ(dialog.places()[1], Vec3(12.5, 20.0, 2.0));
        EXPECT_EQ(table->item(1, 2)->text(), QStringLiteral("20.000"));
        QTest::keyClick(&dialog, Qt::Key_Z, Qt::ControlModifier);
        EXPECT_EQ(dialog.places()[1], Vec3(10.0, 20.0, 2.0));
        table->selectRow(0);
        QTest::mouseClick(button(dialog, "Remove scanner"), Qt::LeftButton);
        ASSERT_EQ(dialog.places().size(), 1u);
        QTest::keyClick(&dialog, Qt::Key_Z, Qt::ControlModifier);
        ASSERT_EQ(dialog.places().size(), 2u);
        QTest::keyClick(&dialog, Qt::Key_Escape);
        EXPECT_TRUE(dialog.isVisible()) << "what was picked is not lost by Esc";
        taken = dialog.places();
        QTest::mouseClick(button(dialog, "Take these places"), Qt::LeftButton);
    });
    window->rooms().deck->choose(PanelDeck::Evidence);
    QTest::mouseClick(button(box().points().scanners(), "Pick…"), Qt::LeftButton);
    ASSERT_TRUE(asked);
    ASSERT_EQ(survey().scanners.size(), 2u);
    EXPECT_LT((survey().scanners[0] - taken[0]).norm(), 1e-6);
    EXPECT_LT((survey().scanners[1] - taken[1]).norm(), 1e-6);
    window->actions()[ActionId::Undo].trigger();
    EXPECT_TRUE(survey().scanners.empty());
}

TEST_F(CloudWork, AScanOfAnInstantIsHeldAgainstThatInstant) {
    openArch();
    makeCheap();
    simulateToEnd();
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    const std::string path = m_folder / "falling.las";
    QString said;
    whenAsked([&](QDialog& opened) {
        auto& dialog = dynamic_cast<widgets::ScanDialog&>(opened);
        EXPECT_FALSE(dialog.instant()) << "unasked it is the end";
        type(field(dialog, "Instant that is scanned"), QStringLiteral("900"));
        CloudTools& tools = *window->rooms().cloudTools;
        const auto scan = [&](const std::string& to) {
            tools.scanTo(dialog, QString::fromStdString(to));
            EXPECT_TRUE(QTest::qWaitFor([&] { return !dialog.content().scanning; }, patience));
        };
        scan(path);
        EXPECT_FALSE(dialog.content().complaint.isEmpty()) << "the run does not reach so far";
        type(field(dialog, "Step between rays"), QStringLiteral("1"));
        type(field(dialog, "Instant that is scanned"), QStringLiteral("2.5"));
        scan(path);
        said = dialog.content().said;
        scan(m_folder / "falling.csv");
        EXPECT_EQ(dialog.content().findings.count("scan.instant_unsaid"), 1);
        dialog.reject();
    });
    window->actions()[ActionId::ScanRun].trigger();
    EXPECT_TRUE(said.contains(QStringLiteral("Scanned at 2.50"))) << qPrintable(said);
    window->rooms().survey->add(QString::fromStdString(path));
    ASSERT_TRUE(survey().instant) << "the file says it";
    EXPECT_EQ(*survey().instant, 2.5);
    const auto& list = window->rooms().deck->evidence().list();
    EXPECT_TRUE(list.item(0, 1)->text().contains(QStringLiteral("the debris at 2.5"))) << qPrintable(list.item(0, 1)->text());
}

TEST_F(CloudWork, AScanOfTheRunIsNoEvidenceUnderAnyName) {
    openArch();
    makeCheap();
    simulateToEnd();
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    const std::string path = m_folder / "scan.las", copy = m_folder / "site.las";
    whenAsked([&](QDialog& opened) {
        auto& dialog = dynamic_cast<widgets::ScanDialog&>(opened);
        type(field(dialog, "Step between rays"), QStringLiteral("1"));
        window->rooms().cloudTools->scanTo(dialog, QString::fromStdString(path));
        EXPECT_TRUE(QTest::qWaitFor([&] { return !dialog.content().scanning; }, patience));
        dialog.reject();
    });
    window->actions()[ActionId::ScanRun].trigger();
    std::filesystem::copy_file(path, copy);
    const auto add = [&](const std::string& file) {
        window->rooms().survey->add(QString::fromStdString(file));
        ASSERT_TRUE(QTest::qWaitFor([&] { return !session->part<SurveyReach>().busy(); }, patience));
    };
    add(copy);
    EXPECT_EQ(box().content().findings.list().front().what.id, "evidence.of_this_run") << "at once, without its provenance";
    const auto& list = window->rooms().deck->evidence().list();
    EXPECT_EQ(list.item(0, 1)->text(), QStringLiteral("a simulated run: no evidence"));
    add(path);
    EXPECT_EQ(box().content().findings.count("evidence.same"), 1) << "of one content";
    QTest::mouseClick(button(box(), "Compare with survey"), Qt::LeftButton);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return box().content().comparison != nullptr && !window->rooms().survey->busy(); }, patience));
    EXPECT_EQ(box().content().findings.count("evidence.of_this_run"), 1) << "said once";
    EXPECT_EQ(box().content().cautions.front().key, "no_evidence");
    const auto height = [this](const QWidget* notice) { return notice->mapTo(&box(), QPoint()).y(); };
    const widgets::Notice* top = nullptr;
    for (const auto* notice : box().findChildren<widgets::Notice*>()) {
        top = notice->isVisibleTo(&box()) && (top == nullptr || height(notice) < height(top)) ? notice : top;
    }
    EXPECT_TRUE(top != nullptr && top->text().contains(QStringLiteral("very run")));
    const std::string map = m_folder / "map.png";
    window->rooms().survey->saveTo(QString::fromStdString(map));
    std::ifstream in(map + ".provenance.json");
    const std::string about((std::istreambuf_iterator<char>(in)), {});
    for (const char* said : {"no_evidence", R"("survey": "scan.las")", R"("subject": "case.rubble)"}) {
        EXPECT_NE(about.find(said), std::string::npos) << about;
    }
    QTest::mouseClick(button(box(), "Take this survey out"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return box().content().names.size() == 1; }, patience));
    EXPECT_EQ(box().content().findings.count("evidence.same"), 0);
}

TEST_F(CloudWork, TheScanDialogSaysWhatStillMoves) {
    openArch();
    makeCheap();
    session->document().setParameter(QStringLiteral("settle_time"), 0.1);
    simulateToEnd();
    const std::int64_t moving = session->computation().currentRun()->reader->result()->stillMoving;
    ASSERT_GT(moving, 0);
    QString before, said;
    whenAsked([&](QDialog& opened) {
        auto& dialog = dynamic_cast<widgets::ScanDialog&>(opened);
        for (const auto* notice : dialog.findChildren<widgets::Notice*>()) {
            before += notice->isVisibleTo(&dialog) ? notice->text() : QString();
        }
        EXPECT_EQ(field(dialog, "Instant that is scanned").placeholderText(), QStringLiteral("the end, not all at rest"));
        type(field(dialog, "Step between rays"), QStringLiteral("1"));
        window->rooms().cloudTools->scanTo(dialog, QString::fromStdString(m_folder / "scan.las"));
        EXPECT_TRUE(QTest::qWaitFor([&] { return !dialog.content().scanning; }, patience));
        said = dialog.content().said;
        dialog.reject();
    });
    window->actions()[ActionId::ScanRun].trigger();
    const QString number = widgets::shownCount(moving) + QStringLiteral(" of ");
    EXPECT_TRUE(before.contains(number) && said.contains(number)) << qPrintable(before + said);
}

TEST_F(CloudWork, TwoCloudsAreHeldAgainstEachOtherWithTheirEpochs) {
    openArch();
    ASSERT_TRUE(window->rooms().files->saveTo(QString::fromStdString(m_folder / "case.rubble")));
    const auto level = [&](const char* name, double height) {
        std::ofstream out(m_folder / name);
        out << "x,y,z\n";
        for (int k = 0; k < 2'500; ++k) {
            out << 0.4 * (k % 50) << ',' << 0.4 * (k / 50) << ',' << height + 0.01 * (k % 3) << '\n';
        }
    };
    level("after.csv", 1.0);
    level("before.csv", 0.4);
    const auto taken = [&](const char* time) {
        window->rooms().survey->edit([&](CaseInput& input) { input.taken = time; }, [] { return QStringLiteral("time"); });
    };
    window->rooms().survey->add(QString::fromStdString(m_folder / "after.csv"));
    taken("2021-06-25 16:30:00");
    window->rooms().survey->add(QString::fromStdString(m_folder / "before.csv"));
    taken("2021-06-20 09:00:00");
    bool asked = false;
    whenAsked([&](QDialog& opened) {
        auto& dialog = dynamic_cast<widgets::CloudPairDialog&>(opened);
        ASSERT_TRUE(dialog.first() && dialog.second());
        EXPECT_TRUE(dialog.first()->path.ends_with("before.csv")) << "the older one is the first";
        QString words;
        for (const auto* label : dialog.findChildren<QLabel*>()) {
            words += label->text();
        }
        EXPECT_TRUE(words.contains(QStringLiteral("2021-06-20 09:00:00, and 2021-06-25 16:30:00"))) << qPrintable(words);
        type(field(dialog, "Registration error"), QStringLiteral("0.02"));
        type(field(dialog, "Cells of the volumes"), QStringLiteral("1"));
        QTest::mouseClick(button(dialog, "Measure distances"), Qt::LeftButton);
        EXPECT_TRUE(QTest::qWaitFor([&] { return !dialog.content().measuring; }, patience));
        EXPECT_TRUE(dialog.content().said.contains(QStringLiteral("Fill "))) << qPrintable(dialog.content().complaint);
        window->rooms().cloudTools->saveTo(QString::fromStdString(m_folder / "distances.csv"));
        // Other scales: what was measured is of others.
        type(field(dialog, "Depth of the cylinder"), QStringLiteral("2"));
        EXPECT_FALSE(dialog.content().savable);
        window->rooms().cloudTools->saveTo(QString::fromStdString(m_folder / "stale.csv"));
        asked = true;
        dialog.reject();
    });
    window->actions()[ActionId::CompareClouds].trigger();
    ASSERT_TRUE(asked);
    EXPECT_TRUE(std::filesystem::exists(m_folder / "distances.csv"));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "stale.csv"));
}

}  // namespace

}  // namespace rubble
