#include "widgets/views/select_form.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include "widgets/basics/unit_label.h"
#include "widgets/figures/number_text.h"

namespace rubble::widgets {
namespace {

class Form : public testing::Test {
protected:
    void SetUp() override {
        form.setComponents({"deck", "pier"});
        QObject::connect(&form, &SelectForm::selectRequested, &form, [this](const auto& criteria) { asked.push_back(criteria); });
        form.show();
    }
    void type(const QString& name, const QString& text) {
        for (QLineEdit* field : form.findChildren<QLineEdit*>()) {
            if (field->accessibleName() == name) {
                field->setText(text);
            }
        }
    }
    void press(const QString& text) {
        for (QPushButton* each : form.findChildren<QPushButton*>()) {
            if (each->text() == text) {
                QTest::mouseClick(each, Qt::LeftButton);
            }
        }
    }
    bool says(const QString& text) const {
        for (const QLabel* label : form.findChildren<QLabel*>()) {
            if (label->text().contains(text)) {
                return true;
            }
        }
        return false;
    }

    SelectForm form;
    std::vector<SelectForm::Criteria> asked;
};

TEST_F(Form, GivesWhatWasTypedAndNothingElse) {
    form.findChild<QComboBox*>()->setCurrentIndex(2);
    type("Born from", "1.5");
    type("x to", "-3");
    press("Add");
    ASSERT_EQ(asked.size(), 1U);
    EXPECT_EQ(asked[0].how, SelectForm::How::Add);
    EXPECT_EQ(asked[0].component, "pier");
    EXPECT_EQ(asked[0].bornFrom, 1.5);
    EXPECT_FALSE(asked[0].bornTo);
    EXPECT_EQ(asked[0].high[0], -3.0);
    EXPECT_FALSE(asked[0].low[0]);
    EXPECT_FALSE(asked[0].cluster);
    form.setFound(0);
    EXPECT_TRUE(says("Nothing fits"));
}

TEST_F(Form, ForgetsTimesThatWereTypedInOtherUnits) {
    figures::setResultSpan(70e-6);
    type("Born to", "70");
    type("x to", "-3");
    EXPECT_NEAR(form.criteria().bornTo.value_or(0.0), 70e-6, 1e-12);
    figures::setResultSpan(0.0);
    tellUnitsChanged();
    EXPECT_FALSE(form.criteria().bornTo) << "not 70 s";
    EXPECT_EQ(form.criteria().high[0], -3.0);
}

TEST_F(Form, RefusesWhatIsNoNumberAndAsksForSomething) {
    press("Select");
    EXPECT_TRUE(says("at least one"));
    type("Born from", "soon");
    press("Select");
    EXPECT_TRUE(says("soon"));
    type("Born from", "");
    type("Cluster", "2.5");
    press("Select");
    EXPECT_TRUE(says("whole number"));
    EXPECT_TRUE(asked.empty());
    type("Cluster", "25");
    press("Take out");
    ASSERT_EQ(asked.size(), 1U);
    EXPECT_EQ(asked[0].cluster, std::size_t{25});
    EXPECT_EQ(asked[0].how, SelectForm::How::Remove);
}

}  // namespace
}  // namespace rubble::widgets
