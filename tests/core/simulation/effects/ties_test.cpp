#include "core/simulation/effects/ties.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/simulation/bodies/hand_over.h"
#include "tests/core/simulation/effects/run_scene.h"
#include "tests/core/simulation/world_scene.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

/// A deck of nx x 1 x 1 blocks of 1 m that die at state 2, or at the states given.
std::shared_ptr<const FeResult> deck(
    int nx, std::function<std::size_t(std::size_t)> death = [](std::size_t) { return std::size_t{2}; }) {
    scenes::Block block;
    block.name = "deck";
    block.low = Vec3(0, 0, 50);
    block.size = Vec3(nx, 1, 1);
    block.cells = {nx, 1, 1};
    block.deathState = std::move(death);
    return scenes::makeScene({block}, 6, 0.1);
}

/// Two bodies of 2,400 kg in empty space with one tie between the faces that look at each other.
class TwoTied : public testing::Test {
protected:
    static constexpr double section = 1e-4;  // m2
    static constexpr double length = 1.0;    // m
    test::WorldScene scene;
    Scenario scenario;
    RunDescription description;
    std::unique_ptr<Ties> ties;
    BodyId a{}, b{};
    double force = 0.0;  // N, on each, apart

    void SetUp() override {
        scene.settings.ground = false;
        scene.settings.gravity = 0.0;
        scene.settings.freeze = false;
        scene.settings.bodyContacts = false;
        scene.dt = 1.0 / 240.0;
        description = test::describe(deck(1), scenario);
        ties = std::make_unique<Ties>(description, scene.world());
        a = scene.box({0, 0, 0}, {1, 1, 1});
        b = scene.box({1, 0, 0}, {1, 1, 1});
        Tie tie;
        tie.a = a;
        tie.b = b;
        tie.onA = Vec3(0.5, 0, 0);
        tie.onB = Vec3(-0.5, 0, 0);
        tie.yieldForce = section * 500e6;
        tie.stiffness = 200e9 * section / length;
        tie.breakGap = 0.15 * length;
        ties->add(tie);
        scene.world().onSubstep([this](const SubstepBodies& bodies, double h) {
            for (MovingBody& body : bodies.moving) {
                body.velocity.x() += (body.id == a ? -1.0 : 1.0) * force * h * body.inverseMass;
            }
            ties->beforeSubstep(bodies, h);
        });
    }
    double gap() { return (scene.place(b) - scene.place(a)).x() - 1.0; }
};

TEST_F(TwoTied, HoldsBelowItsForceAndStretchesByHookesLaw) {
    // Brought on slowly: at once it would swing to twice the stretch, and yield.
    scene.run(5.0, [this](double time) { force = 0.9 * section * 500e6 * std::min(1.0, time); });
    EXPECT_EQ(ties->events(), 0);
    // e = F L / (E A_s), 2.25 mm; the force is in balance with a spring that has come to rest.
    EXPECT_NEAR(gap(), force * length / (200e9 * section), 1e-6);
    EXPECT_LT(scene.velocity(a).norm(), 1e-6);
}

TEST_F(TwoTied, BreaksAboveItsForceWhenItHasYieldedByItsElongation) {
    const double strength = section * 500e6;
    force = 1.1 * strength;
    double last = 0.0, time = 0.0, gapBefore = 0.0;
    while (ties->events() == 0 && time < 2.0) {
        gapBefore = last;
        last = gap();
        scene.run(scene.dt);
        time += scene.dt;
    }
    EXPECT_EQ(ties->events(), 1);
    EXPECT_TRUE(ties->ties().empty());
    // Found broken at the start of the substep after the one that passed the limit: within two of its steps of 1.2 m/s / 240.
    EXPECT_LE(gapBefore, 0.15 * length);
    EXPECT_NEAR(last, 0.15 * length, 0.012);
    // What the force has over the strength pulls the two apart evenly: s = F t^2 / 2 m_eff.
    const double apart = (force - strength) * 2.0 / 2400.0;
    EXPECT_NEAR(time, std::sqrt(2.0 * 0.15 * length / apart), 0.02);
}

TEST_F(TwoTied, TakesTheWorkOfYielding) {
    // Flung apart, the two are stopped by the tie before it breaks: the energy goes into yielding, F_y times the way.
    const double strength = section * 500e6;
    const double speed = 1.0;  // each; 2,400 J in all, enough for 48 mm
    test::WorldScene& s = scene;
    s.run(s.dt);
    ties->leaving(a);
    const BodyId c = s.box({0, 5, 0}, {1, 1, 1}, {-speed, 0, 0});
    const BodyId d = s.box({1, 5, 0}, {1, 1, 1}, {speed, 0, 0});
    Tie tie{c, d, {0.5, 0, 0}, {-0.5, 0, 0}, strength, 200e9 * section / length, 0.15 * length, 0.0, Vec3::Zero()};
    ties->add(tie);
    double stretched = 0.0;
    s.run(0.5, [&](double) { stretched = std::max(stretched, (s.place(d) - s.place(c)).x() - 1.0); });
    EXPECT_EQ(ties->events(), 0);
    // E_kin / F_y and half the elastic stretch of 2.5 mm; a substep of 2 m/s is 8 mm. The spring gives back 2.6 % at most.
    EXPECT_NEAR(stretched, 2400.0 * speed * speed / strength, 0.005);
    EXPECT_NEAR(ties->work(), -2400.0 * speed * speed, 0.03 * 2400.0);
}

TEST_F(TwoTied, KeepsMomentumAndBooksItsWork) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int i = 0; i < 12; ++i) {
        const BodyId body =
            scene.box({2.0 + i, any(random), any(random)}, {0.9, 0.5 + 0.4 * any(random), 0.8},
                      {any(random), any(random), any(random)}, Quat::Identity(), {any(random), any(random), any(random)});
        Tie tie{idAt<BodyId>(at(body) - 1), body, {0.5, 0.1, 0}, {-0.5, 0, 0.1}, 3e5, 1e8, 10.0, 0.0, Vec3::Zero()};
        ties->add(tie);
    }
    const auto sum = [this] {
        Momenta all;
        for (std::size_t i = 0; i < scene.world().bodyCount(); ++i) {
            all += scene.world().momenta(idAt<BodyId>(i));
        }
        return all;
    };
    const Momenta before = sum();
    scene.run(1.0);
    const Momenta after = sum();
    EXPECT_LT((after.linear - before.linear).norm(), 1e-9 * 2400.0 * 13.0);
    // Pulls are along one line; what is left is the world's integration of spin (PHYSICS section 4: 1e-3).
    EXPECT_LT((after.angular - before.angular).norm(), 1e-3 * (before.angular.norm() + 2400.0));
    EXPECT_NEAR(after.kineticEnergy, before.kineticEnergy + ties->work(), 0.01 * before.kineticEnergy);
    EXPECT_LT(after.kineticEnergy, before.kineticEnergy);
}

/// Blocks of 0.3 m (65 kg) in a lattice, each tied to its neighbours by bars of 9 cm2: a substep of the yield force is 29 m/s, so
/// that what is pulled amiss shows.
class TiedLattice : public testing::Test {
protected:
    static constexpr int n = 4;
    static constexpr double side = 0.3;
    test::WorldScene scene;
    Scenario scenario;
    RunDescription description;
    std::unique_ptr<Ties> ties;
    std::vector<BodyId> blocks;
    std::mt19937 random{5};

    void build(const Vec3& low, double speed, double spin) {
        scene.solver = SolverKind::SoftStep;
        scene.dt = 1.0 / 60.0;
        description = test::describe(deck(1), scenario);
        ties = std::make_unique<Ties>(description, scene.world());
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        const auto way = [&] { return Vec3(any(random), any(random), any(random)); };
        for (int i = 0; i < n * n * n; ++i) {
            const Vec3 cell(i % n, i / n % n, i / (n * n));
            blocks.push_back(scene.box(low + side * cell, Vec3::Constant(side), speed * way(), Quat::Identity(), spin * way()));
        }
        for (int i = 0; i < n * n * n; ++i) {
            for (int axis = 0, step = 1; axis < 3; ++axis, step *= n) {
                if (i / step % n + 1 < n) {
                    constexpr double area = 0.01 * side * side;
                    const Vec3 half = 0.5 * side * Vec3::Unit(axis);
                    ties->add({blocks[static_cast<std::size_t>(i)], blocks[static_cast<std::size_t>(i + step)], half, -half,
                               area * 500e6, 200e9 * area / side, 0.15 * side, 0.0, Vec3::Zero()});
                }
            }
        }
        scene.world().onSubstep([this](const SubstepBodies& bodies, double h) { ties->beforeSubstep(bodies, h); });
    }
    double kinetic() {
        double sum = 0.0;
        for (const BodyId id : blocks) {
            sum += scene.world().momenta(id).kineticEnergy;
        }
        return sum;
    }
};

TEST_F(TiedLattice, InEmptySpaceOnlyLosesEnergy) {
    scene.settings.ground = false;
    scene.settings.gravity = 0.0;
    scene.settings.freeze = false;
    scene.settings.bodyContacts = false;
    build({0, 0, 0}, 4.0, 10.0);
    const double begun = kinetic();
    double least = begun;
    double rise = 0.0;
    scene.run(2.0, [&](double) {
        const double now = kinetic();
        rise = std::max(rise, now - least);
        least = std::min(least, now);
    });
    EXPECT_LT(rise, 1e-3 * begun);
    EXPECT_LT(least, 0.1 * begun);
}

TEST_F(TwoTied, AChainHangsAndStays) {
    // Ten blocks under one that nothing moves; the yield force is twenty times their weight.
    scene.run(scene.dt);
    NewBody heavy = test::boxBody({0, 20, 0}, {1, 1, 1});
    heavy.mass *= 1e9;
    heavy.inertia *= 1e9;
    BodyId above = scene.world().addBody(heavy);
    const BodyId top = above;
    std::vector<BodyId> chain;
    for (int i = 1; i <= 10; ++i) {
        chain.push_back(scene.box({0, 20, -1.0 * i}, {1, 1, 1}));
        ties->add({above, chain.back(), {0, 0, -0.5}, {0, 0, 0.5}, 5e6, 2e9, 0.15, 0.0, Vec3::Zero()});
        above = chain.back();
    }
    scene.world().onSubstep([&](const SubstepBodies& bodies, double h) {
        ties->beforeSubstep(bodies, h);
        for (MovingBody& body : bodies.moving) {
            if (body.id != top) {
                body.velocity.z() -= standardGravity * h;
            }
        }
    });
    scene.run(5.0);
    EXPECT_EQ(ties->events(), 0);
    // Elastic stretch: sum of i m g L / (E A) over the ten, 0.6 mm; swinging out it has yielded by one more.
    EXPECT_NEAR(scene.place(chain.back()).z(), -10.0006, 0.002);
    EXPECT_LT(scene.velocity(chain.back()).norm(), 1e-3);
}

TEST(TieSites, AreTheSharedFacesOfReinforcedClusters) {
    Scenario scenario;
    scenario.grid.oneBodyPerFragment = true;
    EXPECT_TRUE(findTieSites(test::describe(deck(4), scenario)).empty()) << "nothing is reinforced";
    scenario.components["deck"].reinforced = true;
    const RunDescription description = test::describe(deck(4), scenario);
    const std::vector<TieSite> sites = findTieSites(description);
    ASSERT_EQ(sites.size(), 3u);
    for (std::size_t s = 0; s < sites.size(); ++s) {
        EXPECT_NEAR(sites[s].area, 1.0, 1e-12);
        EXPECT_NEAR(sites[s].length, 1.0, 1e-12);
        EXPECT_LT((sites[s].centre(description.fe->mesh().nodes) - Vec3(1.0 + static_cast<double>(s), 0.5, 50.5)).norm(), 1e-12);
    }
}

TEST(TieSites, OfClustersAreOneAPair) {
    Scenario scenario;
    scenario.components["deck"].reinforced = true;
    scenes::Block block;
    block.name = "deck";
    block.size = Vec3(4, 2, 2);
    block.cells = {4, 2, 2};
    block.deathState = [](std::size_t) { return std::size_t{2}; };
    scenario.grid.length = 2.0;
    scenario.grid.width = scenario.grid.height = 10.0;
    const RunDescription description = test::describe(scenes::makeScene({block}, 4, 0.1), scenario);
    ASSERT_EQ(description.clustering->list.size(), 2u);
    const std::vector<TieSite> sites = findTieSites(description);
    ASSERT_EQ(sites.size(), 1u);
    EXPECT_EQ(sites[0].joints.size(), 4u);
    EXPECT_NEAR(sites[0].area, 4.0, 1e-12);
    EXPECT_NEAR(sites[0].length, 2.0, 1e-12);
}

TEST(Ties, FormWhenTheLaterBodyEntersUnlessTheGapHasTornOpen) {
    Scenario scenario;
    scenario.grid.oneBodyPerFragment = true;
    scenario.components["deck"].reinforced = true;
    const RunDescription description =
        test::describe(deck(3, [](std::size_t e) { return e == 0 ? std::size_t{3} : std::size_t{2}; }), scenario);
    for (const double wait : {0.0, 0.1, 1.0}) {
        test::WorldScene scene;
        scene.settings.ground = false;
        scene.settings.bodyContacts = false;
        Ties ties(description, scene.world());
        Findings findings;
        // Clusters in the order of hand-over: the second and third block, then the first.
        ties.entered(handOver(description, 0, 2, IslandBirths(), scene.world(), findings).fromFe.bodies, scene.world());
        EXPECT_EQ(ties.ties().size(), 1u);
        scene.run(wait);
        ties.entered(handOver(description, 2, 3, IslandBirths(), scene.world(), findings).fromFe.bodies, scene.world());
        // Falling for 0.1 s opens 0.05 m of the 0.15 m that it may, for 1 s 4.9 m.
        EXPECT_EQ(ties.ties().size(), wait < 0.5 ? 2u : 1u) << wait;
        if (wait == 0.1) {
            EXPECT_NEAR(ties.ties().back().slackGap, 0.5 * standardGravity * 0.01, 1e-9);
        }
        ties.leaving(idAt<BodyId>(0));
        EXPECT_LT(ties.ties().size(), 2u);
    }
}

TEST(Ties, WakeAFrozenPartnerThatTheyWouldMove) {
    test::WorldScene scene;
    const Scenario scenario;
    const RunDescription description = test::describe(deck(1), scenario);
    Ties ties(description, scene.world());
    scene.world().onSubstep([&](const SubstepBodies& bodies, double h) { ties.beforeSubstep(bodies, h); });
    const BodyId rests = scene.box({0, 0, 0.5}, {1, 1, 1});
    scene.run(3.0);
    ASSERT_EQ(scene.world().state(rests), BodyState::Frozen);
    const BodyId flung = scene.box({3, 0, 3}, {1, 1, 1}, {20, 0, 5});
    ties.add({rests, flung, {0.5, 0, 0.5}, {-0.5, 0, -0.5}, 2e6, 2e8, 5.0, 3.2, Vec3::Zero()});
    for (int i = 0; i < 60; ++i) {
        scene.run(scene.dt);
        ties.afterStep(scene.world(), scene.dt);
    }
    EXPECT_GT((scene.place(rests) - Vec3(0, 0, 0.5)).norm(), 0.1);
}

}  // namespace
}  // namespace rubble
