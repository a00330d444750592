#include "core/engine/world/scene_rules.h"

#include <gtest/gtest.h>

#include "core/engine/world/constants.h"

namespace rubble {
namespace {

TEST(SceneRules, ABirthLiesInWhatIsOlderOnly) {
    Collider old, born, twin;
    old.newborn = false;
    noteBirthDepth(old, born, 0.2);
    noteBirthDepth(born, twin, 0.5);
    EXPECT_EQ(born.birthDepth, 0.2) << "two that enter together are not older than each other";
    EXPECT_EQ(born.birthDepthApart, 0.2) << "what shares no node was not joined";
    EXPECT_EQ(old.birthDepth, 0.0);
    noteBirthDepth(born, old, 0.1);
    EXPECT_EQ(born.birthDepth, 0.2) << "the deepest counts";
}

TEST(SceneRules, WhatABirthWasJoinedToIsToldApart) {
    Collider wall, debris, born;
    wall.kind = ColliderKind::Piece;
    wall.nodes = {2, 5, 9};
    debris.newborn = false;
    debris.nodes = {1, 4};
    born.nodes = {3, 5, 7, 8};
    noteBirthDepth(wall, born, 0.3);
    EXPECT_EQ(born.birthDepth, 0.3);
    EXPECT_EQ(born.birthDepthApart, 0.0) << "they share node 5";
    noteBirthDepth(debris, born, 0.1);
    EXPECT_EQ(born.birthDepth, 0.3);
    EXPECT_EQ(born.birthDepthApart, 0.1);
}

TEST(SceneRules, DepthIsNotedForWhoIsAwake) {
    Sleep sleep(0.02, 0.5);
    Collider awake, frozen, piece;
    frozen.index = 1;
    piece.kind = ColliderKind::Piece;
    sleep.addBody();
    sleep.addBody();
    sleep.freeze(frozen);
    ContactReport report;
    notePenetration(awake, frozen, 0.03, sleep, report);
    EXPECT_EQ(report.penetrationMax, 0.03);
    EXPECT_EQ(awake.penetration, 0.03);
    EXPECT_EQ(frozen.penetration, 0.0);
    noteOverlapLeft(awake, piece, 0.04, sleep);
    EXPECT_EQ(awake.overlapLeft, 0.0) << "of overlap with other bodies only";
    noteOverlapLeft(awake, frozen, 0.04, sleep);
    EXPECT_EQ(awake.overlapLeft, 0.04);
}

TEST(SceneRules, APieceThatClosesInFastPressesFromAboveAndCarriesFromBelow) {
    EXPECT_FALSE(pieceAction(0.9 * pieceYieldSpeed, -1.0, true).yielding) << "slow ones do not give way";
    EXPECT_TRUE(pieceAction(1.1 * pieceYieldSpeed, -1.0, false).pressing);
    EXPECT_FALSE(pieceAction(1.1 * pieceYieldSpeed, 1.0, false).pressing);
    EXPECT_TRUE(pieceAction(1.1 * pieceYieldSpeed, 1.0, true).yielding);
}

TEST(SceneRules, APieceGivesWayOnceItsPressIsSpent) {
    double pressed = 0.0;
    EXPECT_FALSE(givesWayToPress(pressed, 0.5 * piecePressSpeed));
    EXPECT_DOUBLE_EQ(pressLeft(pressed), 0.5 * piecePressSpeed);
    EXPECT_TRUE(givesWayToPress(pressed, 0.5 * piecePressSpeed));
    EXPECT_EQ(pressLeft(pressed), 0.0);
    EXPECT_FALSE(givesWayToPushes(piecePushes - 1));
    EXPECT_TRUE(givesWayToPushes(piecePushes));
    EXPECT_TRUE(inVain(0.6, 1.0));
    EXPECT_FALSE(inVain(0.4, 1.0));
}

TEST(SceneRules, WhatWasBornBelowGroundComesUpAtABoundedSpeed) {
    const SiteSurface ground{true, 1.0, nullptr};
    const Vec3 centre(3.0, 4.0, 0.0);
    const double dt = 0.01;
    const GroundRise pressed = riseAboveGround(ground, centre, false, dt);
    EXPECT_EQ(pressed.way, Vec3(0.0, 0.0, 1.0));
    EXPECT_EQ(pressed.share, 1.0);
    EXPECT_EQ(pressed.normal, Vec3(0.0, 0.0, 1.0));
    EXPECT_DOUBLE_EQ(riseAboveGround(ground, centre, true, dt).share, separationSpeed * dt);
}

}  // namespace
}  // namespace rubble
