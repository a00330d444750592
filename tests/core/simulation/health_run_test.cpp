#include <gtest/gtest.h>

#include <cmath>

#include "core/base/standard_gravity.h"
#include "core/base/unknown.h"
#include "core/engine/world/forwarding_world.h"
#include "core/pipeline/pipeline.h"
#include "core/simulation/run/acknowledgement.h"
#include "core/simulation/run/collapse_run.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

/// A world in which something happens at a time.
class TamperedWorld : public ForwardingWorld {
public:
    /// Called before each step with the time at its start and the bodies that move.
    using Tamper = std::function<void(double time, const SubstepBodies& bodies)>;
    TamperedWorld(std::unique_ptr<RigidWorld> world, Tamper tamper)
        : ForwardingWorld(std::move(world)), m_tamper(std::move(tamper)) {
        onSubstep({});
    }
    void onSubstep(SubstepHook hook) override {
        world().onSubstep([this, hook = std::move(hook)](const SubstepBodies& bodies, double h) {
            m_tamper(m_time, bodies);
            if (hook) {
                hook(bodies, h);
            }
        });
    }
    void step(double dt) override {
        ForwardingWorld::step(dt);
        m_time += dt;
    }

private:
    Tamper m_tamper;
    double m_time = 0.0;
};

class HealthRun : public testing::Test {
protected:
    Scenario scenario;
    MemoryTrajectory trajectory;

    void SetUp() override {
        scenario.simulation.settleTime = 2.0;
        scenario.effects.loose = LooseStructurePolicy::Fe;  // bodies of fragments alone
        scenario.fragments.birthWindow = 0.0;
        scenario.simulation.solver = SolverKind::Bullet;
        for (const EffectKind kind : {EffectKind::AirDrag, EffectKind::Ties, EffectKind::BreakUp}) {
            scenario.effects.of(kind) = EffectSwitch::Off;
        }
    }
    SimulationResult run(std::shared_ptr<const FeResult> fe, TamperedWorld::Tamper tamper, TrajectorySink& sink) {
        const Inputs inputs{fe, {}};
        const Results results = rubble::run(inputs, scenario, Stage::Clusters, {}, nullptr, Execution());
        const RunDescription description = describeRun(inputs, scenario, results);
        const WorldFactory make = [&](const WorldSettings& settings) -> std::unique_ptr<RigidWorld> {
            return std::make_unique<TamperedWorld>(makeWorld(scenario.simulation.solver, settings), tamper);
        };
        return simulateIn(make, description, sink, Execution());
    }
    SimulationResult run(std::shared_ptr<const FeResult> fe, TamperedWorld::Tamper tamper) {
        return run(std::move(fe), std::move(tamper), trajectory);
    }
};

std::int64_t count(const SimulationResult& result, HealthCheck check) {
    return std::count_if(result.health.breaches.begin(), result.health.breaches.end(),
                         [check](const HealthBreach& breach) { return breach.check == check; });
}

/// Two blocks of two elements in the air that die one after the other.
std::shared_ptr<const FeResult> twoFallingBlocks() {
    scenes::Block block;
    block.low = Vec3(0, 0, 10);
    block.size = Vec3(2, 1, 1);
    block.cells = {2, 1, 1};
    block.gravity = standardGravity;
    block.deathState = [](std::size_t i) { return 2 + i; };
    scenes::Block other = block;
    other.name = "other";
    other.low = Vec3(0, 6, 10);
    return scenes::makeScene({block, other}, 8, 0.1);
}

TEST_F(HealthRun, AnUntouchedRunIsHealthy) {
    for (const SolverKind solver : {SolverKind::Bullet, SolverKind::SoftStep}) {
        scenario.simulation.solver = solver;
        const SimulationResult result = run(twoFallingBlocks(), [](double, const SubstepBodies&) {});
        EXPECT_FALSE(result.health.tainted()) << (result.health.tainted() ? englishText(result.health.breaches[0].what) : "");
        EXPECT_GT(result.health.contactsPeak, 0);
        EXPECT_GT(result.health.fastestOverLimit, 0.9) << "what falls freely is as fast as it may be";
        EXPECT_LT(result.health.fastestOverLimit, 1.01);
        EXPECT_EQ(result.health.asleepPeak, 1.0);
    }
}

TEST_F(HealthRun, WhatIsNoNumberLeavesAndHarmsNobody) {
    for (const SolverKind solver : {SolverKind::Bullet, SolverKind::SoftStep}) {
        scenario.simulation.solver = solver;
        MemoryTrajectory sink;
        const SimulationResult result = run(
            twoFallingBlocks(),
            [](double time, const SubstepBodies& bodies) {
                if (MovingBody* body = time > 0.3 ? bodies.find(idAt<BodyId>(1)) : nullptr) {
                    body->velocity.x() = unknown;
                }
            },
            sink);
        EXPECT_EQ(result.health.bodiesLost, 1);
        ASSERT_EQ(count(result, HealthCheck::NotANumber), 1);
        EXPECT_EQ(result.health.breaches[0].body, idAt<BodyId>(1));
        EXPECT_TRUE(result.health.breaches[0].place.allFinite());
        EXPECT_EQ(result.findings.count("simulation.not_a_number"), 1);
        EXPECT_TRUE(std::isfinite(result.energy.dissipated));
        EXPECT_LT(result.energy.drift, 1e-3);
        EXPECT_TRUE(std::isfinite(result.maxSpeed));
        for (const FragmentOutcome& fragment : result.fragments) {
            EXPECT_TRUE(fragment.finalPosition.allFinite());
        }
        for (std::size_t i = 0; i < sink.frameCount(); ++i) {
            const auto frame = sink.frame(i);
            for (std::size_t b = 0; b < frame->bodies(); ++b) {
                EXPECT_TRUE(frame->positions[b].allFinite()) << i;
                EXPECT_TRUE(frame->orientations[b].coeffs().allFinite()) << i;
            }
        }
        const auto last = sink.frame(sink.frameCount() - 1);
        EXPECT_EQ(last->states[1], BodyState::Removed);
        EXPECT_EQ(std::count(last->states.begin(), last->states.end(), BodyState::Removed), 1);
    }
}

TEST_F(HealthRun, WhatIsNoNumberIsNotHandedOnByContacts) {
    for (const SolverKind solver : {SolverKind::Bullet, SolverKind::SoftStep}) {
        scenario.simulation.solver = solver;
        MemoryTrajectory sink;
        const SimulationResult result = run(
            scenes::collapsingWall(6, 4),
            [](double time, const SubstepBodies& bodies) {
                for (MovingBody& body : bodies.moving) {
                    if (time > 0.6 && at(body.id) % 5 == 2) {
                        body.spin.y() = unknown;
                    }
                }
            },
            sink);
        EXPECT_GT(result.bodiesPeak, 10);
        EXPECT_GT(result.health.bodiesLost, 0);
        const auto last = sink.frame(sink.frameCount() - 1);
        for (std::size_t b = 0; b < last->bodies(); ++b) {
            EXPECT_TRUE(last->positions[b].allFinite()) << b;
            EXPECT_TRUE(b % 5 == 2 || last->states[b] != BodyState::Removed) << b;
        }
        EXPECT_TRUE(std::isfinite(result.energy.dissipated));
    }
}

/// Speeds everything up a little for a while.
TamperedWorld::Tamper heating(double from, double to, double factor) {
    return [=](double time, const SubstepBodies& bodies) {
        for (MovingBody& body : bodies.moving) {
            body.velocity *= time >= from && time < to ? factor : 1.0;
        }
    };
}

TEST_F(HealthRun, EnergyFromNowhereIsABreachWithAPlaceAndATime) {
    const SimulationResult result = run(twoFallingBlocks(), heating(0.25, 0.3, 1.02));
    ASSERT_GE(count(result, HealthCheck::Energy), 1);
    const HealthBreach& breach = result.health.breaches[0];
    EXPECT_EQ(breach.check, HealthCheck::Energy);
    EXPECT_NEAR(breach.from, 0.1 + 0.25, 0.06);
    EXPECT_GT(breach.worst, 0.001);
    EXPECT_TRUE(breach.body);
    EXPECT_EQ(result.findings.count("simulation.energy_gain"), count(result, HealthCheck::Energy));
    EXPECT_NEAR(result.energy.drift, breach.worst, 1e-12);
}

/// Keeps what a run tells of breaches on its way, the last word on each.
class BreachListener : public MemoryTrajectory {
public:
    void addBreaches(const std::vector<HealthBreach>& breaches) override {
        for (const HealthBreach& breach : breaches) {
            const auto same = [&](const HealthBreach& b) { return b.check == breach.check && b.from == breach.from; };
            std::erase_if(told, same);
            told.push_back(breach);
        }
        if (framesAtFirst == 0) {
            framesAtFirst = frameCount();
        }
    }
    std::vector<HealthBreach> told;
    std::size_t framesAtFirst = 0;
};

TEST_F(HealthRun, BreachesAreToldWhileTheRunGoesOn) {
    BreachListener sink;
    const SimulationResult result = run(twoFallingBlocks(), heating(0.25, 0.3, 1.02), sink);
    ASSERT_FALSE(result.health.breaches.empty());
    EXPECT_LT(sink.framesAtFirst, sink.frameCount() / 2) << "not at the end";
    for (const HealthBreach& breach : result.health.breaches) {
        EXPECT_LE(breach.from, breach.worstAt);
        EXPECT_LE(breach.worstAt, breach.to);
        // The pile is measured when all is over.
        if (breach.check != HealthCheck::Bulking) {
            const auto told = std::find_if(sink.told.begin(), sink.told.end(),
                                           [&](const HealthBreach& b) { return b.check == breach.check && b.from == breach.from; });
            ASSERT_NE(told, sink.told.end()) << healthCheckName(breach.check);
            EXPECT_LE(told->to, breach.to);
            EXPECT_LE(breach.to - told->to, 1.0) << "it is told once a second at least";
        }
    }
}

TEST_F(HealthRun, ALaunchIsABreachOfSpeed) {
    const SimulationResult result = run(twoFallingBlocks(), [](double time, const SubstepBodies& bodies) {
        MovingBody* body = bodies.find(idAt<BodyId>(0));
        if (body != nullptr && time > 0.3 && time < 0.36) {
            body->velocity.x() += 30.0;
        }
    });
    ASSERT_EQ(count(result, HealthCheck::Speed), 1);
    EXPECT_EQ(result.findings.count("simulation.too_fast"), 1);
}

TEST_F(HealthRun, SmallerStepsFollowABreachAndRepeatBitByBit) {
    const SimulationResult plain = run(twoFallingBlocks(), heating(0.25, 0.3, 1.02));
    EXPECT_TRUE(plain.health.remedies.empty());
    scenario.simulation.autoRemedy = true;
    const SimulationResult first = run(twoFallingBlocks(), heating(0.25, 0.3, 1.02));
    ASSERT_FALSE(first.health.remedies.empty());
    const HealthRemedy& remedy = first.health.remedies.front();
    EXPECT_NEAR(remedy.from, first.health.breaches[0].from, 1e-9);
    EXPECT_GE(remedy.to - remedy.from, 0.5 - 1e-9);
    EXPECT_GE(remedy.steps, 30) << "half a second of steps of 1/60 s";
    EXPECT_GT(first.steps, plain.steps);
    EXPECT_EQ(first.findings.count("simulation.auto_remedy") > 0, true);
    MemoryTrajectory other;
    const SimulationResult second = run(twoFallingBlocks(), heating(0.25, 0.3, 1.02), other);
    EXPECT_EQ(first.trajectoryHash, second.trajectoryHash);
    EXPECT_EQ(breachesDigest(first), breachesDigest(second));
    EXPECT_EQ(first.steps, second.steps);
}

TEST_F(HealthRun, ARemedyThatIsNotNeededChangesNothing) {
    const SimulationResult plain = run(scenes::collapsingWall(), [](double, const SubstepBodies&) {});
    scenario.simulation.autoRemedy = true;
    const SimulationResult ready = run(scenes::collapsingWall(), [](double, const SubstepBodies&) {});
    if (plain.health.breaches.empty()) {
        EXPECT_EQ(plain.trajectoryHash, ready.trajectoryHash);
        EXPECT_TRUE(ready.health.remedies.empty());
    } else {
        EXPECT_FALSE(ready.health.remedies.empty());
    }
}

TEST(Acknowledgement, HoldsForTheVeryBreachesOnly) {
    SimulationResult result;
    result.trajectoryHash = Hasher().text("run").finish();
    EXPECT_FALSE(isTainted(result, {}));
    result.health.breaches.push_back({HealthCheck::Energy, 1.0, 2.0, 1.5, std::nullopt, Vec3::Zero(), 0.02, 0.001, 0, {}, {}});
    EXPECT_TRUE(isTainted(result, {}));
    const std::vector<Acknowledgement> list{{"A", utcNow(), "looked at it", breachesDigest(result)}};
    EXPECT_FALSE(isTainted(result, list));
    SimulationResult other = result;
    other.health.breaches[0].worst = 0.03;
    EXPECT_TRUE(isTainted(other, list));
    other = result;
    other.trajectoryHash = Hasher().text("another run").finish();
    EXPECT_TRUE(isTainted(other, list));
    EXPECT_EQ(list[0].when.size(), 20u);
    EXPECT_EQ(list[0].when.back(), 'Z');
}

}  // namespace
}  // namespace rubble
