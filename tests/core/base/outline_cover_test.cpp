#include "core/base/outline_cover.h"

#include <gtest/gtest.h>

namespace rubble {

namespace {

TEST(OutlineCover, APlaceLiesInAPolygonButNotInItsHole) {
    Outline outline;
    EXPECT_FALSE(covers(outline, {0.0, 0.0}));
    outline.polygons.push_back({{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}}, {{1.0, 1.0}, {3.0, 1.0}, {2.0, 3.0}}});
    outline.polygons.push_back({{{3.0, 3.0}, {9.0, 3.0}, {9.0, 5.0}}});
    EXPECT_TRUE(covers(outline, {0.5, 2.0}));
    EXPECT_FALSE(covers(outline, {2.0, 1.5})) << "the hole";
    EXPECT_TRUE(covers(outline, {2.0, 3.5}));
    EXPECT_TRUE(covers(outline, {3.9, 3.1})) << "in both";
    EXPECT_TRUE(covers(outline, {8.0, 3.5}));
    EXPECT_FALSE(covers(outline, {5.0, 2.0}));
    EXPECT_FALSE(covers(outline, {4.5, 4.5}));
}

}  // namespace

}  // namespace rubble
