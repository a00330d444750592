#include "core/fragments/corner_motion.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/core/fragments/element_scene.h"

namespace rubble {
namespace {

const std::vector<Vec3> tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

Vec3 parabola(const Vec3& x, double t) {
    return x + Vec3(3.0, -1.0, 2.0) * t + Vec3(0.5, 0.25, -4.9) * t * t;
}
Vec3 parabolaRate(double t) {
    return Vec3(3.0, -1.0, 2.0) + Vec3(1.0, 0.5, -9.8) * t;
}

/// Motion of the element's last lifetime, reading only the states that the reader asks for.
CornerMotion motionOf(const FeResult& fe, ElementIndex element, Revival policy = Revival::Latch) {
    Findings findings;
    std::vector<Lifetime> lives;
    for (const Lifetime& life : endedLifetimes(fe, test::ElementScene::components(fe), policy, findings, Execution())) {
        if (life.element == element) {
            lives.assign(1, life);
        }
    }
    CornerMotionReader reader(fe, policy);
    const std::vector<bool> needed = reader.statesNeeded(lives);
    for (std::uint32_t k = 0; k <= lives[0].lastActive; ++k) {
        if (needed[k]) {
            reader.advance(k);
        }
    }
    return reader.motionOf(lives[0]);
}

TEST(CornerMotion, BackwardDerivativeIsExactForAnyParabola) {
    const double t = 1.7, recent = 0.08, former = 0.13;
    const auto at = [](double time) { return parabola(Vec3(1, 2, 3), time); };
    EXPECT_LT((backwardDerivative(at(t), at(t - recent), at(t - recent - former), recent, former) - parabolaRate(t)).norm(), 1e-12);
}

TEST(CornerMotion, TakesTheFilesVelocity) {
    test::ElementScene scene;
    scene.element(ElementShape::Tetrahedron, tetrahedron, "11100");
    scene.velocity = [](const Vec3& x, double t) { return Vec3(x.x(), 7.0, t); };
    const auto fe = scene.result();
    const CornerMotion motion = motionOf(*fe, idAt<ElementIndex>(0));
    EXPECT_EQ(motion.corners, 4);
    EXPECT_EQ(motion.known, 4);
    EXPECT_EQ(Vec3(motion.velocities.col(1)), Vec3(1.0, 7.0, 2.0));
    EXPECT_EQ(scene.reads(), std::vector<std::size_t>{2});
}

TEST(CornerMotion, DifferencesAreOfSecondOrderOverThreeActiveStatesAndBlindAfterDeath) {
    test::ElementScene scene;
    scene.element(ElementShape::Tetrahedron, tetrahedron, "111100");
    scene.times = {0.0, 0.1, 0.25, 0.3, 0.4, 0.5};
    scene.position = parabola;
    scene.damage = [](std::size_t k, FeState& state) {
        if (k == 0 || k > 3) {  // after death, and before the last three
            state.positions.assign(state.positions.size(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
        }
    };
    const auto fe = scene.result();
    const CornerMotion motion = motionOf(*fe, idAt<ElementIndex>(0));
    for (int a = 0; a < 4; ++a) {
        EXPECT_LT((motion.velocities.col(a) - parabolaRate(0.3)).norm(), 1e-12);
    }
    EXPECT_EQ(scene.reads(), (std::vector<std::size_t>{1, 2, 3}));
}

TEST(CornerMotion, DifferencesAreOfFirstOrderOverTwoActiveStates) {
    test::ElementScene scene;
    scene.element(ElementShape::Tetrahedron, tetrahedron, "1100");
    scene.position = parabola;
    const CornerMotion motion = motionOf(*scene.result(), idAt<ElementIndex>(0));
    EXPECT_LT((motion.velocities.col(0) - parabolaRate(0.5)).norm(), 1e-12);
    // Also when it appeared late: the two states before are not its own.
    test::ElementScene late;
    late.element(ElementShape::Tetrahedron, tetrahedron, "001100");
    late.position = parabola;
    EXPECT_LT((motionOf(*late.result(), idAt<ElementIndex>(0)).velocities.col(0) - parabolaRate(2.5)).norm(), 1e-12);
}

TEST(CornerMotion, OneActiveStateAtTheStartLeavesVelocityUnknown) {
    test::ElementScene scene;
    scene.element(ElementShape::Tetrahedron, tetrahedron, "100").between(ElementShape::Tetrahedron, {0, 1, 2, 3}, "111");
    scene.position = parabola;
    const CornerMotion motion = motionOf(*scene.result(), idAt<ElementIndex>(0));
    EXPECT_EQ(motion.known, 0);
    EXPECT_TRUE(motion.velocities.isZero());
    EXPECT_TRUE(motion.finite);
}

TEST(CornerMotion, OneActiveStateLaterTakesWhatItsNeighboursHold) {
    // The short-lived element shares three nodes with one that lives on, and one node with one that died earlier.
    test::ElementScene scene;
    scene.element(ElementShape::Tetrahedron, tetrahedron, "11111");
    scene.element(ElementShape::Tetrahedron, {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}}, "11000");
    scene.between(ElementShape::Tetrahedron, {1, 2, 3, 4}, "00100");
    scene.position = [](const Vec3& x, double t) { return Vec3(x + (x.x() > 4 ? 1000.0 : 2.0) * t * Vec3::UnitZ()); };
    const CornerMotion motion = motionOf(*scene.result(), idAt<ElementIndex>(2));
    EXPECT_EQ(motion.known, 3);
    for (int a = 0; a < 4; ++a) {
        EXPECT_LT((motion.velocities.col(a) - Vec3(0, 0, 2)).norm(), 1e-12);
    }
}

TEST(CornerMotion, LatchedNeighboursHoldNothing) {
    test::ElementScene scene;
    scene.element(ElementShape::Tetrahedron, tetrahedron, "10111");
    scene.between(ElementShape::Tetrahedron, {0, 1, 2, 3}, "00010");
    scene.position = parabola;
    const auto fe = scene.result();
    EXPECT_EQ(motionOf(*fe, idAt<ElementIndex>(1), Revival::Latch).known, 0);
    EXPECT_EQ(motionOf(*fe, idAt<ElementIndex>(1), Revival::Follow).known, 4);
}

TEST(CornerMotion, NotANumberIsToldAndNeverSpreads) {
    const Vec3 nan = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    test::ElementScene scene;
    scene.element(ElementShape::Tetrahedron, tetrahedron, "11110");
    scene.position = parabola;
    scene.damage = [&](std::size_t k, FeState& state) {
        if (k == 1) {
            state.positions[0] = nan;  // its second order is lost
        } else if (k == 2) {
            state.positions[1] = nan;  // its velocity is lost
        }
    };
    const CornerMotion motion = motionOf(*scene.result(), idAt<ElementIndex>(0));
    EXPECT_TRUE(motion.finite);
    EXPECT_EQ(motion.known, 3);
    EXPECT_LT((motion.velocities.col(0) - parabolaRate(2.5)).norm(), 1e-12);
    EXPECT_LT((motion.velocities.col(2) - parabolaRate(3.0)).norm(), 1e-12);
    EXPECT_TRUE(motion.velocities.allFinite());

    scene.damage = [&](std::size_t, FeState& state) { state.positions[2] = nan; };
    EXPECT_FALSE(motionOf(*scene.result(), idAt<ElementIndex>(0)).finite);
}

}  // namespace
}  // namespace rubble
