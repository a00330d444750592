#include "widgets/accuracy/calibration_view.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSvgRenderer>
#include <QTest>
#include <cmath>

#include "core/analysis/accuracy/machine_load.h"
#include "core/analysis/accuracy/published_results.h"
#include "widgets/accuracy/calibration_chart.h"
#include "widgets/basics/theme.h"

namespace rubble::widgets {

namespace {

/// FPS that fall as a power of the bodies: 48,000 / n typically, half of it at worst; drawing at 1,200 / sqrt(n).
std::shared_ptr<Calibration> powerLaws() {
    auto calibration = std::make_shared<Calibration>();
    calibration->machine = "a machine";
    calibration->renderer = "a renderer";
    calibration->threads = 2;
    for (const std::int64_t n : {250, 500, 1000, 2000, 4000}) {
        const double physics = 48000.0 / static_cast<double>(n);
        const double drawing = 1200.0 / std::sqrt(static_cast<double>(n));
        const auto both = [drawing](double fps) { return 1.0 / (1.0 / fps + 1.0 / drawing); };
        calibration->points.push_back({PileKind::Typical, n, physics, drawing, both(physics)});
        calibration->points.push_back({PileKind::Worst, n, 0.5 * physics, drawing, both(0.5 * physics)});
    }
    calibration->complete = true;
    return calibration;
}

CalibrationView::Content contentOf(const std::shared_ptr<Calibration>& calibration, std::int64_t bodiesMax = 4500) {
    CalibrationView::Content content;
    content.calibration = calibration;
    content.plot = calibrationPlotContent(calibration.get(), 24.0);
    content.bodiesMax = bodiesMax;
    return content;
}

bool says(const QWidget& widget, const QString& text) {
    for (const QLabel* label : widget.findChildren<QLabel*>()) {
        if (!label->isHidden() && label->text().contains(text)) {
            return true;
        }
    }
    return false;
}

}  // namespace

TEST(CalibrationPlot, HoldsEveryMeasuredRateAndThePublishedOnes) {
    const auto calibration = powerLaws();
    const CalibrationPlotContent content = calibrationPlotContent(calibration.get(), 24.0);
    EXPECT_EQ(content.points.size(), 5u * 2u * 3u + publishedRates.size());
    EXPECT_EQ(content.curves.size(), 6u);
    for (const RateCurve& curve : content.curves) {
        ASSERT_GE(curve.places.size(), 10u);
        EXPECT_NEAR(curve.places.front().bodies, 250.0, 1e-9);
        EXPECT_NEAR(curve.places.back().bodies, 4000.0, 1e-6);
        for (const RateCurve::Place& place : curve.places) {
            const auto fps = calibration->fps(curve.pile, curve.load, place.bodies);
            EXPECT_EQ(place.fps.value, fps->value);
            EXPECT_LT(place.fps.low, place.fps.high);
        }
    }
    ASSERT_TRUE(content.bodiesMax[0].has_value());
    EXPECT_EQ(content.bodiesMax[0]->bodies, calibration->bodiesMax(PileKind::Typical, LiveLoad::Both, 24.0)->bodies);
    EXPECT_LT(content.bodiesMax[1]->bodies, content.bodiesMax[0]->bodies) << "the worst pile is slower";
    const CalibrationPlotContent none = calibrationPlotContent(nullptr, 24.0);
    EXPECT_EQ(none.points.size(), publishedRates.size());
    EXPECT_TRUE(none.curves.empty());
}

TEST(CalibrationPlot, BothAxesAreLogarithmic) {
    const CalibrationPlotContent content = calibrationPlotContent(powerLaws().get(), 24.0);
    const CalibrationPlot plot(content, QRectF(0, 0, 800, 600), headingFont(), figures::palette(render::Theme::Light));
    const double decade = plot.place(1000, 24).x() - plot.place(100, 24).x();
    EXPECT_GT(decade, 20.0);
    EXPECT_NEAR(plot.place(10000, 24).x() - plot.place(1000, 24).x(), decade, 1e-6);
    EXPECT_NEAR(plot.place(1000, 1).y() - plot.place(1000, 10).y(), plot.place(1000, 10).y() - plot.place(1000, 100).y(), 1e-6);
    for (const RatePoint& point : content.points) {
        EXPECT_TRUE(plot.frame().contains(plot.place(point.bodies, point.fps))) << point.bodies << ' ' << point.fps;
    }
    const RatePoint& figure7 = content.points[content.points.size() - 3];
    EXPECT_EQ(figure7.bodies, 4500.0);
    EXPECT_EQ(plot.pointAt(plot.place(4500.0, 24.0) + QPointF(3, 2)), content.points.size() - 3);
    EXPECT_TRUE(ratePointWords(figure7).contains(QStringLiteral("GTX 480")));
}

TEST(CalibrationChart, TellsItsPointsByMouseAndKeyboard) {
    applyTheme(render::Theme::Light);
    CalibrationChart chart;
    chart.resize(640, 440);
    chart.show();
    chart.setContent(calibrationPlotContent(powerLaws().get(), 24.0));
    QTest::mouseMove(&chart, chart.placeOf(0).toPoint());
    ASSERT_TRUE(chart.marked().has_value());
    EXPECT_EQ(chart.accessibleDescription(), ratePointWords(chart.content().points[*chart.marked()]));
    QTest::mouseMove(&chart, QPoint(1, 1));
    EXPECT_FALSE(chart.marked().has_value());
    QTest::keyClick(&chart, Qt::Key_Right);
    QTest::keyClick(&chart, Qt::Key_Right);
    EXPECT_EQ(chart.marked(), 1u);
    QTest::keyClick(&chart, Qt::Key_Left);
    EXPECT_EQ(chart.marked(), 0u);
    EXPECT_EQ(chart.image({960, 640}).pixelColor(1, 1), QColor(Qt::white));
    EXPECT_TRUE(QSvgRenderer(chart.svg({960, 640})).isValid());
    chart.setContent({});
    EXPECT_FALSE(chart.grab().isNull()) << "without any point";
}

TEST(CalibrationView, OffersTheBodiesThatTheMachineCarries) {
    CalibrationView view;
    view.setContent(contentOf(nullptr));
    EXPECT_TRUE(says(view, QStringLiteral("not calibrated yet")));
    auto* use = view.findChild<QPushButton*>(QStringLiteral("useBodies"));
    EXPECT_TRUE(use->isHidden());
    const CalibrationView::Content content = contentOf(powerLaws());
    view.setContent(content);
    EXPECT_FALSE(use->isHidden());
    EXPECT_TRUE(says(view, QStringLiteral("worst pile, both (live):")));
    QSignalSpy chosen(&view, &CalibrationView::bodiesChosen);
    use->click();
    ASSERT_EQ(chosen.count(), 1);
    const double offered = static_cast<double>(chosen.front().front().toLongLong());
    EXPECT_LE(offered, content.plot.bodiesMax[0]->bodies);
    EXPECT_GT(offered, 0.89 * content.plot.bodiesMax[0]->bodies) << "rounded down to two digits";
    view.setContent(contentOf(powerLaws(), static_cast<std::int64_t>(offered)));
    EXPECT_TRUE(use->isHidden()) << "the case has as many already";
}

TEST(CalibrationView, ADisturbedCalibrationOffersNothing) {
    auto calibration = powerLaws();
    calibration->othersShare = 2.0 * MachineLoad::quietBelow;
    calibration->findings.add({"calibration.disturbed", "Other programs worked", {}},
                              {"calibration.disturbed.remedy", "Again", {}});
    CalibrationView view;
    view.setContent(contentOf(calibration));
    EXPECT_TRUE(view.findChild<QPushButton*>(QStringLiteral("useBodies"))->isHidden());
    EXPECT_TRUE(says(view, QStringLiteral("Other programs worked")));
}

TEST(CalibrationView, ShowsCancelWhileItMeasures) {
    CalibrationView view;
    CalibrationView::Content content = contentOf(nullptr);
    content.running = true;
    view.setContent(content);
    auto* cancel = view.findChild<QPushButton*>(QStringLiteral("cancelCalibration"));
    auto* start = view.findChild<QPushButton*>(QStringLiteral("primary"));
    EXPECT_FALSE(cancel->isHidden());
    EXPECT_TRUE(start->isHidden());
    view.setProgress(0.5, 90.0);
    EXPECT_TRUE(says(view, QStringLiteral("left")));
    content.running = false;
    content.why = QStringLiteral("A run is being simulated.");
    view.setContent(content);
    EXPECT_FALSE(start->isEnabled());
    EXPECT_TRUE(says(view, content.why));
}

}  // namespace rubble::widgets
