#include "widgets/case/site_dialog.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>
#include <QStyleOptionViewItem>
#include <QTableWidget>
#include <QTest>
#include <array>

#include "widgets/basics/number_field.h"

namespace rubble::widgets {
namespace {

constexpr int offInPlan = 8;  // column

class SiteForm : public testing::Test {
protected:
    void SetUp() override {
        dialog.show();
        table = dialog.findChild<QTableWidget*>();
        ASSERT_NE(table, nullptr);
    }
    QPushButton* button(const QString& text) {
        for (auto* each : dialog.findChildren<QPushButton*>()) {
            if (each->text() == text) {
                return each;
            }
        }
        return nullptr;
    }
    void press(const QString& text) { QTest::mouseClick(button(text), Qt::LeftButton); }
    /// Types over a cell as a user does: F2, the text, Enter.
    void type(int row, int column, const QString& text) {
        table->setCurrentCell(row, column);
        table->setFocus();
        QTest::keyClick(table, Qt::Key_F2);
        auto* editor = table->viewport()->findChild<QLineEdit*>();
        ASSERT_NE(editor, nullptr) << row << ", " << column;
        editor->selectAll();
        QTest::keyClicks(editor, text);
        QTest::keyClick(editor, Qt::Key_Return);
        // What was typed is taken, and the editor goes, from the loop of events.
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    void use(int row) {
        const QRect cell = table->visualItemRect(table->item(row, 0));
        QStyleOptionViewItem option;
        option.initFrom(table);
        option.rect = cell;
        option.features = QStyleOptionViewItem::HasCheckIndicator;
        const QRect mark = table->style()->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &option, table);
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, mark.center());
    }
    QString cell(int row, int column) { return table->item(row, column)->text(); }
    bool says(const QString& words) {
        for (const auto* label : dialog.findChildren<QLabel*>()) {
            if (label->isVisible() && label->text().contains(words)) {
                return true;
            }
        }
        return false;
    }
    /// Points of a frame turned by a right angle and put to (1000, 2000, 50).
    void fillIn(int points) {
        constexpr std::array<std::array<double, 3>, 4> local{{{0, 0, 0}, {30, 0, 1}, {0, 20, 2}, {30, 20, 3}}};
        for (int i = 0; i < points; ++i) {
            press(QStringLiteral("Add control point"));
            const auto& [x, y, z] = local[static_cast<std::size_t>(i)];
            const std::array<double, 6> values{x, y, z, 1000.0 - y, 2000.0 + x, 50.0 + z};
            for (int c = 0; c < 6; ++c) {
                type(i, 2 + c, QString::number(values[static_cast<std::size_t>(c)]));
            }
            use(i);
        }
    }

    SiteDialog dialog;
    QTableWidget* table = nullptr;
};

TEST_F(SiteForm, PointsAreTypedAndTheirResidualsStandBesideThem) {
    dialog.setContent(Site(), QStringLiteral("EPSG:25832"));
    EXPECT_TRUE(says(QStringLiteral("The origin of the frame")));
    fillIn(4);
    ASSERT_EQ(dialog.site().controlPoints.size(), 4u);
    EXPECT_TRUE(dialog.site().controlPoints[3].used);
    EXPECT_EQ(dialog.site().controlPoints[2].world, Vec3(980.0, 2000.0, 52.0));
    EXPECT_TRUE(says(QStringLiteral("turned by 90.000°"))) << "the frame is turned";
    for (int row = 0; row < 4; ++row) {
        EXPECT_EQ(cell(row, offInPlan), QStringLiteral("0.000"));
    }
    // A wrong point shows; left out it stands apart from the others, which fit again.
    type(1, 5, QStringLiteral("1004"));
    EXPECT_GT(cell(1, offInPlan).toDouble(), 1.0);
    use(1);
    EXPECT_FALSE(dialog.site().controlPoints[1].used);
    EXPECT_EQ(cell(0, offInPlan), QStringLiteral("0.000"));
    EXPECT_EQ(cell(1, offInPlan), QStringLiteral("4.000"));
    EXPECT_EQ(dialog.crs(), QStringLiteral("EPSG:25832"));
}

TEST_F(SiteForm, WhatIsNoCoordinateIsRefusedInPlace) {
    dialog.setContent(Site(), {});
    fillIn(2);
    EXPECT_TRUE(says(QStringLiteral("Two points always fit")));
    for (const char* wrong : {"here", "1e99", "nan"}) {
        type(0, 2, QString::fromLatin1(wrong));
        EXPECT_TRUE(says(QStringLiteral("no coordinate in metres"))) << wrong;
        EXPECT_EQ(cell(0, 2), QStringLiteral("0.000"));
    }
    EXPECT_EQ(dialog.site().controlPoints[0].local.x(), 0.0);
    // Both in one place: said, not crashed.
    for (const int c : {2, 3, 4}) {
        type(1, c, QStringLiteral("0"));
    }
    EXPECT_FALSE(says(QStringLiteral("Least squares")));
    table->setCurrentCell(1, 1);
    press(QStringLiteral("Delete"));
    EXPECT_EQ(dialog.site().controlPoints.size(), 1u);
    EXPECT_TRUE(says(QStringLiteral("One control point says nothing yet")));
}

TEST_F(SiteForm, SurroundingsAreFallenOnOnlyWhereThereAreSome) {
    dialog.setContent(Site(), {});
    auto* collide = dialog.findChild<QCheckBox*>();
    ASSERT_NE(collide, nullptr);
    EXPECT_FALSE(collide->isEnabled());
    dialog.setContent(Site(), {}, {{QStringLiteral("house.obj"), {}}, {QStringLiteral("wall.ply"), {}}});
    EXPECT_TRUE(collide->isEnabled());
    collide->setFocus();
    QTest::keyClick(collide, Qt::Key_Space);
    EXPECT_TRUE(dialog.site().collide);
    auto* shift = dialog.findChild<NumberField*>();
    shift->setFocus();
    shift->selectAll();
    QTest::keyClicks(shift, QStringLiteral("-43.7"));
    QTest::keyClick(shift, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(dialog.site().heightShift, -43.7);
}

TEST_F(SiteForm, OffsetsOfMeshesAreTypedAndTakenBack) {
    dialog.setContent(Site(), {}, {{QStringLiteral("house.obj"), {}}, {QStringLiteral("wall.ply"), Vec3(1.0, 2.0, 3.0)}});
    QTableWidget* offsets = dialog.findChildren<QTableWidget*>().back();
    ASSERT_NE(offsets, table);
    ASSERT_EQ(offsets->rowCount(), 2);
    EXPECT_TRUE(offsets->item(0, 1)->text().isEmpty()) << "as a file beside it says";
    offsets->item(0, 1)->setText(QStringLiteral("356500"));
    offsets->item(0, 2)->setText(QStringLiteral("5699500.5"));
    EXPECT_EQ(dialog.surroundings()[0].offset, Vec3(356500.0, 5699500.5, 0.0));
    offsets->item(0, 3)->setText(QStringLiteral("high"));
    EXPECT_TRUE(says(QStringLiteral("no offset in metres")));
    EXPECT_EQ(dialog.surroundings()[0].offset, Vec3(356500.0, 5699500.5, 0.0));
    for (const int c : {1, 2, 3}) {
        offsets->item(1, c)->setText({});
    }
    EXPECT_FALSE(dialog.surroundings()[1].offset);
    dialog.setContent(Site(), {});
    EXPECT_FALSE(offsets->isVisible());
}

TEST_F(SiteForm, WhatSpeaksAgainstAPlaceIsShown) {
    dialog.setContent(Site(), {});
    std::string asked;
    dialog.setCheck([&](const Site&, const std::string& crs) {
        asked = crs;
        Findings findings;
        findings.add({"site.swapped", "the place is odd", {}}, {"site.swapped.remedy", "look at it", {}});
        return findings;
    });
    EXPECT_TRUE(says(QStringLiteral("the place is odd")));
    auto* crs = dialog.findChild<QLineEdit*>();
    crs->setFocus();
    crs->selectAll();
    QTest::keyClicks(crs, QStringLiteral("EPSG:2263"));
    // As when the field is left; a window that is not active has no focus to lose.
    emit crs->editingFinished();
    EXPECT_EQ(asked, "EPSG:2263");
}

TEST_F(SiteForm, ClassesOfTheGroundAreTypedAndWhatIsNoneIsNotTaken) {
    Site site;
    site.groundClasses = {2, 9};
    dialog.setContent(site, {});
    QLineEdit* classes = nullptr;
    for (auto* each : dialog.findChildren<QLineEdit*>()) {
        classes = each->accessibleName() == QStringLiteral("Ground classes") ? each : classes;
    }
    ASSERT_NE(classes, nullptr);
    EXPECT_EQ(classes->text(), QStringLiteral("2,9"));
    const auto typed = [&](const QString& text) {
        classes->selectAll();
        QTest::keyClicks(classes, text);
        emit classes->editingFinished();
        return dialog.site().groundClasses;
    };
    const std::vector<std::uint16_t> other{8, 2};
    EXPECT_EQ(typed(QStringLiteral("8, 2")), other);
    EXPECT_EQ(typed(QStringLiteral("8,256")), other);
    EXPECT_EQ(classes->text(), QStringLiteral("8,2")) << "it says what counts";
    EXPECT_EQ(typed(QStringLiteral("road")), other);
}

TEST_F(SiteForm, EnterTakesWhatWasTypedAndEscapeNothing) {
    dialog.setContent(Site(), {});
    press(QStringLiteral("Add control point"));
    auto* shift = dialog.findChild<NumberField*>();
    shift->setFocus();
    shift->selectAll();
    QTest::keyClicks(shift, QStringLiteral("12.5"));
    QTest::keyClick(shift, Qt::Key_Return);
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
    EXPECT_DOUBLE_EQ(dialog.site().heightShift, 12.5);
    EXPECT_EQ(dialog.site().controlPoints.size(), 1u) << "Enter presses OK, not the buttons of the table";
    dialog.show();
    QTest::keyClick(&dialog, Qt::Key_Escape);
    EXPECT_EQ(dialog.result(), QDialog::Rejected);
}

TEST_F(SiteForm, TellsHowTheTerrainWasReadWhereGroundClassesAreChosen) {
    const auto shown = [&] {
        QString all;
        for (const auto* label : dialog.findChildren<QLabel*>()) {
            all += label->isVisibleTo(&dialog) ? label->text() : QString();
        }
        return all;
    };
    dialog.setTerrain({});
    EXPECT_FALSE(shown().contains(QStringLiteral("as it was read")));
    Findings found;
    found.add({"cloud.gridded",
               "{0} points were laid on cells of {1}, {2} to a cell in the median; {3} % of the cells have none",
               {26'107, {0.62, "m"}, 2, 12.5}},
              {"r", "r", {}});
    found.add({"terrain.spikes", "one that is told elsewhere", {}}, {"r", "r", {}});
    found.add({"terrain.filled", "{0} of {1} places of the terrain had no height and were filled from their neighbours", {40, 900}},
              {"r", "r", {}}, "", 40);
    dialog.setTerrain(found);
    EXPECT_TRUE(shown().contains(QStringLiteral("26,107 points were laid on cells of 0.620"))) << qPrintable(shown());
    EXPECT_TRUE(shown().contains(QStringLiteral("40 of 900 places"))) << qPrintable(shown());
    EXPECT_FALSE(shown().contains(QStringLiteral("told elsewhere")));
}

}  // namespace
}  // namespace rubble::widgets
