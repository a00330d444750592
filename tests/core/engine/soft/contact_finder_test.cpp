#include "core/engine/soft/contact_finder.h"

#include <gtest/gtest.h>

#include <deque>

#include "core/base/standard_gravity.h"

namespace rubble {
namespace {

constexpr double dt = 1.0 / 40.0;  // s

/// Two cubes of a metre, one above the other, and how they move.
class TwoCubes : public testing::Test {
protected:
    std::deque<Collider> colliders;
    SoftBodies bodies;
    WorkerPool pool{1};
    PairFinder pairs{true, pool};
    ContactFinder finder{SiteSurface{}, standardGravity, false, bodies, pairs, pool};

    void SetUp() override {
        for (std::uint32_t i = 0; i < 2; ++i) {
            Collider& cube = colliders.emplace_back();
            cube.kind = ColliderKind::Body;
            cube.number = i + 1;
            cube.index = i;
            cube.radius = std::sqrt(0.75);
            cube.parts.resize(1);
            cube.parts[0].box.halfExtents = Vec3::Constant(0.5);
            bodies.add(cube, {Vec3(0.0, 0.0, i), Quat::Identity()});
            finder.enter(cube);
        }
    }
    /// Points that the solver gets, with the upper cube `gap` [m] above the lower one.
    int points(double gap, const Vec3& lower, const Vec3& upper, const Vec3& spin = Vec3::Zero()) {
        bodies.bodies[0].velocity = lower;
        bodies.bodies[1].velocity = upper;
        bodies.bodies[1].spin = spin;
        bodies.bodies[1].pose.position.z() = 1.0 + gap;
        for (const SoftBody& body : bodies.bodies) {
            finder.place(body);
            pairs.sweep(body.collider->number, finder.sweep(body, dt));
        }
        finder.begin();
        const std::vector<NearPair> both{{1, 2}};
        finder.collide(both, dt);
        int count = 0;
        for (const Found& found : finder.inOrder()) {
            count += found.contact->patch.count;
        }
        return count;
    }
};

const Vec3 falling(0.0, 0.0, -20.0);

TEST_F(TwoCubes, ThatTouchHaveAllPoints) {
    EXPECT_EQ(points(0.0, Vec3::Zero(), Vec3::Zero()), 4);
    EXPECT_EQ(points(-0.01, falling, falling), 4);
    EXPECT_EQ(points(-0.01, Vec3::Zero(), Vec3(0.0, 0.0, 3.0)), 4) << "what overlaps is looked at even as it parts";
}

TEST_F(TwoCubes, ThatFallSideBySideHaveNone) {
    EXPECT_EQ(points(0.012, falling, falling), 0);
    EXPECT_EQ(points(0.03, falling, falling), 0);
    EXPECT_EQ(points(0.01, falling, falling), 4) << "what gravity may close in a step is looked at";
}

TEST_F(TwoCubes, ThatCloseInTheStepHaveThem) {
    EXPECT_EQ(points(0.03, Vec3::Zero(), Vec3(0.0, 0.0, -1.0)), 4);
    EXPECT_EQ(points(0.03, falling, falling + Vec3(0.0, 0.0, -1.0)), 4);
    EXPECT_EQ(points(0.45, Vec3::Zero(), falling), 4);
    EXPECT_EQ(points(0.03, Vec3::Zero(), Vec3(0.0, 0.0, -0.5)), 0) << "half a metre a second is 12 mm, and 11 are within reach";
    EXPECT_EQ(points(0.03, Vec3::Zero(), Vec3(0.0, 0.0, 1.0)), 0);
}

TEST_F(TwoCubes, OfWhichAnEdgeClosesHaveThemToo) {
    // The edge at -x comes down at 1 m/s; a hit there turns in the other one, which goes up.
    EXPECT_EQ(points(0.03, Vec3::Zero(), Vec3::Zero(), Vec3(0.0, -2.0, 0.0)), 4);
    EXPECT_EQ(points(0.05, Vec3::Zero(), Vec3::Zero(), Vec3(0.0, -2.0, 0.0)), 0);
}

}  // namespace
}  // namespace rubble
