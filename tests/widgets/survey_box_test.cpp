#include "widgets/evidence/survey_box.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>
#include <QTranslator>
#include <map>

#include "widgets/basics/number_field.h"
#include "widgets/basics/panel.h"
#include "widgets/evidence/survey_view.h"

namespace rubble::widgets {
namespace {

/// 4 x 4 m of debris 2 m high against 6 x 4 m surveyed.
std::shared_ptr<const SurveyComparison> made() {
    MapPiece piece;
    piece.centre = Vec3(0.0, 0.0, 1.0);
    piece.box = {piece.centre, Quat::Identity(), Vec3(2.0, 2.0, 1.0)};
    piece.mass = 1.0;
    piece.volume = 32.0;
    Survey survey;
    survey.isFootprint = true;
    survey.footprint.polygons = {{{{-2.0, -2.0}, {4.0, -2.0}, {4.0, 2.0}, {-2.0, 2.0}}}};
    const SiteSurface ground;
    return std::make_shared<SurveyComparison>(compareWithSurvey(rasterOf(std::vector{piece}, 0.5, ground, Execution()), survey,
                                                                ground, Eigen::Vector2d::Zero(), SurveySettings(), Execution()));
}

class SurveyForm : public testing::Test {
protected:
    void SetUp() override {
        box.resize(300, 700);
        box.show();
        content.available = true;
        content.names = QStringList{QStringLiteral("drone.tif"), QStringLiteral("outline.gpkg")};
        content.chosen = 0;
    }
    QPushButton* button(const QString& text) {
        for (auto* each : box.findChildren<QPushButton*>()) {
            if (each->text() == text) {
                return each;
            }
        }
        return nullptr;
    }
    NumberField* field(const QString& name) {
        for (auto* each : box.findChildren<NumberField*>()) {
            if (each->accessibleName() == name) {
                return each;
            }
        }
        return nullptr;
    }
    bool says(const QString& words) {
        for (const auto* label : box.findChildren<QLabel*>()) {
            if (label->isVisible() && label->text().contains(words)) {
                return true;
            }
        }
        return false;
    }
    SurveyBox box;
    SurveyBox::Content content;
};

TEST_F(SurveyForm, SaysWhatIsMissingUntilItCanCompare) {
    box.setContent({});
    EXPECT_FALSE(button(QStringLiteral("Add survey…"))->isEnabled());
    content.chosen = -1;
    content.names.clear();
    box.setContent(content);
    EXPECT_TRUE(button(QStringLiteral("Add survey…"))->isEnabled());
    EXPECT_FALSE(button(QStringLiteral("Compare with survey"))->isEnabled());
    EXPECT_TRUE(says(QStringLiteral("measured after the collapse")));
    content.names = QStringList{QStringLiteral("drone.tif")};
    content.chosen = 0;
    content.noComparison = QStringLiteral("Simulate first");
    box.setContent(content);
    EXPECT_FALSE(button(QStringLiteral("Compare with survey"))->isEnabled());
    EXPECT_TRUE(says(QStringLiteral("Simulate first")));
    content.noComparison.clear();
    box.setContent(content);
    QSignalSpy asked(&box, &SurveyBox::compareRequested);
    QTest::mouseClick(button(QStringLiteral("Compare with survey")), Qt::LeftButton);
    EXPECT_EQ(asked.count(), 1);
}

TEST_F(SurveyForm, WhatMustBeKnownOfTheRunStandsAboveTheFigures) {
    const auto words = [this] {
        QString text;
        for (const Notice* notice : box.findChildren<Notice*>()) {
            text += notice->isHidden() ? QString() : notice->text();
        }
        return text;
    };
    RunStanding run;
    run.reached = 19.68;
    run.fragments = run.bodies = 1999;
    run.moving = 514;
    content.cautions = runCautions(run);
    box.setContent(content);
    EXPECT_FALSE(words().contains(QStringLiteral("514"))) << "nothing is compared yet";
    content.comparison = made();
    box.setContent(content);
    EXPECT_TRUE(words().contains(QStringLiteral("514"))) << words().toStdString();
    content.stale = true;
    box.setContent(content);
    EXPECT_FALSE(words().contains(QStringLiteral("514"))) << "of another run";
}

TEST_F(SurveyForm, ThatASurveyIsNoEvidenceStandsBeforeAllElseWithItsRemedy) {
    content.findings.add({"survey.gaps", "gaps", {}}, {"survey.gaps.remedy", "none", {}});
    content.findings.add({"evidence.of_this_run", "made from the very run", {}}, {"evidence.of_run.remedy", "take it out", {}});
    box.setContent(content);
    QSignalSpy asked(&box, &SurveyBox::removeRequested);
    QCoreApplication::processEvents();
    int first = box.height();
    QString text;
    for (const Notice* notice : box.findChildren<Notice*>()) {
        const int top = notice->mapTo(&box, QPoint()).y();
        if (notice->isVisible() && top < first) {
            first = top;
            text = notice->text();
        }
    }
    EXPECT_TRUE(text.contains(QStringLiteral("very run"))) << text.toStdString();
    QTest::mouseClick(button(QStringLiteral("Take this survey out")), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return asked.count() == 1; }, 2000));
}

TEST_F(SurveyForm, DirectionsAreWordsOfTheWindow) {
    struct East : QTranslator {
        QString translate(const char* context, const char* source, const char*, int) const override {
            return QLatin1String(context) == QLatin1String("compass") && QLatin1String(source) == QLatin1String("E")
                       ? QStringLiteral("Ost")
                       : QString();
        }
        bool isEmpty() const override { return false; }
    } east;
    const auto first = [&] {
        content.comparison = made();
        box.setContent({});
        box.setContent(content);
        for (const QTableWidget* table : box.findChildren<QTableWidget*>()) {
            if (table->accessibleName() == QLatin1String("Run-out by direction")) {
                return table->item(0, 0)->text();
            }
        }
        return QString();
    };
    EXPECT_EQ(first(), QStringLiteral("E"));
    QCoreApplication::installTranslator(&east);
    EXPECT_EQ(first(), QStringLiteral("Ost"));
    QCoreApplication::removeTranslator(&east);
}

TEST_F(SurveyForm, FieldsAreTheSettings) {
    box.setContent(content);
    QSignalSpy changed(&box, &SurveyBox::settingsChanged);
    NumberField* cell = field(QStringLiteral("Cells of the survey comparison"));
    NumberField* least = field(QStringLiteral("Least height of debris"));
    ASSERT_NE(cell, nullptr);
    ASSERT_NE(least, nullptr);
    const auto type = [](NumberField* field, const QString& text) {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    };
    type(cell, QStringLiteral("0.25"));
    type(least, QStringLiteral("0.1"));
    type(least, QStringLiteral("99"));
    QComboBox* fit = nullptr;
    for (auto* each : box.findChildren<QComboBox*>()) {
        if (each->accessibleName() == QStringLiteral("Registration of the survey")) {
            fit = each;
        }
    }
    ASSERT_NE(fit, nullptr);
    fit->setFocus();
    QTest::keyClick(fit, Qt::Key_Down);
    for (auto* each : box.findChildren<QCheckBox*>()) {
        if (each->text() == QStringLiteral("Fallen structure counts as debris")) {
            QTest::keyClick(each, Qt::Key_Space);
        }
    }
    const SurveySettings settings = box.settings();
    EXPECT_DOUBLE_EQ(settings.cell, 0.25);
    EXPECT_DOUBLE_EQ(settings.leastHeight, 0.1) << "what is out of range is not taken";
    EXPECT_EQ(settings.fit, SurveyFit::Ground);
    EXPECT_FALSE(settings.withFallen);
    EXPECT_EQ(changed.count(), 4);
}

TEST_F(SurveyForm, WhatTheSurveyShowsIsAskedAndShown) {
    content.showsFallen = false;
    box.setContent(content);
    QComboBox* shows = nullptr;
    for (auto* each : box.findChildren<QComboBox*>()) {
        if (each->accessibleName() == QStringLiteral("Whether the survey shows fallen structure")) {
            shows = each;
        }
    }
    ASSERT_NE(shows, nullptr);
    EXPECT_EQ(shows->currentText(), QStringLiteral("no"));
    std::optional<bool> asked = false;
    int count = 0;
    QObject::connect(&box, &SurveyBox::showsFallenChosen, &box, [&](std::optional<bool> chosen) {
        asked = chosen;
        ++count;
    });
    shows->setFocus();
    QTest::keyClick(shows, Qt::Key_Up);
    EXPECT_EQ(asked, std::optional<bool>(true));
    QTest::keyClick(shows, Qt::Key_Up);
    EXPECT_EQ(asked, std::nullopt);
    EXPECT_EQ(count, 2) << "setting the content asks for nothing";
}

TEST_F(SurveyForm, WhatIsComparedIsListedAndNoiseIsAskedFor) {
    content.scope.area.polygons = {{{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}}}};
    content.scope.leftOut.polygons = {{{{1.0, 1.0}, {2.0, 1.0}, {2.0, 2.0}, {1.0, 2.0}}}};
    content.errors.noise = 0.05;
    box.setContent(content);
    auto* list = box.findChild<QListWidget*>();
    ASSERT_EQ(list->count(), 2);
    EXPECT_TRUE(list->item(0)->text().contains(QStringLiteral("area of interest")));
    EXPECT_TRUE(list->item(1)->text().contains(QStringLiteral("left out, corners: 4")));
    std::vector<std::pair<ScopePart, int>> removed;
    QObject::connect(&box, &SurveyBox::scopeRemoved, &box,
                     [&](ScopePart part, int polygon) { removed.emplace_back(part, polygon); });
    list->setCurrentRow(1);
    for (auto* each : box.findChildren<QToolButton*>()) {
        if (each->text() == QStringLiteral("Remove")) {
            QTest::mouseClick(each, Qt::LeftButton);
        }
    }
    ASSERT_EQ(removed.size(), 1u);
    EXPECT_EQ(removed.front(), std::pair(ScopePart::LeftOut, 0));
    SurveyBox::Errors chosen{0.0, 1.0, 1.0};
    QObject::connect(&box, &SurveyBox::noiseChosen, &box, [&](const SurveyBox::Errors& errors) { chosen = errors; });
    NumberField* noise = field(QStringLiteral("Noise of the survey"));
    ASSERT_NE(noise, nullptr);
    EXPECT_EQ(noise->number(), std::optional<double>(0.05));
    noise->setFocus();
    noise->selectAll();
    QTest::keyClicks(noise, QStringLiteral("0.1"));
    QTest::keyClick(noise, Qt::Key_Return);
    EXPECT_EQ(chosen.noise, std::optional<double>(0.1));
    EXPECT_EQ(chosen.groundNoise, std::nullopt);
    EXPECT_EQ(chosen.offset, std::nullopt);
    NumberField* offset = field(QStringLiteral("Offset error of the survey"));
    ASSERT_NE(offset, nullptr);
    offset->setFocus();
    QTest::keyClicks(offset, QStringLiteral("0.03"));
    QTest::keyClick(offset, Qt::Key_Return);
    EXPECT_EQ(chosen.offset, std::optional<double>(0.03));
}

TEST_F(SurveyForm, PolygonsAreDrawnOnTheMapByMouseAndKeys) {
    SurveyView view;
    view.resize(600, 500);
    view.draw(SurveyView::Draws::Area);
    EXPECT_FALSE(view.drawing()) << "there is nothing to draw on";
    view.setComparison(made());
    view.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view));
    view.grab();
    std::vector<std::pair<SurveyView::Draws, OutlineRing>> drawn;
    QObject::connect(&view, &SurveyView::drawn, &view,
                     [&](SurveyView::Draws what, const OutlineRing& ring) { drawn.emplace_back(what, ring); });
    const std::vector<Eigen::Vector2d> corners{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
    view.draw(SurveyView::Draws::LeftOut);
    for (const Eigen::Vector2d& corner : corners) {
        QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, view.toWidget(corner).toPoint());
    }
    QTest::keyClick(&view, Qt::Key_Backspace);
    QTest::mouseClick(&view, Qt::LeftButton, Qt::NoModifier, view.toWidget(corners.back()).toPoint());
    QTest::keyClick(&view, Qt::Key_Return);
    ASSERT_EQ(drawn.size(), 1u);
    EXPECT_EQ(drawn.front().first, SurveyView::Draws::LeftOut);
    ASSERT_EQ(drawn.front().second.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_LT((drawn.front().second[k] - corners[k]).norm(), 0.05) << "a pixel is about 2 cm";
    }
    EXPECT_FALSE(view.drawing());
    // Keys alone do the same.
    view.draw(SurveyView::Draws::Area);
    for (const int key : {Qt::Key_Space, Qt::Key_Right, Qt::Key_Space, Qt::Key_Down, Qt::Key_Space, Qt::Key_Enter}) {
        QTest::keyClick(&view, static_cast<Qt::Key>(key), Qt::ShiftModifier);
    }
    ASSERT_EQ(drawn.size(), 2u);
    EXPECT_EQ(drawn.back().second.size(), 3u);
    view.draw(SurveyView::Draws::Area);
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_FALSE(view.drawing());
    // What is compared is seen on the map.
    const QImage before = view.grab().toImage();
    SurveyScope scope;
    scope.leftOut.polygons = {{corners}};
    view.setScope(scope);
    EXPECT_NE(view.grab().toImage(), before);
}

TEST_F(SurveyForm, WhatIsNotKnownIsSaidInWordsAndWhatIsNotCountedWithItsVolume) {
    // Ten centimetres over half of it, which may be noise, and no debris at all.
    Survey survey;
    survey.heights.x0 = survey.heights.y0 = -9.75;
    survey.heights.dx = survey.heights.dy = 0.5;
    survey.heights.nx = survey.heights.ny = 40;
    for (std::size_t k = 0; k < 1600; ++k) {
        survey.heights.heights.push_back(k < 800 ? 0.1 : -0.05);
    }
    SurveySettings settings;
    settings.noise = settings.groundNoise = 0.1;
    content.comparison = std::make_shared<SurveyComparison>(
        compareWithSurvey(PieceRaster(), survey, SiteSurface(), Eigen::Vector2d::Zero(), settings, Execution()));
    box.setContent(content);
    EXPECT_TRUE(says(QStringLiteral("Neither side has debris")));
    EXPECT_TRUE(says(QStringLiteral("Below it also lie fill 20.0, cut 10.0, net 10.0 m³, which are not counted.")));
    EXPECT_FALSE(says(QStringLiteral("nan")));
    EXPECT_FALSE(says(QStringLiteral("Heights differ")));
    survey = Survey();
    survey.isFootprint = true;
    survey.footprint.polygons = {{{{-2.0, -2.0}, {4.0, -2.0}, {4.0, 2.0}, {-2.0, 2.0}}}};
    content.comparison = std::make_shared<SurveyComparison>(
        compareWithSurvey(PieceRaster(), survey, SiteSurface(), Eigen::Vector2d::Zero(), settings, Execution()));
    box.setContent(content);
    EXPECT_TRUE(says(QStringLiteral("How far centroids lie apart is not known: one side has no debris.")));
}

TEST_F(SurveyForm, AComparisonStandsInTablesAndWords) {
    content.comparison = made();
    box.setContent(content);
    const auto tables = box.findChildren<QTableWidget*>();
    ASSERT_EQ(tables.size(), 2);
    EXPECT_EQ(tables[0]->item(0, 1)->text(), QStringLiteral("24"));
    EXPECT_EQ(tables[0]->item(0, 2)->text(), QStringLiteral("16"));
    EXPECT_EQ(tables[0]->rowCount(), 3) << "an outline has no volume";
    EXPECT_EQ(tables[1]->rowCount(), 8);
    EXPECT_TRUE(says(QStringLiteral("(IoU): 0.667")));
    EXPECT_TRUE(says(QStringLiteral("The survey lies where it was surveyed")));
    EXPECT_FALSE(says(QStringLiteral("compare again")));
    QSignalSpy saved(&box, &SurveyBox::saveRequested);
    QTest::mouseClick(button(QStringLiteral("Save difference map…")), Qt::LeftButton);
    EXPECT_EQ(saved.count(), 1);
    content.stale = true;
    box.setContent(content);
    EXPECT_TRUE(says(QStringLiteral("compare again")));
    for (const auto* table : tables) {
        // Nothing is clipped: the last row ends above the foot of the table.
        const QRect last = table->visualItemRect(table->item(table->rowCount() - 1, 0));
        EXPECT_LE(last.bottom(), table->viewport()->height());
    }
}

TEST_F(SurveyForm, TheDifferenceMapIsDrawnInBothThemes) {
    SurveyView view;
    view.resize(600, 500);
    const QImage empty = view.grab().toImage();
    view.setComparison(made());
    const QImage map = view.grab().toImage();
    EXPECT_NE(map, empty);
    // Surveyed only and covered on both sides are areas of their own colours; 8 and 16 of 24 m2.
    std::map<QRgb, int> areas;
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            ++areas[map.pixel(x, y)];
        }
    }
    int large = 0;
    for (const auto& [colour, count] : areas) {
        large += count > map.width() * map.height() / 60;
    }
    EXPECT_GE(large, 3);
}

}  // namespace
}  // namespace rubble::widgets
