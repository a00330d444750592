#include "widgets/render/panes.h"

#include <gtest/gtest.h>

namespace rubble::render {
namespace {

TEST(Panes, TileTheWindowWithOneHairline) {
    for (const Layout layout :
         {Layout::Beside, Layout::Stacked, Layout::FeOnly, Layout::FragmentsOnly, Layout::OverlayOnly, Layout::Four}) {
        for (const auto& [width, height] : {std::pair{1280, 800}, {1279, 801}, {40, 30}}) {
            const auto panes = panesOf(layout, width, height);
            int pixels = 0;
            for (const Pane& pane : panes) {
                pixels += pane.width * pane.height;
            }
            const bool two = layout == Layout::Beside || layout == Layout::Stacked;
            ASSERT_EQ(panes.size(), layout == Layout::Four ? 4u : two ? 2u : 1u);
            const int lines = layout == Layout::Beside    ? height
                              : layout == Layout::Stacked ? width
                              : layout == Layout::Four    ? width + height - 1
                                                          : 0;
            EXPECT_EQ(pixels, width * height - lines);
            int covered = 0;
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    covered += paneAt(layout, width, height, x, y).has_value();
                }
            }
            EXPECT_EQ(covered, pixels);  // so none overlap
        }
    }
}

TEST(Panes, EveryWindowHasPanesOfSomeSize) {
    for (const int size : {0, 1, 2, -5}) {
        for (const Pane& pane : panesOf(Layout::Stacked, size, size)) {
            EXPECT_GE(pane.width, 1);
            EXPECT_GE(pane.height, 1);
        }
    }
    EXPECT_FALSE(paneAt(Layout::Beside, 100, 100, -1, 5));
    EXPECT_FALSE(paneAt(Layout::Beside, 100, 100, 50, 100));
}

TEST(Panes, LayoutFollowsTheModelsProportions) {
    const Aabb bridge(Vec3(0, 0, 0), Vec3(315, 13, 42));
    const Aabb tower(Vec3(0, 0, 0), Vec3(20, 20, 90));
    EXPECT_EQ(suggestLayout(bridge, 1280, 800), Layout::Stacked);
    EXPECT_EQ(suggestLayout(tower, 1280, 800), Layout::Beside);
    EXPECT_EQ(suggestLayout(Aabb(), 1280, 800), Layout::Beside);
}

}  // namespace
}  // namespace rubble::render
