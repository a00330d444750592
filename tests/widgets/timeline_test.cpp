#include "widgets/views/timeline.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QTest>

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

}  // namespace rubble::widgets
