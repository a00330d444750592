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

TEST(LooseBodies, CarryWhatLiesOnThemAtTheHeightWhereItLies) {
    WorldScene scene;
    scene.solver = SolverKind::SoftStep;
    NewBody bar = boxBody({0, 0, 1}, {20, 2, 2}, {5, 0, 0});
    bar.loose = true;
    scene.world().addBody(bar);
    const BodyId carried = scene.box({0, 0, 2.5}, {1, 1, 1}, {5, 0, 0});
    scene.run(0.1);
    const double energy = 0.5 * scene.velocity(carried).squaredNorm() + standardGravity * scene.place(carried).z();
    EXPECT_GE(scene.world().loosePush(carried), 0.999 * energy) << "its centre lies half a metre above where it is pushed";
}

/// m, by which two cubes, one on the other on the ground, lie in others in the mean of the two seconds after a block of 2,400 t
/// came down on them; mean of twelve places of the block, for one fall alone is chance.
double leftInside(bool partsJammed) {
    double sum = 0.0;
    int count = 0;
    for (int place = 0; place < 12; ++place) {
        WorldScene scene;
        scene.solver = SolverKind::SoftStep;
        scene.settings.partsJammed = partsJammed;
        scene.settings.substeps = 4;
        scene.dt = 1.0 / 25.0;
        const BodyId cube = scene.box({0, 0, 0.25}, {0.5, 0.5, 0.5});
        const BodyId other = scene.box({0, 0, 0.75}, {0.5, 0.5, 0.5});
        scene.run(0.5);
        scene.box({0.2 * place, 0, 6.0}, {10, 10, 10}, {0, 0, -5});
        scene.run(0.2);
        for (int step = 0; step < 50; ++step, count += 2) {
            scene.run(scene.dt);
            sum += scene.world().penetration(cube) + scene.world().penetration(other);
        }
    }
    return sum / count;
}

TEST(LooseBodies, WhatIsSqueezedComesApartByPosition) {
    const double squeezed = leftInside(false), apart = leftInside(true);
    EXPECT_GT(squeezed, 0.05) << "or the case asks for nothing";
    EXPECT_LT(apart, 0.7 * squeezed);
}

}  // namespace
}  // namespace rubble
