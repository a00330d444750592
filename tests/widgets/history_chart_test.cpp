#include "widgets/views/history_chart.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "widgets/basics/theme.h"
#include "widgets/views/history_panel.h"

namespace rubble::widgets {
namespace {

/// A body of 2 t that falls from 20 m for 2 s of a timeline of 4 s.
HistoryChart::Content fall() {
    HistoryChart::Content content;
    content.from = 1.0;
    content.to = 5.0;
    content.subject = QStringLiteral("Fragment 7");
    for (int k = 0; k <= 20; ++k) {
        const double t = 0.1 * k;
        HistoryPoint point;
        point.time = 2.0 + t;
        point.fragments = 1;
        point.mass = 2000.0;
        point.speed = point.topSpeed = 10.0 * t;
        point.height = 20.0 - 5.0 * t * t;
        point.kinetic = 0.5 * point.mass * point.speed * point.speed;
        point.potential = point.mass * 10.0 * point.height;
        content.points.push_back(point);
    }
    return content;
}

class Chart : public testing::Test {
protected:
    void SetUp() override {
        panel.resize(520, 460);
        panel.setContent(fall(), {}, false);
        panel.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    }
    /// Pixels of a colour in a column of the chart.
    int pixels(int x, const QColor& colour) {
        const QImage picture = panel.chart().grab().toImage();
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            count += picture.pixelColor(x, y) == colour ? 1 : 0;
        }
        return count;
    }
    HistoryPanel panel;
};

TEST_F(Chart, TheInstantOfTheTimelineIsALineThroughAllFields) {
    panel.setTime(3.0);
    const int x = static_cast<int>(std::lround(panel.chart().placeOf(3.0)));
    EXPECT_GT(pixels(x, tints().accent) + pixels(x - 1, tints().accent) + pixels(x + 1, tints().accent),
              panel.chart().height() / 2);
    panel.setTime(4.9);
    EXPECT_EQ(pixels(x, tints().accent), 0);
}

TEST_F(Chart, ItTellsTheFiguresOfTheInstant) {
    panel.setTime(1.5);
    EXPECT_EQ(panel.words(), QStringLiteral("None of them is on its way yet."));
    panel.setTime(3.04);
    EXPECT_EQ(panel.words().replace(QChar::Nbsp, u' '),
              QStringLiteral("3.00 s: 2.00 t of fragments, 10.0 m/s in the mean, 10.0 m/s the fastest; at 15.0 m; kinetic 100 kJ, "
                             "potential 300 kJ"));
}

TEST_F(Chart, AClickAndADragAskForTheirInstants) {
    QSignalSpy asked(&panel.chart(), &HistoryChart::timeRequested);
    const auto at = [&](double time) { return QPoint(static_cast<int>(std::lround(panel.chart().placeOf(time))), 60); };
    QTest::mouseClick(&panel.chart(), Qt::LeftButton, {}, at(2.0));
    ASSERT_EQ(asked.size(), 1);
    EXPECT_NEAR(asked[0][0].toDouble(), 2.0, 0.02);
    QTest::mousePress(&panel.chart(), Qt::LeftButton, {}, at(2.0));
    QMouseEvent move(QEvent::MouseMove, QPointF(at(4.0)), panel.chart().mapToGlobal(QPointF(at(4.0))), Qt::NoButton, Qt::LeftButton,
                     {});
    QApplication::sendEvent(&panel.chart(), &move);
    EXPECT_NEAR(asked.back()[0].toDouble(), 4.0, 0.02);
    QTest::mouseRelease(&panel.chart(), Qt::LeftButton, {}, QPoint(-500, 60));
}

TEST_F(Chart, WithoutCurvesItSaysWhyAndSavesNothing) {
    panel.setContent({}, QStringLiteral("Simulate first."), false);
    EXPECT_FALSE(panel.chart().isVisible());
    for (const char* name : {"saveHistoryTable", "saveHistoryChart"}) {
        EXPECT_FALSE(panel.findChild<QPushButton*>(QLatin1String(name))->isEnabled());
    }
    panel.setContent(fall(), {}, false);
    QSignalSpy saved(&panel, &HistoryPanel::saveTableRequested);
    QTest::mouseClick(panel.findChild<QPushButton*>(QStringLiteral("saveHistoryTable")), Qt::LeftButton);
    EXPECT_EQ(saved.size(), 1);
}

TEST_F(Chart, ItIsDrawnForFilesToo) {
    EXPECT_GT(panel.chart().svg(QSize(960, 640)).size(), 3000);
    HistoryChart::Content two = fall();
    two.subject = QStringLiteral("Fragment 7 & 8");
    panel.setContent(two, {}, false);
    EXPECT_TRUE(panel.chart().svg(QSize(960, 640)).contains("<title>History of Fragment 7 &amp; 8</title>"));
    EXPECT_EQ(panel.chart().image(QSize(960, 640)).size(), QSize(960, 640));
}

}  // namespace
}  // namespace rubble::widgets
