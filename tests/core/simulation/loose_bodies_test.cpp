#include <gtest/gtest.h>

#include "core/base/standard_gravity.h"
#include "tests/core/simulation/world_scene.h"

namespace rubble {
namespace {

using test::boxBody;
using test::WorldScene;

/// A bar of 20 m that turns about its middle at 2 rad/s without gravity, and two cubes in a row before one of its ends.
struct TurningSpan {
    WorldScene scene;
    BodyId span{}, first{}, second{}, far{};

    explicit TurningSpan(bool loose) {
        scene.solver = SolverKind::SoftStep;
        scene.settings.ground = false;
        scene.settings.gravity = 0.0;
        NewBody bar = boxBody({0, 0, 0}, {20, 2, 2}, Vec3::Zero(), Quat::Identity(), {0, 0, 2});
        bar.loose = loose;
        span = scene.world().addBody(bar);
        first = scene.box({9.5, 1.8, 0}, {1, 1, 1});
        second = scene.box({9.5, 2.9, 0}, {1, 1, 1});
        far = scene.box({0, 30, 0}, {1, 1, 1});
        scene.run(0.5);
    }
};

TEST(LooseBodies, TellHowFastTheyWereWhereTheyPushed) {
    TurningSpan turning(true);
    RigidWorld& world = turning.scene.world();
    // Its corner is sqrt(101) m from the middle, the cube's inner edge 9 m.
    const double least = 0.5 * 15.0 * 15.0, most = 0.5 * 4.0 * 101.0;
    EXPECT_GT(world.loosePush(turning.first), least);
    EXPECT_LE(world.loosePush(turning.first), most);
    EXPECT_GT(turning.scene.velocity(turning.first).norm(), 10.0);
    EXPECT_GT(turning.scene.velocity(turning.second).norm(), 5.0);
    EXPECT_GT(world.loosePush(turning.second), noPush) << "it was pushed through the first one";
    EXPECT_LE(world.loosePush(turning.second), world.loosePush(turning.first));
    EXPECT_EQ(world.loosePush(turning.far), noPush);
    EXPECT_EQ(world.loosePush(turning.span), noPush);
}

TEST(LooseBodies, NothingElseTellsSo) {
    TurningSpan turning(false);
    EXPECT_GT(turning.scene.velocity(turning.first).norm(), 10.0);
    EXPECT_EQ(turning.scene.world().loosePush(turning.first), noPush);
    EXPECT_EQ(turning.scene.world().loosePush(turning.second), noPush);
}

/// m, by which a block of 2,400 t has pressed itself into a cube that lies on the ground, some time after it came down.
double leftInside(bool partsJammed) {
    WorldScene scene;
    scene.solver = SolverKind::SoftStep;
    scene.settings.partsJammed = partsJammed;
    scene.settings.substeps = 4;
    scene.dt = 1.0 / 25.0;
    const BodyId cube = scene.box({0, 0, 0.25}, {0.5, 0.5, 0.5});
    const BodyId other = scene.box({0, 0, 0.75}, {0.5, 0.5, 0.5});
    scene.run(0.5);
    scene.box({0, 0, 6.0}, {10, 10, 10}, {0, 0, -5});
    scene.run(0.6);
    return std::max(scene.world().penetration(cube), scene.world().penetration(other));
}

TEST(LooseBodies, WhatIsSqueezedComesApartByPosition) {
    const double squeezed = leftInside(false), apart = leftInside(true);
    EXPECT_GT(squeezed, 0.05) << "or the case asks for nothing";
    EXPECT_LT(apart, 0.7 * squeezed);
}

}  // namespace
}  // namespace rubble
