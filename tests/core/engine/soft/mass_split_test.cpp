#include "core/engine/soft/mass_split.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "tests/core/simulation/world_scene.h"

namespace rubble {
namespace {

using test::WorldScene;
using Ends = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// `count` bodies that lie on body 0, each with a contact of its own.
Ends onOne(std::uint32_t count) {
    Ends ends;
    for (std::uint32_t i = 1; i <= count; ++i) {
        ends.emplace_back(0, i);
    }
    return ends;
}

TEST(MassSplit, GivesABodyOfManyContactsSeveralCopies) {
    constexpr std::uint32_t movable = 101;
    Ends ends = onOne(100);
    ends.emplace_back(5, movable);
    MassSplit split;
    split.split(ends, movable);
    ASSERT_EQ(split.bodies().size(), 1u);
    const SplitBody& body = split.bodies()[0];
    EXPECT_EQ(body.slot, 0u);
    EXPECT_EQ(body.firstCopy, movable);
    EXPECT_EQ(body.copies, 5u);
    EXPECT_EQ(split.added(), 4u);
    std::map<std::uint32_t, int> contactsOf;
    for (std::uint32_t i = 0; i < 100; ++i) {
        EXPECT_EQ(ends[i].second, i + 1);
        ++contactsOf[ends[i].first];
    }
    EXPECT_EQ(contactsOf, (std::map<std::uint32_t, int>{{0, 20}, {101, 20}, {102, 20}, {103, 20}, {104, 20}}));
    EXPECT_EQ(ends[100], std::pair(5u, movable + 4)) << "what does not move comes behind the copies";
}

TEST(MassSplit, LeavesAloneWhatHasFewContactsOrDoesNotMove) {
    const Ends few = onOne(40);
    Ends ends = few;
    MassSplit split;
    split.split(ends, 41);
    EXPECT_TRUE(split.bodies().empty());
    EXPECT_EQ(ends, few);
    Ends ground;
    for (std::uint32_t i = 0; i < 100; ++i) {
        ground.emplace_back(100, i);
    }
    const Ends before = ground;
    split.split(ground, 100);
    EXPECT_EQ(split.added(), 0u);
    EXPECT_EQ(ground, before);
}

/// A plate of 12 m on a hundred cubes of 1 m that stand on the ground or float.
struct Plate {
    WorldScene scene;
    BodyId plate{};
    std::vector<BodyId> cubes;

    Plate(bool splits, double gravity, int threads, double speed) {
        scene.solver = SolverKind::SoftStep;
        scene.settings.splitsMass = splits;
        scene.settings.gravity = gravity;
        scene.settings.ground = gravity > 0.0;
        scene.settings.threads = threads;
        scene.settings.freeze = false;
        for (int i = 0; i < 100; ++i) {
            cubes.push_back(scene.box({1.1 * (i % 10) - 4.95, 1.1 * (i / 10) - 4.95, 0.5}, {1, 1, 1}));
        }
        plate = scene.box({0, 0, 2.05}, {12, 12, 2}, {0, 0, speed});
    }

    double mass(BodyId body) const { return body == plate ? 288.0 : 1.0; }  // in those of a cube
    Vec3 momentum() {
        Vec3 sum = mass(plate) * scene.velocity(plate);
        for (const BodyId cube : cubes) {
            sum += mass(cube) * scene.velocity(cube);
        }
        return sum;
    }
};

TEST(MassSplit, CarriesAPlateAsOneBodyDoes) {
    Plate whole(false, 9.81, 1, 0.0), split(true, 9.81, 1, 0.0);
    whole.scene.run(2.0);
    split.scene.run(2.0);
    EXPECT_NEAR(split.scene.place(split.plate).z(), whole.scene.place(whole.plate).z(), 2e-3);
    EXPECT_NEAR(split.scene.place(split.plate).z(), 2.0, 0.02);
    EXPECT_LT(split.scene.velocity(split.plate).norm(), 5e-3);
    EXPECT_LT(split.scene.place(split.plate).head<2>().norm(), 2e-3);
    for (const BodyId cube : split.cubes) {
        ASSERT_LT(split.scene.world().penetration(cube), 0.02);
    }
}

TEST(MassSplit, KeepsMomentum) {
    Plate split(true, 0.0, 1, -2.0);
    const Vec3 before = split.momentum();
    split.scene.run(0.5);
    EXPECT_GT(-split.scene.velocity(split.cubes[44]).z(), 1.0) << "or nothing was hit";
    EXPECT_LT((split.momentum() - before).norm(), 1e-9 * before.norm());
    EXPECT_LT(split.scene.velocity(split.plate).head<2>().norm(), 0.01);
}

TEST(MassSplit, GivesTheSameBitsOnAnyNumberOfThreads) {
    Plate one(true, 9.81, 1, -3.0), two(true, 9.81, 2, -3.0);
    one.scene.run(0.6);
    two.scene.run(0.6);
    EXPECT_EQ(one.scene.place(one.plate), two.scene.place(two.plate));
    for (std::size_t i = 0; i < one.cubes.size(); ++i) {
        ASSERT_EQ(one.scene.place(one.cubes[i]), two.scene.place(two.cubes[i])) << i;
    }
}

}  // namespace
}  // namespace rubble
