#include "core/clusters/rigid_motion.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <vector>

#include "core/clusters/velocity_split.h"
#include "tests/core/clusters/fragment_blocks.h"

namespace rubble {
namespace {

MovingMass randomMass(std::mt19937& random, const Vec3& around) {
    MovingMass m;
    m.mass = uniform(random, 10.0, 5000.0);
    m.centre = around + uniformVector(random, -3.0, 3.0);
    const Mat3 skew = Mat3::Random();
    m.inertia = m.mass * (skew * skew.transpose() * 0.1 + 0.02 * Mat3::Identity());
    m.velocity = uniformVector(random, -30.0, 30.0);
    m.angularVelocity = uniformVector(random, -5.0, 5.0);
    return m;
}

std::vector<std::uint32_t> everyone(const std::vector<MovingMass>& all) {
    std::vector<std::uint32_t> members(all.size());
    std::iota(members.begin(), members.end(), 0u);
    return members;
}

Vec3 angularMomentumAbout(const MovingMass& m, const Vec3& point) {
    return m.inertia * m.angularVelocity + m.mass * (m.centre - point).cross(m.velocity);
}

TEST(RigidMotion, ConservesMassMomentumAndAngularMomentum) {
    std::mt19937 random(1);
    for (int round = 0; round < 300; ++round) {
        const Vec3 around = uniformVector(random, -200.0, 200.0);
        std::vector<MovingMass> all;
        for (std::size_t n = 1 + random() % 20; all.size() < n;) {
            all.push_back(randomMass(random, around));
        }
        const MovingMass body = joinRigidly(all, everyone(all));
        double mass = 0.0;
        Vec3 momentum = Vec3::Zero();
        Vec3 angular = Vec3::Zero();
        double scale = 0.0;
        double angularScale = 0.0;
        for (const MovingMass& m : all) {
            mass += m.mass;
            momentum += m.mass * m.velocity;
            angular += angularMomentumAbout(m, Vec3::Zero());
            scale += m.mass * m.velocity.norm();
            angularScale += m.mass * m.centre.norm() * m.velocity.norm();
        }
        // Rounding of sums of at most 20 terms.
        EXPECT_NEAR(body.mass, mass, 1e-13 * mass);
        EXPECT_LT((body.mass * body.velocity - momentum).norm(), 1e-13 * scale);
        EXPECT_LT((angularMomentumAbout(body, Vec3::Zero()) - angular).norm(), 1e-12 * angularScale);
    }
}

TEST(RigidMotion, RecoversTheMotionOfARigidCloud) {
    std::mt19937 random(2);
    const Vec3 spin(0.3, -1.2, 0.7);
    const Vec3 velocity(1.0, 2.0, -20.0);
    std::vector<MovingMass> all;
    for (int i = 0; i < 12; ++i) {
        MovingMass m = randomMass(random, Vec3(100.0, 5.0, 30.0));
        m.velocity = velocity + spin.cross(m.centre);
        m.angularVelocity = spin;
        all.push_back(m);
    }
    const MovingMass body = joinRigidly(all, everyone(all));
    EXPECT_LT((body.angularVelocity - spin).norm(), 1e-11);
    for (const MovingMass& m : all) {
        EXPECT_LT(velocityMisfit(body, m), 1e-10);
    }
}

TEST(RigidMotion, OneMemberIsItself) {
    std::mt19937 random(3);
    const std::vector<MovingMass> all{randomMass(random, Vec3::Zero())};
    const MovingMass body = joinRigidly(all, everyone(all));
    EXPECT_EQ(body.velocity, all[0].velocity);
    EXPECT_EQ(body.angularVelocity, all[0].angularVelocity);
    EXPECT_EQ(body.centre, all[0].centre);
}

TEST(RigidMotion, NoInertiaAboutAnAxisGivesNoSpinAboutIt) {
    // Point masses on a line along x: the spin about z is theirs, about x there is none.
    std::vector<MovingMass> all(3);
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].mass = 2.0;
        all[i].centre = Vec3(static_cast<double>(i), 0.0, 0.0);
        all[i].velocity = Vec3(0.0, 0.5 * static_cast<double>(i), 0.0);
    }
    const MovingMass body = joinRigidly(all, everyone(all));
    EXPECT_LT((body.angularVelocity - Vec3(0.0, 0.0, 0.5)).norm(), 1e-12);
    all.assign(2, {});
    const MovingMass nothing = joinRigidly(all, everyone(all));
    EXPECT_TRUE(nothing.velocity.allFinite() && nothing.angularVelocity.allFinite() && nothing.centre.allFinite());
}

std::vector<std::vector<std::uint32_t>> split(const std::vector<MovingMass>& all, double tolerance) {
    std::vector<std::uint32_t> members = everyone(all);
    std::vector<std::uint32_t> sizes;
    splitByVelocity(all, tolerance, members, sizes);
    std::vector<std::vector<std::uint32_t>> clusters;
    std::size_t first = 0;
    for (const std::uint32_t size : sizes) {
        clusters.emplace_back(members.begin() + static_cast<std::ptrdiff_t>(first),
                              members.begin() + static_cast<std::ptrdiff_t>(first + size));
        first += size;
    }
    EXPECT_EQ(first, all.size());
    return clusters;
}

/// A row of equal blocks that falls at 20 m/s.
std::vector<MovingMass> fallingRow(int n) {
    FragmentBlocks blocks;
    std::vector<MovingMass> all;
    for (int i = 0; i < n; ++i) {
        const Fragment& f = blocks.add(Vec3(i, i % 2, i % 3), Vec3::Ones());
        all.push_back({f.mass, f.centre, f.inertia, Vec3(0.0, 0.0, -20.0), Vec3::Zero()});
    }
    return all;
}

TEST(VelocitySplit, WhatMovesRigidlyStaysTogether) {
    std::vector<MovingMass> all = fallingRow(9);
    for (MovingMass& m : all) {
        m.velocity += Vec3(0.0, 3.0, 1.0).cross(m.centre);
        m.angularVelocity = Vec3(0.0, 3.0, 1.0);
    }
    EXPECT_EQ(split(all, 0.5).size(), 1u);
}

TEST(VelocitySplit, OneStrayLeavesAlone) {
    std::vector<MovingMass> all = fallingRow(9);
    all[4].velocity.y() += 25.0;
    const auto clusters = split(all, 0.5);
    ASSERT_EQ(clusters.size(), 2u);
    EXPECT_EQ(clusters[0], (std::vector<std::uint32_t>{0, 1, 2, 3, 5, 6, 7, 8}));
    EXPECT_EQ(clusters[1], std::vector<std::uint32_t>{4});
}

TEST(VelocitySplit, StraysThatFlyTogetherStayTogether) {
    std::vector<MovingMass> all = fallingRow(12);
    for (const std::size_t i : {2u, 5u, 8u}) {
        all[i].velocity += Vec3(10.0, 0.0, 4.0);
    }
    const auto clusters = split(all, 0.5);
    ASSERT_EQ(clusters.size(), 2u);
    EXPECT_EQ(clusters[1], (std::vector<std::uint32_t>{2, 5, 8}));
}

TEST(VelocitySplit, TwoHalvesFlyingApartArePartedOnce) {
    std::vector<MovingMass> all(4);
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i] = {1.0, Vec3(static_cast<double>(i % 2), 0.0, 0.0), Mat3::Identity(), Vec3(i < 2 ? 8.0 : -8.0, 0.0, 0.0),
                  Vec3::Zero()};
    }
    const auto clusters = split(all, 0.5);
    ASSERT_EQ(clusters.size(), 2u);
    EXPECT_EQ(clusters[0], (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(clusters[1], (std::vector<std::uint32_t>{2, 3}));
}

TEST(VelocitySplit, EveryClusterHoldsAndNobodyIsLost) {
    std::mt19937 random(4);
    for (int round = 0; round < 200; ++round) {
        std::vector<MovingMass> all = fallingRow(1 + static_cast<int>(random() % 40));
        const double scatter = std::exp(uniform(random, -3.0, 4.0));
        for (MovingMass& m : all) {
            m.velocity += scatter * uniformVector(random, -1.0, 1.0);
        }
        const double tolerance = uniform(random, 0.01, 2.0);
        std::vector<int> seen(all.size(), 0);
        for (const auto& cluster : split(all, tolerance)) {
            EXPECT_TRUE(std::ranges::is_sorted(cluster));
            const MovingMass body = joinRigidly(all, cluster);
            for (const std::uint32_t i : cluster) {
                EXPECT_TRUE(cluster.size() == 1 || velocityMisfit(body, all[i]) <= tolerance);
                ++seen[i];
            }
        }
        EXPECT_TRUE(std::ranges::all_of(seen, [](int times) { return times == 1; }));
    }
}

}  // namespace
}  // namespace rubble
