#include "core/evidence/clouds/cloud_volumes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/sequence.h"

namespace rubble {

namespace {

constexpr double gridCell = 0.5;
constexpr double half = 6.0;

template <class Height>
PointIndex surface(std::uint64_t seed, const Height& height) {
    Sequence numbers(seed);
    std::vector<Vec3> places;
    for (int k = 0; k < 60'000; ++k) {
        const double x = numbers.between(-half, half);
        const double y = numbers.between(-half, half);
        places.emplace_back(x, y, height(x, y));
    }
    return PointIndex(std::move(places), 0.5);
}

/// Volumes from level ground to a surface.
template <class Height>
CloudVolumes above(const Height& height, double registration, std::uint64_t seed = 2) {
    const PointIndex ground = surface(1, [](double, double) { return 0.0; });
    const PointIndex other = surface(seed, height);
    std::vector<Vec3> middles;
    for (double x = -half + 0.5 * gridCell; x < half; x += gridCell) {
        for (double y = -half + 0.5 * gridCell; y < half; y += gridCell) {
            middles.emplace_back(x, y, 0.0);
        }
    }
    const CloudDistanceSettings upwards{gridCell, gridCell / std::sqrt(std::numbers::pi), 5.0, registration, true};
    return cloudVolumes(cloudDistances(middles, ground, other, upwards, Execution()), gridCell, registration);
}

TEST(CloudVolumes, AreThoseOfShapesSolvedOnPaper) {
    const double area = 4.0 * half * half;
    const CloudVolumes raised = above([](double, double) { return 0.7; }, 0.0);
    EXPECT_NEAR(raised.fill, 0.7 * area, 1e-6);
    EXPECT_EQ(raised.measured, 576);
    EXPECT_NEAR(raised.fillError.random, 0.0, 1e-9);
    // A plane that tilts about the middle cuts as much as it fills: each half is a wedge of slope h^2/2 times its width.
    const CloudVolumes tilted = above([](double x, double) { return 0.1 * x; }, 0.0);
    const double wedge = 0.5 * 0.1 * half * half * 2.0 * half;
    EXPECT_NEAR(tilted.fill, wedge, 0.03 * wedge);
    EXPECT_NEAR(tilted.cut, wedge, 0.03 * wedge);
    EXPECT_LT(std::abs(tilted.net()), tilted.netError.random);
    // A cone of height 2 and radius 4.
    const auto cone = [](double x, double y) { return std::max(0.0, 2.0 - 0.5 * std::hypot(x, y)); };
    const double whole = std::numbers::pi * 16.0 * 2.0 / 3.0;
    const CloudVolumes heap = above(cone, 0.0);
    EXPECT_NEAR(heap.fill, whole, 2.0 * heap.fillError.random + 0.01 * whole);
    // Below a level of 0.5 m a ring of it is not counted: what lies within radius 3 is pi (2 r^2 / 2 - r^3 / 6) 2.
    const CloudVolumes poor = above(cone, 0.5 / 1.96);
    const double within = 2.0 * std::numbers::pi * (9.0 - 27.0 / 6.0);
    EXPECT_NEAR(poor.fill, within, 0.06 * within);
    EXPECT_NEAR(poor.fill + poor.undetected(), heap.fill, 0.02 * whole);
    EXPECT_NEAR(poor.fillError.systematic, 0.5 * gridCell * gridCell * static_cast<double>(poor.fillCells), 1e-9);
}

TEST(CloudVolumes, WhereNothingWasMeasuredTheyAreNotKnown) {
    const PointIndex ground = surface(1, [](double, double) { return 0.0; });
    const PointIndex high = surface(2, [](double, double) { return 50.0; });
    const CloudDistanceSettings upwards{gridCell, gridCell / std::sqrt(std::numbers::pi), 5.0, 0.01, true};
    const CloudVolumes made =
        cloudVolumes(cloudDistances({Vec3::Zero(), Vec3(1, 1, 0)}, ground, high, upwards, Execution()), gridCell, 0.01);
    EXPECT_EQ(made.cells, 2);
    EXPECT_EQ(made.measured, 0);
    for (const double volume :
         {made.fill, made.cut, made.net(), made.undetected(), made.fillError.random, made.netError.systematic}) {
        EXPECT_TRUE(std::isnan(volume));
    }
    // No surface moved: that is known.
    const CloudVolumes even = cloudVolumes(cloudDistances({Vec3::Zero()}, ground, ground, upwards, Execution()), gridCell, 0.01);
    EXPECT_EQ(even.measured, 1);
    EXPECT_EQ(even.fill, 0.0);
}

TEST(CloudVolumes, ASurfaceHasNoneAgainstItself) {
    Sequence numbers(9);
    std::size_t outside = 0;
    constexpr int trials = 20;
    for (std::uint64_t seed = 2; seed < 2 + trials; ++seed) {
        const CloudVolumes made = above([&](double, double) { return numbers.between(-0.05, 0.05); }, 0.0, seed);
        // One cell in twenty is significant by chance, above as often as below.
        EXPECT_LT(made.fillCells + made.cutCells, 60);
        EXPECT_GT(made.fillCells + made.cutCells, 6);
        outside += std::abs(made.net()) > 3.0 * made.netError.random ? 1 : 0;
    }
    EXPECT_LE(outside, 2u);
}

}  // namespace

}  // namespace rubble
