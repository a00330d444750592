#include "core/fe/live_islands.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/pipeline/pipeline.h"
#include "core/simulation/bodies/island_bodies.h"
#include "core/simulation/bodies/loose_count.h"
#include "core/simulation/run/simulation.h"
#include "tests/core/fragments/element_scene.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

const SiteSurface flatGround{true, 0.0, nullptr};

std::vector<Vec3> cube(const Vec3& low, double side = 1.0) {
    std::vector<Vec3> corners;
    for (const auto& c :
         {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)}) {
        corners.push_back(low + side * c);
    }
    return corners;
}

std::vector<LiveIsland> islandsOf(const FeResult& fe, const SiteSurface& ground = flatGround) {
    return liveIslands(fe, fe.activity(), ground);
}

/// One element that goes from its place at rest to another over the three states, and whether that leaves it supported.
bool supportedAfter(const test::ElementScene::Motion& motion, const Vec3& low = Vec3(0, 0, 0)) {
    test::ElementScene scene;
    scene.element(ElementShape::Hexahedron, cube(low), "111");
    scene.position = motion;
    return islandsOf(*scene.result()).front().supported;
}

TEST(LiveIslands, HangTogetherBySharedNodes) {
    scenes::Block one;
    one.name = "one";
    one.size = Vec3(5, 1, 1);
    one.cells = {5, 1, 1};
    one.deathState = [](std::size_t e) { return e == 2 ? std::size_t{1} : scenes::never; };
    scenes::Block touching = one;
    touching.name = "touching";
    touching.low = Vec3(0, 1, 0);
    touching.deathState = [](std::size_t) { return scenes::never; };
    const auto fe = scenes::makeScene({one, touching}, 3, 0.1);
    const std::vector<LiveIsland> islands = islandsOf(*fe);
    ASSERT_EQ(islands.size(), 3u) << "the death in the middle parts the first block; nodes in one place are not one node";
    EXPECT_EQ(islands[0].elements.size(), 2u);
    EXPECT_EQ(islands[1].elements.size(), 2u);
    EXPECT_EQ(islands[2].elements.size(), 5u);
}

TEST(LiveIslands, AreSupportedWhereAFaceStandsStill) {
    const Vec3 high(0, 0, 30);
    EXPECT_TRUE(supportedAfter([](const Vec3& x, double) { return x; }, high)) << "held in the air by what the file does not name";
    EXPECT_TRUE(supportedAfter([](const Vec3& x, double t) { return Vec3(x + 0.004 * t * Vec3::UnitX()); }, high)) << "8 mm";
    EXPECT_FALSE(supportedAfter([](const Vec3& x, double t) { return Vec3(x + 0.006 * t * Vec3::UnitX()); }, high)) << "12 mm";
    EXPECT_FALSE(supportedAfter([](const Vec3& x, double t) { return Vec3(x + t * (t - 2) * Vec3::UnitX()); }, high))
        << "it is where it was, at 1 m/s";
    // It turns about an edge: two corners stand still, no face does.
    const auto topple = [](const Vec3& x, double t) { return Vec3(Eigen::AngleAxisd(0.3 * t, Vec3::UnitY()) * x); };
    EXPECT_FALSE(supportedAfter(topple));
    const auto nothing = [](const Vec3&, double) { return Vec3(Vec3::Constant(std::numeric_limits<double>::quiet_NaN())); };
    EXPECT_FALSE(supportedAfter(nothing));
}

TEST(LiveIslands, AreSupportedWhereTheyStoodOnTheGroundAndStillDo) {
    const auto slid = [](double distance) {
        return [distance](const Vec3& x, double t) { return Vec3(x + (t > 0.5 ? distance : 0.0) * Vec3::UnitX()); };
    };
    EXPECT_TRUE(supportedAfter(slid(0.4))) << "a foundation that an earthquake moved";
    EXPECT_FALSE(supportedAfter(slid(0.6)));
    EXPECT_FALSE(supportedAfter(slid(0.4), Vec3(0, 0, 1))) << "did not stand on the ground";
    const auto landed = [](const Vec3& x, double t) { return Vec3(x - (t > 0.5 ? 1.0 : 0.0) * Vec3::UnitZ()); };
    EXPECT_FALSE(supportedAfter(landed, Vec3(0, 0, 1))) << "what fell and lies on the ground is loose";
    test::ElementScene scene;
    scene.element(ElementShape::Hexahedron, cube(Vec3::Zero()), "111");
    scene.position = slid(0.4);
    EXPECT_FALSE(islandsOf(*scene.result(), {false, 0.0, nullptr}).front().supported) << "no ground, no support";
}

TEST(LiveIslands, ShellsStandOnAnEdgeAndBeamsOnANode) {
    const auto lean = [](const Vec3& x, double t) { return Vec3(x + (t > 0.5 ? 0.1 * x.z() : 0.0) * Vec3::UnitX()); };
    test::ElementScene scene;
    scene.element(ElementShape::Quadrilateral, {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}, "111", 0.2);
    scene.element(ElementShape::Beam, {{5, 0, 0}, {5, 0, 3}}, "111", 0.01);
    scene.element(ElementShape::Triangle, {{9, 0, 0}, {9, 1, 1}, {9, -1, 1}}, "111", 0.2);
    scene.position = lean;
    const std::vector<LiveIsland> islands = islandsOf(*scene.result());
    ASSERT_EQ(islands.size(), 3u);
    EXPECT_TRUE(islands[0].supported);
    EXPECT_TRUE(islands[1].supported);
    EXPECT_FALSE(islands[2].supported) << "one corner of a shell";
}

TEST(LiveIslands, LooseOnesAreCounted) {
    scenes::Block stands;
    stands.name = "stands";
    stands.size = Vec3(3, 1, 3);
    stands.cells = {3, 1, 3};
    scenes::Block falls;
    falls.name = "falls";
    falls.low = Vec3(10, 0, 20);
    falls.size = Vec3(2, 1, 1);
    falls.cells = {2, 1, 1};
    falls.gravity = standardGravity;
    for (const bool withVelocity : {true, false}) {
        const auto fe = scenes::makeScene({stands, falls}, 8, 0.1, withVelocity);
        const Components components = groupComponents(fe->mesh(), {}, {}, {});
        const LiveIslands count = countLoose(*fe, components, islandsOf(*fe));
        EXPECT_EQ(count.islands, 1);
        EXPECT_EQ(count.elements, 2);
        EXPECT_NEAR(count.mass, 2 * 2000.0, 1e-6);
        EXPECT_EQ(count.moving, 2);
        EXPECT_EQ(count.released, 0);
    }
}

/// Bodies of the loose islands of a scene.
struct Made {
    RunDescription description;
    Activity activity;
    Findings findings;
    std::vector<IslandBody> bodies;

    explicit Made(std::shared_ptr<const FeResult> fe, const Scenario& scenario = {}) : activity(fe->activity()) {
        description.components = std::make_shared<Components>(groupComponents(fe->mesh(), {}, {}, {}));
        description.scenario = scenario;
        description.fe = fe;
        std::vector<LiveIsland> islands = islandsOf(*fe);
        std::erase_if(islands, [](const LiveIsland& island) { return island.supported; });
        IslandMaker maker(description, activity, islands, fe->stateCount() - 1);
        for (const LiveIsland& island : islands) {
            if (auto body = maker.make(island, findings)) {
                bodies.push_back(std::move(*body));
            }
        }
    }
};

/// A bar of three cubes in the air that flies and turns as a rigid body.
test::ElementScene turningBar(bool withVelocity) {
    test::ElementScene scene;
    const Vec3 spin(0.3, -0.2, 0.5), drift(2, 1, -4), about(10.5, 20.5, 30.5);
    const auto turn = [=](double t) { return Eigen::AngleAxisd(spin.norm() * t, spin.normalized()).toRotationMatrix(); };
    scene.times = {0.0, 0.01, 0.02, 0.03};
    scene.position = [=](const Vec3& x, double t) { return Vec3(about + turn(t) * (x - about) + t * drift); };
    if (withVelocity) {
        scene.velocity = [=](const Vec3& x, double t) { return Vec3(drift + spin.cross(turn(t) * (x - about))); };
    }
    scene.element(ElementShape::Hexahedron, cube(Vec3(9, 20, 30)), "1111");
    scene.element(ElementShape::Hexahedron, cube(Vec3(11, 20, 30)), "1111");
    scene.between(ElementShape::Hexahedron, {1, 8, 11, 2, 5, 12, 15, 6}, "1111");
    return scene;
}

TEST(IslandBodies, KeepMassMomentumAndSpinOfTheirElements) {
    for (const bool withVelocity : {true, false}) {
        const Made made(turningBar(withVelocity).result());
        ASSERT_EQ(made.bodies.size(), 1u);
        const IslandBody& body = made.bodies.front();
        EXPECT_EQ(body.elements.size(), 3u);
        EXPECT_NEAR(body.motion.mass, 6000.0, 1e-9);
        // Differences over three states 0.01 s apart miss the third derivative: (0.6 rad/s)^3 x 1.6 m x h^2 / 3.
        EXPECT_LT((body.motion.angularVelocity - Vec3(0.3, -0.2, 0.5)).norm(), withVelocity ? 1e-9 : 5e-5);
        const double momentum = body.fe.linear.norm();
        const double angular = body.motion.centre.norm() * momentum;
        EXPECT_LT((body.fe.linear - body.rigid.linear).norm(), 1e-12 * momentum);
        EXPECT_LT((body.fe.angular - body.rigid.angular).norm(), 1e-12 * angular);
        const MovingMass& m = body.motion;
        const Momenta joined = rigidMomenta(m.mass, m.centre, m.inertia, m.velocity, m.angularVelocity);
        EXPECT_LT((joined.linear - body.fe.linear).norm(), 1e-12 * momentum);
        EXPECT_LT((joined.angular - body.fe.angular).norm(), 1e-12 * angular);
        // A bar of 3 x 1 x 1 m: m (1 + 1) / 12 along it, m (9 + 1) / 12 across.
        EXPECT_NEAR(body.inertia.x(), 1000.0, 1e-6);
        EXPECT_NEAR(body.inertia.z(), 5000.0, 1e-6);
    }
}

/// Floating blocks that fall from the first state on, so that nothing holds them.
scenes::Block falling(const std::string& name, const Vec3& low, const Vec3& size, std::array<int, 3> cells) {
    scenes::Block block;
    block.name = name;
    block.low = low;
    block.size = size;
    block.cells = cells;
    block.gravity = standardGravity;
    return block;
}

TEST(IslandBodies, ThousandsOfElementsMakeOneBodyOfFewBoxes) {
    const auto fe = scenes::makeScene({falling("deck", Vec3(0, 0, 50), Vec3(100, 20, 1), {100, 20, 2})}, 4, 0.1);
    Scenario cells;
    cells.simulation.shape = ClusterShape::OrientedBox;
    const Made made(fe, cells);
    ASSERT_EQ(made.bodies.size(), 1u);
    const IslandBody& body = made.bodies.front();
    EXPECT_EQ(body.elements.size(), 4000u);
    EXPECT_NEAR(body.motion.mass, 2000.0 * 100 * 20, 1e-6 * body.motion.mass);
    EXPECT_NEAR(body.volume, 2000.0, 1e-6);
    // 4 m cells would be 25 x 5 x 1; of 8 m it is 13 x 3.
    EXPECT_EQ(body.shape.size(), 39u);
    double volume = 0.0;
    for (const ConvexPart& part : body.shape) {
        volume += part.box.volume();
    }
    EXPECT_NEAR(volume, 2000.0, 1.0) << "boxes of a regular slab fill it and nothing else";
    const Made bricks(fe);
    ASSERT_EQ(bricks.bodies.size(), 1u);
    EXPECT_LE(bricks.bodies.front().shape.size(), 8u);
    double joined = 0.0;
    for (const ConvexPart& part : bricks.bodies.front().shape) {
        joined += part.box.volume();
        EXPECT_LT(2.0 * part.box.halfExtents.minCoeff(), 1.01) << "no box is thicker than the slab, however long it is";
    }
    EXPECT_NEAR(joined, 2000.0, 1.0);
    const Vec3 sides(100, 20, 1);
    const double mass = body.motion.mass;
    EXPECT_NEAR(body.inertia.maxCoeff(), mass * (sides.x() * sides.x() + sides.y() * sides.y()) / 12.0, 1e-6 * mass * 1e4);
}

TEST(IslandBodies, OneElementMakesABody) {
    const Made made(scenes::makeScene({falling("brick", Vec3(3, 4, 5), Vec3(2, 1, 1), {1, 1, 1})}, 2, 0.1));
    ASSERT_EQ(made.bodies.size(), 1u);
    ASSERT_EQ(made.bodies.front().shape.size(), 1u);
    EXPECT_NEAR(made.bodies.front().shape.front().box.volume(), 2.0, 1e-6);
    EXPECT_TRUE(made.findings.empty());
}

TEST(IslandBodies, WithoutNumbersOrMassTheyAreRefused) {
    test::ElementScene scene;
    scene.times = {0.0, 0.1, 0.2};
    scene.element(ElementShape::Hexahedron, cube(Vec3(0, 0, 9)), "111");
    std::vector<Vec3> flat = cube(Vec3(5, 0, 9));
    for (Vec3& p : flat) {
        p.z() = 9;
    }
    scene.element(ElementShape::Hexahedron, flat, "111");
    scene.element(ElementShape::Hexahedron, cube(Vec3(10, 0, 9)), "111");
    scene.position = [](const Vec3& x, double t) { return Vec3(x - 5.0 * t * Vec3::UnitZ()); };
    scene.damage = [](std::size_t, FeState& state) { state.positions[3].y() = std::numeric_limits<double>::quiet_NaN(); };
    const Made made(scene.result());
    ASSERT_EQ(made.bodies.size(), 1u);
    EXPECT_EQ(made.bodies.front().elements.front(), idAt<ElementIndex>(2));
    EXPECT_EQ(made.findings.count("simulation.island_refused"), 2);
}

TEST(IslandBodies, ASingleStateTellsNoVelocity) {
    // Active at the last state only, away from its place at rest.
    test::ElementScene scene;
    scene.element(ElementShape::Hexahedron, cube(Vec3(0, 0, 9)), "001");
    scene.position = [](const Vec3& x, double t) { return Vec3(x - t * Vec3::UnitZ()); };
    const Made made(scene.result());
    ASSERT_EQ(made.bodies.size(), 1u);
    EXPECT_EQ(made.bodies.front().motion.velocity, Vec3::Zero());
    EXPECT_EQ(made.findings.count("simulation.island_no_velocity"), 1);
}

TEST(IslandBodies, AreBornAtRestWhereAllBodiesAre) {
    Scenario scenario;
    scenario.fragments.birthVelocity = BirthVelocity::Rest;
    const Made made(scenes::makeScene({falling("brick", Vec3(3, 4, 5), Vec3(2, 1, 1), {1, 1, 1})}, 4, 0.1), scenario);
    EXPECT_EQ(made.bodies.front().motion.velocity, Vec3::Zero());
    EXPECT_GT(made.bodies.front().fe.linear.norm(), 0.0);
}

}  // namespace
}  // namespace rubble
