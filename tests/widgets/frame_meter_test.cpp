#include "widgets/views/frame_meter.h"

#include <gtest/gtest.h>

namespace rubble::widgets {

TEST(FrameMeter, EvenFramesGiveTheirRateAsMeanAndWorstSecond) {
    FrameMeter meter;
    for (int i = 0; i <= 100; ++i) {
        meter.frame(7.0 + i / 25.0);
    }
    EXPECT_NEAR(meter.mean(), 25.0, 1e-9);
    EXPECT_NEAR(meter.worstSecond(), 25.0, 1.0);  // a frame on the border of a second falls to either side
    EXPECT_NEAR(meter.recent(11.0), 25.0, 1.0);
}

TEST(FrameMeter, AStallShowsInTheWorstSecondAndLittleInTheMean) {
    FrameMeter meter;
    double instant = 0.0;
    for (int i = 0; i < 200; ++i) {
        instant += 0.02;
        if (i == 100) {
            instant += 1.5;
        }
        meter.frame(instant);
    }
    EXPECT_EQ(meter.worstSecond(), 0.0);  // one whole second without a frame
    EXPECT_NEAR(meter.mean(), 199.0 / (199 * 0.02 + 1.5), 1e-9);
}

TEST(FrameMeter, ForgetsWhenReset) {
    FrameMeter meter;
    meter.frame(0.0);
    meter.frame(0.1);
    meter.reset();
    EXPECT_EQ(meter.frames(), 0);
    EXPECT_EQ(meter.mean(), 0.0);
    EXPECT_EQ(meter.recent(0.2), 0.0);
}

TEST(FrameMeter, WithinTheFirstSecondTheWorstIsTheMean) {
    FrameMeter meter;
    for (int i = 0; i < 10; ++i) {
        meter.frame(i * 0.05);
    }
    EXPECT_NEAR(meter.worstSecond(), 20.0, 1e-9);
}

}  // namespace rubble::widgets
