#include "widgets/views/playback_clock.h"

#include <gtest/gtest.h>

namespace rubble::widgets {

TEST(PlaybackClock, StaysInsideItsRange) {
    PlaybackClock clock;
    clock.setRange(1.0, 3.0);
    EXPECT_EQ(clock.time(), 1.0);
    clock.setTime(99.0);
    EXPECT_EQ(clock.time(), 3.0);
    clock.setRange(0.0, 2.0);
    EXPECT_EQ(clock.time(), 2.0);
}

TEST(PlaybackClock, AdvancesByItsRateAndStopsAtTheEnd) {
    PlaybackClock clock;
    clock.setRange(0.0, 10.0);
    clock.setRate(0.5);
    clock.play();
    clock.advance(4.0);
    EXPECT_DOUBLE_EQ(clock.time(), 2.0);
    EXPECT_TRUE(clock.playing());
    clock.advance(100.0);
    EXPECT_DOUBLE_EQ(clock.time(), 10.0);
    EXPECT_FALSE(clock.playing());
    clock.play();  // from the end it starts over
    EXPECT_DOUBLE_EQ(clock.time(), 0.0);
}

TEST(PlaybackClock, WaitsAtTheNewestInstantOfARunThatGrows) {
    PlaybackClock clock;
    clock.setRange(0.0, 10.0);
    clock.setNewest(2.0);
    clock.play();
    clock.advance(5.0);
    EXPECT_DOUBLE_EQ(clock.time(), 2.0);
    EXPECT_TRUE(clock.playing());
    clock.setNewest(3.0);
    clock.advance(0.5);
    EXPECT_DOUBLE_EQ(clock.time(), 2.5);
    // Scrubbing beyond is allowed; playing from there does not jump back.
    clock.setTime(7.0);
    clock.advance(1.0);
    EXPECT_DOUBLE_EQ(clock.time(), 7.0);
}

TEST(PlaybackClock, PlaysBackwardsToTheFirstInstant) {
    PlaybackClock clock;
    clock.setRange(1.0, 10.0);
    clock.setTime(4.0);
    clock.play(true);
    clock.advance(2.0);
    EXPECT_DOUBLE_EQ(clock.time(), 2.0);
    clock.play();
    clock.advance(1.5);
    EXPECT_DOUBLE_EQ(clock.time(), 3.5);
    clock.play(true);
    clock.advance(9.0);
    EXPECT_DOUBLE_EQ(clock.time(), 1.0);
    EXPECT_FALSE(clock.playing());
    clock.play(true);  // from the first instant it begins at the last
    EXPECT_DOUBLE_EQ(clock.time(), 10.0);
}

TEST(PlaybackClock, GoesRoundItsLoopBothWays) {
    PlaybackClock clock;
    clock.setRange(0.0, 10.0);
    clock.setLoop(std::pair(2.0, 5.0));
    clock.setTime(8.0);
    clock.play();
    EXPECT_DOUBLE_EQ(clock.time(), 2.0) << "from outside it begins at the range's start";
    clock.advance(2.5);
    EXPECT_DOUBLE_EQ(clock.time(), 4.5);
    clock.advance(1.0);
    EXPECT_DOUBLE_EQ(clock.time(), 2.5);
    clock.advance(3.0 * 7 + 1.0);
    EXPECT_DOUBLE_EQ(clock.time(), 3.5);
    clock.play(true);
    clock.advance(2.0);
    EXPECT_DOUBLE_EQ(clock.time(), 4.5);
    EXPECT_TRUE(clock.playing());
    clock.setLoop(std::pair(5.0, 5.0));
    EXPECT_FALSE(clock.loop().has_value()) << "a range without length is none";
    // A range that ends beyond what there is goes round what there is.
    clock.setLoop(std::pair(9.0, 20.0));
    clock.play();
    clock.advance(1.5);
    EXPECT_LE(clock.time(), 10.0);
    EXPECT_GE(clock.time(), 9.0);
    EXPECT_TRUE(clock.playing());
}

TEST(PlaybackClock, ALoopWaitsForARunThatGrowsToo) {
    PlaybackClock clock;
    clock.setRange(0.0, 10.0);
    clock.setLoop(std::pair(0.0, 10.0));
    clock.setNewest(3.0);
    clock.play();
    clock.advance(5.0);
    EXPECT_DOUBLE_EQ(clock.time(), 3.0);
    clock.advance(5.0);
    EXPECT_DOUBLE_EQ(clock.time(), 3.0);
}

TEST(PlaybackClock, WithoutARangeItDoesNotPlay) {
    PlaybackClock clock;
    clock.play();
    EXPECT_FALSE(clock.playing());
}

}  // namespace rubble::widgets
