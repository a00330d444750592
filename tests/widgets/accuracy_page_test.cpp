#include "widgets/accuracy/accuracy_page.h"
#include <gtest/gtest.h>

#include "core/base/unknown.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSvgRenderer>
#include <QTest>
#include <cmath>

#include "widgets/accuracy/accuracy_chart.h"
#include "widgets/accuracy/accuracy_panel.h"
#include "widgets/accuracy/accuracy_table.h"
#include "widgets/basics/theme.h"

namespace rubble::widgets {

namespace {

constexpr AccuracyKind footprint{Measure::FootprintIou, std::nullopt};

DebrisDifference differing(double iou) {
    DebrisDifference difference;
    difference.values.fill(0.5);
    difference.of(Measure::FootprintIou) = iou;
    difference.of(Measure::CoreIou) = iou;
    difference.of(Measure::RunOut) = iou - 1.0;
    difference.tolerances = {0.1, 0.2, 0.3};
    difference.accuracy = {0.5 * iou, 0.7 * iou, 0.9 * iou};
    return difference;
}

AccuracyPoint pointOf(const std::string& setting, double iou, double stepMs, double fps) {
    AccuracyPoint point;
    point.setting = setting;
    point.fragments = 100;
    point.bodies = 40;
    point.done = true;
    point.difference = differing(iou);
    point.cost.stepMeanMs = stepMs;
    point.cost.stepWorstMs = 2.0 * stepMs;
    point.cost.wallSeconds = 10.0 * stepMs;
    point.cost.fps = fps;
    return point;
}

/// A reference with a repeat, four settings that are done (one of them without a cost), one that failed and one that is not done.
std::shared_ptr<AccuracyReport> someReport() {
    auto report = std::make_shared<AccuracyReport>();
    report->reference = pointOf("reference", 1.0, 60.0, 3.0);
    report->floor.emplace();
    report->floor->largest = differing(0.95);
    report->floor->repeats.emplace_back();
    report->points.push_back(pointOf("multiple=4", 0.88, 4.0, 40.0));
    report->points.push_back(pointOf("multiple=2", 0.93, 12.0, 16.0));
    report->points.push_back(pointOf("multiple=3 cluster_shape=hull", 0.86, 9.0, unknown));
    report->points.push_back(pointOf("multiple=1", 0.97, unknown, unknown));
    AccuracyPoint failed;
    failed.setting = "multiple=1.5";
    failed.failure = {"accuracy.memory", "there was not enough memory for it", {}};
    report->points.push_back(failed);
    AccuracyPoint open;
    open.setting = "paper";
    report->points.push_back(open);
    return report;
}

PlotContent contentOf(const AccuracyReport& report, CostKind cost = CostKind::StepMean, const AccuracyKind& kind = footprint) {
    return plotContent(report, cost, kind, 0, 24.0);
}

QPoint placeOf(AccuracyChart& chart, int row) {
    for (std::size_t i = 0; i < chart.content().points.size(); ++i) {
        if (chart.content().points[i].row == row) {
            return chart.placeOf(i).toPoint();
        }
    }
    return {-1, -1};
}

class AccuracyWidgets : public testing::Test {
protected:
    void SetUp() override {
        applyTheme(render::Theme::Light);
        chart.resize(640, 440);
        chart.show();
    }
    std::shared_ptr<AccuracyReport> report = someReport();
    AccuracyChart chart;
};

TEST_F(AccuracyWidgets, ThePlotHoldsOnePointForEachSettingWithBothFigures) {
    const PlotContent content = contentOf(*report);
    ASSERT_EQ(content.points.size(), 4u);
    EXPECT_EQ(content.left, 3u) << "without a cost, failed, and not done";
    EXPECT_EQ(content.points.front().row, 0);
    EXPECT_TRUE(content.points.front().inUse);
    EXPECT_EQ(content.points.back().row, referenceRow);
    EXPECT_FALSE(content.points.back().front) << "the reference agrees with itself, which is no merit";
    EXPECT_TRUE(content.points[0].front);
    EXPECT_FALSE(content.points[1].front) << "dearer and worse than the first";
    EXPECT_TRUE(content.points[2].front);
    EXPECT_EQ(content.band, std::pair(0.95, 1.0));
    ASSERT_TRUE(content.target.has_value());
    EXPECT_GT(*content.target, 4.0);
    EXPECT_LT(*content.target, 12.0);
}

TEST_F(AccuracyWidgets, ALineThroughAPointShowsItsOwnSpread) {
    chart.setContent(contentOf(*report));
    const QImage without = chart.grab().toImage();
    // The least of all, and a better one.
    report->points[0].repeats = {differing(0.60), differing(0.92)};
    const PlotContent content = contentOf(*report);
    ASSERT_EQ(content.points.front().row, 0);
    EXPECT_EQ(content.points.front().range, std::pair(0.60, 0.92));
    EXPECT_FALSE(content.points[1].range);
    EXPECT_TRUE(content.points.front().words.contains(QStringLiteral("0.600 to 0.920 over 3 runs")));
    chart.setContent(content);
    // The axis reaches that far, and the line is drawn down to there.
    const AccuracyPlot plot(content, QRectF(chart.rect()), headingFont(), tints());
    const QPointF low = plot.place({content.points.front().at.cost, 0.61});
    EXPECT_TRUE(plot.frame().contains(low));
    const QImage with = chart.grab().toImage();
    const auto isMuted = [&](const QPoint& at) { return std::abs(with.pixelColor(at).value() - tints().muted.value()) < 60; };
    EXPECT_TRUE(isMuted(low.toPoint()) || isMuted(low.toPoint() - QPoint(1, 0)));
    EXPECT_NE(with, without);
}

TEST_F(AccuracyWidgets, PlacesFollowTheFigures) {
    chart.setContent(contentOf(*report));
    const QPoint cheap = placeOf(chart, 0);
    const QPoint dear = placeOf(chart, 1);
    EXPECT_LT(cheap.x(), dear.x());
    EXPECT_GT(cheap.y(), dear.y()) << "more overlap is higher";
    // Cost is logarithmic: 4 to 12 takes as much room as 20 to 60.
    const double perDecade = (dear.x() - cheap.x()) / std::log10(3.0);
    EXPECT_NEAR((placeOf(chart, referenceRow).x() - dear.x()) / std::log10(5.0), perDecade, 0.02 * perDecade);
    chart.setContent(contentOf(*report, CostKind::StepMean, {Measure::RunOut, std::nullopt}));
    EXPECT_LT(placeOf(chart, 0).y(), placeOf(chart, 1).y()) << "an error is lower where it is better";
    for (std::size_t i = 0; i < chart.content().points.size(); ++i) {
        EXPECT_TRUE(QRectF(chart.rect()).contains(chart.placeOf(i)));
    }
}

TEST_F(AccuracyWidgets, HoveringTellsTheNumbersAndAClickChooses) {
    chart.setContent(contentOf(*report));
    QSignalSpy chosen(&chart, &AccuracyChart::rowChosen);
    QTest::mouseMove(&chart, placeOf(chart, 1));
    ASSERT_TRUE(chart.marked().has_value());
    const QString words = chart.content().points[*chart.marked()].words;
    for (const char* part : {"multiple 2", "40 bodies", "12.0 ms", "16.0 FPS", "0.930", "within 0.1 m: 46.5 %"}) {
        EXPECT_TRUE(words.contains(QLatin1String(part))) << part << " in " << words.toStdString();
    }
    EXPECT_EQ(chart.accessibleDescription(), words);
    QTest::mouseClick(&chart, Qt::LeftButton, {}, placeOf(chart, 1) + QPoint(3, -3));
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen.front().front().toInt(), 1);
    QTest::mouseMove(&chart, QPoint(2, 2));
    EXPECT_FALSE(chart.marked().has_value());
    QTest::mouseClick(&chart, Qt::LeftButton, {}, QPoint(2, 2));
    EXPECT_EQ(chosen.count(), 1) << "beside all points";
}

TEST_F(AccuracyWidgets, TheKeyboardGoesFromPointToPoint) {
    chart.setContent(contentOf(*report));
    QSignalSpy chosen(&chart, &AccuracyChart::rowChosen);
    QTest::keyClick(&chart, Qt::Key_Return);
    EXPECT_EQ(chosen.count(), 0) << "no point is marked yet";
    QTest::keyClick(&chart, Qt::Key_Right);
    QTest::keyClick(&chart, Qt::Key_Right);
    QTest::keyClick(&chart, Qt::Key_Right);
    QTest::keyClick(&chart, Qt::Key_Return);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen.front().front().toInt(), 1);
    QTest::keyClick(&chart, Qt::Key_Home);
    EXPECT_EQ(chart.marked(), 0u);
    QTest::keyClick(&chart, Qt::Key_Left);
    EXPECT_EQ(chart.marked(), 0u);
    QTest::keyClick(&chart, Qt::Key_End);
    EXPECT_EQ(chart.marked(), 3u);
    // New points come in: the mark stays on its setting.
    report->points.erase(report->points.begin());
    chart.setContent(plotContent(*report, CostKind::StepMean, footprint, std::nullopt, 24.0));
    ASSERT_TRUE(chart.marked().has_value());
    EXPECT_EQ(chart.content().points[*chart.marked()].row, referenceRow);
}

TEST_F(AccuracyWidgets, EmptyAndDegenerateContentsAreDrawn) {
    chart.setContent({});
    EXPECT_FALSE(chart.grab().isNull());
    AccuracyReport one;
    one.reference = pointOf("reference", 1.0, 5.0, unknown);
    for (const AccuracyKind& kind :
         {footprint, AccuracyKind{Measure::MassMap, std::nullopt}, AccuracyKind{Measure::MassMap, 0.1}}) {
        chart.setContent(contentOf(one, CostKind::Wall, kind));
        ASSERT_EQ(chart.content().points.size(), 1u);
        EXPECT_FALSE(chart.content().target.has_value());
        EXPECT_FALSE(chart.grab().isNull());
        EXPECT_TRUE(QRectF(chart.rect()).contains(chart.placeOf(0)));
    }
    one.reference.cost.stepMeanMs = 0.0;
    EXPECT_TRUE(contentOf(one).points.empty()) << "a cost of nothing has no place on a logarithmic axis";
}

TEST_F(AccuracyWidgets, FilesHoldTheChartOnWhite) {
    chart.setContent(contentOf(*report));
    applyTheme(render::Theme::Dark);
    const QImage image = chart.image({960, 640});
    EXPECT_EQ(image.size(), QSize(960, 640));
    EXPECT_EQ(image.pixelColor(1, 1), QColor(Qt::white));
    QSvgRenderer svg(chart.svg({960, 640}));
    ASSERT_TRUE(svg.isValid());
    QImage drawn(960, 640, QImage::Format_RGB32);
    drawn.fill(Qt::black);
    QPainter painter(&drawn);
    svg.render(&painter);
    painter.end();
    EXPECT_EQ(drawn.pixelColor(1, 1), QColor(Qt::white));
    // Both show the same: where one has ink, the other has ink nearby.
    int inked = 0;
    int apart = 0;
    for (int y = 0; y < 640; y += 4) {
        for (int x = 0; x < 960; x += 4) {
            const bool a = image.pixelColor(x, y).lightness() < 200;
            inked += a ? 1 : 0;
            apart += a != (drawn.pixelColor(x, y).lightness() < 200) ? 1 : 0;
        }
    }
    EXPECT_GT(inked, 20);
    EXPECT_LT(apart, inked) << "edges may differ by a shade, the drawing may not";
    applyTheme(render::Theme::Light);
}

TEST_F(AccuracyWidgets, TheTableHasTheSameRows) {
    AccuracyTable table;
    table.setReport(*report, 0);
    ASSERT_EQ(table.rowCount(), 8) << "reference, floor, six settings";
    EXPECT_EQ(table.item(0, 0)->text(), QStringLiteral("reference"));
    EXPECT_EQ(table.item(1, 0)->text(), QStringLiteral("repeat floor"));
    EXPECT_TRUE(table.item(2, 0)->text().contains(QStringLiteral("in use")));
    EXPECT_EQ(table.item(3, 2)->text(), QStringLiteral("12.0"));
    EXPECT_EQ(table.item(5, 2)->text(), QString(QChar(0x2013))) << "not measured";
    EXPECT_TRUE(table.item(6, 0)->text().contains(QStringLiteral("failed")));
    EXPECT_TRUE(table.item(6, 0)->toolTip().contains(QStringLiteral("memory")));
    EXPECT_TRUE(table.item(7, 0)->text().contains(QStringLiteral("not done")));
    for (int column = 0; column < table.columnCount(); ++column) {
        EXPECT_FALSE(table.horizontalHeaderItem(column)->toolTip().isEmpty()) << column;
    }
    QSignalSpy chosen(&table, &AccuracyTable::rowChosen);
    table.setCurrentCell(3, 0);
    QTest::keyClick(&table, Qt::Key_Return);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen.front().front().toInt(), 1);
    table.setCurrentCell(1, 0);
    QTest::keyClick(&table, Qt::Key_Return);
    EXPECT_EQ(chosen.count(), 1) << "the floor is no setting";
}

TEST_F(AccuracyWidgets, ThePageSaysWhatIsMissingAndWhatIsStale) {
    AccuracyPage page;
    page.resize(900, 560);
    page.show();
    const auto says = [&page](const char* text) {
        for (const QLabel* label : page.findChildren<QLabel*>()) {
            if (label->isVisible() && label->text().contains(QLatin1String(text))) {
                return true;
            }
        }
        return false;
    };
    EXPECT_TRUE(says("Nothing has been compared yet"));
    EXPECT_FALSE(page.chart().isVisible());
    page.setContent({report, std::nullopt, 24.0, false, false});
    EXPECT_TRUE(page.chart().isVisible());
    EXPECT_TRUE(says("without both figures: 3"));
    EXPECT_TRUE(says("none of the points"));
    page.setContent({report, std::nullopt, 24.0, true, false});
    EXPECT_TRUE(says("has changed since"));
    page.setContent({report, 1, 500.0, false, false});
    EXPECT_TRUE(says("Where 500 FPS lie is not known"));
    page.setCost(CostKind::Fps);
    EXPECT_EQ(page.chart().content().cost, CostKind::Fps);
    EXPECT_TRUE(says("further right is better"));
    page.findChild<QComboBox*>(QStringLiteral("accuracyKind"))->setCurrentIndex(0);
    EXPECT_EQ(page.chart().content().accuracy.measure, Measure::MassMap);
    EXPECT_TRUE(says("Lower and further right"));
}

/// Worlds of a cluster have no times of this machine.
TEST_F(AccuracyWidgets, BodiesStandForTheCostWhereNoneWasMeasured) {
    report->reference.bodies = 900;
    std::int64_t bodies = 100;
    for (AccuracyPoint* point : {&report->reference, &report->points[0], &report->points[1], &report->points[2]}) {
        point->cost = {};
    }
    for (AccuracyPoint& point : report->points) {
        point.bodies = point.done ? bodies *= 2 : 0;
    }
    AccuracyPage page;
    page.resize(1000, 600);
    page.show();
    page.setContent({report, std::nullopt, 24.0, false, false});
    EXPECT_EQ(page.chart().content().cost, CostKind::Bodies);
    ASSERT_EQ(page.chart().content().points.size(), 5u);
    EXPECT_EQ(page.chart().content().points.front().at.cost, 200.0);
    EXPECT_EQ(page.chart().content().points[2].at.cost, 800.0);
    EXPECT_EQ(page.chart().content().points[2].row, 2);
    EXPECT_EQ(page.table().item(0, 1)->text(), QStringLiteral("900"));
    EXPECT_EQ(page.table().item(6, 1)->text(), QString(QChar(0x2013))) << "bodies that nobody counted are not none";
    // The first time that is known takes its place, until somebody chooses.
    report->points[0].cost.wallSeconds = 3.0;
    page.setContent({report, std::nullopt, 24.0, false, false});
    EXPECT_EQ(page.chart().content().cost, CostKind::Wall);
    page.setCost(CostKind::Bodies);
    report->points[0].cost.stepMeanMs = 4.0;
    page.setContent({report, std::nullopt, 24.0, false, false});
    EXPECT_EQ(page.chart().content().cost, CostKind::Bodies);
}

TEST_F(AccuracyWidgets, ThePanelReadsWhatIsAskedFor) {
    AccuracyPanel panel;
    panel.findChild<QLineEdit*>(QStringLiteral("multiples"))->setText(QStringLiteral(" 2, auto,,3 "));
    panel.findChild<QLineEdit*>(QStringLiteral("varied"))->setText(QStringLiteral("cluster_shape=hull, axis_box; pieces = off ;"));
    const AccuracyPanel::Request request = panel.request();
    EXPECT_EQ(request.multiples, (std::vector<std::string>{"2", "auto", "3"}));
    ASSERT_EQ(request.varied.size(), 2u);
    EXPECT_EQ(request.varied[0].key, "cluster_shape");
    EXPECT_EQ(request.varied[0].values, (std::vector<std::string>{"hull", "axis_box"}));
    EXPECT_EQ(request.varied[1].key, "pieces");
    EXPECT_EQ(request.repeats, 2);
    EXPECT_TRUE(request.liveFps);
    panel.findChild<QLineEdit*>(QStringLiteral("varied"))->setText(QStringLiteral("pieces"));
    EXPECT_TRUE(panel.request().varied.front().values.empty()) << "a key without values is refused by the sweep, not lost";
}

TEST_F(AccuracyWidgets, TolerancesAreReadInOrderOrRefusedInPlace) {
    AccuracyPanel panel;
    std::vector<double> heard;
    QObject::connect(&panel, &AccuracyPanel::tolerancesChanged, [&heard](const std::vector<double>& t) { heard = t; });
    auto* field = panel.findChild<QLineEdit*>(QStringLiteral("tolerances"));
    auto* complaint = panel.findChild<QLabel*>(QStringLiteral("complaint"));
    const auto type = [field](const char* text) {
        field->setText(QLatin1String(text));
        QTest::keyClick(field, Qt::Key_Return);
    };
    type("0.5, 0.25,0.5, 2");
    EXPECT_EQ(heard, (std::vector<double>{0.25, 0.5, 2.0}));
    EXPECT_EQ(panel.request().tolerances, heard);
    EXPECT_TRUE(complaint->isHidden());
    for (const char* wrong : {"", "abc", "0.1, -2", "0", "1e9", "nan", "1,2,3,4,5,6,7"}) {
        type(wrong);
        EXPECT_FALSE(complaint->isHidden()) << wrong;
        EXPECT_EQ(panel.request().tolerances, heard) << wrong;
    }
    type("0.1");
    EXPECT_TRUE(complaint->isHidden());
    EXPECT_EQ(panel.request().tolerances, std::vector<double>{0.1});
}

}  // namespace
}  // namespace rubble::widgets
