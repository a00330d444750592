#include "widgets/evidence/surveys/survey_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rubble::widgets {
namespace {

// Walls are what did not move, and often one cell wide: there no height lies between four of them.
TEST(SurveyPlan, ACellBesideGapsIsAPlaceToo) {
    SurveyHeights heights;
    heights.nx = 5;
    heights.ny = 4;
    heights.dx = heights.dy = 0.5;
    heights.heights.assign(heights.nx * heights.ny, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t row = 0; row < heights.ny; ++row) {
        heights.heights[row * heights.nx + 2] = 3.0 + static_cast<double>(row);
    }
    const SurveyPlan plan(heights);
    std::size_t found = 0;
    for (std::size_t row = 0; row < heights.ny; ++row) {
        for (std::size_t column = 0; column < heights.nx; ++column) {
            const QPointF pixel(static_cast<double>(column) + 0.7, static_cast<double>(row) + 0.7);
            const auto place = plan.placeAt(pixel);
            EXPECT_EQ(place.has_value(), column == 2) << column << ", " << row;
            found += place ? 1 : 0;
            if (place) {
                EXPECT_NEAR(place->z(), 3.0 + std::round(place->y() / 0.5), 1e-9) << "the height of its own row";
            }
        }
    }
    EXPECT_EQ(found, heights.ny);
    EXPECT_FALSE(plan.placeAt(QPointF(-0.5, 1.0)));
}

}  // namespace
}  // namespace rubble::widgets
