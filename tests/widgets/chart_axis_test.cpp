#include "widgets/basics/chart_axis.h"

#include <gtest/gtest.h>

#include <array>

namespace rubble::widgets {

TEST(ChartAxis, LogarithmicPlacesGrowByFactors) {
    const ChartAxis axis = ChartAxis::logarithmicBetween(1.0, 100.0, 10.0);
    EXPECT_DOUBLE_EQ(axis.share(1.0), 0.0);
    EXPECT_DOUBLE_EQ(axis.share(10.0), 0.5);
    EXPECT_DOUBLE_EQ(axis.share(100.0), 1.0);
    EXPECT_EQ(axis.ticks, (std::vector<double>{1, 2, 5, 10, 20, 50, 100}));
    EXPECT_EQ(ChartAxis::logarithmicBetween(1.0, 100.0, 3.0).ticks, (std::vector<double>{1, 10, 100}));
}

TEST(ChartAxis, AFieldPutsItsCornersOnItsFrame) {
    const ChartField field{QRectF(0, 0, 200, 100), QRectF(20, 10, 160, 80), {0.0, 4.0, false, {}}, {1.0, 100.0, true, {}}};
    EXPECT_EQ(field.place(0.0, 1.0), field.frame.bottomLeft());
    EXPECT_EQ(field.place(4.0, 100.0), field.frame.topRight());
    EXPECT_EQ(field.place(2.0, 10.0), field.frame.center());
}

TEST(ChartAxis, TheNearestPlaceIsWithinReach) {
    const std::array<QPointF, 3> places{QPointF(0, 0), QPointF(10, 0), QPointF(10, 5)};
    EXPECT_EQ(nearestPlace(places, QPointF(9, 1), 3.0), std::optional<std::size_t>(1));
    EXPECT_EQ(nearestPlace(places, QPointF(5, 0), 3.0), std::nullopt);
}

}  // namespace rubble::widgets
