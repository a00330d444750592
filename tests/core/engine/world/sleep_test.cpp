#include "core/engine/world/sleep.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace rubble {
namespace {

/// Four bodies in a row, each of which touches the next one.
struct Row {
    Sleep sleep{0.02, 0.5};
    std::array<Collider, 4> bodies;

    Row() {
        for (std::uint32_t i = 0; i < bodies.size(); ++i) {
            bodies[i].index = i;
            bodies[i].number = i + 1;
            bodies[i].newborn = false;
            sleep.addBody();
        }
    }
    /// What an engine hands over.
    auto touching() {
        return [this](auto visit) {
            for (std::size_t i = 0; i + 1 < bodies.size(); ++i) {
                visit(bodies[i], bodies[i + 1]);
            }
        };
    }
    void freezeAll() {
        for (const Collider& body : bodies) {
            sleep.freeze(body);
        }
    }
};

TEST(Sleep, KnowsWhoIsAwakeFrozenAndGone) {
    Row row;
    EXPECT_TRUE(row.sleep.awake(row.bodies[0]));
    row.sleep.freeze(row.bodies[0]);
    EXPECT_FALSE(row.sleep.awake(row.bodies[0]));
    EXPECT_TRUE(row.sleep.frozen(row.bodies[0]));
    EXPECT_FALSE(row.sleep.stirs(row.bodies[0]));
    row.bodies[0].newborn = true;
    EXPECT_TRUE(row.sleep.stirs(row.bodies[0]));
    row.sleep.forget(row.bodies[0]);
    EXPECT_FALSE(row.sleep.awake(row.bodies[0]));
    EXPECT_FALSE(row.sleep.frozen(0u)) << "nobody is left to wake";
    Collider piece;
    piece.kind = ColliderKind::Piece;
    EXPECT_FALSE(row.sleep.awake(piece) || row.sleep.frozen(piece));
}

TEST(Sleep, IsEndedByHardHitsAndByPiecesThatTouch) {
    Row row;
    row.freezeAll();
    row.sleep.thaw(row.bodies[1], Vec3::Zero());
    EXPECT_TRUE(row.sleep.wakes(row.bodies[1], 1.5, false));
    EXPECT_FALSE(row.sleep.wakes(row.bodies[1], 0.5, true)) << "too slow";
    EXPECT_FALSE(row.sleep.wakes(row.bodies[2], 1.5, true)) << "it sleeps itself";
    Collider piece;
    piece.kind = ColliderKind::Piece;
    piece.newborn = false;
    EXPECT_FALSE(row.sleep.wakes(piece, 5.0, true)) << "it stands still";
    piece.moving = true;
    EXPECT_TRUE(row.sleep.wakes(piece, 0.0, true));
    EXPECT_FALSE(row.sleep.wakes(piece, 0.0, false));
}

TEST(Sleep, OfNeighboursEndsOnceAThawedBodyHasMoved) {
    Row row;
    row.freezeAll();
    row.sleep.thaw(row.bodies[1], Vec3::Zero());
    EXPECT_EQ(row.sleep.justThawed(), (std::vector<Collider*>{&row.bodies[1]}));
    row.sleep.linkDependants(row.touching());
    EXPECT_TRUE(row.sleep.justThawed().empty());
    EXPECT_TRUE(row.sleep.wokenBy(row.bodies[1], Vec3(0.001, 0, 0)).empty()) << "it has hardly moved";
    EXPECT_EQ(row.sleep.wokenBy(row.bodies[1], Vec3(0.1, 0, 0)), (std::vector<std::uint32_t>{0, 2}));
    EXPECT_TRUE(row.sleep.wokenBy(row.bodies[1], Vec3(0.2, 0, 0)).empty()) << "each is woken once";
}

TEST(Sleep, IsNotEndedTwiceOrForWhoHasLeft) {
    Row row;
    row.freezeAll();
    row.sleep.thaw(row.bodies[1], Vec3::Zero());
    row.sleep.linkDependants(row.touching());
    row.sleep.thaw(row.bodies[0], Vec3::Zero());
    row.sleep.forget(row.bodies[2]);
    EXPECT_TRUE(row.sleep.wokenBy(row.bodies[1], Vec3(0.1, 0, 0)).empty());
}

TEST(Sleep, NeighboursOfWhatLeavesAreFoundInOrderAndOnce) {
    Row row;
    row.freezeAll();
    row.bodies[1].leaving = row.bodies[2].leaving = true;
    const auto twice = [&](auto visit) {
        row.touching()(visit);
        row.touching()(visit);
    };
    EXPECT_EQ(row.sleep.neighboursOfLeaving(twice), (std::vector<Collider*>{&row.bodies[0], &row.bodies[3]}));
    row.sleep.thaw(row.bodies[0], Vec3::Zero());
    EXPECT_EQ(row.sleep.neighboursOfLeaving(twice), (std::vector<Collider*>{&row.bodies[3]})) << "who is awake needs no waking";
}

}  // namespace
}  // namespace rubble
