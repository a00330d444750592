#include "core/simulation/soft_lanes.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>
#include <vector>

#include "core/simulation/soft_solver.h"
#include "tests/core/simulation/solver_contact.h"

namespace rubble {
namespace {

/// Bodies on each other in columns, with contacts of one to four points, some in overlap, some limited.
struct Column {
    static constexpr std::size_t bodies = 37;
    static constexpr double h = 1.0 / 240.0;
    WorkerPool pool{1};
    SoftSolver solver{pool};

    /// @param height  bodies in a column
    explicit Column(unsigned seed, std::uint32_t height = 3) {
        std::mt19937 random(seed);
        const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
        solver.bodies.resize(bodies + 1);
        for (std::size_t i = 0; i < bodies; ++i) {
            SolverBody& body = solver.bodies[i];
            body.velocity = Vec3(between(-1, 1), between(-1, 1), between(-1, 1));
            body.spin = Vec3(between(-1, 1), between(-1, 1), between(-1, 1));
            body.inverseMass = between(0.5, 2.0);
            body.inverseInertia = Vec3(between(2, 4), between(2, 4), between(2, 4)).asDiagonal();
        }
        std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
        for (std::uint32_t i = 0; i < bodies; ++i) {
            ends.emplace_back(i % height == 0 ? bodies : i - 1, i);
        }
        ContactColours colours;
        colourContacts(ends, bodies, colours);
        solver.firstOfGroup = colours.first;
        solver.lastInOrder = colours.lastInOrder;
        for (const std::uint32_t k : colours.order) {
            SolverContact c =
                scenes::solverContact(ends[k], k, solver.points.size(), Vec3(between(-0.2, 0.2), between(-0.2, 0.2), 1.0), h);
            c.impulseLimit = k % 5 == 0 ? 0.02 : -1.0;
            c.booked = k % 2 == 0;
            c.parting = k % 4 == 0 ? 0.2 : 0.0;
            for (std::uint32_t n = 0; n < c.points; ++n) {
                solver.points.push_back(scenes::solverPoint(between));
            }
            solver.contacts.push_back(c);
        }
        prepare();
    }

    void prepare() {
        solver.resize(solver.contacts.size(), solver.points.size());
        for (std::size_t i = 0; i < solver.contacts.size(); ++i) {
            solver.prepareContact(i, h);
        }
        solver.layOut(h, bodies);
    }

    void substep() {
        for (std::size_t i = 0; i < bodies; ++i) {
            solver.bodies[i].velocity.z() -= standardGravity * h;
        }
        solver.solveSoft(1.0);
        for (std::size_t i = 0; i < bodies; ++i) {
            solver.bodies[i].moved += h * solver.bodies[i].velocity;
            solver.bodies[i].turned += h * solver.bodies[i].spin;
        }
        solver.relax();
        solver.book();
    }
};

TEST(SoftLanes, BothMakesRoundAlike) {
    const LanePasses* wide = wideLanePasses();
    if (wide == nullptr || &lanePasses() != wide) {
        SUCCEED() << "this processor takes the common make";
        return;
    }
    Column common(7), fast(7);
    common.solver.use(commonLanePasses());
    fast.solver.use(*wide);
    for (int i = 0; i < 8; ++i) {
        common.substep();
        fast.substep();
    }
    ASSERT_TRUE(common.solver.part());
    ASSERT_TRUE(fast.solver.part());
    common.solver.takeBack();
    fast.solver.takeBack();
    for (std::size_t i = 0; i < Column::bodies; ++i) {
        EXPECT_EQ(common.solver.bodies[i].velocity, fast.solver.bodies[i].velocity) << i;
        EXPECT_EQ(common.solver.bodies[i].spin, fast.solver.bodies[i].spin) << i;
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(common.solver.parted()[i].velocity[k], fast.solver.parted()[i].velocity[k]) << i;
            EXPECT_EQ(common.solver.parted()[i].spin[k], fast.solver.parted()[i].spin[k]) << i;
        }
    }
    for (std::size_t i = 0; i < common.solver.points.size(); ++i) {
        EXPECT_EQ(common.solver.points[i].impulseSum, fast.solver.points[i].impulseSum) << i;
    }
}

TEST(SoftLanes, WhatAContactGetsDoesNotDependOnThoseBesideIt) {
    // Friction whose load is gone, alone and beside contacts that carry: contacts of a colour go side by side in any order.
    const auto speedsAfter = [](std::size_t contacts) {
        Column column(9);
        column.solver.contacts.resize(contacts);
        column.solver.firstOfGroup = {0, static_cast<std::uint32_t>(contacts)};
        const SolverContact& c = column.solver.contacts[0];
        for (SolverPoint& p : std::span(column.solver.points).subspan(c.firstPoint, c.points)) {
            p.normalImpulse = 0.0;
            p.tangentImpulse[0] = 0.05;
            p.separation = 1.0;
        }
        column.prepare();
        column.solver.solveSoft(1.0);
        return std::pair(column.solver.bodies[c.a].velocity, column.solver.bodies[c.b].velocity);
    };
    const std::uint32_t firstColour = Column(9).solver.firstOfGroup[1];
    ASSERT_GT(firstColour, 1u);
    EXPECT_EQ(speedsAfter(1), speedsAfter(firstColour));
}

TEST(SoftLanes, PushesApartGoOnFromTheStepBefore) {
    // A column in which all contacts come apart: the lower ones carry the way of what lies above, for which the passes of one step
    // are too few. What is open may close first.
    Column column(7, Column::bodies);
    for (SolverContact& c : column.solver.contacts) {
        c.parting = 0.2;
    }
    column.prepare();
    const auto missing = [&] {
        EXPECT_TRUE(column.solver.part());
        double most = 0.0;
        for (const SolverContact& c : column.solver.contacts) {
            const LaneBody& a = column.solver.parted()[c.a];
            const LaneBody& b = column.solver.parted()[c.b];
            for (std::uint32_t k = 0; k < c.points; ++k) {
                const SolverPoint& p = column.solver.points[c.firstPoint + k];
                const Vec3 way = Vec3(b.velocity) + Vec3(b.spin).cross(p.fromB) - Vec3(a.velocity) - Vec3(a.spin).cross(p.fromA);
                most = std::max(most, c.parting - std::max(0.0, p.separation) - c.normal.dot(way));
            }
        }
        return most;
    };
    const double first = missing();
    double last = first;
    for (int step = 0; step < 30; ++step) {
        column.solver.takeBack();
        column.prepare();
        last = missing();
    }
    EXPECT_LT(last, 0.01 * first);
}

TEST(SoftLanes, ContactsKeepMomentum) {
    // The ground takes part in every third contact: without it momentum stays to rounding.
    Column column(3);
    std::erase_if(column.solver.contacts, [](const SolverContact& c) { return c.a == Column::bodies; });
    column.solver.firstOfGroup = {0};
    for (std::size_t i = 0; i < column.solver.contacts.size(); ++i) {
        column.solver.firstOfGroup.push_back(static_cast<std::uint32_t>(i + 1));
    }
    column.prepare();
    const auto momentum = [&] {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < Column::bodies; ++i) {
            sum += column.solver.bodies[i].velocity / column.solver.bodies[i].inverseMass;
        }
        return sum;
    };
    const Vec3 before = momentum();
    column.solver.solveSoft(1.0);
    column.solver.relax();
    // 37 bodies of about 1 kg at 1 m/s, 25 contacts, five passes: some 1e-15 each.
    EXPECT_LT((momentum() - before).norm(), 1e-12);
}

TEST(SoftLanes, WorkBookedCoversWhatContactsPutIn) {
    Column column(11);
    for (SolverContact& c : column.solver.contacts) {
        c.booked = true;
        c.parting = 0.2;
    }
    for (SolverBody& body : column.solver.bodies) {
        body.velocity = body.spin = Vec3::Zero();
    }
    column.prepare();
    const auto energy = [&] {
        double sum = 0.0;
        for (std::size_t i = 0; i < Column::bodies; ++i) {
            const SolverBody& b = column.solver.bodies[i];
            sum += 0.5 * b.velocity.squaredNorm() / b.inverseMass + 0.5 * b.spin.dot(b.inverseInertia.inverse() * b.spin);
        }
        return sum;
    };
    const double before = energy();
    column.solver.solveSoft(1.0);
    column.solver.relax();
    column.solver.book();
    column.solver.takeBack();
    double work = 0.0;
    for (const SolverContact& c : column.solver.contacts) {
        work += c.work;
    }
    EXPECT_GE(work, energy() - before - 1e-12);
    EXPECT_GT(work, 0.0);
}

}  // namespace
}  // namespace rubble
