#include "widgets/render/shapes/island_motion.h"

#include <gtest/gtest.h>

#include "tests/widgets/scenes/released_slab.h"
#include "widgets/render/pane_geometry.h"

namespace rubble::render {
namespace {

constexpr Rgb releasedColour{125, 90, 140};

ColourScale scaleOfIslands() {
    ColourScale scale;
    scale.colours.structure = {{100, 100, 100}};
    scale.colours.fragment = {213, 94, 0};
    scale.colours.released = releasedColour;
    return scale;
}

/// Box of all points of a colour.
Aabb boxOf(const PaneGeometry& pane, const Rgb& colour) {
    Aabb box;
    for (std::size_t i = 0; i < pane.points().size() / 3; ++i) {
        const std::uint8_t* c = pane.colours().data() + 4 * i;
        if (Rgb{c[0], c[1], c[2]} == colour) {
            const float* p = pane.points().data() + 3 * i;
            box.extend(Vec3(p[0], p[1], p[2]));
        }
    }
    return box;
}

TEST(IslandMotion, CarriesReleasedStructureInItsOwnColour) {
    scenes::ReleasedSlab run;
    run.runToFeEnd();
    run.release();
    const ColourScale scale = scaleOfIslands();
    PaneGeometry pane(PaneContent::Fragments, run.data, false);
    pane.update(0.2, ColourBy::Highlight, scale, {});
    EXPECT_EQ(pane.status().released, 0u);
    EXPECT_EQ(pane.status().active, 9u);
    EXPECT_TRUE(boxOf(pane, releasedColour).isEmpty());
    pane.update(0.3, ColourBy::Highlight, scale, {});
    EXPECT_EQ(pane.status().released, 6u);
    EXPECT_EQ(pane.status().active, 3u);
    Aabb box = boxOf(pane, releasedColour);
    EXPECT_LT((box.min() - Vec3(10, 0, 19.7)).norm(), 1e-5) << "where the FE result left it";
    EXPECT_LT((box.max() - Vec3(13, 2, 20.7)).norm(), 1e-5);
    pane.update(1.3, ColourBy::Highlight, scale, {});
    box = boxOf(pane, releasedColour);
    // A quarter turn about y swaps x and z; the centre has sunk by 2 m.
    EXPECT_LT((box.min() - Vec3(11, 0, 16.7)).norm(), 1e-4);
    EXPECT_LT((box.max() - Vec3(12, 2, 19.7)).norm(), 1e-4);
    EXPECT_LT((boxOf(pane, Rgb{100, 100, 100}).max() - Vec3(1, 1, 3)).norm(), 1e-5) << "nothing is left at its FE place";
    // Scrubbing back makes structure of it again.
    pane.update(0.2, ColourBy::Highlight, scale, {});
    EXPECT_TRUE(boxOf(pane, releasedColour).isEmpty());
    EXPECT_EQ(pane.status().active, 9u);
}

TEST(IslandMotion, FollowsARunThatGrows) {
    scenes::ReleasedSlab run;
    run.runToFeEnd();
    const ColourScale scale = scaleOfIslands();
    PaneGeometry pane(PaneContent::Fragments, run.data, false);
    pane.update(1.0, ColourBy::Highlight, scale, {});
    EXPECT_TRUE(pane.status().waitsForRun);
    EXPECT_EQ(pane.status().released, 0u);
    run.release();
    pane.update(0.8, ColourBy::Component, scale, {});
    EXPECT_EQ(pane.status().released, 6u);
    EXPECT_NEAR(boxOf(pane, releasedColour).center().z(), 20.2 - 1.0, 1e-4);
}

TEST(IslandMotion, LeavesTheFePaneAtTheLastState) {
    scenes::ReleasedSlab run;
    run.runToFeEnd();
    run.release();
    PaneGeometry pane(PaneContent::Fe, run.data, false);
    pane.update(1.3, ColourBy::Highlight, scaleOfIslands(), {});
    EXPECT_EQ(pane.status().released, 0u);
    EXPECT_NEAR(boxOf(pane, Rgb{100, 100, 100}).max().z(), 20.7, 1e-5);
}

TEST(IslandMotion, PicksReleasedStructureWhereItIs) {
    scenes::ReleasedSlab run;
    run.runToFeEnd();
    run.release();
    PaneGeometry pane(PaneContent::Fragments, run.data, false);
    pane.update(1.3, ColourBy::Highlight, scaleOfIslands(), {});
    const auto hit = pane.cast({Vec3(11.5, -50, 17.0), Vec3::UnitY()});
    ASSERT_TRUE(hit.has_value());
    EXPECT_LT(at(hit->element), run.slabElements);
    EXPECT_FALSE(hit->fragment.has_value());
    EXPECT_FALSE(pane.cast({Vec3(12.5, -50, 20.2), Vec3::UnitY()}).has_value()) << "its FE place is empty";
}

TEST(IslandMotion, LeavesOutWhatNamesNoBodyOrElement) {
    const scenes::ReleasedSlab run;
    IslandMotion motion;
    const std::vector<BodyRecord> bodies(1);
    const std::vector<IslandRecord> islands{{BodyId{7}, {ElementIndex{0}}}, {BodyId{0}, {ElementIndex{99999}}}};
    motion.bind(run.fe->mesh(), islands, bodies);
    EXPECT_TRUE(motion.empty());
}

}  // namespace
}  // namespace rubble::render
