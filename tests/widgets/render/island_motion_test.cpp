#include "widgets/render/island_motion.h"

#include <gtest/gtest.h>

#include "core/simulation/simulation.h"
#include "tests/scenes/fe_scenes.h"
#include "tests/widgets/scenes/ballistic_run.h"
#include "widgets/render/pane_geometry.h"

namespace rubble::render {
namespace {

constexpr Rgb releasedColour{125, 90, 140};

ColourScale scaleOfTests() {
    ColourScale scale;
    scale.colours.structure = {{100, 100, 100}};
    scale.colours.fragment = {213, 94, 0};
    scale.colours.released = releasedColour;
    return scale;
}

/// A slab in the air, a pier and a block that dies. The FE result ends at 0.3 s; a run by hand turns the slab by a quarter about y
/// over 1 s, and lets it sink by 2 m, from then on.
struct Release {
    std::shared_ptr<const FeResult> fe;
    SceneData data;
    std::size_t slabElements = 6;
    Vec3 centre;
    std::shared_ptr<MemoryTrajectory> trajectory = std::make_shared<MemoryTrajectory>();

    Release() {
        scenes::Block slab;
        slab.name = "slab";
        slab.low = Vec3(10, 0, 20);
        slab.size = Vec3(3, 2, 1);
        slab.cells = {3, 2, 1};
        slab.velocity = Vec3(0, 0, -1);
        scenes::Block pier;
        pier.name = "pier";
        pier.size = Vec3(1, 1, 3);
        pier.cells = {1, 1, 3};
        scenes::Block dies;
        dies.name = "dies";
        dies.low = Vec3(30, 0, 5);
        dies.deathState = [](std::size_t) { return std::size_t{2}; };
        fe = scenes::makeScene({slab, pier, dies}, 4, 0.1);
        data = scenes::withoutRun(fe);
        data.trajectory = trajectory;
        centre = Vec3(11.5, 1, 20.2);
        trajectory->begin({});
    }
    TrajectoryFrame frameAt(double time, std::size_t bodies) const {
        TrajectoryFrame frame;
        frame.time = time;
        frame.positions.assign(bodies, data.fragments->list.front().centre.cast<float>());
        frame.orientations.assign(bodies, Eigen::Quaternionf::Identity());
        frame.speeds.assign(bodies, 0.0f);
        frame.states.assign(bodies, BodyState::Awake);
        if (bodies > 1) {
            const double share = time - 0.3;
            frame.positions[1] = Vec3(centre - 2.0 * share * Vec3::UnitZ()).cast<float>();
            frame.orientations[1] = Quat(Eigen::AngleAxisd(0.5 * M_PI * share, Vec3::UnitY())).cast<float>();
        }
        return frame;
    }
    void runToFeEnd() {
        const Fragment& f = data.fragments->list.front();
        const BodyRecord body{BodyId{0}, ClusterId{0}, f.handOverTime, f.endTime, f.mass, {f.centre, Quat::Identity()}};
        const Carrier carrier{FragmentId{0}, BodyId{0}, f.handOverTime, f.endTime, {-f.centre, Quat::Identity()}};
        trajectory->addBodies(std::span(&body, 1), std::span(&carrier, 1));
        trajectory->commit(frameAt(0.1, 1));
        trajectory->commit(frameAt(0.2, 1));
    }
    void release() {
        BodyRecord body;
        body.body = BodyId{1};
        body.cluster = noCluster;
        body.from = 0.3;
        body.atBirth.position = centre;
        trajectory->addBodies(std::span(&body, 1), {});
        IslandRecord island{BodyId{1}, {}};
        for (std::size_t e = 0; e < slabElements; ++e) {
            island.elements.push_back(idAt<ElementIndex>(e));
        }
        trajectory->addIslands(std::span(&island, 1), {});
        trajectory->commit(frameAt(0.3, 2));
        trajectory->commit(frameAt(1.3, 2));
        trajectory->finish({});
    }
};

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
    Release run;
    run.runToFeEnd();
    run.release();
    const ColourScale scale = scaleOfTests();
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
    Release run;
    run.runToFeEnd();
    const ColourScale scale = scaleOfTests();
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
    Release run;
    run.runToFeEnd();
    run.release();
    PaneGeometry pane(PaneContent::Fe, run.data, false);
    pane.update(1.3, ColourBy::Highlight, scaleOfTests(), {});
    EXPECT_EQ(pane.status().released, 0u);
    EXPECT_NEAR(boxOf(pane, Rgb{100, 100, 100}).max().z(), 20.7, 1e-5);
}

TEST(IslandMotion, PicksReleasedStructureWhereItIs) {
    Release run;
    run.runToFeEnd();
    run.release();
    PaneGeometry pane(PaneContent::Fragments, run.data, false);
    pane.update(1.3, ColourBy::Highlight, scaleOfTests(), {});
    const auto hit = pane.cast({Vec3(11.5, -50, 17.0), Vec3::UnitY()});
    ASSERT_TRUE(hit.has_value());
    EXPECT_LT(at(hit->element), run.slabElements);
    EXPECT_FALSE(hit->fragment.has_value());
    EXPECT_FALSE(pane.cast({Vec3(12.5, -50, 20.2), Vec3::UnitY()}).has_value()) << "its FE place is empty";
}

TEST(IslandMotion, LeavesOutWhatNamesNoBodyOrElement) {
    const Release run;
    IslandMotion motion;
    const std::vector<BodyRecord> bodies(1);
    const std::vector<IslandRecord> islands{{BodyId{7}, {ElementIndex{0}}}, {BodyId{0}, {ElementIndex{99999}}}};
    motion.bind(run.fe->mesh(), islands, bodies);
    EXPECT_TRUE(motion.empty());
}

}  // namespace
}  // namespace rubble::render
