#include "core/simulation/health/health_monitor.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/simulation/scripted_world.h"

namespace rubble {
namespace {

constexpr double step = 1.0 / 64.0;  // s; exact in binary, so that times compare exactly

/// A monitor beside a scripted world of a few bodies at rest on level ground, 10 m from a structure 20 m high.
class HealthMonitorTest : public testing::Test {
protected:
    test::ScriptedWorld world;
    std::vector<TrackedBody> bodies;
    HealthSite site;
    double time = 0.0;
    std::unique_ptr<HealthMonitor> monitor;

    void SetUp() override {
        site.structure = Aabb(Vec3(0, 0, 0), Vec3(10, 10, 20));
        bodies.reserve(1000);
    }
    TrackedBody& add(const Vec3& place = Vec3(20, 0, 0.5)) {
        world.scripted.emplace_back();
        TrackedBody body;
        body.mass = 1000.0;
        body.birthHeight = place.z();
        body.latest.pose.position = place;
        bodies.push_back(body);
        return bodies.back();
    }
    void run(double seconds, HealthStep sample = {}) {
        if (!monitor) {
            monitor = std::make_unique<HealthMonitor>(site);
        }
        for (int i = 0; i < static_cast<int>(std::llround(seconds / step)); ++i) {
            sample.time = time += step;
            monitor->stepped(world, bodies, sample);
        }
    }
    std::vector<HealthBreach> breaches() const { return monitor->report().breaches; }
    std::int64_t finding(std::string_view id) const {
        Findings findings;
        monitor->addFindings(findings);
        return findings.count(id);
    }
};

TEST_F(HealthMonitorTest, SaysNothingOfWhatIsSound) {
    add();
    run(3.0);
    EXPECT_TRUE(breaches().empty());
    EXPECT_FALSE(monitor->report().tainted());
    EXPECT_FALSE(monitor->unwell(time));
    Findings findings;
    monitor->addFindings(findings);
    EXPECT_TRUE(findings.empty());
}

TEST_F(HealthMonitorTest, EnergyGainJustBeyondTheLimitIsABreach) {
    add();
    add(Vec3(30, 0, 0.5));
    run(1.0, {0.0, 0.001});
    EXPECT_TRUE(breaches().empty()) << "what lies on the limit is sound";
    run(step, {0.0, 0.0011});
    run(step, {0.0, 0.003});
    run(step, {0.0, 0.002});
    const double last = time;
    run(1.0);
    ASSERT_EQ(breaches().size(), 1u);
    const HealthBreach breach = breaches().front();
    EXPECT_EQ(breach.check, HealthCheck::Energy);
    EXPECT_EQ(breach.from, 1.0 + step);
    EXPECT_EQ(breach.to, last);
    EXPECT_EQ(breach.worstAt, last - step);
    EXPECT_EQ(breach.worst, 0.003);
    EXPECT_EQ(breach.limit, 0.001);
    EXPECT_NE(englishText(breach.what).find("0.3 %"), std::string::npos) << englishText(breach.what);
    EXPECT_NE(englishText(breach.remedy).find("step_rate"), std::string::npos);
    EXPECT_EQ(finding("simulation.energy_gain"), 1);
}

TEST_F(HealthMonitorTest, EnergyBreachNamesTheBodyThatGainedMost) {
    add();
    add(Vec3(30, 0, 0.5));
    world.scripted[1].pushed = true;
    run(1.0);
    bodies[1].latest.velocity = Vec3(4, 0, 0);
    run(step, {0.0, 0.5});
    ASSERT_EQ(breaches().size(), 1u);
    EXPECT_EQ(breaches()[0].body, idAt<BodyId>(1));
    EXPECT_EQ(breaches()[0].place, Vec3(30, 0, 0.5));
}

TEST_F(HealthMonitorTest, PenetrationCountsOnceItLasts) {
    for (int i = 0; i < 200; ++i) {
        add();
    }
    world.scripted[7].side = 0.4;
    world.scripted[7].penetration = 0.0401;
    run(0.5);
    EXPECT_TRUE(breaches().empty()) << "a blow is over in less";
    world.scripted[7].penetration = 0.0399;
    run(step);
    world.scripted[7].penetration = 0.06;
    const double since = time + step;
    run(0.5);
    EXPECT_TRUE(breaches().empty()) << "the wait began anew";
    run(1.0);
    ASSERT_EQ(breaches().size(), 1u);
    const HealthBreach breach = breaches().front();
    EXPECT_EQ(breach.check, HealthCheck::Penetration);
    EXPECT_EQ(breach.body, idAt<BodyId>(7));
    EXPECT_EQ(breach.from, since) << "from when it lay so, not from when that was long enough";
    EXPECT_EQ(breach.to, time);
    EXPECT_NEAR(breach.worst, 0.15, 1e-12);
    EXPECT_EQ(breach.limit, 0.10);
    EXPECT_EQ(breach.bodies, 1);
    EXPECT_NEAR(monitor->report().penetrationSustained, 0.06, 1e-12);
    EXPECT_NEAR(monitor->report().penetrationShare, 0.15, 1e-12);
    EXPECT_TRUE(monitor->unwell(time));
    EXPECT_EQ(finding("simulation.penetration"), 1);
}

TEST_F(HealthMonitorTest, PenetrationOfTenPercentIsStillSound) {
    for (int i = 0; i < 200; ++i) {
        add();
    }
    world.scripted[0].penetration = 0.10;
    world.scripted[1].penetration = 0.10;
    run(2.0);
    EXPECT_TRUE(breaches().empty()) << "two of 200 above 5 % are 1 %, which is the limit";
    EXPECT_NEAR(monitor->report().crowdShare, 0.01, 1e-12);
}

TEST_F(HealthMonitorTest, ManyBodiesNeedLessPenetration) {
    for (int i = 0; i < 200; ++i) {
        add();
    }
    for (std::size_t i = 0; i < 3; ++i) {
        world.scripted[i].penetration = 0.051;
    }
    run(1.0);
    ASSERT_EQ(breaches().size(), 1u);
    EXPECT_EQ(breaches()[0].check, HealthCheck::Penetration);
    EXPECT_NEAR(breaches()[0].worst, 0.015, 1e-12);
    EXPECT_EQ(breaches()[0].limit, 0.01);
    EXPECT_EQ(breaches()[0].bodies, 3);
    EXPECT_NE(englishText(breaches()[0].what).find("1.5 %"), std::string::npos) << englishText(breaches()[0].what);
}

TEST_F(HealthMonitorTest, WhatRestsKeepsItsPenetrationAndAsksForNoRemedy) {
    add();
    world.scripted[0].penetration = 0.2;
    run(0.25);
    world.scripted[0].state = BodyState::Frozen;
    run(2.0);
    ASSERT_EQ(breaches().size(), 1u);
    EXPECT_EQ(breaches()[0].to, time);
    EXPECT_FALSE(monitor->unwell(time)) << "smaller steps move nothing that rests";
}

/// The speed of a body that fell from 20 m to the ground, times a factor.
Vec3 fallen(double factor) {
    return {0, 0, -factor * std::sqrt(2.0 * standardGravity * 20.0)};
}

TEST_F(HealthMonitorTest, SpeedBeyondBirthAndFallIsABreach) {
    TrackedBody& body = add(Vec3(20, 0, 20));
    run(step);
    body.latest.pose.position.z() = 0.0;
    body.latest.velocity = fallen(1.049);
    run(1.0);
    EXPECT_TRUE(breaches().empty());
    EXPECT_NEAR(monitor->report().fastestOverLimit, 1.049, 0.002);
    body.latest.velocity = fallen(1.055);
    run(step);
    ASSERT_EQ(breaches().size(), 1u);
    EXPECT_EQ(breaches()[0].check, HealthCheck::Speed);
    EXPECT_GT(breaches()[0].worst, 1.05);
    EXPECT_EQ(finding("simulation.too_fast"), 1);
}

TEST_F(HealthMonitorTest, WhatAPiecePushedMayBeFaster) {
    TrackedBody& body = add(Vec3(20, 0, 20));
    world.scripted[0].pushed = true;
    run(step);
    body.latest.velocity = Vec3(50, 0, 0);
    run(1.0);
    EXPECT_TRUE(breaches().empty());
    EXPECT_EQ(monitor->report().fastestOverLimit, 0.0);
}

TEST_F(HealthMonitorTest, WhatASpanCarriesAlongMayBeAsFastAsTheSpanIsThere) {
    TrackedBody& body = add(Vec3(20, 0, 20));
    TrackedBody& other = add(Vec3(30, 0, 19));
    // The span went by at 12 m/s at a height of 21 m.
    world.scripted[0].handedEnergy = 0.5 * 12.0 * 12.0 + standardGravity * 21.0;
    run(step);
    const double speed = std::sqrt(12.0 * 12.0 + 2.0 * standardGravity * 1.0);
    body.latest.velocity = Vec3(1.04 * speed, 0, 0);
    run(1.0);
    EXPECT_TRUE(breaches().empty());
    // Nor is what it hits in its turn too fast.
    other.latest.velocity = Vec3(1.04 * speed, 0, 0);
    other.hardest = 1.0;
    run(1.0);
    EXPECT_TRUE(breaches().empty());
    body.latest.velocity = Vec3(1.06 * speed, 0, 0);
    run(step);
    ASSERT_EQ(breaches().size(), 1u);
    EXPECT_EQ(breaches()[0].body, idAt<BodyId>(0));
}

TEST_F(HealthMonitorTest, WhatWasHitMayBeAsFastAsWhateverHitIt) {
    add(Vec3(20, 0, 20)).birthEnergy = 50.0;
    TrackedBody& low = add(Vec3(20, 0, 0.5));
    run(step);
    low.latest.velocity = Vec3(15, 0, 0);
    low.hardest = 15.0;
    run(1.0);
    EXPECT_TRUE(breaches().empty());
    low.latest.velocity = Vec3(std::sqrt(100.0 + 2.0 * standardGravity * 19.5) * 1.06, 0, 0);
    run(step);
    EXPECT_EQ(breaches().size(), 1u);
}

TEST_F(HealthMonitorTest, NothingThatWasNotHitMayGainSpeed) {
    add(Vec3(20, 0, 20));
    TrackedBody& low = add(Vec3(20, 0, 0.5));
    run(step);
    low.latest.velocity = Vec3(0.99, 0, 0);
    run(1.0);
    EXPECT_TRUE(breaches().empty()) << "slow bodies are left alone";
    low.latest.velocity = Vec3(1.1, 0, 0);
    run(step);
    EXPECT_EQ(breaches().size(), 1u);
}

TEST_F(HealthMonitorTest, WaterCarriesAndLifts) {
    site.waterLevel = 5.0;
    site.current = 3.0;
    TrackedBody& body = add(Vec3(20, 0, 0.5));
    run(step);
    body.latest.velocity = Vec3(3.0, 0, 0);
    run(0.25);
    body.latest.pose.position.z() = 4.5;
    body.latest.velocity = Vec3(3.0, 0, 8.0);
    run(0.25);
    EXPECT_TRUE(breaches().empty());
    body.latest.velocity = Vec3(3.0, 0, 10.0);
    run(0.25);
    EXPECT_EQ(breaches().size(), 1u);
}

TEST_F(HealthMonitorTest, BelowGroundIsABreachAtOnce) {
    TrackedBody& body = add();
    add(Vec3(30, 0, 0.0));
    run(1.0);
    EXPECT_TRUE(breaches().empty());
    body.latest.pose.position.z() = -0.01;
    run(step);
    ASSERT_EQ(breaches().size(), 1u);
    EXPECT_EQ(breaches()[0].check, HealthCheck::BelowGround);
    EXPECT_NEAR(breaches()[0].worst, 0.01, 1e-12);
    EXPECT_EQ(finding("simulation.below_ground"), 1);
    body.latest.pose.position.z() = 0.5;
    run(2.0);
    EXPECT_EQ(breaches()[0].to, 1.0 + step);
}

TEST_F(HealthMonitorTest, WhatIsBornBelowGroundMayComeUp) {
    TrackedBody& body = add(Vec3(20, 0, -1));
    run(1.0);
    EXPECT_TRUE(breaches().empty());
    body.latest.pose.position.z() = 0.1;
    run(step);
    body.latest.pose.position.z() = -0.1;
    run(step);
    EXPECT_EQ(breaches().size(), 1u) << "it had come up";
    monitor.reset();
    bodies.clear();
    world.scripted.clear();
    add(Vec3(20, 0, -1));
    run(1.0 + 2.0 * step);
    EXPECT_EQ(breaches().size(), 1u) << "it stayed there";
}

TEST_F(HealthMonitorTest, TheTerrainIsTheGroundWhereThereIsOne) {
    site.surface.terrain = std::make_shared<const TerrainGrid>(-100.0, -100.0, 100.0, 3, 3, std::vector<double>(9, -30.0));
    TrackedBody& body = add(Vec3(20, 0, -20));
    run(2.0);
    EXPECT_TRUE(breaches().empty());
    body.latest.pose.position.z() = -30.5;
    run(step);
    EXPECT_EQ(breaches().size(), 1u);
}

TEST_F(HealthMonitorTest, WithoutGroundNothingIsBelowIt) {
    site.surface.level = false;
    add(Vec3(20, 0, -50));
    run(2.0);
    EXPECT_TRUE(breaches().empty());
}

TEST_F(HealthMonitorTest, TenBuildingHeightsAwayIsOutside) {
    TrackedBody& body = add(Vec3(10 + 199, 5, 0.5));
    run(1.0);
    EXPECT_TRUE(breaches().empty());
    EXPECT_NEAR(monitor->report().farthest, 199.0, 1e-9);
    body.latest.pose.position.x() = 10 + 201;
    world.scripted[0].state = BodyState::Frozen;
    run(1.0);
    ASSERT_EQ(breaches().size(), 1u);
    EXPECT_EQ(breaches()[0].check, HealthCheck::OutsideSite);
    EXPECT_NEAR(breaches()[0].worst, 201.0, 1e-9);
    EXPECT_EQ(breaches()[0].limit, 200.0);
    EXPECT_EQ(breaches()[0].to, time) << "what rests out there is still out there";
    EXPECT_EQ(finding("simulation.outside_site"), 1);
}

TEST_F(HealthMonitorTest, DownASlopeOfTheTerrainBodiesMayGoFarther) {
    // 1 in 2 to the east: 201 m from the structure the ground is 100 m lower, and ten times as much is allowed.
    site.surface.terrain =
        std::make_shared<const TerrainGrid>(-1000.0, -1000.0, 2000.0, 2, 2, std::vector<double>{500.0, -500.0, 500.0, -500.0});
    TrackedBody& body = add(Vec3(10 + 201, 5, 0.5));
    run(step);
    EXPECT_TRUE(breaches().empty());
    // To the west it rises.
    body.latest.pose.position = Vec3(-10 - 201, 5, 200.0);
    run(step);
    ASSERT_EQ(breaches().size(), 1u);
    EXPECT_EQ(breaches()[0].check, HealthCheck::OutsideSite);
    EXPECT_EQ(breaches()[0].limit, 200.0);
}

TEST_F(HealthMonitorTest, APileThatWakesByItselfIsABreach) {
    for (int i = 0; i < 100; ++i) {
        add();
    }
    const auto freeze = [&](int count) {
        for (int i = 0; i < 100; ++i) {
            world.scripted[static_cast<std::size_t>(i)].state = i < count ? BodyState::Frozen : BodyState::Awake;
        }
        run(0.25);
    };
    freeze(94);
    freeze(50);
    EXPECT_TRUE(breaches().empty()) << "it had not reached 95 %";
    freeze(95);
    freeze(94);
    EXPECT_TRUE(breaches().empty()) << "one percent is within the limit";
    freeze(93);
    ASSERT_EQ(breaches().size(), 1u);
    EXPECT_EQ(breaches()[0].check, HealthCheck::AsleepShare);
    EXPECT_NEAR(breaches()[0].worst, 0.93, 1e-12);
    EXPECT_EQ(breaches()[0].bodies, 7);
    EXPECT_FALSE(breaches()[0].body);
    EXPECT_NEAR(monitor->report().asleepPeak, 0.95, 1e-12);
    EXPECT_EQ(finding("simulation.pile_woke"), 1);
}

TEST_F(HealthMonitorTest, WhatIsStirredMayWake) {
    for (int i = 0; i < 100; ++i) {
        add();
        world.scripted.back().state = BodyState::Frozen;
    }
    run(1.0);
    for (std::size_t i = 0; i < 50; ++i) {
        world.scripted[i].state = BodyState::Awake;
    }
    run(0.25, {0.0, 0.0, true});
    run(1.0);
    EXPECT_TRUE(breaches().empty()) << "a piece moved";
    for (std::size_t i = 0; i < 50; ++i) {
        world.scripted[i].state = BodyState::Frozen;
    }
    run(1.0);
    for (int i = 0; i < 100; ++i) {
        add();
    }
    run(1.0);
    EXPECT_TRUE(breaches().empty()) << "bodies entered";
}

TEST_F(HealthMonitorTest, WhatIsNoNumberIsCounted) {
    add();
    run(0.25);
    monitor->lost(idAt<BodyId>(0), Vec3(1, 2, 3), time);
    world.scripted[0].state = BodyState::Removed;
    run(0.25);
    ASSERT_EQ(breaches().size(), 1u);
    EXPECT_EQ(breaches()[0].check, HealthCheck::NotANumber);
    EXPECT_TRUE(std::isnan(breaches()[0].worst));
    EXPECT_EQ(breaches()[0].place, Vec3(1, 2, 3));
    EXPECT_EQ(monitor->report().bodiesLost, 1);
    EXPECT_EQ(finding("simulation.not_a_number"), 1);
}

TEST_F(HealthMonitorTest, APileMustHaveTheVolumeOfRubble) {
    const auto at = [&](double bulking, double layers) {
        HealthMonitor fresh(site);
        fresh.pile(bulking, layers, 12.0);
        return fresh.report().breaches;
    };
    EXPECT_TRUE(at(1.15, 5.0).empty());
    EXPECT_TRUE(at(2.0, 5.0).empty());
    EXPECT_TRUE(at(std::nan(""), 5.0).empty());
    EXPECT_TRUE(at(1.0, 1.9).empty()) << "single blocks on the ground are no pile";
    ASSERT_EQ(at(1.14, 2.0).size(), 1u);
    EXPECT_EQ(at(1.14, 2.0)[0].limit, 1.15);
    ASSERT_EQ(at(2.01, 2.0).size(), 1u);
    EXPECT_EQ(at(2.01, 2.0)[0].limit, 2.0);
    EXPECT_NE(at(2.01, 2.0)[0].remedy.id, at(1.14, 2.0)[0].remedy.id);
    EXPECT_EQ(at(2.01, 2.0)[0].from, 12.0);
}

TEST_F(HealthMonitorTest, AFlickeringCheckIsOneBreach) {
    TrackedBody& body = add();
    for (int i = 0; i < 40; ++i) {
        body.latest.pose.position.z() = i % 8 == 0 ? -0.01 * (1 + i) : 0.5;
        run(step);
    }
    ASSERT_EQ(breaches().size(), 1u);
    EXPECT_EQ(breaches()[0].from, step);
    EXPECT_EQ(breaches()[0].to, 33 * step);
    EXPECT_NEAR(breaches()[0].worst, 0.33, 1e-12);
    body.latest.pose.position.z() = 0.5;
    run(1.0);
    body.latest.pose.position.z() = -0.1;
    run(step);
    EXPECT_EQ(breaches().size(), 2u) << "half a second of health is the end of a breach";
}

TEST_F(HealthMonitorTest, BreachesComeInTheOrderInWhichTheyBegan) {
    TrackedBody& body = add();
    run(step, {0.0, 0.5});
    body.latest.pose.position = Vec3(500, 0, -1);
    run(step);
    ASSERT_EQ(breaches().size(), 3u);
    EXPECT_EQ(breaches()[0].check, HealthCheck::Energy);
    EXPECT_EQ(breaches()[1].check, HealthCheck::BelowGround);
    EXPECT_EQ(breaches()[2].check, HealthCheck::OutsideSite);
}

TEST_F(HealthMonitorTest, RemediesMergeIntoIntervals) {
    monitor = std::make_unique<HealthMonitor>(site);
    monitor->remedied(1.0, 1.25);
    monitor->remedied(1.25, 1.5);
    monitor->remedied(3.0, 3.25);
    const HealthReport report = monitor->report();
    ASSERT_EQ(report.remedies.size(), 2u);
    EXPECT_EQ(report.remedies[0].to, 1.5);
    EXPECT_EQ(report.remedies[0].steps, 2);
    EXPECT_EQ(finding("simulation.auto_remedy"), 3);
    EXPECT_FALSE(report.tainted());
}

TEST(HealthChecks, HaveNamesAndTitles) {
    for (std::size_t i = 0; i < healthCheckCount; ++i) {
        const auto check = static_cast<HealthCheck>(i);
        EXPECT_FALSE(healthCheckName(check).empty());
        EXPECT_FALSE(healthCheckTitle(check).empty());
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_NE(healthCheckName(check), healthCheckName(static_cast<HealthCheck>(j)));
        }
    }
}

}  // namespace
}  // namespace rubble
