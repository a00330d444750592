#include "widgets/figures/shown_units.h"

#include <gtest/gtest.h>

#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include "widgets/basics/number_field.h"
#include "widgets/basics/parameter_editor.h"
#include "widgets/basics/unit_label.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/number_text.h"

namespace rubble::widgets {

namespace {

using figures::UnitSet;

class ShownUnits : public testing::Test {
protected:
    ~ShownUnits() override {
        figures::chooseUnits(UnitSet::Si);
        figures::setResultSpan(0.0);
    }
};

// Factors against the definitions: 1 ft = 0.3048 m, 1 lb = 0.45359237 kg, 1 psi = 6894.757 Pa.
TEST_F(ShownUnits, AreWhatTheyAreDefinedAs) {
    figures::chooseUnits(UnitSet::UsCustomary);
    EXPECT_NEAR(figures::shownUnit("m").perSi * 0.3048, 1.0, 1e-12);
    EXPECT_NEAR(figures::shownUnit("kg").perSi * 0.45359237, 1.0, 1e-12);
    EXPECT_NEAR(figures::shownUnit("Pa").perSi * 6894.757293168, 1.0, 1e-9);
    EXPECT_NEAR(figures::shownUnit("kg/m3").perSi * 16.018463373960, 1.0, 1e-9);
    EXPECT_NEAR(figures::shownUnit("J").perSi * 1.3558179483314, 1.0, 1e-9);
    EXPECT_EQ(figures::shownUnit("s").name, QStringLiteral("s"));
    figures::chooseUnits(UnitSet::MillimetreTonne);
    EXPECT_EQ(shownLength(1.234), QStringLiteral("1,230\u00A0mm"));
    EXPECT_EQ(shownPlace(1.2345), QStringLiteral("1,235"));
    EXPECT_DOUBLE_EQ(typedIn(2.5e-9, "kg/m3"), 2500.0);
}

TEST_F(ShownUnits, NeverReachFiles) {
    figures::chooseUnits(UnitSet::UsCustomary);
    const figures::FileUnits file;
    EXPECT_EQ(figures::shownUnit("m").name, QStringLiteral("m"));
    EXPECT_EQ(figures::shownUnit("m").perSi, 1.0);
}

TEST_F(ShownUnits, AreTypedInASetting) {
    ParameterEditor editor(*findParameter("ground_height").first);
    UnitLabel unit(QStringLiteral("m"));
    editor.setValue(3.048);
    auto* field = editor.findChild<QLineEdit*>();
    EXPECT_EQ(field->text(), QStringLiteral("3.048"));
    figures::chooseUnits(UnitSet::UsCustomary);
    tellUnitsChanged();
    EXPECT_EQ(field->text(), QStringLiteral("10"));
    EXPECT_EQ(unit.text(), QStringLiteral("ft"));
    QSignalSpy edited(&editor, &ParameterEditor::edited);
    field->setFocus();
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_EQ(edited.count(), 0) << "a number that was left alone keeps its value to the bit";
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("20"));
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_EQ(edited.count(), 1);
    EXPECT_NEAR(std::get<double>(editor.value()), 6.096, 1e-12);
}

TEST_F(ShownUnits, OfNoTimeAreThoseOfTheTimeThatIsDelivered) {
    figures::setResultSpan(70e-6);
    ParameterEditor editor(*findParameter("settle_time").first);
    QSignalSpy unit(&editor, &ParameterEditor::unitShown);
    editor.setValue(10.0);
    auto* field = editor.findChild<QLineEdit*>();
    for (const double seconds : {0.0, 10.0}) {
        field->selectAll();
        QTest::keyClicks(field, QString::number(seconds));
        QTest::keyClick(field, Qt::Key_Return);
        EXPECT_DOUBLE_EQ(std::get<double>(editor.value()), seconds);
        EXPECT_EQ(unit.last().front().toString(), QStringLiteral("s"));
    }
    ParameterEditor automatic(*findParameter("overlap_time").first);
    automatic.setValue({});
    auto* typed = automatic.findChild<QLineEdit*>();
    QTest::keyClicks(typed, QStringLiteral("0.5"));
    QTest::keyClick(typed, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(std::get<double>(automatic.value()), 0.5) << "nothing is predicted yet";
}

// The list of paces and the movie itself tell a pace alike.
TEST_F(ShownUnits, OfAPaceAreThoseOfABriefResult) {
    EXPECT_EQ(figures::paceText(0.01), QStringLiteral("0.01 ×"));
    figures::setResultSpan(0.05);
    EXPECT_EQ(figures::paceText(0.01), QStringLiteral("10 ms/s"));
    EXPECT_EQ(figures::paceText(0.1), QStringLiteral("100 ms/s"));
    EXPECT_EQ(figures::paceText(0.25), QStringLiteral("0.25 ×"));
    EXPECT_TRUE(figures::paceIsTime(0.1));
    EXPECT_FALSE(figures::paceIsTime(0.25));
    figures::setResultSpan(70e-6);
    EXPECT_EQ(figures::paceText(1e-5), QStringLiteral("10 µs/s"));
    EXPECT_EQ(figures::paceText(0.05), QStringLiteral("50 ms/s"));
}

TEST_F(ShownUnits, AreTypedInAField) {
    NumberField field(QStringLiteral("x"));
    field.setUnit("m");
    field.setNumber(1.0);
    figures::chooseUnits(UnitSet::MillimetreTonne);
    tellUnitsChanged();
    EXPECT_EQ(field.text(), QStringLiteral("1000"));
    field.selectAll();
    QTest::keyClicks(&field, QStringLiteral("250"));
    QTest::keyClick(&field, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(field.number().value_or(0.0), 0.25);
}

}  // namespace
}  // namespace rubble::widgets
