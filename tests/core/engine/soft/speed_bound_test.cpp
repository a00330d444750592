#include "core/engine/soft/speed_bound.h"

#include <gtest/gtest.h>

#include "core/engine/world/constants.h"

namespace rubble {
namespace {

/// Bodies in slots, the last of which is that of all that is still.
struct Scene {
    SpeedBound bound;
    std::vector<SolverBody> bodies;
    std::vector<SpeedBound::SlotPair> ends;
    double restitution = 0.0;
    Vec3 arm = Vec3::Zero();  ///< m, to where the first of two meets the second

    explicit Scene(std::size_t movable) : bodies(movable + 1) { bound.begin(bodies.size(), movable); }
    void body(std::size_t slot, double mass, double speed) {
        bodies[slot].inverseMass = 1.0 / mass;
        bodies[slot].velocity = Vec3(speed, 0, 0);
        bound.set(slot, 1.0 / mass, speed);
    }
    std::vector<double> bounds(double fall = 0.0) {
        ContactConstraint contact;
        contact.restitution = restitution;
        contact.normal = Vec3::UnitX();
        // All meet in one point of theirs.
        contact.points[0].fromA = arm;
        contact.points[0].fromB = Vec3::Zero();
        bound.spread(ends);
        std::vector<std::pair<double, double>> struck;
        for (const SpeedBound::SlotPair& pair : ends) {
            struck.push_back(bound.struck(pair, contact, 1, bodies));
        }
        return bound.bounds(ends, struck, fall);
    }
};

TEST(SpeedBound, LeavesRoomForOwnSpeedFallAndPush) {
    Scene scene(1);
    scene.body(0, 5.0, 3.0);
    EXPECT_DOUBLE_EQ(scene.bounds(0.5)[0], 2.0 * 3.0 + pushOutSpeed + 0.5);
}

TEST(SpeedBound, HandsSpeedOnThroughOthers) {
    Scene scene(3);
    scene.body(0, 1.0, 10.0);
    scene.body(1, 1.0, 0.0);
    scene.body(2, 4.0, 0.0);
    scene.ends = {{0, 1}, {1, 2}};
    const std::vector<double> bounds = scene.bounds();
    // Equal masses hand on all of it, a mass four times as large gets 2 m / (m + M) of it.
    EXPECT_DOUBLE_EQ(bounds[1], 2.0 * 10.0 + pushOutSpeed);
    EXPECT_DOUBLE_EQ(bounds[2], 2.0 * 10.0 * 2.0 / 5.0 + pushOutSpeed);
}

TEST(SpeedBound, NothingComesOfWhatIsStill) {
    Scene scene(2);
    scene.body(0, 1.0, 0.0);
    scene.body(1, 1.0, 0.0);
    scene.ends = {{0, 2}, {0, 1}};
    EXPECT_DOUBLE_EQ(scene.bounds()[0], pushOutSpeed);
}

TEST(SpeedBound, AFarLighterBodyLeavesWhatStrikesItByTheLawOfItsBounce) {
    Scene scene(2);
    scene.body(0, 1000.0, 10.0);
    scene.body(1, 1.0, 0.0);
    scene.ends = {{0, 1}};
    // It goes on with the heavy one, and bounces off it by half of what it came with.
    EXPECT_DOUBLE_EQ(scene.bounds()[1], 10.0 + pushOutSpeed);
    scene.restitution = 0.5;
    EXPECT_DOUBLE_EQ(scene.bounds()[1], 10.0 + 5.0);
    // What parts already keeps that, and what slides goes on.
    scene.bodies[1].velocity = Vec3(18.0, 6.0, 0.0);
    EXPECT_DOUBLE_EQ(scene.bounds()[1], 10.0 + 10.0);
    // A point that the heavy one's spin brings along strikes as fast as it is.
    scene.bodies[1].velocity = Vec3(10.0, 0.0, 0.0);
    scene.bodies[0].spin = Vec3(0.0, 0.0, -2.0);
    scene.arm = Vec3(0.0, 3.0, 0.0);
    EXPECT_DOUBLE_EQ(scene.bounds()[1], 16.0 + 3.0);
    scene.bodies[0].spin = Vec3::Zero();
    scene.restitution = 0.0;
    // One 29 times as light is not far lighter.
    scene.body(0, 29.0, 10.0);
    scene.body(1, 1.0, 0.0);
    const double handed = 10.0 * std::min(1.0, 2.0 / (1.0 + 1.0 / 29.0));
    EXPECT_DOUBLE_EQ(scene.bounds()[1], 2.0 * handed + pushOutSpeed);
}

TEST(SpeedBound, HoldsBackOnlyWhatContactsActOn) {
    SolverBody body;
    body.velocity = Vec3(6.0, 0.0, 8.0);
    body.spin = Vec3(0.0, 3.0, 0.0);
    body.radius = 1.0;
    body.fastest = 5.0;
    EXPECT_FALSE(SpeedBound::holdBack(body));
    EXPECT_EQ(body.velocity, Vec3(6.0, 0.0, 8.0));
    body.active = true;
    EXPECT_TRUE(SpeedBound::holdBack(body));
    EXPECT_NEAR(body.velocity.norm(), 5.0, 1e-12);
    EXPECT_EQ(body.spin, Vec3(0.0, 3.0, 0.0)) << "its corners are slow enough";
    EXPECT_FALSE(SpeedBound::holdBack(body)) << "it is slow enough by now";
}

}  // namespace
}  // namespace rubble
