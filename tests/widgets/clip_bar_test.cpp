#include "widgets/views/clip_bar.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLineEdit>
#include <QSlider>
#include <QTest>
#include <QToolButton>

namespace rubble::widgets {
namespace {

class Cut : public testing::Test {
protected:
    void SetUp() override {
        bar.setBounds(Aabb(Vec3(-10, 0, 0), Vec3(30, 8, 20)), Vec3(100, 0, 50));
        QObject::connect(&bar, &ClipBar::planeChanged, &bar, [this](const render::ClipPlane& plane) { told.push_back(plane); });
        bar.show();
    }
    ClipBar bar;
    std::vector<render::ClipPlane> told;
};

TEST_F(Cut, BeginsInTheMiddleAcrossX) {
    ASSERT_TRUE(bar.plane());
    EXPECT_EQ(bar.plane()->point, Vec3(10, 4, 10));
    EXPECT_EQ(bar.plane()->normal, Vec3(1, 0, 0));
    EXPECT_EQ(bar.findChild<QLineEdit*>()->text(), QStringLiteral("110.00")) << "as the file counts";
}

TEST_F(Cut, FollowsSliderNumberAndKeys) {
    auto* slider = bar.findChild<QSlider*>();
    slider->setValue(0);
    ASSERT_FALSE(told.empty());
    EXPECT_NEAR(told.back().point.x(), -10.0, 1e-9);
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_End);
    EXPECT_NEAR(told.back().point.x(), 30.0, 1e-9);
    auto* field = bar.findChild<QLineEdit*>();
    field->setText(QStringLiteral("105"));
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_NEAR(told.back().point.x(), 5.0, 1e-9);
    const std::size_t before = told.size();
    field->setText(QStringLiteral("there"));
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_EQ(told.size(), before);
    EXPECT_EQ(field->text(), QStringLiteral("105.00")) << "what is no number gives way to what holds";
}

TEST_F(Cut, AxisSideAndFreeDirection) {
    auto* direction = bar.findChild<QComboBox*>();
    direction->setFocus();
    QTest::keyClick(direction, Qt::Key_Down);
    QTest::keyClick(direction, Qt::Key_Down);
    ASSERT_FALSE(told.empty());
    EXPECT_EQ(told.back().normal, Vec3(0, 0, 1));
    EXPECT_EQ(bar.findChild<QLineEdit*>()->text(), QStringLiteral("60.00"));
    for (QToolButton* button : bar.findChildren<QToolButton*>()) {
        if (button->text() == QStringLiteral("Other side")) {
            button->click();
        }
    }
    EXPECT_EQ(told.back().normal, Vec3(0, 0, -1));
    EXPECT_EQ(bar.findChild<QLineEdit*>()->text(), QStringLiteral("60.00")) << "the place is the same from both sides";
    bool asked = false;
    QObject::connect(&bar, &ClipBar::viewDirectionRequested, &bar, [&] { asked = true; });
    QTest::keyClick(direction, Qt::Key_Down);
    EXPECT_TRUE(asked);
    const Vec3 slanted = Vec3(1, 1, 0).normalized();
    bar.setPlane({Vec3(10, 4, 10), slanted});
    EXPECT_EQ(direction->currentIndex(), 3);
    bar.findChild<QSlider*>()->setValue(1000);
    EXPECT_NEAR(told.back().point.dot(slanted), Vec3(30, 8, 0).dot(slanted), 1e-9) << "to the last corner of the model";
}

}  // namespace
}  // namespace rubble::widgets
