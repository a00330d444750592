#include "core/engine/soft/contact_strips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "core/engine/soft/soft_solver.h"
#include "tests/core/engine/soft/solver_contact.h"

namespace rubble {
namespace {

/// A heap along x: every body touches some that lie near it, and the ground; one of them touches more than there are colours.
struct Heap {
    static constexpr std::uint32_t bodies = 1500;
    static constexpr double h = 1.0 / 150.0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    WorkerPool pool;
    SoftSolver solver{pool};
    scenes::SolverConstraints constraints;

    explicit Heap(int threads) : pool(threads) {
        std::mt19937 random(11);
        const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
        solver.resizeBodies(bodies + 1);
        for (std::uint32_t i = 0; i < bodies; ++i) {
            SolverBody& body = solver.bodies[i];
            body.velocity = Vec3(between(-1, 1), between(-1, 1), between(-1, 1));
            body.inverseMass = between(0.5, 2.0);
            body.inverseInertia = Vec3(between(2, 4), between(2, 4), between(2, 4)).asDiagonal();
            ends.emplace_back(bodies, i);
            for (std::uint32_t k = 1; k < 5 && i + k < bodies; ++k) {
                ends.emplace_back(i, i + k);
            }
            if (i > 700 && i < 790) {
                ends.emplace_back(700, i);
            }
        }
        ContactColours colours;
        colourContacts(ends, bodies, colours);
        EXPECT_TRUE(colours.lastInOrder);
        solver.firstOfGroup = colours.first;
        solver.lastInOrder = colours.lastInOrder;
        for (const std::uint32_t k : colours.order) {
            ContactConstraint made = scenes::contactConstraint(Vec3(between(-0.5, 0.5), between(-0.5, 0.5), 1.0), h);
            SolverContact c = scenes::solverContact(ends[k], k);
            c.x = 0.1f * static_cast<float>(c.b);
            c.y = static_cast<float>(between(0.0, 5.0));
            made.countsWork = k % 3 == 0;
            made.correction = k % 4 == 0 ? 0.01 : 0.0;
            for (std::uint32_t n = 0; n < c.points; ++n) {
                made.points[n] = scenes::solverPoint(between);
            }
            solver.contacts.push_back(c);
            constraints.made.push_back(made);
        }
    }

    /// All numbers that a few steps leave.
    std::vector<double> run() {
        std::vector<double> numbers;
        for (int step = 0; step < 3; ++step) {
            solver.begin(bodies);
            solver.layOut(h, constraints.source());
            for (int substep = 0; substep < 2; ++substep) {
                solver.solveSoft(1.0);
                solver.relax();
                solver.accumulateWork();
            }
            EXPECT_TRUE(solver.correctPositions());
            solver.end();
            for (std::uint32_t i = 0; i < bodies; ++i) {
                const Vec3 moved = solver.correctionOf(i).moved;
                numbers.insert(numbers.end(), moved.begin(), moved.end());
                numbers.insert(numbers.end(), solver.bodies[i].velocity.begin(), solver.bodies[i].velocity.end());
                numbers.insert(numbers.end(), solver.bodies[i].spin.begin(), solver.bodies[i].spin.end());
            }
            constraints.takeBack(solver);
            for (const ContactOutcome& outcome : constraints.outcomes) {
                numbers.push_back(outcome.work);
            }
        }
        return numbers;
    }
};

TEST(ContactStrips, GiveTheSameBitsWhateverTheNumberOfThreads) {
    const std::vector<double> alone = Heap(1).run();
    EXPECT_GT(*std::max_element(alone.begin(), alone.end()), 0.0);
    for (const int threads : {2, 3, 8}) {
        EXPECT_EQ(Heap(threads).run(), alone) << threads;
    }
}

TEST(ContactStrips, HaveAboutAsManyContactsEach) {
    const Heap heap(1);
    ContactStrips strips;
    cutIntoStrips(heap.solver.contacts, Heap::bodies, 3, heap.solver.contacts.size(), strips);
    ASSERT_EQ(strips.strip.size(), heap.solver.contacts.size());
    for (std::uint16_t strip = 0; strip < 3; ++strip) {
        const auto count = std::count(strips.strip.begin(), strips.strip.end(), strip);
        EXPECT_NEAR(static_cast<double>(count), static_cast<double>(strips.strip.size()) / 3.0, 60.0) << strip;
    }
    // Across the heap, which is longer in x: further along, no earlier strip.
    for (std::size_t i = 1; i < heap.solver.contacts.size(); ++i) {
        for (std::size_t j : {i - 1, i / 2}) {
            if (heap.solver.contacts[i].x > heap.solver.contacts[j].x) {
                ASSERT_GE(strips.strip[i], strips.strip[j]);
            }
        }
    }
}

TEST(ContactStrips, MeetWhereABodyHasContactsInSeveral) {
    const Heap heap(1);
    ContactStrips strips;
    cutIntoStrips(heap.solver.contacts, Heap::bodies, 2, heap.solver.contacts.size(), strips);
    std::vector<std::pair<bool, bool>> in(Heap::bodies);
    const auto movable = [](std::uint32_t body) { return body < Heap::bodies; };
    for (std::size_t i = 0; i < heap.solver.contacts.size(); ++i) {
        for (const std::uint32_t body : {heap.solver.contacts[i].a, heap.solver.contacts[i].b}) {
            if (movable(body)) {
                (strips.strip[i] == 0 ? in[body].first : in[body].second) = true;
            }
        }
    }
    int atBorder = 0;
    for (std::size_t i = 0; i < heap.solver.contacts.size(); ++i) {
        const auto common = [&](std::uint32_t body) { return movable(body) && in[body].first && in[body].second; };
        EXPECT_EQ(strips.border[i] != 0, common(heap.solver.contacts[i].a) || common(heap.solver.contacts[i].b)) << i;
        atBorder += strips.border[i] != 0;
    }
    EXPECT_GT(atBorder, 0);
    EXPECT_LT(atBorder, static_cast<int>(heap.solver.contacts.size()) / 10);
}

TEST(ContactStrips, TakeWhatIsNowhereAndWhatMustGoOneByOneIntoTheFirst) {
    Heap heap(1);
    const std::size_t loose = heap.solver.firstOfGroup[heap.solver.firstOfGroup.size() - 2];
    ASSERT_LT(loose, heap.solver.contacts.size());
    heap.solver.contacts[5].x = std::numeric_limits<float>::quiet_NaN();
    ContactStrips strips;
    cutIntoStrips(heap.solver.contacts, Heap::bodies, 4, loose, strips);
    EXPECT_EQ(strips.strip[5], 0);
    for (std::size_t i = loose; i < heap.solver.contacts.size(); ++i) {
        EXPECT_EQ(strips.strip[i], 0) << i;
    }
    for (SolverContact& c : heap.solver.contacts) {
        c.x = c.y = std::numeric_limits<float>::quiet_NaN();
    }
    cutIntoStrips(heap.solver.contacts, Heap::bodies, 4, loose, strips);
    EXPECT_EQ(std::count(strips.strip.begin(), strips.strip.end(), 0), static_cast<std::ptrdiff_t>(strips.strip.size()));
}

}  // namespace
}  // namespace rubble
