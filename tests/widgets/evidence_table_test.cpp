#include "widgets/evidence/evidence_table.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTest>

#include "widgets/basics/number_field.h"
#include "widgets/basics/theme.h"
#include "widgets/evidence/survey_place.h"

namespace rubble::widgets {

namespace {

std::vector<EvidenceRow> threeRows() {
    EvidenceRow cloud{"survey-1", EvidenceForm::Cloud, "scans/site.laz", {}, {"evidence.at_rest", "the debris at rest", {}}};
    cloud.within = 0.04;
    cloud.score = 0.75;
    const EvidenceRow photograph{
        "photograph-1", EvidenceForm::Photograph, "a.jpg", {}, {"evidence.at", "the debris at {0}", {{2.5, "s"}}}};
    const EvidenceRow points{
        {}, EvidenceForm::Points, {}, {}, {"evidence.points", "where the case lies: {0} of {1} control points are used", {2, 3}}};
    return {cloud, photograph, points};
}

TEST(EvidenceTable, ListsWhatEachShowsHowWellItLiesAndItsScore) {
    EvidenceTable table;
    EXPECT_TRUE(table.isHidden()) << "nothing is listed of a case without evidence";
    table.setRows(threeRows());
    ASSERT_EQ(table.rowCount(), 3);
    EXPECT_EQ(table.item(0, 0)->text(), QStringLiteral("site.laz"));
    EXPECT_EQ(table.item(0, 1)->text(), QStringLiteral("the debris at rest"));
    EXPECT_EQ(table.item(0, 2)->text(), QStringLiteral("0.0400"));
    EXPECT_EQ(table.item(0, 3)->text(), QStringLiteral("0.750"));
    EXPECT_EQ(table.item(1, 1)->text(), QStringLiteral("the debris at 2.500\u00a0s"));
    EXPECT_EQ(table.item(1, 2)->text(), QStringLiteral("not known")) << "what nobody knows is never 0";
    EXPECT_EQ(table.item(2, 0)->text(), QStringLiteral("control points"));
}

TEST(EvidenceTable, TellsWhichWasChosenByAPersonAlone) {
    EvidenceTable table;
    QStringList told;
    QObject::connect(&table, &EvidenceTable::chosen, &table, [&](const QString& id) { told << id; });
    table.setRows(threeRows());
    table.setCurrentCell(1, 0);
    table.setRows(threeRows());
    EXPECT_EQ(told, QStringList{QStringLiteral("photograph-1")});
    EXPECT_EQ(table.currentRow(), 1);
}

/// Each row is as high as the words of its columns need.
void expectWholeWords(const EvidenceTable& table) {
    for (int row = 0; row < table.rowCount(); ++row) {
        for (const int column : {0, 1}) {
            const QRect room(0, 0, table.columnWidth(column) - 16, 1000);
            const QRect needed = table.fontMetrics().boundingRect(room, Qt::TextWordWrap, table.item(row, column)->text());
            EXPECT_LE(needed.height(), table.rowHeight(row)) << row << ", " << column;
        }
    }
}

TEST(EvidenceTable, WordsStayWholeWhereAnotherColumnWidens) {
    std::vector<EvidenceRow> rows = threeRows();
    EvidenceTable table;
    table.setRows(rows);
    table.resize(330, table.height());
    table.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&table));
    const int wide = table.columnWidth(1);
    rows[0].unread = {"cloud.empty", "{0} is empty", {"site.laz"}};
    table.setRows(rows);
    ASSERT_TRUE(QTest::qWaitFor([&] { return table.columnWidth(1) < wide; }));
    expectWholeWords(table);
}

TEST(EvidenceTable, WhatIsTooLongTakesASecondLineAndNamesKeepBothEnds) {
    std::vector<EvidenceRow> rows = threeRows();
    rows[0].path = "scans/north-abutment-2026-11-24-registered.laz";
    EvidenceTable table;
    table.setRows(rows);
    // As wide as in the narrowest panel.
    table.resize(270, table.height());
    table.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&table));
    EXPECT_EQ(table.textElideMode(), Qt::ElideMiddle);
    EXPECT_TRUE(table.item(0, 1)->toolTip().contains(QStringLiteral("north-abutment-2026-11-24-registered.laz")));
    EXPECT_GT(table.columnWidth(0), 60);
    EXPECT_FALSE(table.horizontalScrollBar()->isVisible());
    int height = table.horizontalHeader()->height();
    for (int row = 0; row < table.rowCount(); ++row) {
        height += table.rowHeight(row);
    }
    expectWholeWords(table);
    EXPECT_GE(table.height(), height) << "all three rows are seen";
}

TEST(EvidenceTable, OneThatThisProgramMadeIsMarked) {
    std::vector<EvidenceRow> rows = threeRows();
    rows[0].ours = true;
    EvidenceTable table;
    table.setRows(rows);
    EXPECT_EQ(table.item(0, 1)->foreground().color(), tints().finding);
    EXPECT_NE(table.item(1, 1)->foreground().color(), tints().finding);
}

TEST(EvidenceTable, WhatMeasuredPointsSayIsChosenInTheirRow) {
    std::vector<EvidenceRow> rows = threeRows();
    EvidenceRow measured{"survey-2", EvidenceForm::Measured, "station.csv", {}, {"evidence.measured", "measured heights", {}}};
    measured.held = PointsHeld::Section;
    rows.insert(rows.begin() + 1, measured);
    EvidenceTable table;
    table.setRows(rows);
    table.resize(270, table.height());
    table.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&table));
    auto* choice = qobject_cast<QComboBox*>(table.cellWidget(1, 1));
    ASSERT_NE(choice, nullptr);
    EXPECT_EQ(table.cellWidget(0, 1), nullptr) << "what a cloud shows is not chosen";
    EXPECT_EQ(choice->currentText(), QStringLiteral("sections"));
    EXPECT_GE(table.rowHeight(1), choice->sizeHint().height());
    std::vector<std::pair<QString, PointsHeld>> told;
    QObject::connect(&table, &EvidenceTable::held, &table, [&](const QString& id, PointsHeld as) { told.emplace_back(id, as); });
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_Down);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_EQ(told[0], std::pair(QStringLiteral("survey-2"), PointsHeld::Outline));
    rows[1].held = PointsHeld::Control;
    table.setRows(rows);
    EXPECT_EQ(table.cellWidget(1, 1), choice) << "who uses it keeps it";
    EXPECT_EQ(choice->currentText(), QStringLiteral("control"));
    EXPECT_EQ(told.size(), 1u) << "only a person chooses";
    rows.erase(rows.begin() + 1);
    table.setRows(rows);
    EXPECT_EQ(table.cellWidget(1, 1), nullptr);
}

TEST(EvidenceTable, OneThatCannotBeReadSaysWhyAndAGuessSaysThatItIsOne) {
    std::vector<EvidenceRow> rows = threeRows();
    rows[0].unread = {"cloud.empty", "{0} is empty", {"site.laz"}};
    rows[0].byEnding = true;
    EvidenceTable table;
    table.setRows(rows);
    EXPECT_EQ(table.item(0, 2)->text(), QStringLiteral("unreadable"));
    EXPECT_TRUE(table.item(0, 0)->toolTip().contains(QStringLiteral("site.laz is empty")))
        << qPrintable(table.item(0, 0)->toolTip());
    EXPECT_TRUE(table.item(0, 0)->toolTip().contains(QStringLiteral("by the ending of its name")));
    EXPECT_FALSE(table.item(1, 0)->toolTip().contains(QStringLiteral("by the ending of its name")));
}

TEST(EvidenceTable, OneThatLiesElsewhereIsMarkedAndSaysWhy) {
    std::vector<EvidenceRow> rows = threeRows();
    rows[0].elsewhere = {
        "survey.far", "the survey lies {0} from the structure; debris of this site is not expected there", {{5200.0, "m"}}};
    EvidenceTable table;
    table.setRows(rows);
    EXPECT_EQ(table.item(0, 2)->text(), QStringLiteral("elsewhere"));
    EXPECT_TRUE(table.item(0, 0)->toolTip().contains(QStringLiteral("from the structure")));
    EXPECT_NE(table.item(1, 2)->text(), QStringLiteral("elsewhere"));
}

class PlaceOfSurvey : public testing::Test {
protected:
    SurveyPlace place;
    SurveyPlace::Stated told;
    int edits = 0;

    PlaceOfSurvey() {
        QObject::connect(&place, &SurveyPlace::edited, &place, [this](const SurveyPlace::Stated& stated) {
            told = stated;
            ++edits;
        });
        place.setStated({}, true);
        place.show();
    }
    void typeTime(const char* text) {
        auto* taken = place.findChild<QLineEdit*>();
        taken->setFocus();
        taken->selectAll();
        QTest::keyClicks(taken, QString::fromLatin1(text));
        QTest::keyClick(taken, Qt::Key_Return);
    }
};

TEST_F(PlaceOfSurvey, TimeIsTakenAsPeopleWriteItOrAskedAgain) {
    typeTime("2021-06-25");
    EXPECT_EQ(edits, 0) << "a day without a time does not say what was removed by then";
    typeTime("2021-06-25 16:30");
    EXPECT_EQ(edits, 1);
    EXPECT_EQ(told.taken, "2021-06-25 16:30:00");
    place.setStated(told, true);
    place.findChild<QLineEdit*>()->clear();
    QTest::keyClick(place.findChild<QLineEdit*>(), Qt::Key_Return);
    EXPECT_EQ(told.taken, "") << "not known again";
}

TEST_F(PlaceOfSurvey, OneOfBeforeTheCollapseShowsNoInstant) {
    auto* before = place.findChild<QCheckBox*>();
    before->click();
    EXPECT_TRUE(told.before);
    place.setStated(told, true);
    EXPECT_FALSE(place.findChild<NumberField*>()->isEnabled());
    EXPECT_EQ(edits, 1) << "what is shown is no edit";
}

TEST_F(PlaceOfSurvey, ARegistrationCanBeTakenOut) {
    QPushButton* unplace = nullptr;
    for (QPushButton* button : place.findChildren<QPushButton*>()) {
        if (button->text() == QStringLiteral("Unplace")) {
            unplace = button;
        }
    }
    ASSERT_NE(unplace, nullptr);
    EXPECT_FALSE(unplace->isEnabled());
    SurveyPlace::Stated stated;
    stated.registration.emplace().pairs = 4;
    place.setStated(stated, true);
    EXPECT_TRUE(unplace->isEnabled());
    bool asked = false;
    QObject::connect(&place, &SurveyPlace::unplaceRequested, &place, [&] { asked = true; });
    unplace->click();
    EXPECT_TRUE(asked);
}

}  // namespace

}  // namespace rubble::widgets
