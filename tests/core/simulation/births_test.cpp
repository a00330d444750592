#include <gtest/gtest.h>

#include <algorithm>

#include "core/engine/soft/rest_offsets.h"
#include "core/engine/world/birth_overlap.h"
#include "tests/core/simulation/world_scene.h"

namespace rubble {
namespace {

using test::WorldScene;

TEST(BirthOverlap, IsTheRestOffsetAndNeverGrows) {
    BirthOverlaps overlaps;
    const ColliderPair pair = colliderPair(7, 3);
    EXPECT_EQ(pair, colliderPair(3, 7));
    overlaps.beginStep();
    EXPECT_EQ(overlaps.offset(pair, 0.4, true), 0.4);
    overlaps.endStep();
    overlaps.beginStep();
    EXPECT_EQ(overlaps.offset(pair, 0.9, false), 0.4) << "deeper than at birth is penetration";
    overlaps.bleed(pair, 0.1);
    overlaps.endStep();
    overlaps.beginStep();
    EXPECT_NEAR(overlaps.offset(pair, 0.9, false), 0.3, 1e-15);
    EXPECT_NEAR(overlaps.offset(pair, 0.2, false), 0.2, 1e-15) << "what came apart by itself does not come back";
    EXPECT_NEAR(overlaps.offset(pair, 0.9, false), 0.2, 1e-15);
    overlaps.endStep();
    overlaps.beginStep();
    overlaps.endStep();
    EXPECT_TRUE(overlaps.empty()) << "pairs that were not seen are forgotten";
}

TEST(Births, OverlapIsNeverALaunch) {
    for (const double overlap : {0.001, 0.003, 0.01, 0.03, 0.1, 0.3}) {
        WorldScene scene;
        scene.settings.gravity = 0.0;
        scene.settings.ground = false;
        scene.settings.freeze = false;
        const BodyId a = scene.box({0, 0, 0}, {0.5, 0.5, 0.5});
        const BodyId b = scene.box({0.5 - overlap, 0.05, 0.02}, {0.5, 0.5, 0.5});
        double fastest = 0.0;
        Vec3 before = scene.place(b) - scene.place(a);
        double parting = 0.0;
        scene.run(4.0, [&](double) {
            fastest = std::max(fastest, scene.maxSpeed());
            const Vec3 now = scene.place(b) - scene.place(a);
            parting = std::max(parting, (now - before).norm() / scene.dt);
            before = now;
        });
        // Speed at most 1 cm/s (PHYSICS section 4): the overlap goes by position only, at the speed set for it.
        EXPECT_LT(fastest, 0.01) << overlap;
        EXPECT_LT(parting, scene.settings.overlapSpeed * 1.001 + 0.01) << overlap;
        EXPECT_GT(scene.place(b).x() - scene.place(a).x(), 0.499) << overlap;
    }
}

TEST(Births, WhatIsNotApartInTimeStaysAndRests) {
    WorldScene scene;
    scene.solver = SolverKind::SoftStep;
    scene.settings.overlapSpeed = 0.4;
    scene.settings.overlapTime = 0.5;
    scene.box({0, 0, 0.5}, {1, 1, 1});
    const BodyId upper = scene.box({0, 0, 0.6}, {1, 1, 1});
    scene.run(3.0);
    // 0.9 m deep at first, apart at 0.4 m/s for 0.5 s; the load presses the lower one a little into the ground meanwhile.
    EXPECT_NEAR(scene.place(upper).z() - scene.place(idAt<BodyId>(0)).z(), 0.1 + 0.4 * 0.5, 0.05);
    EXPECT_EQ(scene.world().state(upper), BodyState::Frozen);
    // Lifted by position: the speed never knew of it, the work did, and what soft contacts spent on the load beside it.
    const double way = scene.world().lifted(upper);
    const double least = scene.world().mass(upper) * scene.settings.gravity * way;
    EXPECT_NEAR(way, 0.4 * 0.5, 0.03);
    EXPECT_GE(scene.world().contacts().overlapWork, 0.99 * least);
    EXPECT_LE(scene.world().contacts().overlapWork, 1.3 * least);
}

TEST(Births, APileComesApartWithoutBoiling) {
    WorldScene scene;
    scene.solver = SolverKind::SoftStep;
    // 4 x 4 x 6 boxes in the space of half as many: each lies half in its neighbours above and below.
    for (int k = 0; k < 6; ++k) {
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 4; ++j) {
                scene.box({0.62 * i, 0.62 * j, 0.3 + 0.3 * k}, {0.6, 0.6, 0.6});
            }
        }
    }
    scene.run(8.0);
    std::size_t asleep = 0;
    double highest = 0.0;
    for (std::size_t i = 0; i < scene.world().bodyCount(); ++i) {
        asleep += scene.world().state(idAt<BodyId>(i)) == BodyState::Frozen;
        highest = std::max(highest, scene.place(idAt<BodyId>(i)).z());
    }
    EXPECT_GE(asleep, 0.9 * static_cast<double>(scene.world().bodyCount()));
    EXPECT_GT(highest, 2.5) << "six boxes on each other, apart from what fell off the top";
    EXPECT_LT(highest, 3.4);
}

TEST(Births, OverlapHasItsTimeFromTheLaterBirth) {
    WorldScene scene;
    scene.solver = SolverKind::SoftStep;
    scene.settings.overlapSpeed = 0.4;
    scene.settings.overlapTime = 0.5;
    scene.settings.overlapTimeFromEntry = true;
    const BodyId lower = scene.box({0, 0, 0.5}, {1, 1, 1});
    scene.run(2.0);
    const BodyId upper = scene.box({0, 0, 0.6}, {1, 1, 1});
    scene.run(3.0);
    EXPECT_NEAR(scene.place(upper).z() - scene.place(lower).z(), 0.1 + 0.4 * 0.5, 0.05);
}

// Overlap that is pushed on to older bodies, or is found between other parts of the same two, has no time of its own.
TEST(Births, OverlapOfOldBodiesIsNotBroughtApartByNewContacts) {
    Collider older, younger;
    older.entered = 1.0;
    younger.entered = 3.0;
    SoftContact contact;
    contact.a = &older;
    contact.b = &younger;
    contact.offset = 0.3;
    WorldSettings settings;
    settings.overlapTime = 2.0;
    EXPECT_EQ(overlapToPart(contact, settings, 9.0), 0.3) << "each contact has its own time";
    contact.correctedFor = 2.0;
    EXPECT_EQ(overlapToPart(contact, settings, 9.0), 0.0);
    settings.overlapTimeFromEntry = true;
    EXPECT_EQ(overlapToPart(contact, settings, 4.9), 0.3);
    contact.correctedFor = 0.0;
    EXPECT_EQ(overlapToPart(contact, settings, 5.0), 0.0);
}

TEST(Births, InsideAnOlderPileDoNotLaunchIt) {
    WorldScene scene;
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < 5; ++j) {
            for (int k = 0; k < 3; ++k) {
                scene.box({0.61 * i, 0.61 * j, 0.3 + 0.6 * k}, {0.6, 0.6, 0.6});
            }
        }
    }
    scene.run(1.0);
    const double energyBefore = scene.energy();
    double born = 0.0;
    for (int i = 0; i < 4; ++i) {
        const NewBody body = test::boxBody({0.3 + 0.6 * i, 1.2, 0.5}, {0.7, 0.5, 0.4});
        const BodyId id = scene.world().addBody(body);
        born += body.mass * scene.settings.gravity * scene.place(id).z();
    }
    double fastest = 0.0;
    double gain = 0.0;
    scene.run(4.0, [&](double) {
        fastest = std::max(fastest, scene.maxSpeed());
        gain = std::max(gain, scene.energy() - energyBefore - born - scene.world().contacts().overlapWork);
    });
    // What topples from the edge of the pile reaches 3 m/s; a launch gives tens.
    EXPECT_LT(fastest, 3.0);
    EXPECT_GT(scene.world().contacts().overlapWork, 0.0);
    EXPECT_LT(gain, 0.02 * (energyBefore + born)) << "beyond the work booked";
    for (std::size_t i = 0; i < scene.world().bodyCount(); ++i) {
        EXPECT_GT(scene.place(idAt<BodyId>(i)).z(), 0.0);
    }
    EXPECT_GT(scene.world().birthDepth(idAt<BodyId>(75)), 0.05);
    EXPECT_EQ(scene.world().birthDepth(idAt<BodyId>(0)), 0.0);
}

TEST(Births, ArriveFastInsideOthersAndStop) {
    WorldScene scene;
    const BodyId lying = scene.box({0, 0, 0.5}, {2, 2, 1});
    scene.run(1.0);
    const BodyId born = scene.box({0.2, 0.1, 0.9}, {1, 1, 1}, {0, 0, -25});
    double fastest = 0.0;
    scene.run(0.05);
    scene.run(3.0, [&](double) { fastest = std::max(fastest, scene.maxSpeed()); });
    EXPECT_LT(fastest, 3.0);
    EXPECT_GT(scene.place(lying).z(), 0.3);
    EXPECT_GT(scene.place(born).z(), 0.3);
    EXPECT_LT(scene.place(born).head<2>().norm(), 3.0);
}

TEST(Births, NeighboursBornTogetherWithScatteredVelocitiesGainNothing) {
    for (const double scatter : {1.0, 10.0}) {
        WorldScene scene;
        scene.settings.gravity = 0.0;
        scene.settings.ground = false;
        scene.settings.freeze = false;
        for (int i = 0; i < 64; ++i) {
            const Vec3 direction(std::sin(1.0 + 7 * i), std::sin(2.0 + 13 * i), std::sin(3.0 + 29 * i));
            scene.box(0.5 * Vec3(i % 4, (i / 4) % 4, i / 16), {0.52, 0.52, 0.52}, scatter * direction);
        }
        const double before = scene.energy();
        double most = 0.0;
        scene.run(2.0, [&](double) { most = std::max(most, scene.energy()); });
        EXPECT_LT(most, 1.001 * before) << scatter;
    }
}

}  // namespace
}  // namespace rubble
