#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

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

TEST(LooseBodies, HandOnTheSpeedOfThePointThatPushes) {
    TurningSpan turning(true);
    RigidWorld& world = turning.scene.world();
    // Its corner is sqrt(101) m from the middle, the cube's inner edge 9 m.
    const double least = 0.5 * 15.0 * 15.0, most = 0.5 * 4.0 * 101.0;
    EXPECT_GT(world.handedEnergy(turning.first), least);
    EXPECT_LE(world.handedEnergy(turning.first), most);
    EXPECT_GT(turning.scene.velocity(turning.first).norm(), 10.0);
    EXPECT_GT(turning.scene.velocity(turning.second).norm(), 5.0);
    EXPECT_GT(world.handedEnergy(turning.second), noPush) << "it was pushed through the first one";
    EXPECT_LE(world.handedEnergy(turning.second), world.handedEnergy(turning.first));
    EXPECT_EQ(world.handedEnergy(turning.far), noPush);
    EXPECT_EQ(world.handedEnergy(turning.span), noPush) << "what it carries along does not drive it on";
}

TEST(LooseBodies, AndSoDoAllOthers) {
    TurningSpan loose(true), other(false);
    EXPECT_EQ(loose.scene.world().handedEnergy(loose.first), other.scene.world().handedEnergy(other.first));
    EXPECT_EQ(loose.scene.world().handedEnergy(loose.second), other.scene.world().handedEnergy(other.second));
}

TEST(LooseBodies, HandOnNoMoreThanTheyMayHave) {
    WorldScene scene;
    scene.solver = SolverKind::SoftStep;
    scene.settings.ground = false;
    scene.settings.gravity = 0.0;
    const BodyId bar = scene.world().addBody(boxBody({0, 0, 0}, {20, 2, 2}, {0, 3, 0}));
    const BodyId first = scene.box({9.5, 1.8, 0}, {1, 1, 1}), second = scene.box({9.5, 2.9, 0}, {1, 1, 1});
    // Nothing that pushed it makes it six times as fast.
    scene.world().onSubstep([&](const SubstepBodies& bodies, double) {
        for (MovingBody& body : bodies.moving) {
            body.velocity = body.id == bar ? Vec3(0, 18, 0) : body.velocity;
        }
    });
    scene.run(0.5);
    EXPECT_GT(scene.velocity(second).norm(), 10.0);
    EXPECT_NEAR(scene.world().handedEnergy(first), 0.5 * 3.0 * 3.0, 1e-9);
    EXPECT_NEAR(scene.world().handedEnergy(second), 0.5 * 3.0 * 3.0, 1e-9);
    EXPECT_EQ(scene.world().handedEnergy(bar), noPush);
}

TEST(LooseBodies, HandOnABlowThroughARowInOneStep) {
    WorldScene scene;
    scene.solver = SolverKind::SoftStep;
    scene.settings.ground = false;
    scene.settings.gravity = 0.0;
    scene.world().addBody(boxBody({-1.55, 0, 0}, {2, 2, 2}, {10, 0, 0}));
    std::vector<BodyId> row;
    for (int i = 0; i < 5; ++i) {
        row.push_back(scene.box({i * 1.0, 0, 0}, {1, 1, 1}));
    }
    while (scene.velocity(row.back()).x() < 1.0 && scene.time() < 1.0) {
        scene.run(scene.dt);
    }
    ASSERT_GT(scene.velocity(row.back()).x(), 1.0);
    // Eight times as heavy as the first cube, which leaves it as fast as it is then; each hands that on at once.
    const double struck = scene.world().handedEnergy(row.front());
    EXPECT_GT(struck, 0.5 * 5.0 * 5.0);
    for (const BodyId body : row) {
        EXPECT_GE(scene.world().handedEnergy(body), struck);
    }
}

TEST(LooseBodies, CarryWhatLiesOnThemAtTheHeightWhereItLies) {
    WorldScene scene;
    scene.solver = SolverKind::SoftStep;
    NewBody bar = boxBody({0, 0, 1}, {20, 2, 2}, {5, 0, 0});
    bar.loose = true;
    scene.world().addBody(bar);
    const BodyId carried = scene.box({0, 0, 2.5}, {1, 1, 1}, {4, 0, 0});
    scene.run(0.1);
    const double energy = 0.5 * scene.velocity(carried).squaredNorm() + standardGravity * scene.place(carried).z();
    EXPECT_GE(scene.world().handedEnergy(carried), 0.999 * energy) << "its centre lies half a metre above where it is pushed";
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
