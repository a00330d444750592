#include "io/run/frame_cache.h"

#include <gtest/gtest.h>

#include <random>

namespace rubble::io {
namespace {

std::shared_ptr<const TrajectoryFrame> frameWith(std::size_t bodies, double time) {
    auto frame = std::make_shared<TrajectoryFrame>();
    frame->time = time;
    frame->positions.resize(bodies);
    return frame;
}

TEST(FrameCache, NeverHoldsMoreThanItsLimit) {
    FrameCache cache(200000);
    std::mt19937 engine(1);
    for (std::size_t i = 0; i < 2000; ++i) {
        cache.add(i, frameWith(engine() % 1000, static_cast<double>(i)));
        EXPECT_LE(cache.bytes(), 200000u);
        EXPECT_EQ(cache.find(i)->time, static_cast<double>(i));
    }
    EXPECT_EQ(cache.find(0), nullptr);
}

TEST(FrameCache, DropsWhatWasUsedLongestAgo) {
    const std::size_t one = [] {
        FrameCache probe(1000000);
        probe.add(0, frameWith(100, 0));
        return probe.bytes();
    }();
    FrameCache cache(3 * one);
    for (std::size_t i = 0; i < 3; ++i) {
        cache.add(i, frameWith(100, static_cast<double>(i)));
    }
    EXPECT_NE(cache.find(0), nullptr);
    cache.add(3, frameWith(100, 3));
    EXPECT_NE(cache.find(0), nullptr);
    EXPECT_EQ(cache.find(1), nullptr);
    EXPECT_NE(cache.find(2), nullptr);
}

TEST(FrameCache, KeepsTwoNeighboursWhateverTheLimit) {
    FrameCache cache(1);
    cache.add(0, frameWith(1000, 0));
    cache.add(1, frameWith(1000, 1));
    EXPECT_NE(cache.find(0), nullptr);
    EXPECT_NE(cache.find(1), nullptr);
    cache.add(2, frameWith(1000, 2));
    EXPECT_EQ(cache.find(0), nullptr);
}

}  // namespace
}  // namespace rubble::io
