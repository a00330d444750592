#include "widgets/figures/round_step.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rubble::figures {

TEST(RoundStep, IsRoundAndNotTooFine) {
    for (double span = 0.013; span < 5000.0; span *= 1.37) {
        for (const double count : {3.0, 8.0, 20.0}) {
            const double step = roundStep(span, count);
            EXPECT_LE(span / step, count * (1.0 + 1e-9));
            EXPECT_GE(span / step, count / 2.5001);
            const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
            EXPECT_TRUE(std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 || std::abs(mantissa - 5) < 1e-6) << step;
        }
    }
}

TEST(RoundStep, IsOneWhereThereIsNothingToDivide) {
    EXPECT_EQ(roundStep(0.0, 5.0), 1.0);
    EXPECT_EQ(roundStep(5.0, 0.0), 1.0);
}

}  // namespace rubble::figures
