#include "core/fragments/rigid_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <vector>

#include "tests/core/fragments/element_scene.h"

namespace rubble {
namespace {

Corners box(const Vec3& half) {
    Corners x;
    for (int a = 0; a < 8; ++a) {
        x.col(a) = half.cwiseProduct(Vec3(a % 4 == 0 || a % 4 == 3 ? -1 : 1, a % 4 < 2 ? -1 : 1, a < 4 ? -1 : 1));
    }
    return x;
}

Corners rigidVelocities(const Corners& x, const Vec3& centre, const Vec3& v, const Vec3& w) {
    Corners velocities;
    for (int a = 0; a < 8; ++a) {
        velocities.col(a) = v + w.cross(x.col(a) - centre);
    }
    return velocities;
}

TEST(RigidFit, InertiaOfABoxIsTheClosedForm) {
    const Vec3 half(0.5, 1.0, 2.0);
    std::mt19937 random(1);
    const Mat3 turn = test::randomRotation(random);
    const Vec3 place(120, -35, 40);
    const Corners x = (turn * box(half)).colwise() + place;
    const RigidFit fit = fitRigidMotion(consistentMass(x, 12.0), x, Corners::Zero(), 0.0);
    const Vec3 square = half.cwiseProduct(half);
    const Mat3 expected =
        turn *
        Vec3(4.0 * (square.y() + square.z()), 4.0 * (square.x() + square.z()), 4.0 * (square.x() + square.y())).asDiagonal() *
        turn.transpose();
    EXPECT_LT((fit.inertia - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.maxCoeff());
    EXPECT_LT((fit.centre - place).norm(), 1e-12);
}

TEST(RigidFit, KeepsMomentaOfAnyMotionAndGainsNoEnergy) {
    std::mt19937 random(2);
    for (int i = 0; i < 500; ++i) {
        const std::vector<Vec3> corners = test::randomElement(ElementShape::Hexahedron, random, 1.0, 0.4);
        Corners x, v;
        for (int a = 0; a < 8; ++a) {
            x.col(a) = corners[static_cast<std::size_t>(a)];
            v.col(a) = test::randomVector(random, 25.0);
        }
        const RigidFit fit = fitRigidMotion(consistentMass(x, 4000.0), x, v, 0.0);
        const Momenta rigid = rigidMomenta(4000.0, fit.centre, fit.inertia, fit.velocity, fit.angularVelocity);
        const double scale = 4000.0 * 25.0;
        EXPECT_NEAR(rigid.mass, fit.field.mass, 1e-12 * 4000.0);
        EXPECT_LT((rigid.linear - fit.field.linear).norm(), 1e-12 * scale);
        EXPECT_LT((rigid.angular - fit.field.angular).norm(), 1e-12 * scale * 50.0);
        // Also about the centre, where the lever to the origin hides nothing.
        const Vec3 spin = fit.field.angular - fit.centre.cross(fit.field.linear);
        EXPECT_LT((fit.inertia * fit.angularVelocity - spin).norm(), 1e-11 * scale);
        EXPECT_LE(rigid.kineticEnergy, fit.field.kineticEnergy * (1.0 + 1e-12));
    }
}

TEST(RigidFit, NoOtherRigidMotionIsNearer) {
    std::mt19937 random(6);
    const std::vector<Vec3> corners = test::randomElement(ElementShape::Hexahedron, random, 1.0, 0.4);
    Corners x, v;
    for (int a = 0; a < 8; ++a) {
        x.col(a) = corners[static_cast<std::size_t>(a)];
        v.col(a) = test::randomVector(random, 5.0);
    }
    const ConsistentMass mass = consistentMass(x, 10.0);
    const RigidFit fit = fitRigidMotion(mass, x, v, 0.0);
    const auto misfit = [&](const Vec3& linear, const Vec3& angular) {
        const Corners rest = v - rigidVelocities(x, fit.centre, linear, angular);
        return (rest * mass.matrix).cwiseProduct(rest).sum();
    };
    const double best = misfit(fit.velocity, fit.angularVelocity);
    for (int i = 0; i < 100; ++i) {
        EXPECT_GT(misfit(fit.velocity + test::randomVector(random, 0.1), fit.angularVelocity + test::randomVector(random, 0.1)),
                  best);
    }
}

TEST(RigidFit, RecoversARigidMotion) {
    std::mt19937 random(4);
    for (int i = 0; i < 200; ++i) {
        const std::vector<Vec3> corners = test::randomElement(ElementShape::Hexahedron, random, 1.0, 0.4);
        Corners x;
        for (int a = 0; a < 8; ++a) {
            x.col(a) = corners[static_cast<std::size_t>(a)];
        }
        const ConsistentMass mass = consistentMass(x, 500.0);
        const Vec3 centre = fitRigidMotion(mass, x, Corners::Zero(), 0.0).centre;
        const Vec3 v = test::randomVector(random, 30.0), w = test::randomVector(random, 5.0);
        const RigidFit fit = fitRigidMotion(mass, x, rigidVelocities(x, centre, v, w), 0.0);
        EXPECT_LT((fit.velocity - v).norm(), 1e-12 * 30.0);
        EXPECT_LT((fit.angularVelocity - w).norm(), 1e-11);
        EXPECT_NEAR(fit.field.kineticEnergy, rigidMomenta(500.0, centre, fit.inertia, v, w).kineticEnergy, 1e-8);
    }
}

TEST(RigidFit, NeedleAndPointHaveNoSpinToGive) {
    // All mass on a line along x: no inertia about it; the pseudo-inverse leaves that spin at zero and keeps the others.
    const Corners needle = box(Vec3(1, 0, 0));
    const ConsistentMass mass = consistentMass(needle, 3.0);
    const RigidFit fit = fitRigidMotion(mass, needle, rigidVelocities(needle, Vec3::Zero(), Vec3(1, 2, 3), Vec3(4, 5, 6)), 0.0);
    EXPECT_LT((fit.angularVelocity - Vec3(0, 5, 6)).norm(), 1e-12);
    EXPECT_LT((fit.velocity - Vec3(1, 2, 3)).norm(), 1e-12);
    const Corners point = Corners::Constant(2.0);
    const RigidFit still = fitRigidMotion(consistentMass(point, 3.0), point, Corners::Constant(1.0), 0.0);
    EXPECT_TRUE(still.angularVelocity.isZero());
    EXPECT_LT((still.velocity - Vec3::Ones()).norm(), 1e-12);
}

TEST(RigidFit, LeastSpreadMakesInertiaPositiveAndStillClosesMomenta) {
    std::mt19937 random(8);
    for (const Vec3& half : {Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 0)}) {
        const Corners x = (test::randomRotation(random) * box(half)).colwise() + Vec3(10, 20, 30);
        Corners v;
        for (int a = 0; a < 8; ++a) {
            v.col(a) = test::randomVector(random, 3.0);
        }
        const RigidFit fit = fitRigidMotion(consistentMass(x, 6.0), x, v, 0.01);
        // At least that of a cube of half extent 0.01.
        EXPECT_GE(Eigen::SelfAdjointEigenSolver<Mat3>(fit.inertia).eigenvalues().minCoeff(), 6.0 * 2.0 / 3.0 * 1e-4 * (1 - 1e-9));
        const Momenta rigid = rigidMomenta(6.0, fit.centre, fit.inertia, fit.velocity, fit.angularVelocity);
        EXPECT_LT((rigid.angular - fit.field.angular).norm(), 1e-12 * 18.0 * 40.0);
    }
}

TEST(Momenta, AddUp) {
    Momenta sum = rigidMomenta(2.0, Vec3(1, 0, 0), Mat3::Identity(), Vec3(0, 3, 0), Vec3(0, 0, 1));
    EXPECT_TRUE(sum.linear.isApprox(Vec3(0, 6, 0)));
    EXPECT_TRUE(sum.angular.isApprox(Vec3(0, 0, 7)));
    EXPECT_DOUBLE_EQ(sum.kineticEnergy, 9.5);
    sum += sum;
    EXPECT_DOUBLE_EQ(sum.mass, 4.0);
    EXPECT_TRUE(sum.angular.isApprox(Vec3(0, 0, 14)));
    EXPECT_DOUBLE_EQ(sum.kineticEnergy, 19.0);
}

}  // namespace
}  // namespace rubble
