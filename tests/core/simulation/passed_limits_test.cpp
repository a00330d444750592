#include "core/simulation/health/passed_limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/simulation/health/breach_log.h"

namespace rubble {
namespace {

HealthBreach breachOf(HealthCheck check, double worst, double limit, double from = 1.0, double to = 2.0) {
    HealthBreach breach;
    breach.check = check;
    breach.worst = worst;
    breach.limit = limit;
    breach.from = from;
    breach.to = to;
    return breach;
}

TEST(HealthGrade, SaysHowFarEachLimitWasPassed) {
    using enum HealthGrade;
    struct Row {
        HealthBreach breach;
        HealthGrade grade;
    };
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (const Row& row : std::vector<Row>{{breachOf(HealthCheck::Energy, 0.002, 0.001), Finding},
                                           {breachOf(HealthCheck::Energy, 0.01, 0.001), Finding},
                                           {breachOf(HealthCheck::Energy, 0.0101, 0.001), Tainted},
                                           {breachOf(HealthCheck::Energy, none, 0.001), Tainted},
                                           {breachOf(HealthCheck::Penetration, 0.3, 0.1), Notice},
                                           {breachOf(HealthCheck::Penetration, 4.742, 0.1), Finding},
                                           {breachOf(HealthCheck::Penetration, 0.02, 0.01), Finding},
                                           {breachOf(HealthCheck::Penetration, 0.021, 0.01), Tainted},
                                           {breachOf(HealthCheck::Speed, 1.2, 1.05), Finding},
                                           {breachOf(HealthCheck::Speed, 1.6, 1.05), Tainted},
                                           {breachOf(HealthCheck::BelowGround, 0.2, 0.0), Finding},
                                           {breachOf(HealthCheck::BelowGround, 2.0, 0.0), Tainted},
                                           {breachOf(HealthCheck::OutsideSite, 250.0, 240.0), Tainted},
                                           {breachOf(HealthCheck::NotANumber, none, 0.0), Tainted},
                                           {breachOf(HealthCheck::AsleepShare, 0.9, 0.95), Notice},
                                           {breachOf(HealthCheck::AsleepShare, 0.5, 0.95), Finding},
                                           {breachOf(HealthCheck::Bulking, 1.1, 1.15), Finding},
                                           {breachOf(HealthCheck::Bulking, 0.9, 1.15), Tainted},
                                           {breachOf(HealthCheck::Bulking, 2.5, 2.0), Finding},
                                           {breachOf(HealthCheck::Bulking, 3.5, 2.0), Tainted}}) {
        EXPECT_EQ(gradeOf(row.breach), row.grade) << healthCheckName(row.breach.check) << ' ' << row.breach.worst;
        EXPECT_FALSE(gradeReason(row.breach).empty()) << healthCheckName(row.breach.check) << ' ' << row.breach.worst;
    }
}

TEST(HealthGrade, OnlyWhatIsTaintedTaintsTheRun) {
    HealthReport report;
    EXPECT_FALSE(report.tainted());
    report.breaches.push_back(breachOf(HealthCheck::AsleepShare, 0.9, 0.95));
    report.breaches.push_back(breachOf(HealthCheck::Energy, 0.002, 0.001));
    EXPECT_EQ(gravestGrade(report.breaches), HealthGrade::Finding);
    EXPECT_FALSE(report.tainted());
    report.breaches.push_back(breachOf(HealthCheck::OutsideSite, 300.0, 200.0));
    EXPECT_TRUE(report.tainted());
}

TEST(PassedLimits, ALimitThatWasPassedTwiceIsOneWithBothTimes) {
    const std::vector<HealthBreach> breaches{
        breachOf(HealthCheck::Penetration, 0.2, 0.1, 1.0, 1.5), breachOf(HealthCheck::Energy, 0.003, 0.001, 1.2, 1.4),
        breachOf(HealthCheck::Penetration, 0.02, 0.01, 2.0, 2.5), breachOf(HealthCheck::Penetration, 4.7, 0.1, 3.0, 4.0),
        breachOf(HealthCheck::Penetration, 0.3, 0.1, 6.0, 6.25)};
    const std::vector<PassedLimit> limits = passedLimits(breaches);
    ASSERT_EQ(limits.size(), 3U);
    EXPECT_EQ(limits[0].breaches, (std::vector<std::size_t>{0, 3, 4}));
    EXPECT_EQ(limits[0].worst, 3U);
    EXPECT_EQ(limits[0].grade, HealthGrade::Finding) << "of its worst";
    EXPECT_DOUBLE_EQ(heldFor(limits[0], breaches), 1.75);
    EXPECT_EQ(limits[2].breaches, std::vector<std::size_t>{2}) << "many bodies, each a little, is another limit";
}

TEST(PassedLimits, TheLeastShareAtRestIsTheWorst) {
    const std::vector<HealthBreach> breaches{breachOf(HealthCheck::AsleepShare, 0.7, 0.95, 1.0, 1.5),
                                             breachOf(HealthCheck::AsleepShare, 0.6, 0.95, 3.0, 3.5),
                                             breachOf(HealthCheck::AsleepShare, 0.9, 0.95, 5.0, 5.5)};
    ASSERT_EQ(passedLimits(breaches).size(), 1U);
    EXPECT_EQ(passedLimits(breaches)[0].worst, 1U);
}

TEST(HealthMeasure, SaysAShareAboveOneInTimes) {
    EXPECT_EQ(englishText(healthMeasure(HealthCheck::Penetration, 0.474)), "47.4 %");
    EXPECT_EQ(englishText(healthMeasure(HealthCheck::Penetration, 4.742)), "4.742×");
    EXPECT_EQ(englishText(healthMeasure(HealthCheck::BelowGround, 0.25)), "0.25 m");
    EXPECT_EQ(englishText(healthMeasure(HealthCheck::NotANumber, 0.0)), "no number");
}

TEST(ThinPile, SaysWhyAFactorOutsideItsLimitsIsNoBreach) {
    for (const double bulking : {0.741, 2.68}) {
        const auto why = thinPile(bulking, {});
        ASSERT_TRUE(why.has_value());
        EXPECT_EQ(englishText(*why),
                  "outside the 1.15 to 2 of a pile, yet no pile to judge: the debris lies less than 2 fragments deep");
        const std::vector<HealthBreach> breaches{breachOf(HealthCheck::Bulking, bulking, bulking < 1.0 ? 1.15 : 2.0, 9.0, 9.0)};
        EXPECT_FALSE(thinPile(bulking, breaches).has_value()) << "it is told as a breach";
    }
    EXPECT_FALSE(thinPile(1.4, {}).has_value());
    EXPECT_FALSE(thinPile(std::nan(""), {}).has_value());
}

std::string told(std::int64_t bodies, double measured, double limit) {
    HealthObservation seen;
    seen.check = HealthCheck::Penetration;
    seen.measured = seen.severity = measured;
    seen.limit = limit;
    seen.depth = 1.2;
    seen.body = idAt<BodyId>(7);
    seen.bodies = bodies;
    BreachLog log(0.5);
    log.hold(seen, 1.0, 1.0);
    return englishText(log.breaches()[0].what);
}

TEST(BreachWords, CountOneBodyAsOne) {
    EXPECT_EQ(told(1, 0.31, 0.1),
              "body 7 lay 1.2 m deep in another for over 0.5 s, 31 % of its smallest side; the limit is 10 % (1 body)");
    EXPECT_EQ(
        told(17, 4.742, 0.1),
        "body 7 lay 1.2 m deep in another for over 0.5 s, 4.742 times its smallest side: it has gone through; the limit is 10 % "
        "of that side (17 bodies)");
    EXPECT_EQ(told(1, 0.02, 0.01),
              "1 body at once lay more than 5 % of a smallest side inside another for over 0.5 s, 2 % of all; body 7 worst");
}

}  // namespace
}  // namespace rubble
