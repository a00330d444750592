#include "core/engine/soft/lanes/soft_lanes.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>
#include <vector>

#include "core/engine/soft/soft_solver.h"
#include "tests/core/engine/soft/solver_contact.h"

namespace rubble {
namespace {

/// Bodies on each other in columns, with contacts of one to four points, some in overlap, some limited.
struct Column {
    static constexpr std::size_t bodies = 37;
    static constexpr double h = 1.0 / 240.0;
    WorkerPool pool{1};
    SoftSolver solver{pool};
    scenes::SolverConstraints constraints;

    /// @param height  bodies in a column
    explicit Column(unsigned seed, std::uint32_t height = 3) {
        std::mt19937 random(seed);
        const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
        solver.resizeBodies(bodies + 1);
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
            ContactConstraint c = scenes::contactConstraint(Vec3(between(-0.2, 0.2), between(-0.2, 0.2), 1.0), h);
            c.impulseLimit = k % 5 == 0 ? 0.02 : -1.0;
            c.countsWork = k % 2 == 0;
            c.correction = k % 4 == 0 ? 0.2 : 0.0;
            solver.contacts.push_back(scenes::solverContact(ends[k], k));
            for (std::uint32_t n = 0; n < solver.contacts.back().points; ++n) {
                c.points[n] = scenes::solverPoint(between);
            }
            constraints.made.push_back(c);
        }
        prepare();
    }

    void prepare() {
        solver.begin(bodies);
        solver.layOut(h, constraints.source());
    }

    void takeBack() { constraints.takeBack(solver); }

    void substep() {
        solver.applyGravity(standardGravity * h);
        solver.solveSoft(1.0);
        solver.move(standardGravity);
        solver.relax();
        solver.accumulateWork();
    }
};

/// Compares with the variant for every processor what another one leaves, to the bit.
void expectAlike(const LanePasses& variant) {
    Column common(7), fast(7);
    common.solver.use(commonLanePasses());
    fast.solver.use(variant);
    for (int i = 0; i < 8; ++i) {
        common.substep();
        fast.substep();
    }
    for (Column* column : {&common, &fast}) {
        EXPECT_TRUE(column->solver.correctPositions());
        column->solver.end();
        column->takeBack();
    }
    for (std::size_t i = 0; i < Column::bodies; ++i) {
        const SolverBody& a = common.solver.bodies[i];
        const SolverBody& b = fast.solver.bodies[i];
        EXPECT_EQ(a.velocity, b.velocity) << i;
        EXPECT_EQ(a.spin, b.spin) << i;
        EXPECT_EQ(common.solver.poseOf(i).position, fast.solver.poseOf(i).position) << i;
        EXPECT_EQ(common.solver.poseOf(i).orientation.coeffs(), fast.solver.poseOf(i).orientation.coeffs()) << i;
        EXPECT_EQ(a.moved, b.moved) << i;
        EXPECT_EQ(a.turned, b.turned) << i;
        EXPECT_EQ(common.solver.correctionOf(i).moved, fast.solver.correctionOf(i).moved) << i;
        EXPECT_EQ(common.solver.correctionOf(i).turned, fast.solver.correctionOf(i).turned) << i;
    }
    for (std::size_t i = 0; i < common.constraints.outcomes.size(); ++i) {
        EXPECT_EQ(common.constraints.outcomes[i].work, fast.constraints.outcomes[i].work) << i;
        for (std::size_t n = 0; n < common.solver.contacts[i].points; ++n) {
            EXPECT_EQ(common.constraints.outcomes[i].points[n].sum, fast.constraints.outcomes[i].points[n].sum) << i;
            EXPECT_EQ(common.constraints.outcomes[i].points[n].push, fast.constraints.outcomes[i].points[n].push) << i;
            EXPECT_EQ(common.constraints.outcomes[i].points[n].normal, fast.constraints.outcomes[i].points[n].normal) << i;
        }
    }
}

TEST(SoftLanes, AllMakesRoundAlike) {
    // A processor that takes the widest variant has the other one as well.
    if (wideLanePasses() != nullptr && &lanePasses() != &commonLanePasses()) {
        expectAlike(*wideLanePasses());
        expectAlike(lanePasses());
    }
}

TEST(SoftLanes, BodiesInTheMiddleOfAStepMoveLikeThoseAtItsEnds) {
    // One body alone, one in the middle of many: eight go side by side.
    const auto after = [](std::size_t bodies, std::size_t at) {
        WorkerPool pool{1};
        SoftSolver solver{pool};
        solver.resizeBodies(bodies + 1);
        SolverBody& body = solver.bodies[at];
        body.velocity = Vec3(1.0, -2.0, 3.0);
        body.spin = Vec3(0.5, 4.0, -2.0);
        body.inertia = Vec3(1.0, 3.0, 2.0);
        solver.place(at, {Vec3(10.0, 20.0, 30.0), Quat(0.5, 0.5, -0.5, 0.5)});
        solver.firstOfGroup = {0};
        solver.begin(bodies);
        solver.layOut(Column::h, {});
        for (int substep = 0; substep < 4; ++substep) {
            solver.applyGravity(standardGravity * Column::h);
            EXPECT_EQ(solver.move(standardGravity), 0);
        }
        solver.end();
        return std::pair(solver.bodies[at], solver.poseOf(at));
    };
    const auto [alone, alonePose] = after(1, 0);
    const double time = 4.0 * Column::h;
    EXPECT_NEAR(alonePose.position.z(), 30.0 + 3.0 * time - 0.5 * standardGravity * time * time, 1e-12);
    EXPECT_NEAR(alone.moved.x(), time, 1e-15);
    EXPECT_FALSE(alone.active);
    for (const std::size_t at : {0u, 7u, 8u, 11u}) {
        const auto [among, pose] = after(12, at);
        EXPECT_EQ(pose.position, alonePose.position) << at;
        EXPECT_EQ(pose.orientation.coeffs(), alonePose.orientation.coeffs()) << at;
        EXPECT_EQ(among.spin, alone.spin) << at;
    }
}

TEST(SoftLanes, ABodyThatContactsActOnIsHeldToWhatItMayGetTo) {
    Column column(7);
    for (std::size_t i = 0; i < Column::bodies; ++i) {
        column.solver.bodies[i].radius = 1.0;
    }
    column.prepare();
    for (std::size_t i = 0; i < Column::bodies; ++i) {
        column.solver.bound(i, 0.25);
    }
    column.solver.solveSoft(1.0);
    EXPECT_GT(column.solver.move(standardGravity), 0);
    column.solver.end();
    for (std::size_t i = 0; i < Column::bodies; ++i) {
        const SolverBody& body = column.solver.bodies[i];
        EXPECT_TRUE(!body.active || body.velocity.norm() <= 0.25 + 1e-12) << i;
    }
}

TEST(SoftLanes, WhatAContactGetsDoesNotDependOnThoseBesideIt) {
    // Friction whose load is gone, alone and beside contacts that carry: contacts of a colour go side by side in any order.
    const auto speedsAfter = [](std::size_t contacts) {
        Column column(9);
        column.solver.contacts.resize(contacts);
        column.solver.firstOfGroup = {0, static_cast<std::uint32_t>(contacts)};
        const SolverContact& c = column.solver.contacts[0];
        for (SolverPoint& p : std::span(column.constraints.made[0].points).first(c.points)) {
            p.impulses.normal = 0.0;
            p.impulses.tangent[0] = 0.05;
            p.separation = 1.0;
        }
        column.prepare();
        column.solver.solveSoft(1.0);
        column.solver.end();
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
    for (ContactConstraint& c : column.constraints.made) {
        c.correction = 0.2;
    }
    column.prepare();
    const auto missing = [&] {
        EXPECT_TRUE(column.solver.correctPositions());
        double most = 0.0;
        for (std::size_t i = 0; i < column.constraints.made.size(); ++i) {
            const SolverContact& of = column.solver.contacts[i];
            const ContactConstraint& c = column.constraints.made[i];
            const SolverWay a = column.solver.correctionOf(of.a), b = column.solver.correctionOf(of.b);
            for (std::uint32_t k = 0; k < of.points; ++k) {
                const SolverPoint& p = c.points[k];
                const Vec3 way = b.moved + b.turned.cross(p.fromB) - a.moved - a.turned.cross(p.fromA);
                most = std::max(most, c.correction - std::max(0.0, p.separation) - c.normal.dot(way));
            }
        }
        return most;
    };
    const double first = missing();
    double last = first;
    for (int step = 0; step < 30; ++step) {
        column.takeBack();
        column.prepare();
        last = missing();
    }
    EXPECT_LT(last, 0.01 * first);
}

TEST(SoftLanes, ContactsKeepMomentum) {
    // The ground takes part in every third contact: without it momentum stays to rounding.
    Column column(3);
    std::vector<ContactConstraint> kept;
    for (std::size_t i = 0; i < column.constraints.made.size(); ++i) {
        if (column.solver.contacts[i].a != Column::bodies) {
            kept.push_back(column.constraints.made[i]);
        }
    }
    column.constraints.made = kept;
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
    column.solver.end();
    // 37 bodies of about 1 kg at 1 m/s, 25 contacts, five passes: some 1e-15 each.
    EXPECT_LT((momentum() - before).norm(), 1e-12);
}

TEST(SoftLanes, WorkBookedCoversWhatContactsPutIn) {
    Column column(11);
    for (ContactConstraint& c : column.constraints.made) {
        c.countsWork = true;
        c.correction = 0.2;
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
    column.solver.accumulateWork();
    column.solver.end();
    column.takeBack();
    double work = 0.0;
    for (const ContactOutcome& outcome : column.constraints.outcomes) {
        work += outcome.work;
    }
    EXPECT_GE(work, energy() - before - 1e-12);
    EXPECT_GT(work, 0.0);
}

}  // namespace
}  // namespace rubble
