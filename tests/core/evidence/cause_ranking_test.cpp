#include "core/evidence/ensembles/cause_ranking.h"
#include <gtest/gtest.h>

#include "core/base/unknown.h"

#include <cmath>
#include <random>

#include "core/base/error.h"

namespace rubble {
namespace {

constexpr double z95 = 1.959963984540054;

class Numbers {
public:
    explicit Numbers(unsigned seed) : m_random(seed) {}
    double normal(double mean) {
        double sum = -6.0;
        for (int k = 0; k < 12; ++k) {
            sum += static_cast<double>(m_random()) / 4294967296.0;
        }
        return mean + sum;
    }
    std::vector<double> list(int count, double mean) {
        std::vector<double> values;
        for (int k = 0; k < count; ++k) {
            values.push_back(normal(mean));
        }
        return values;
    }

private:
    std::mt19937 m_random;
};

TEST(CauseRanking, SuperiorityCountsPairs) {
    const std::vector<double> a{1.0, 2.0, 3.0};
    const std::vector<double> b{2.0, 4.0};
    // 1 < 2, 1 < 4, 2 = 2, 2 < 4, 3 > 2, 3 < 4.
    EXPECT_NEAR(superiorityOf(a, b, z95).share, 4.5 / 6.0, 1e-12);
    EXPECT_NEAR(superiorityOf(b, a, z95).share, 1.5 / 6.0, 1e-12);
    const std::vector<double> gap{1.0, unknown, 2.0, 3.0};
    EXPECT_EQ(superiorityOf(gap, b, z95).share, superiorityOf(a, b, z95).share);
    EXPECT_EQ(superiorityOf({}, b, z95).low, 0.0);
}

TEST(CauseRanking, IntervalOfFewMembersIsWide) {
    const std::vector<double> a{1.0, 2.0, 3.0, 4.0};
    const std::vector<double> b{5.0, 6.0, 7.0, 8.0};
    const Superiority superiority = superiorityOf(a, b, z95);
    EXPECT_EQ(superiority.share, 1.0);
    EXPECT_EQ(superiority.high, 1.0);
    // (1 - t)^2 = z^2 t (1 - t) (1 + 3 ((1 - t) / (2 - t) + t / (1 + t))) / 16 holds at the end.
    const double t = superiority.low;
    EXPECT_NEAR(1.0 - t, z95 * std::sqrt(t * (1.0 - t) * (1.0 + 3.0 * ((1.0 - t) / (2.0 - t) + t / (1.0 + t))) / 16.0), 1e-6);
    EXPECT_LT(t, 0.7) << "four members a side prove little";
}

TEST(CauseRanking, IntervalsHoldTheTruthAsOftenAsTheySay) {
    // Normal numbers one deviation apart: the share is Phi(1 / sqrt 2).
    const double truth = 0.5 * std::erfc(-0.5);
    Numbers numbers(7);
    int held = 0;
    constexpr int trials = 1500;
    for (int k = 0; k < trials; ++k) {
        const Superiority superiority = superiorityOf(numbers.list(12, 0.0), numbers.list(12, 1.0), z95);
        held += superiority.low <= truth && truth <= superiority.high ? 1 : 0;
    }
    EXPECT_GE(held, 0.93 * trials);
    EXPECT_LE(held, 0.99 * trials);
}

TEST(CauseRanking, TheClosestComesFirstAndIsToldApartOnlyIfSurely) {
    Numbers numbers(3);
    const std::vector<Departures> far{{numbers.list(16, 8.0)}, {numbers.list(16, 0.0)}, {numbers.list(16, 4.0)}};
    const CauseRanking ranking = rankCauses(far);
    ASSERT_EQ(ranking.causes.size(), 3u);
    EXPECT_EQ(ranking.causes[0].hypothesis, 1u);
    EXPECT_EQ(ranking.causes[1].hypothesis, 2u);
    EXPECT_TRUE(ranking.decided());
    EXPECT_FALSE(ranking.causes[0].apart);
    EXPECT_GT(ranking.causes[1].bestOver.low, tellingShare);

    const std::vector<Departures> alike{{numbers.list(16, 0.3)}, {numbers.list(16, 0.0)}, {numbers.list(16, 9.0)}};
    const CauseRanking open = rankCauses(alike);
    EXPECT_FALSE(open.decided());
    EXPECT_FALSE(open.causes[1].apart);
    EXPECT_TRUE(open.causes[2].apart);
}

TEST(CauseRanking, EqualCausesAreHardlyEverToldApart) {
    Numbers numbers(11);
    int told = 0;
    for (int trial = 0; trial < 300; ++trial) {
        const std::vector<Departures> causes{{numbers.list(12, 0.0)}, {numbers.list(12, 0.0)}, {numbers.list(12, 0.0)}};
        told += rankCauses(causes).decided() ? 1 : 0;
    }
    EXPECT_LE(told, 3);
}

TEST(CauseRanking, EvidenceThatScattersWeighsLittle) {
    Numbers numbers(5);
    std::vector<Departures> causes(2);
    for (std::size_t h = 0; h < 2; ++h) {
        std::vector<double> sharp = numbers.list(20, h == 0 ? 0.0 : 4.0);
        std::vector<double> blunt = numbers.list(20, h == 0 ? 1.0 : 0.0);
        for (double& value : sharp) {
            value *= 0.01;
        }
        causes[h] = {sharp, blunt};
    }
    const CauseRanking ranking = rankCauses(causes);
    EXPECT_EQ(ranking.causes[0].hypothesis, 0u) << "4 deviations of one outweigh 1 of the other, whatever their size";
    EXPECT_GT(ranking.causes[1].bestOverEvidence[0].share, 0.9);
    EXPECT_LT(ranking.causes[1].bestOverEvidence[1].share, 0.5);
}

TEST(CauseRanking, WhatIsNotKnownIsPassedOver) {
    const std::vector<Departures> causes{{{0.1, unknown, 0.2}, {unknown, unknown, 0.3}}, {{0.5, 0.6, 0.7}, {unknown, 0.8, 0.9}}};
    const CauseRanking ranking = rankCauses(causes);
    EXPECT_EQ(ranking.causes[0].score.count, 2u);
    EXPECT_EQ(ranking.causes[1].score.count, 3u);
    const std::vector<Departures> nothing{{{unknown, unknown}}};
    EXPECT_THROW(rankCauses(nothing), UsageError);
    EXPECT_THROW(rankCauses({}), UsageError);
}

}  // namespace
}  // namespace rubble
