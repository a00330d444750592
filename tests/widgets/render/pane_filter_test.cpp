#include <gtest/gtest.h>

#include <algorithm>

#include "tests/scenes/fe_scenes.h"
#include "tests/widgets/scenes/ballistic_run.h"
#include "widgets/render/pane_geometry.h"

namespace rubble::render {
namespace {

ColourScale blackScale() {
    ColourScale scale;
    scale.colours.structure = {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}, {5, 5, 5}};
    scale.colours.categories = {{1, 0, 0}};
    return scale;
}

/// Fragments that have a triangle.
std::size_t drawnFragments(PaneGeometry& pane, const SceneData& data) {
    std::size_t count = 0;
    for (const Fragment& fragment : data.fragments->list) {
        pane.update(pane.status().time, ColourBy::Highlight, blackScale(), {fragment.element});
        count += pane.selected().empty() ? 0 : 1;
    }
    return count;
}

class PaneFilter : public testing::Test {
protected:
    SceneData m_data = scenes::ballisticRun(scenes::collapsingWall(4, 3), 1.0);
    void show(PaneGeometry& pane, double time) { pane.update(time, ColourBy::Highlight, blackScale(), {}); }
};

TEST_F(PaneFilter, OnlyWhatMeetsItIsDrawnAndCounted) {
    PaneGeometry pane(PaneContent::Fragments, m_data, false);
    show(pane, 0.9);
    EXPECT_FALSE(pane.status().meeting);
    const std::size_t all = pane.status().fragments;
    ASSERT_EQ(drawnFragments(pane, m_data), all);
    FragmentFilter filter;
    filter.birth.high = m_data.fragments->list.front().birthTime + 1e-6;
    const auto early =
        static_cast<std::size_t>(std::count_if(m_data.fragments->list.begin(), m_data.fragments->list.end(),
                                               [&](const Fragment& fragment) { return fragment.birthTime <= *filter.birth.high; }));
    ASSERT_GT(early, 0U);
    ASSERT_LT(early, all);
    pane.setFilter(filter);
    show(pane, 0.9);
    ASSERT_TRUE(pane.status().meeting);
    EXPECT_EQ(*pane.status().meeting, early);
    EXPECT_EQ(pane.status().fragments, all) << "the count of what is born stays";
    EXPECT_EQ(drawnFragments(pane, m_data), early);
    pane.setFilter({});
    show(pane, 0.9);
    EXPECT_FALSE(pane.status().meeting);
    EXPECT_EQ(drawnFragments(pane, m_data), all);
}

TEST_F(PaneFilter, WhatALeftOutFragmentCoveredIsDrawn) {
    PaneGeometry pane(PaneContent::Fragments, m_data, false);
    FragmentFilter none;
    none.mass.low = 0.0;
    pane.setFilter(none);
    show(pane, 0.9);
    PaneGeometry whole(PaneContent::Fragments, m_data, false);
    show(whole, 0.9);
    EXPECT_GT(pane.triangles().size(), whole.triangles().size()) << "clusters are open while fragments may be left out of them";
}

TEST_F(PaneFilter, SpeedsAreThoseOfTheTimeShown) {
    PaneGeometry pane(PaneContent::Fragments, m_data, false);
    FragmentFilter filter;
    filter.speed.low = 0.5;
    pane.setFilter(filter);
    for (double time = 0.0; time <= 1.0; time += 0.05) {
        show(pane, time);
        const TrajectoryFrame frame = frameAtTime(*m_data.trajectory, pane.status().time);
        const std::vector<double> speeds = speedsShown(m_data, &frame);
        std::size_t fast = 0;
        for (std::size_t f = 0; f < speeds.size(); ++f) {
            const Fragment& fragment = m_data.fragments->list[f];
            fast += fragment.birthTime <= pane.status().time && speeds[f] >= 0.5 ? 1 : 0;
        }
        ASSERT_TRUE(pane.status().meeting);
        EXPECT_EQ(*pane.status().meeting, fast) << time;
    }
}

TEST_F(PaneFilter, WhatIsLeftOutCannotBePicked) {
    PaneGeometry pane(PaneContent::Fragments, m_data, false);
    const auto anywhere = [](const Vec3&) { return true; };
    show(pane, 0.9);
    const std::size_t before = pane.elementsWhere(anywhere).size();
    FragmentFilter filter;
    filter.mass.low = 1e9;
    pane.setFilter(filter);
    show(pane, 0.9);
    EXPECT_EQ(pane.elementsWhere(anywhere).size(), before - pane.status().fragments);
}

TEST_F(PaneFilter, AComponentIsKnownByItsName) {
    FragmentFilter filter;
    filter.component = "wall";
    const std::vector<std::uint8_t> meets = meeting(filter, *m_data.fragments, m_data.components.get(), {});
    for (std::size_t f = 0; f < meets.size(); ++f) {
        EXPECT_EQ(meets[f] != 0, m_data.components->list[at(m_data.fragments->list[f].component)].name == "wall");
    }
    filter.component = "no such";
    const std::vector<std::uint8_t> nobody = meeting(filter, *m_data.fragments, m_data.components.get(), {});
    EXPECT_EQ(std::count(nobody.begin(), nobody.end(), 1), 0);
}

}  // namespace
}  // namespace rubble::render
