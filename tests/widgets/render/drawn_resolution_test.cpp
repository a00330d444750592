#include "widgets/render/basics/drawn_resolution.h"

#include <gtest/gtest.h>

namespace rubble::render {
namespace {

constexpr double limit = 1.0 / 24.0;

TEST(DrawnResolution, StaysFullWherePicturesAreFastEnough) {
    DrawnResolution resolution;
    for (int picture = 0; picture < 100; ++picture) {
        resolution.drew(0.7 * limit, limit);
        EXPECT_EQ(resolution.share(), 1.0);
    }
}

TEST(DrawnResolution, OneSlowPictureIsNoReason) {
    DrawnResolution resolution;
    for (int picture = 0; picture < 100; ++picture) {
        resolution.drew(picture % 2 == 0 ? 5.0 * limit : 0.5 * limit, limit);
        EXPECT_EQ(resolution.share(), 1.0);
    }
}

// A machine on which a part of the time goes with the pixels: the share that keeps the limit is found and kept.
TEST(DrawnResolution, FindsTheShareThatKeepsTheLimitAndDoesNotWaver) {
    for (const double full : {1.1, 1.3, 1.8, 4.0}) {
        DrawnResolution resolution;
        const auto took = [&] { return full * limit * (0.3 + 0.7 * resolution.share() * resolution.share()); };
        for (int picture = 0; picture < 10; ++picture) {
            resolution.drew(took(), limit);
        }
        const double settled = resolution.share();
        EXPECT_TRUE(took() <= 0.8 * limit || settled == DrawnResolution::steps.back()) << full;
        for (int picture = 0; picture < 100; ++picture) {
            resolution.drew(took(), limit);
            EXPECT_EQ(resolution.share(), settled) << full;
        }
    }
}

TEST(DrawnResolution, ComesBackWhereThereIsRoom) {
    DrawnResolution resolution;
    for (int picture = 0; picture < 8; ++picture) {
        resolution.drew(2.0 * limit, limit);
    }
    EXPECT_EQ(resolution.share(), DrawnResolution::steps.back());
    for (int picture = 0; picture < 8; ++picture) {
        resolution.drew(0.2 * limit, limit);
    }
    EXPECT_EQ(resolution.share(), 1.0);
}

}  // namespace
}  // namespace rubble::render
