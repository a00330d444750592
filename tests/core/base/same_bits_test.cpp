#include "core/base/same_bits.h"
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/sequence.h"

namespace rubble {
namespace {

/// Units in the last place between two numbers of one sign and about one size.
double apart(double a, double b) {
    return a == b ? 0.0 : std::abs(a - b) / (std::nextafter(std::abs(b), std::numeric_limits<double>::infinity()) - std::abs(b));
}

TEST(SameBits, AreWithinALastPlaceOfTheStandardLibrary) {
    Sequence random(5);
    for (int i = 0; i < 20000; ++i) {
        const double x = random.between(-50.0, 50.0), y = random.between(-3.0, 3.0), c = random.between(-1.0, 1.0);
        EXPECT_LE(apart(sineOf(x), std::sin(x)), 1.0) << x;
        EXPECT_LE(apart(cosineOf(x), std::cos(x)), 1.0) << x;
        EXPECT_LE(apart(arcCosineOf(c), std::acos(c)), 1.0) << c;
        // The library's own in double precision is up to four off.
        EXPECT_LE(apart(cubeRootOf(x), static_cast<double>(std::cbrt(static_cast<long double>(x)))), 1.0) << x;
        EXPECT_LE(apart(lengthOf(x, y), std::hypot(x, y)), 1.0) << x << ' ' << y;
        EXPECT_LE(apart(powerOfTen(y), std::pow(10.0, y)), 1.0) << y;
    }
}

TEST(SameBits, HoldAtTheEnds) {
    EXPECT_EQ(sineOf(0.0), 0.0);
    EXPECT_EQ(cosineOf(0.0), 1.0);
    EXPECT_EQ(arcCosineOf(1.0), 0.0);
    EXPECT_EQ(arcCosineOf(-1.5), std::numbers::pi);
    EXPECT_EQ(arcCosineOf(0.0), std::numbers::pi / 2.0);
    EXPECT_EQ(cubeRootOf(0.0), 0.0);
    EXPECT_EQ(cubeRootOf(-27.0), -3.0);
    EXPECT_EQ(cubeRootOf(0x1p-60), 0x1p-20);
    EXPECT_TRUE(std::isinf(cubeRootOf(std::numeric_limits<double>::infinity())));
    EXPECT_EQ(lengthOf(3.0, 4.0), 5.0);
    EXPECT_EQ(lengthOf(0.0, 0.0), 0.0);
    EXPECT_EQ(powerOfTen(-2.0), 0.01);
    {
        const double bad = std::numeric_limits<double>::quiet_NaN();
        EXPECT_TRUE(std::isnan(sineOf(bad)));
        EXPECT_TRUE(std::isnan(arcCosineOf(bad)));
        EXPECT_TRUE(std::isnan(cubeRootOf(bad)));
        EXPECT_TRUE(std::isnan(lengthOf(bad, 1.0)));
    }
}

TEST(SameBits, TurnsAreThoseOfEigen) {
    Sequence random(6);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 axis = random.direction();
        const double angle = random.between(-4.0, 4.0), share = random.between(0.0, 1.0);
        const Quat a = random.turn(), b = random.turn();
        EXPECT_TRUE(turnAbout(axis, angle).coeffs().isApprox(Quat(Eigen::AngleAxisd(angle, axis)).coeffs(), 1e-14));
        EXPECT_TRUE(axesTurned(axis, angle).isApprox(Eigen::AngleAxisd(angle, axis).toRotationMatrix(), 1e-14));
        EXPECT_TRUE(turnBetween(a, share, b).coeffs().isApprox(a.slerp(share, b).coeffs(), 1e-12));
    }
    EXPECT_EQ(turnBetween(Quat::Identity(), 0.25, Quat::Identity()).coeffs(), Quat::Identity().coeffs());
}

}  // namespace
}  // namespace rubble
