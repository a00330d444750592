#include "widgets/render/shapes/island_motion.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>

#include "core/pipeline/pipeline.h"
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
    IslandMotion motion(run.fe);
    const std::vector<BodyRecord> bodies(1);
    motion.bind({{BodyId{7}, 0, {}, {ElementIndex{0}}}, {BodyId{0}, 0, {}, {ElementIndex{99999}}}}, bodies);
    motion.moveTo({}, 0.1);
    EXPECT_EQ(motion.elements(), 0u);
    EXPECT_EQ(motion.of(0), IslandMotion::none);
}

/// Reads of each state.
class CountingSource : public StateSource {
public:
    explicit CountingSource(std::shared_ptr<const FeResult> fe) : m_fe(std::move(fe)) {}
    FeState read(std::size_t k) const override {
        ++reads;
        return *m_fe->state(k);
    }
    mutable std::atomic<std::size_t> reads = 0;

private:
    std::shared_ptr<const FeResult> m_fe;
};

/// The slab of ReleasedSlab, carried from 0.1 s on by a body that turns it by half a turn about z; from 0.2 s on by two bodies: its
/// first elements shoot up, its last two stay with a body that moves sideways until 0.3 s.
struct CarriedSlab {
    std::shared_ptr<const FeResult> fe = scenes::ReleasedSlab().fe;
    std::shared_ptr<CountingSource> source = std::make_shared<CountingSource>(fe);
    std::vector<BodyRecord> bodies;
    std::vector<IslandRecord> islands;

    CarriedSlab() {
        FeResult::Contents contents = fe->contents();
        contents.source = source;
        fe = std::make_shared<FeResult>(std::move(contents), 0);
        add(0.1, 0.2, 1, Vec3(11.5, 1, 20.4), {0, 1, 2, 3, 4, 5});
        add(0.2, std::numeric_limits<double>::infinity(), 1, Vec3(11, 1, 20.4), {0, 1, 3, 4});
        add(0.2, 0.3, 1, Vec3(12.5, 1, 20.4), {2, 5});
    }
    void add(double from, double to, std::uint32_t state, const Vec3& centre, const std::vector<std::size_t>& elements) {
        BodyRecord body;
        body.body = idAt<BodyId>(bodies.size());
        body.cluster = noCluster;
        body.from = from;
        body.to = to;
        body.atBirth.position = centre;
        bodies.push_back(body);
        islands.push_back({body.body, state, {centre, Quat::Identity()}, {}});
        for (const std::size_t e : elements) {
            islands.back().elements.push_back(idAt<ElementIndex>(e));
        }
    }
    /// The body of each island moved by this, and the first turned.
    static TrajectoryFrame frame() {
        TrajectoryFrame frame;
        frame.positions = {{11.5f, 1, 0.5f}, {11, 1, 90}, {-12.5f, 1, 20.4f}};
        frame.orientations.assign(3, Eigen::Quaternionf::Identity());
        frame.orientations[0] = Eigen::Quaternionf(Eigen::AngleAxisf(static_cast<float>(M_PI), Eigen::Vector3f::UnitZ()));
        return frame;
    }
    Aabb boxOf(const IslandMotion& motion, ElementIndex e) const {
        Aabb box;
        for (const std::uint32_t node : fe->mesh().cornersOf(e)) {
            box.extend(motion.place(node).cast<double>());
        }
        return box;
    }
};

TEST(IslandMotion, ANodeRidesOnOneBodyAfterTheOther) {
    const CarriedSlab slab;
    IslandMotion motion(slab.fe);
    motion.bind(slab.islands, slab.bodies);
    const std::uint32_t shared = slab.fe->mesh().cornersOf(ElementIndex{0})[0];
    motion.moveTo(CarriedSlab::frame(), 0.05);
    EXPECT_EQ(motion.elements(), 0u);
    EXPECT_EQ(motion.of(shared), IslandMotion::none);
    motion.moveTo(CarriedSlab::frame(), 0.1);
    EXPECT_EQ(motion.elements(), 6u);
    // Element 0 lies at (10, 0, 19.9) at 0.1 s, and half a turn about (11.5, 1) brings it to the far end; the body hangs 19.9
    // lower.
    Aabb box = slab.boxOf(motion, ElementIndex{0});
    EXPECT_LT((box.min() - Vec3(12, 1, 0.0)).norm(), 1e-5);
    EXPECT_LT((box.max() - Vec3(13, 2, 1.0)).norm(), 1e-5);
    const std::uint64_t version = motion.version();
    motion.moveTo(CarriedSlab::frame(), 0.15);
    EXPECT_EQ(motion.version(), version) << "the same islands";
    motion.moveTo(CarriedSlab::frame(), 0.25);
    EXPECT_NE(motion.version(), version);
    EXPECT_EQ(motion.elements(), 6u);
    EXPECT_NE(motion.of(shared), motion.of(slab.fe->mesh().cornersOf(ElementIndex{5})[6]));
    EXPECT_LT((slab.boxOf(motion, ElementIndex{0}).min() - Vec3(10, 0, 89.5)).norm(), 1e-5);
    EXPECT_LT((slab.boxOf(motion, ElementIndex{5}).min() - Vec3(-13, 1, 19.9)).norm(), 1e-5);
    motion.moveTo(CarriedSlab::frame(), 0.3);
    EXPECT_EQ(motion.elements(), 4u) << "the body of the others has left";
    motion.moveTo(CarriedSlab::frame(), 0.0);
    EXPECT_EQ(motion.elements(), 0u);
}

TEST(IslandMotion, ReadsAStateOnceForAllThatIsLeftOfAnIsland) {
    const CarriedSlab slab;
    IslandMotion motion(slab.fe);
    motion.bind(slab.islands, slab.bodies);
    EXPECT_EQ(slab.source->reads, 0u) << "nothing before it is shown";
    for (int i = 0; i < 100; ++i) {
        motion.moveTo(CarriedSlab::frame(), i % 2 == 0 ? 0.25 : 0.05 + 0.003 * i);
    }
    EXPECT_EQ(slab.source->reads, 1u);
    // A run that grows brings another island of another state, and keeps what is held of the first.
    std::vector<IslandRecord> more = slab.islands;
    std::vector<BodyRecord> bodies = slab.bodies;
    BodyRecord& body = bodies.emplace_back(bodies.back());
    body.body = BodyId{3};
    body.from = 0.3;
    body.to = 0.4;
    more.push_back({BodyId{3}, 3, {Vec3(12.5, 1, 20.2), Quat::Identity()}, {ElementIndex{2}}});
    motion.bind(more, bodies);
    motion.moveTo(CarriedSlab::frame(), 0.15);
    EXPECT_EQ(slab.source->reads, 1u);
    motion.moveTo(CarriedSlab::frame(), 0.35);
    EXPECT_EQ(motion.elements(), 5u);
    EXPECT_EQ(slab.source->reads, 2u);
}

/// The run of a slab that came loose before the FE result ends, as the simulation makes it.
struct SimulatedSlab {
    std::shared_ptr<const FeResult> fe;
    render::SceneData data;

    SimulatedSlab() {
        scenes::Block slab;
        slab.name = "slab";
        slab.low = Vec3(0, 0, 12);
        slab.size = Vec3(3, 2, 1);
        slab.cells = {3, 2, 1};
        slab.gravity = 9.81;
        slab.deathState = [](std::size_t e) { return e == 0 ? std::size_t{9} : scenes::never; };
        scenes::Block dies;
        dies.name = "dies";
        dies.low = Vec3(30, 0, 5);
        dies.deathState = [](std::size_t) { return std::size_t{2}; };
        fe = scenes::makeScene({slab, dies}, 20, 0.1);
        Scenario scenario;
        scenario.effects.loose = LooseStructurePolicy::AtOnce;
        scenario.simulation.settleTime = 1.0;
        auto run = std::make_shared<MemoryTrajectory>();
        const Results results = rubble::run({fe, {}}, scenario, Stage::Simulation, {}, run.get(), Execution());
        data = scenes::withoutRun(fe);
        data.fragments = results.fragments;
        data.clustering = results.clustering;
        data.components = results.components;
        data.trajectory = run;
    }
};

TEST(IslandMotion, ShowsAnIslandWhereTheEngineHasItBeforeTheFeResultEnds) {
    const SimulatedSlab run;
    const std::vector<IslandRecord> islands = run.data.trajectory->islands();
    ASSERT_GE(islands.size(), 2u) << "the slab, and what is left of it";
    PaneGeometry pane(PaneContent::Fragments, run.data, false);
    PaneGeometry fe(PaneContent::Fe, run.data, false);
    const double tookOver = run.data.trajectory->bodies()[at(islands[0].body)].from;
    EXPECT_LT(tookOver, 0.8);
    for (const double time : {tookOver, 0.75, 0.8, 0.85, 1.3}) {
        pane.update(time, ColourBy::Highlight, scaleOfIslands(), {});
        // Out of the island at 0.8 s and born at 0.9 s: until then it is no active structure again.
        const bool lost = time >= 0.9;
        EXPECT_EQ(pane.status().released, lost ? 5u : 6u) << time;
        if (time > tookOver) {
            EXPECT_EQ(pane.status().active, 0u) << time;
            EXPECT_EQ(pane.status().fragments, lost ? 2u : 1u) << time;
            EXPECT_TRUE(boxOf(pane, scaleOfIslands().colours.structure.front()).isEmpty()) << time;
        }
        const Aabb box = boxOf(pane, releasedColour);
        // It falls on its parabola; the FE result moves linearly between its states, and the engine does not.
        EXPECT_NEAR(box.min().z(), 12.0 - 0.5 * 9.81 * time * time, 0.02) << time;
        fe.update(time, ColourBy::Highlight, scaleOfIslands(), {});
        EXPECT_EQ(fe.status().released, 0u);
    }
    // The FE result lets it fall through the ground; in the engine it has landed.
    pane.update(2.4, ColourBy::Highlight, scaleOfIslands(), {});
    EXPECT_NEAR(boxOf(pane, releasedColour).min().z(), 0.0, 0.05);
    EXPECT_EQ(pane.elementsWhere([](const Vec3& centre) { return centre.z() < -0.5; }).size(), 0u);
}

}  // namespace
}  // namespace rubble::render
