#include <gtest/gtest.h>

#include "core/engine/world/freeze.h"
#include "tests/core/simulation/world_scene.h"

namespace rubble {
namespace {

using test::WorldScene;

TEST(FreezeClock, WaitsForTheWholeDelay) {
    FreezeClock clock(0.02, 0.5);
    clock.addBody();
    EXPECT_FALSE(clock.quiet(0, 0.01, 0.3));
    EXPECT_FALSE(clock.quiet(0, 0.03, 0.3)) << "too fast: the wait begins anew";
    EXPECT_FALSE(clock.quiet(0, 0.01, 0.3));
    EXPECT_TRUE(clock.quiet(0, 0.01, 0.3));
    EXPECT_TRUE(clock.resting(0));
    clock.freeze(0);
    clock.thaw(0, Vec3::Zero());
    EXPECT_FALSE(clock.frozen(0));
    EXPECT_FALSE(clock.resting(0));
    clock.addDependant(0, 5);
    EXPECT_TRUE(clock.takeDependants(0, Vec3(0.001, 0, 0)).empty()) << "has not moved yet";
    EXPECT_EQ(clock.takeDependants(0, Vec3(0.1, 0, 0)).size(), 1u);
    EXPECT_FALSE(clock.watched(0));
}

TEST(Freeze, HoldsExactly) {
    WorldScene scene;
    const BodyId lower = scene.box({0, 0, 0.5}, {1, 1, 1});
    const BodyId upper = scene.box({0.1, 0, 1.5}, {1, 1, 1});
    scene.run(3.0);
    ASSERT_EQ(scene.world().state(lower), BodyState::Frozen);
    ASSERT_EQ(scene.world().state(upper), BodyState::Frozen);
    const BodyMotion before = scene.world().motion(upper);
    // Something else keeps the world busy, gently enough to thaw nobody.
    scene.box({10, 0, 20}, {1, 1, 1});
    scene.run(1.5);
    const BodyMotion after = scene.world().motion(upper);
    EXPECT_EQ(before.pose.position, after.pose.position);
    EXPECT_EQ(before.pose.orientation.coeffs(), after.pose.orientation.coeffs());
}

TEST(Freeze, CarriesWhatIsLaidOnItAndStaysFrozen) {
    WorldScene scene;
    const BodyId lower = scene.box({0, 0, 0.5}, {1, 1, 1});
    scene.run(2.0);
    const Vec3 before = scene.place(lower);
    const BodyId upper = scene.box({0, 0, 1.51}, {1, 1, 1});
    scene.run(2.0);
    EXPECT_EQ(scene.place(lower), before);
    EXPECT_NEAR(scene.place(upper).z(), 1.5, 0.02);
}

TEST(Freeze, ThawsByAHit) {
    WorldScene scene;
    const BodyId lying = scene.box({0, 0, 0.5}, {1, 1, 1});
    scene.run(2.0);
    ASSERT_EQ(scene.world().state(lying), BodyState::Frozen);
    const Vec3 before = scene.place(lying);
    scene.box({-3, 0, 0.6}, {1, 1, 1}, {10, 0, 0});
    scene.run(1.0);
    EXPECT_GT((scene.place(lying) - before).norm(), 0.1);
}

TEST(Freeze, EndsWhenABodyBelowLeaves) {
    WorldScene scene;
    const BodyId lower = scene.box({0, 0, 0.5}, {1, 1, 1});
    const BodyId upper = scene.box({0, 0, 1.5}, {1, 1, 1});
    const BodyId top = scene.box({0, 0, 2.5}, {1, 1, 1});
    scene.run(3.0);
    ASSERT_EQ(scene.world().state(top), BodyState::Frozen);
    scene.world().removeBody(lower);
    EXPECT_EQ(scene.world().state(lower), BodyState::Removed);
    scene.run(3.0);
    EXPECT_NEAR(scene.place(upper).z(), 0.5, 0.05);
    EXPECT_NEAR(scene.place(top).z(), 1.5, 0.05) << "what lay on the thawed one wakes as well";
    EXPECT_EQ(scene.world().momenta(lower).mass, 0.0);
}

TEST(Freeze, EndsWhenAPieceBelowVanishes) {
    WorldScene scene;
    const PieceId support = scene.piece({0, 0, 2.5}, {4, 4, 1});
    std::vector<BodyId> pile;
    for (int i = 0; i < 3; ++i) {
        pile.push_back(scene.box({0, 0, 3.5 + i}, {1, 1, 1}));
    }
    scene.run(3.0);
    for (const BodyId body : pile) {
        ASSERT_EQ(scene.world().state(body), BodyState::Frozen);
    }
    scene.world().removePiece(support);
    scene.run(4.0);
    for (std::size_t i = 0; i < pile.size(); ++i) {
        EXPECT_LT(scene.place(pile[i]).z(), 3.2) << i;
    }
}

TEST(Freeze, CanBeSwitchedOff) {
    WorldScene scene;
    scene.settings.freeze = false;
    const BodyId lying = scene.box({0, 0, 0.5}, {1, 1, 1});
    scene.run(2.0);
    EXPECT_EQ(scene.world().state(lying), BodyState::Frozen) << "counts as asleep";
    const Vec3 before = scene.place(lying);
    scene.box({-1.02, 0, 0.5}, {1, 1, 1}, {0.9, 0, 0});
    scene.run(0.3);
    EXPECT_GT((scene.place(lying) - before).norm(), 1e-4) << "and yet is free to move";
}

}  // namespace
}  // namespace rubble
