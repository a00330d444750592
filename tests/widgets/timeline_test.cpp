#include "widgets/views/timeline.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QTest>

#include "widgets/basics/theme.h"

namespace rubble::widgets {

TEST(Timeline, PlaceAndTimeAreInverse) {
    Timeline timeline;
    timeline.resize(800, 110);
    timeline.setRange(0.5, 19.7);
    for (double time = 0.5; time <= 19.7; time += 0.37) {
        EXPECT_NEAR(timeline.toTime(timeline.toX(time)), time, 1e-9);
    }
}

TEST(Timeline, TheMouseScrubs) {
    Timeline timeline;
    timeline.resize(800, 110);
    timeline.setRange(0.0, 10.0);
    std::vector<double> scrubbed;
    QObject::connect(&timeline, &Timeline::scrubbed, [&](double time) { scrubbed.push_back(time); });
    const auto at = [&](double time) { return QPoint(static_cast<int>(timeline.toX(time)), 40); };
    QTest::mousePress(&timeline, Qt::LeftButton, {}, at(3.0));
    QTest::mouseMove(&timeline, at(6.0));
    QTest::mouseRelease(&timeline, Qt::LeftButton, {}, at(6.0));
    ASSERT_FALSE(scrubbed.empty());
    EXPECT_NEAR(scrubbed.front(), 3.0, 0.05);  // one pixel is 0.015 s
}

TEST(Timeline, WithoutAResultTheMouseDoesNothing) {
    Timeline timeline;
    timeline.resize(800, 110);
    int scrubbed = 0;
    QObject::connect(&timeline, &Timeline::scrubbed, [&] { ++scrubbed; });
    QTest::mouseClick(&timeline, Qt::LeftButton, {}, QPoint(400, 40));
    EXPECT_EQ(scrubbed, 0);
}

TEST(Timeline, TheComputedBarGrowsToItsPlace) {
    Timeline timeline;
    timeline.resize(800, 110);
    timeline.setRange(0.0, 10.0);
    const auto coloured = [&] {
        // The bar is the widest run of one colour in the accent: count its pixels in the image.
        const QImage image = timeline.grab().toImage();
        QImage without = image;
        timeline.setComputed(0.0, 0.0, false);
        without = timeline.grab().toImage();
        int differing = 0;
        for (int x = 0; x < image.width(); ++x) {
            bool differs = false;
            for (int y = 0; y < image.height(); ++y) {
                differs = differs || image.pixel(x, y) != without.pixel(x, y);
            }
            differing += differs ? 1 : 0;
        }
        return differing;
    };
    timeline.setComputed(0.0, 5.0, false);
    const int half = coloured();
    timeline.setComputed(0.0, 10.0, false);
    const int whole = coloured();
    EXPECT_NEAR(half, timeline.toX(5.0) - timeline.toX(0.0), 3);
    EXPECT_NEAR(whole, timeline.toX(10.0) - timeline.toX(0.0), 3);
}

TEST(Timeline, PhotographsHaveARowAndAClickGoesToTheirTime) {
    Timeline timeline;
    timeline.setRange(0.0, 10.0);
    timeline.resize(800, timeline.sizeHint().height());
    const int low = timeline.sizeHint().height();
    timeline.setPhotographs({{4.0, 1.0, QStringLiteral("a.jpg")}, {99.0, 0.0, QStringLiteral("later.jpg")}});
    EXPECT_GT(timeline.sizeHint().height(), low) << "they take a row of their own";
    timeline.resize(800, timeline.sizeHint().height());
    const int x = static_cast<int>(timeline.toX(4.0));
    int row = -1;
    for (int y = 0; y < timeline.height() && row < 0; ++y) {
        row = timeline.photographAt(QPointF(x, y)) ? y + 4 : -1;
    }
    ASSERT_GE(row, 0);
    std::vector<double> scrubbed;
    QObject::connect(&timeline, &Timeline::scrubbed, [&](double time) { scrubbed.push_back(time); });
    QTest::mouseClick(&timeline, Qt::LeftButton, {}, QPoint(x + 3, row));
    EXPECT_EQ(scrubbed, std::vector<double>{4.0}) << "exactly its time, not that of the pixel";
    const QImage with = timeline.grab().toImage();
    timeline.setPhotographs({});
    EXPECT_EQ(timeline.sizeHint().height(), low);
    timeline.resize(with.size());
    EXPECT_NE(timeline.grab().toImage(), with);
}

TEST(Timeline, HandOversOfIslandsAreTicksThatLeadToTheirTime) {
    Timeline timeline;
    timeline.resize(800, 116);
    timeline.setRange(0.0, 10.0);
    timeline.setDeaths({0.0, 2.0, 4.0, 6.0}, {0.0, 10.0, 40.0, 20.0});
    const QImage without = timeline.grab().toImage();
    EXPECT_FALSE(timeline.handOverAt(QPointF(timeline.toX(2.0), 50.0)));
    timeline.setIslands({0.0, 0.0, 30.0, 20.0}, {{1.9, QStringLiteral("two islands")}, {2.0, QStringLiteral("one more")}});
    ASSERT_TRUE(timeline.handOverAt(timeline.tickOf(1)));
    EXPECT_EQ(*timeline.handOverAt(timeline.tickOf(1)), 1u) << "the nearer of two that are close together";
    EXPECT_EQ(*timeline.handOverAt(timeline.tickOf(0) - QPointF(3, 0)), 0u);
    EXPECT_FALSE(timeline.handOverAt(timeline.tickOf(0) - QPointF(30, 0)));
    std::vector<double> scrubbed;
    QObject::connect(&timeline, &Timeline::scrubbed, [&](double time) { scrubbed.push_back(time); });
    QTest::mouseClick(&timeline, Qt::LeftButton, {}, timeline.tickOf(0).toPoint());
    ASSERT_EQ(scrubbed.size(), 1u);
    EXPECT_EQ(scrubbed.front(), 1.9) << "not the time of the pixel";
    // Ticks and the area of deaths in islands are seen, and go with them.
    const auto pixelsOf = [&](const QImage& image) {
        int count = 0;
        const QRgb ink = tints().released.rgb();
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                count += image.pixel(x, y) == ink ? 1 : 0;
            }
        }
        return count;
    };
    EXPECT_EQ(pixelsOf(without), 0);
    EXPECT_GT(pixelsOf(timeline.grab().toImage()), 10);
    timeline.setIslands({}, {});
    EXPECT_EQ(pixelsOf(timeline.grab().toImage()), 0);
}

}  // namespace rubble::widgets
