#include "widgets/views/moving_detail.h"

#include <gtest/gtest.h>

#include <limits>

namespace rubble::widgets {
namespace {

constexpr double limit = 0.02;

TEST(MovingDetail, IsGivenUpAfterTwoSlowPicturesInARow) {
    MovingDetail detail;
    EXPECT_FALSE(detail.tooSlow(limit));
    detail.drewMoving(0.05);
    EXPECT_FALSE(detail.tooSlow(limit)) << "one may have been kept up";
    detail.drewMoving(0.01);
    detail.drewMoving(0.05);
    EXPECT_FALSE(detail.tooSlow(limit));
    detail.drewMoving(0.03);
    EXPECT_TRUE(detail.tooSlow(limit));
    EXPECT_FALSE(detail.tooSlow(std::numeric_limits<double>::infinity()));
}

TEST(MovingDetail, ComesBackWhereThePictureAtRestIsLight) {
    MovingDetail detail;
    detail.drewMoving(0.05);
    detail.drewMoving(0.05);
    detail.drewResting(0.05, limit);
    detail.drewResting(0.015, limit);
    EXPECT_TRUE(detail.tooSlow(limit)) << "what moves takes longer than what rests";
    detail.drewResting(0.004, limit);
    EXPECT_FALSE(detail.tooSlow(limit));
    detail.drewMoving(0.05);
    detail.drewMoving(0.05);
    EXPECT_TRUE(detail.tooSlow(limit)) << "and is given up again";
}

TEST(MovingDetail, AtRestNothingBecomesSlow) {
    MovingDetail detail;
    detail.drewResting(1.0, limit);
    detail.drewResting(1.0, limit);
    EXPECT_FALSE(detail.tooSlow(limit)) << "at rest a picture may have had to build something anew";
}

}  // namespace
}  // namespace rubble::widgets
