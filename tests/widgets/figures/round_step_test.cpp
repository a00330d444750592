#include "widgets/figures/round_step.h"

#include <gtest/gtest.h>

#include <QString>
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

TEST(DigitsOfMark, TellAMarkFromTheNextOne) {
    EXPECT_EQ(digitsOfMark(20990.2, 0.2), 6);
    EXPECT_EQ(digitsOfMark(20991.0, 0.2), 6);
    EXPECT_EQ(digitsOfMark(12.0, 2.0), 2);
    EXPECT_EQ(digitsOfMark(-300.0, 100.0), 1);
    EXPECT_EQ(digitsOfMark(1000.0, 0.001), 7);
    EXPECT_EQ(digitsOfMark(0.0, 0.5), 1);
    EXPECT_EQ(digitsOfMark(5.0, 0.0), 1) << "no scale";
    for (double step : {0.001, 0.2, 5.0, 100.0}) {
        for (int k = 990; k < 1010; ++k) {
            EXPECT_NE(QString::number(k * step, 'g', digitsOfMark(k * step, step)),
                      QString::number((k + 1) * step, 'g', digitsOfMark((k + 1) * step, step)))
                << k << " x " << step;
        }
    }
}

}  // namespace rubble::figures
