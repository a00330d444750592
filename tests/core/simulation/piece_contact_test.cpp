#include <gtest/gtest.h>

#include "core/base/standard_gravity.h"
#include "tests/core/simulation/world_scene.h"

namespace rubble {
namespace {

using test::WorldScene;

TEST(PieceContact, CarriesABodyAlong) {
    WorldScene scene;
    scene.settings.ground = false;
    const PieceId floor = scene.piece({0, 0, -0.5}, {20, 6, 1});
    const BodyId body = scene.box({0, 0, 0.5}, {1, 1, 1});
    scene.run(3.0, [&](double time) { scene.world().movePiece(floor, {{1.0 * time, 0, -0.5}, Quat::Identity()}); });
    // At 1 m/s friction takes 0.17 s to bring the body up to speed: it lags 0.085 m behind.
    EXPECT_NEAR(scene.place(body).x(), 3.0 - 1.0 / (2 * 0.6 * standardGravity), 0.05);
    EXPECT_NEAR(scene.place(body).z(), 0.5, 0.02);
}

TEST(PieceContact, LiftsWhatLiesOnIt) {
    for (const double speed : {1.0, 5.0}) {
        WorldScene scene;
        scene.settings.ground = false;
        scene.settings.pairs = PairTable::uniform(0.6, 0.1);
        const PieceId floor = scene.piece({0, 0, -0.5}, {6, 6, 1});
        const BodyId body = scene.box({0, 0, 0.5}, {1, 1, 1});
        scene.run(0.5);
        double fastest = 0.0;
        scene.run(1.0, [&](double time) {
            scene.world().movePiece(floor, {{0, 0, -0.5 + speed * (time - 0.5)}, Quat::Identity()});
            fastest = std::max(fastest, scene.maxSpeed());
        });
        EXPECT_LT(fastest, 1.3 * speed) << speed;
        EXPECT_GT(scene.place(body).z(), speed + 0.5 - 0.15) << speed;
        // Work: the gain in height and the speed it was given.
        const double mass = scene.world().mass(body);
        EXPECT_NEAR(scene.world().contacts().pieceWork, mass * standardGravity * speed + mass * speed * speed,
                    0.3 * mass * standardGravity * speed + 0.3 * mass * speed * speed);
        EXPECT_TRUE(scene.world().pushedByPiece(body));
        EXPECT_EQ(scene.world().contacts().piecesYielded, 0);
    }
}

TEST(PieceContact, ComingDownOnDebrisGivesWay) {
    WorldScene scene;
    std::vector<BodyId> debris;
    for (int i = 0; i < 16; ++i) {
        debris.push_back(scene.box({1.1 * (i % 4), 1.1 * (i / 4), 0.5}, {1, 1, 1}));
    }
    scene.run(1.0);
    const double before = scene.energy();
    const PieceId deck = scene.piece({1.6, 1.6, 6.0}, {8, 8, 2});
    double fastest = 0.0;
    scene.run(0.24, [&](double time) {
        scene.world().movePiece(deck, {{1.6, 1.6, 6.0 - 25.0 * (time - 1.0)}, Quat::Identity()});
        fastest = std::max(fastest, scene.maxSpeed());
    });
    scene.world().removePiece(deck);
    scene.run(2.0, [&](double) { fastest = std::max(fastest, scene.maxSpeed()); });
    // A push of 0.5 m/s and what gravity adds within the debris: no launch.
    EXPECT_LT(fastest, 3.0);
    EXPECT_GE(scene.world().contacts().piecesYielded, 16);
    EXPECT_LT(scene.energy(), before + scene.world().contacts().pieceWork + scene.world().contacts().overlapWork + 1.0);
    for (const BodyId body : debris) {
        EXPECT_GT(scene.place(body).z(), 0.3);
        EXPECT_LT(scene.place(body).z(), 1.2);
        EXPECT_TRUE(scene.place(body).allFinite());
    }
}

TEST(PieceContact, ClosingOnATrappedBodyStaysFinite) {
    WorldScene scene;
    scene.settings.ground = false;
    const PieceId low = scene.piece({0, 0, -1}, {4, 4, 2});
    const PieceId high = scene.piece({0, 0, 3}, {4, 4, 2});
    const BodyId body = scene.box({0, 0, 0.5}, {1, 1, 1});
    double fastest = 0.0;
    scene.run(2.0, [&](double time) {
        scene.world().movePiece(low, {{0, 0, -1 + 0.5 * time}, Quat::Identity()});
        scene.world().movePiece(high, {{0, 0, 3 - 0.5 * time}, Quat::Identity()});
        fastest = std::max(fastest, scene.maxSpeed());
    });
    EXPECT_TRUE(scene.place(body).allFinite());
    EXPECT_LT(fastest, 3.0);
}

TEST(PieceContact, ANewPieceDoesNotFightWhatItOverlaps) {
    WorldScene scene;
    const BodyId body = scene.box({0, 0, 0.5}, {1, 1, 1});
    scene.run(1.0);
    scene.piece({0.6, 0, 0.5}, {1, 1, 1});
    double fastest = 0.0;
    scene.run(4.0, [&](double) { fastest = std::max(fastest, scene.maxSpeed()); });
    EXPECT_LT(fastest, 0.3);
    EXPECT_LT(scene.place(body).x(), -0.3) << "the overlap is bled off";
}

TEST(PieceContact, StandingStillWakesNobody) {
    WorldScene scene;
    scene.piece({0, 0, 0.5}, {4, 4, 1});
    const BodyId body = scene.box({0, 0, 1.5}, {1, 1, 1});
    scene.run(3.0);
    EXPECT_EQ(scene.world().state(body), BodyState::Frozen);
}

TEST(PieceContact, MovingWakesWhatLiesOnIt) {
    WorldScene scene;
    const PieceId floor = scene.piece({0, 0, 2.5}, {4, 4, 1});
    const BodyId body = scene.box({0, 0, 3.5}, {1, 1, 1});
    scene.run(2.0);
    ASSERT_EQ(scene.world().state(body), BodyState::Frozen);
    scene.run(0.5, [&](double time) { scene.world().movePiece(floor, {{0, 0, 2.5 - 0.5 * (time - 2.0)}, Quat::Identity()}); });
    EXPECT_NEAR(scene.place(body).z(), 3.25, 0.05);
}

}  // namespace
}  // namespace rubble
