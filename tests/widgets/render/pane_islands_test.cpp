#include <gtest/gtest.h>

#include <set>

#include "core/base/standard_gravity.h"
#include "tests/scenes/fe_scenes.h"
#include "tests/widgets/scenes/ballistic_run.h"
#include "tests/widgets/scenes/released_slab.h"
#include "widgets/render/basics/colour_choice.h"
#include "widgets/render/pane_geometry.h"
#include "widgets/render/shapes/island_colours.h"

namespace rubble::render {
namespace {

constexpr Rgb grey{100, 100, 100};

ColourScale scaleOfIslands() {
    ColourScale scale;
    scale.colours.fragment = {213, 94, 0};
    scale.colours.released = {9, 9, 9};
    scale.colours.structure = {grey, grey, grey, grey, grey};
    scale.colours.categories = {{200, 0, 0}, {0, 200, 0}, {0, 0, 200}};
    return scale;
}

std::shared_ptr<const LooseStructure> looseOf(const FeResult& fe) {
    return std::make_shared<const LooseStructure>(looseStructure(fe, fe.activity(), {true, 0.0, nullptr}, Execution()));
}

/// A falling slab that breaks in two when its middle row dies, and a pier that stands on the ground.
class PaneIslands : public testing::Test {
protected:
    PaneIslands() {
        scenes::Block slab;
        slab.name = "slab";
        slab.low = Vec3(10, 0, 50);
        slab.size = Vec3(5, 1, 1);
        slab.cells = {5, 1, 1};
        slab.gravity = standardGravity;
        slab.deathState = [](std::size_t i) { return i == 2 ? std::size_t{4} : i == 0 ? std::size_t{7} : scenes::never; };
        scenes::Block pier;
        pier.name = "pier";
        pier.size = Vec3(1, 1, 3);
        pier.cells = {1, 1, 3};
        m_fe = scenes::makeScene({slab, pier}, 9, 0.1);
        m_data = scenes::withoutRun(m_fe);
        m_data.loose = looseOf(*m_fe);
    }

    void show(PaneGeometry& pane, double time, ColourBy by = ColourBy::Island) { pane.update(time, by, m_scale, {}); }

    /// The colours of the triangles on one side of a plane across x.
    static std::set<std::array<std::uint8_t, 3>> coloursWhere(const PaneGeometry& pane, double from, double to) {
        std::set<std::array<std::uint8_t, 3>> found;
        for (const std::int32_t corner : pane.triangles()) {
            const auto i = static_cast<std::size_t>(corner);
            if (pane.points()[3 * i] >= from && pane.points()[3 * i] <= to) {
                found.insert({pane.colours()[4 * i], pane.colours()[4 * i + 1], pane.colours()[4 * i + 2]});
            }
        }
        return found;
    }
    using Colours = std::set<std::array<std::uint8_t, 3>>;

    std::shared_ptr<const FeResult> m_fe;
    SceneData m_data;
    ColourScale m_scale = scaleOfIslands();
};

TEST_F(PaneIslands, StructureIsColouredByTheIslandOfTheShownState) {
    PaneGeometry pane(PaneContent::Fe, m_data, false);
    show(pane, 0.0);
    EXPECT_EQ(coloursWhere(pane, 0, 20), (Colours{{100, 100, 100}})) << "at rest nothing is loose";
    EXPECT_TRUE(pane.status().islands.empty());
    show(pane, 0.25);
    const Colours whole = coloursWhere(pane, 10, 15);
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_FALSE(whole.contains({100, 100, 100}));
    EXPECT_EQ(coloursWhere(pane, 0, 1), (Colours{{100, 100, 100}})) << "the pier stands";
    ASSERT_EQ(pane.status().islands.size(), 1u);
    EXPECT_EQ(pane.status().islands[0].elements, 5u);
    show(pane, 0.45);
    // The first half of equal ones goes on as the island; the other is a new one.
    EXPECT_EQ(coloursWhere(pane, 10, 12), whole);
    const Colours other = coloursWhere(pane, 13, 15);
    ASSERT_EQ(other.size(), 1u);
    EXPECT_NE(other, whole);
    ASSERT_EQ(pane.status().islands.size(), 2u);
    show(pane, 0.75);
    EXPECT_EQ(coloursWhere(pane, 11, 12), whole) << "it keeps its colour while it loses elements";
    EXPECT_EQ(coloursWhere(pane, 13, 15), other);
    EXPECT_EQ(pane.status().islands[0].elements, 2u) << "the largest first";
    EXPECT_EQ(pane.status().islands[1].elements, 1u);
}

TEST_F(PaneIslands, ScrubbingGivesTheColoursOfAPictureMadeAnew) {
    for (const PaneContent content : {PaneContent::Fe, PaneContent::Fragments}) {
        for (const bool simplified : {false, true}) {
            PaneGeometry pane(content, m_data, false);
            pane.setSimplified(simplified);
            for (const double time : {0.05, 0.75, 0.3, 0.45, 0.35, 0.8, 0.0, 0.25}) {
                show(pane, time);
                PaneGeometry anew(content, m_data, false);
                anew.setSimplified(simplified);
                show(anew, time);
                EXPECT_EQ(pane.colours(), anew.colours()) << time;
                EXPECT_EQ(pane.triangles(), anew.triangles()) << time;
                EXPECT_EQ(pane.status().islands.size(), anew.status().islands.size()) << time;
            }
        }
    }
}

TEST_F(PaneIslands, OtherColoursComeBack) {
    PaneGeometry pane(PaneContent::Fe, m_data, false);
    m_scale.componentColours["slab"] = {77, 8, 8};
    show(pane, 0.25, ColourBy::Highlight);
    EXPECT_EQ(coloursWhere(pane, 10, 15), (Colours{{77, 8, 8}}));
    show(pane, 0.25);
    EXPECT_FALSE(coloursWhere(pane, 10, 15).contains({77, 8, 8}));
    m_scale.componentColours["pier"] = {78, 8, 8};
    show(pane, 0.25);
    EXPECT_EQ(coloursWhere(pane, 0, 1), (Colours{{100, 100, 100}})) << "what stands is quiet";
    show(pane, 0.25, ColourBy::Highlight);
    EXPECT_EQ(coloursWhere(pane, 10, 15), (Colours{{77, 8, 8}}));
    EXPECT_TRUE(pane.status().islands.empty());
}

TEST_F(PaneIslands, WithoutLooseStructureItIsNotKnown) {
    m_data.loose = nullptr;
    PaneGeometry pane(PaneContent::Fe, m_data, false);
    show(pane, 0.25);
    EXPECT_FALSE(pane.status().islandsKnown);
    EXPECT_EQ(coloursWhere(pane, 0, 20), (Colours{{100, 100, 100}}));
}

TEST_F(PaneIslands, WhatABodyCarriesHasTheColourOfItsIslandToo) {
    scenes::ReleasedSlab run;
    run.runToFeEnd();
    run.release();
    run.data.loose = looseOf(*run.fe);
    PaneGeometry fe(PaneContent::Fe, run.data, false);
    PaneGeometry fragments(PaneContent::Fragments, run.data, false);
    show(fe, 0.3);
    const Colours inFe = coloursWhere(fe, 10, 13);
    ASSERT_EQ(inFe.size(), 1u);
    EXPECT_FALSE(inFe.contains({100, 100, 100}));
    show(fragments, 0.3);
    EXPECT_EQ(coloursWhere(fragments, 10, 13), inFe);
    EXPECT_FALSE(inFe.contains({9, 9, 9})) << "the colour of released structure does not tell islands apart";
}

TEST(IslandColours, NoneIsThatOfAFragment) {
    SceneColours colours = scaleOfIslands().colours;
    EXPECT_EQ(colour_choice::unlikeFragments(colours).size(), 9u);
    colours.categories[1] = colours.fragment;
    EXPECT_EQ(colour_choice::unlikeFragments(colours), (std::vector<std::uint32_t>{0, 2, 3, 5, 6, 8})) << "in no lightness";
    colours.categories.clear();
    EXPECT_EQ(colour_choice::unlikeFragments(colours).size(), 1u);
}

TEST(IslandColours, ThoseTogetherDifferWhileThereAreColours) {
    LooseStructure loose;
    loose.members.resize(10);
    const auto add = [&](std::uint32_t from, std::uint32_t to, std::size_t size) {
        LooseIsland island;
        island.from = from;
        island.to = to;
        island.elements.resize(size);
        loose.islands.push_back(island);
    };
    add(0, 3, 5);
    add(2, 6, 50);
    add(3, 9, 20);
    add(7, 9, 4);
    add(3, 3, 1);
    const std::vector<std::uint32_t> colours = islandColours(loose, 3);
    ASSERT_EQ(colours.size(), 5u);
    EXPECT_EQ(colours[1], 0u) << "the largest chooses first";
    EXPECT_NE(colours[1], colours[2]);
    EXPECT_NE(colours[0], colours[1]);
    EXPECT_NE(colours[0], colours[2]);
    EXPECT_EQ(colours[3], 0u) << "the first that is free by then";
    EXPECT_EQ(colours[4], colours[0]) << "none is free: that of which there is least";
    EXPECT_TRUE(islandColours(LooseStructure(), 3).empty());
}

}  // namespace
}  // namespace rubble::render
