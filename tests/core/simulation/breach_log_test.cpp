#include "core/simulation/health/breach_log.h"

#include <gtest/gtest.h>

namespace rubble {
namespace {

HealthObservation gain(double measured) {
    HealthObservation seen;
    seen.check = HealthCheck::Energy;
    seen.measured = seen.severity = measured;
    seen.limit = 0.001;
    return seen;
}

TEST(BreachLog, KnowsWhenABreachWasWorst) {
    BreachLog log(0.5);
    log.hold(gain(0.002), 1.0, 1.0);
    log.hold(gain(0.005), 1.1, 1.1);
    log.hold(gain(0.003), 1.2, 1.2);
    ASSERT_EQ(log.breaches().size(), 1u);
    EXPECT_EQ(log.breaches()[0].from, 1.0);
    EXPECT_EQ(log.breaches()[0].worstAt, 1.1);
    EXPECT_EQ(log.breaches()[0].to, 1.2);
}

TEST(BreachLog, TellsOfABreachAtOnceAndOfItsGrowthOnceASecond) {
    BreachLog log(0.5);
    EXPECT_TRUE(log.news(0.0).empty());
    std::vector<double> told;
    for (int step = 0; step <= 25; ++step) {
        const double time = 1.0 + 0.1 * step;
        log.hold(gain(0.002 + 0.001 * step), time, time);
        for (const HealthBreach& breach : log.news(time)) {
            EXPECT_EQ(breach.from, 1.0) << "a breach is known by its beginning";
            EXPECT_EQ(breach.to, time);
            EXPECT_EQ(breach.worstAt, time);
            told.push_back(time);
        }
    }
    ASSERT_EQ(told.size(), 3u);
    EXPECT_EQ(told[0], 1.0);
    EXPECT_NEAR(told[1], 2.0, 0.11);
    EXPECT_NEAR(told[2], 3.0, 0.21);
    // What has changed since is told even when the breach is over; what has not, never again.
    ASSERT_EQ(log.news(5.0).size(), 1u);
    EXPECT_TRUE(log.news(9.0).empty());
    log.hold(gain(0.002), 10.0, 10.0);
    ASSERT_EQ(log.breaches().size(), 2u);
    const std::vector<HealthBreach> second = log.news(10.0);
    ASSERT_EQ(second.size(), 1u);
    EXPECT_EQ(second[0].from, 10.0);
}

// "Set auto_remedy = true" stood beside runs that had it on already.
TEST(HealthRemedy, AdvisesNothingThatWasSetAlready) {
    for (const HealthCheck check : {HealthCheck::Energy, HealthCheck::Penetration, HealthCheck::Bulking}) {
        for (const bool halved : {false, true}) {
            for (const bool softStep : {false, true}) {
                const std::string text = englishText(healthRemedy(check, 1.0, 1.15, {halved, softStep}));
                EXPECT_EQ(text.find("auto_remedy = true") != std::string::npos, !halved && check != HealthCheck::Bulking) << text;
                EXPECT_EQ(text.find("solver = soft-step") != std::string::npos, !softStep) << text;
                EXPECT_NE(text.find("step_rate"), std::string::npos) << text;
            }
        }
    }
    BreachLog log(0.5, {true, true});
    log.hold(gain(0.002), 1.0, 1.0);
    EXPECT_EQ(englishText(log.breaches().at(0).remedy), "raise step_rate: auto_remedy is on and was not enough");
}

}  // namespace
}  // namespace rubble
