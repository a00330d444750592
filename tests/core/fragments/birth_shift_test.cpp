#include "core/fragments/birth_shift.h"

#include <gtest/gtest.h>

namespace rubble {
namespace {

TEST(BirthShift, HasItsLengthAndNoPreferredDirection) {
    Vec3 mean = Vec3::Zero();
    Mat3 spread = Mat3::Zero();
    constexpr int count = 20000;
    for (int e = 0; e < count; ++e) {
        const Vec3 shift = birthShift(1e-6, 1, e);
        EXPECT_NEAR(shift.norm(), 1e-6, 1e-20);
        mean += shift / 1e-6 / count;
        spread += shift * shift.transpose() / 1e-12 / count;
    }
    // Standard errors: 0.004 of each mean coordinate, 0.002 of each second moment; five of them.
    EXPECT_LT(mean.cwiseAbs().maxCoeff(), 0.02);
    EXPECT_LT((spread - Mat3::Identity() / 3.0).cwiseAbs().maxCoeff(), 0.01);
}

TEST(BirthShift, DependsOnSeedAndElementAlone) {
    EXPECT_EQ(birthShift(1.0, 1, 17), birthShift(1.0, 1, 17));
    EXPECT_NE(birthShift(1.0, 1, 17), birthShift(1.0, 2, 17));
    EXPECT_NE(birthShift(1.0, 1, 17), birthShift(1.0, 1, 18));
    EXPECT_EQ(birthShift(2.0, 5, -3), 2.0 * birthShift(1.0, 5, -3));
    EXPECT_TRUE(birthShift(0.0, 1, 17).isZero());
}

}  // namespace
}  // namespace rubble
