#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <random>

#include "core/evidence/clouds/cloud_distance.h"

namespace rubble {

namespace {

/// Numbers of a normal distribution that are the same on every machine.
class NormalNumbers {
public:
    explicit NormalNumbers(std::uint32_t seed) : m_engine(seed) {}
    double uniform() { return (m_engine() + 0.5) / 4294967296.0; }
    double next() { return std::sqrt(-2.0 * std::log(uniform())) * std::cos(2.0 * std::numbers::pi * uniform()); }

private:
    std::mt19937 m_engine;
};

/// Points of a surface at random places of a square about zero.
template <class Height>
std::vector<Vec3> scan(std::size_t count, double half, std::uint32_t seed, double noise, const Height& height) {
    NormalNumbers numbers(seed);
    std::vector<Vec3> places;
    for (std::size_t k = 0; k < count; ++k) {
        const double x = half * (2.0 * numbers.uniform() - 1.0);
        const double y = half * (2.0 * numbers.uniform() - 1.0);
        places.emplace_back(x, y, height(x, y) + noise * numbers.next());
    }
    return places;
}

std::vector<Vec3> coresOf(const std::vector<Vec3>& places, std::size_t count, double half) {
    std::vector<Vec3> cores;
    for (const Vec3& place : places) {
        if (cores.size() < count && place.head<2>().cwiseAbs().maxCoeff() < half) {
            cores.push_back(place);
        }
    }
    return cores;
}

const CloudDistanceSettings scales{0.5, 0.5, 2.0, std::nullopt};

TEST(CloudDistance, PlanesAreAsFarApartAsTheyWerePut) {
    for (const double slope : {0.0, 0.5, 2.0}) {
        const std::vector<Vec3> low = scan(20'000, 5.0, 1, 0.0, [&](double x, double) { return slope * x; });
        const std::vector<Vec3> high = scan(20'000, 5.0, 2, 0.0, [&](double x, double) { return slope * x + 0.7; });
        const std::vector<Vec3> cores = coresOf(low, 200, 2.0);
        const PointIndex first(low, scales.projectionRadius);
        const PointIndex second(high, scales.projectionRadius);
        for (const CoreDistance& core : cloudDistances(cores, first, second, scales, Execution())) {
            ASSERT_EQ(core.state, CoreState::Measured);
            // The distance of parallel planes is that along z times the cosine of their slope.
            EXPECT_NEAR(core.distance, 0.7 / std::hypot(1.0, slope), 1e-9);
            EXPECT_NEAR(core.normal.z(), 1.0 / std::hypot(1.0, slope), 1e-9);
            EXPECT_NEAR(core.detection, 0.0, 1e-9);
            EXPECT_TRUE(core.significant());
        }
        for (const CoreDistance& core : cloudDistances(cores, second, first, scales, Execution())) {
            if (core.state == CoreState::Measured) {
                EXPECT_NEAR(core.distance, -0.7 / std::hypot(1.0, slope), 1e-9);
            }
        }
    }
}

TEST(CloudDistance, ACloudAgainstItselfIsNowhereAway) {
    const std::vector<Vec3> cloud = scan(5'000, 3.0, 3, 0.05, [](double x, double y) { return 0.3 * std::sin(x) * y; });
    const PointIndex index(cloud, scales.projectionRadius);
    for (const CoreDistance& core : cloudDistances(coresOf(cloud, 300, 3.0), index, index, scales, Execution())) {
        ASSERT_EQ(core.state, CoreState::Measured);
        EXPECT_EQ(core.distance, 0.0);
        EXPECT_FALSE(core.significant());
    }
}

TEST(CloudDistance, WithNoiseAloneFiveOfAHundredAreSignificant) {
    const auto level = [](double, double) { return 0.0; };
    const std::vector<Vec3> one = scan(40'000, 10.0, 4, 0.03, level);
    const std::vector<Vec3> other = scan(40'000, 10.0, 5, 0.03, level);
    // Cylinders that share no point, so that cores are independent.
    std::vector<Vec3> cores;
    for (int i = -8; i <= 8; ++i) {
        for (int j = -8; j <= 8; ++j) {
            cores.emplace_back(1.1 * i, 1.1 * j, 0.0);
        }
    }
    const PointIndex first(one, scales.projectionRadius);
    const PointIndex second(other, scales.projectionRadius);
    const std::vector<CoreDistance> made = cloudDistances(cores, first, second, scales, Execution());
    const auto significant = std::count_if(made.begin(), made.end(), [](const CoreDistance& core) { return core.significant(); });
    // 289 cores: 14.5 are expected, and 3.7 is the deviation.
    EXPECT_GE(significant, 4);
    EXPECT_LE(significant, 26);
    CloudDistanceSettings placed = scales;
    placed.registrationError = 0.02;
    const std::vector<CoreDistance> wider = cloudDistances(cores, first, second, placed, Execution());
    for (std::size_t k = 0; k < made.size(); ++k) {
        EXPECT_NEAR(wider[k].detection, made[k].detection + 1.96 * 0.02, 1e-12);
        // By its definition, from what is told beside it.
        EXPECT_NEAR(made[k].detection,
                    1.96 * std::sqrt(made[k].first.roughness * made[k].first.roughness / made[k].first.points +
                                     made[k].second.roughness * made[k].second.roughness / made[k].second.points),
                    1e-12);
        EXPECT_NEAR(made[k].first.roughness, 0.03, 0.012);
    }
}

TEST(CloudDistance, SaysWhyThereIsNone) {
    std::vector<Vec3> low = scan(4'000, 2.0, 6, 0.0, [](double, double) { return 0.0; });
    std::vector<Vec3> high = scan(4'000, 2.0, 7, 0.0, [](double, double) { return 0.1; });
    std::erase_if(high, [](const Vec3& place) { return place.x() > 0.0; });
    low.emplace_back(50.0, 0.0, 0.0);
    for (int k = 0; k < 10; ++k) {
        low.emplace_back(60.0 + 0.01 * k, 0.0, 0.0);
    }
    high.emplace_back(-70.0, 0.0, 0.0);
    for (const double z : {0.8, 0.9}) {
        high.emplace_back(1.5, 0.0, z);
    }
    const std::vector<Vec3> cores{{-1.0, 0.0, 0.0}, {1.0, -1.0, 0.0}, {50.0, 0.0, 0.0}, {60.05, 0.0, 0.0}, {1.5, 0.0, 0.0}};
    const PointIndex first(low, scales.projectionRadius);
    const PointIndex second(high, scales.projectionRadius);
    const std::vector<CoreDistance> made = cloudDistances(cores, first, second, scales, Execution());
    EXPECT_EQ(made[0].state, CoreState::Measured);
    EXPECT_EQ(made[1].state, CoreState::NoSecond);
    EXPECT_GT(made[1].first.points, 3u);
    EXPECT_TRUE(std::isnan(made[1].distance));
    EXPECT_FALSE(made[1].significant());
    EXPECT_EQ(made[2].state, CoreState::NoNormal);
    EXPECT_EQ(made[3].state, CoreState::NoNormal) << "points on a line have no plane";
    EXPECT_EQ(made[4].state, CoreState::Measured);
    EXPECT_NEAR(made[4].distance, 0.85, 1e-9);
    EXPECT_TRUE(std::isnan(made[4].detection)) << "two points tell no roughness";
    EXPECT_FALSE(made[4].significant());
}

TEST(CloudDistance, NoResultDependsOnThreads) {
    const auto hill = [](double x, double y) { return std::exp(-0.1 * (x * x + y * y)); };
    const std::vector<Vec3> one = scan(30'000, 5.0, 8, 0.02, hill);
    const PointIndex first(one, scales.projectionRadius);
    const PointIndex second(scan(30'000, 5.0, 9, 0.02, hill), scales.projectionRadius);
    const std::vector<CoreDistance> alone = cloudDistances(one, first, second, scales, Execution().withThreads(1));
    const std::vector<CoreDistance> together = cloudDistances(one, first, second, scales, Execution().withThreads(5));
    for (std::size_t k = 0; k < one.size(); ++k) {
        ASSERT_EQ(alone[k].distance, together[k].distance) << k;
        ASSERT_EQ(alone[k].detection, together[k].detection) << k;
        ASSERT_EQ(alone[k].normal, together[k].normal) << k;
    }
}

/// A rough, tilted cloud, and what its rays meet: each by chance a little off along z, some far off or nothing.
struct RayByRay {
    std::vector<Vec3> points;
    std::vector<Vec3> met;
};

RayByRay rayByRay(std::size_t count, double noise, std::size_t farFrom) {
    NormalNumbers numbers(11);
    RayByRay made;
    made.points = scan(count, 3.0, 10, 0.2, [](double x, double) { return 0.5 * x; });
    orderByCubes(made.points, scales.projectionRadius);
    for (std::size_t k = 0; k < count; ++k) {
        const bool far = farFrom > 0 && k % farFrom == 0;
        made.met.push_back(made.points[k] + Vec3(0.0, 0.0, far ? 0.8 : noise * numbers.next()));
    }
    return made;
}

TEST(SiteDistance, WhatOneRayMeetsOfBothIsPaired) {
    const RayByRay made = rayByRay(6'000, 0.01, 0);
    const PointIndex first(made.points, scales.projectionRadius);
    const SeenSite second(made.points, made.met, scales.projectionRadius);
    EXPECT_TRUE(second.others.places().empty());
    std::size_t within = 0;
    const std::vector<Vec3> cores = coresOf(made.points, 400, 2.0);
    for (const CoreDistance& core : siteDistances(cores, first, second, scales, Execution())) {
        ASSERT_EQ(core.pairs, core.first.points);
        ASSERT_EQ(core.pairs, core.second.points);
        // The roughness of 0.2 m is in both and so in no error: noise along z by the root of the points, along the normal.
        const double expected = 0.01 * core.normal.z() / std::sqrt(core.pairs);
        EXPECT_NEAR(core.error, expected, 5.0 * expected / std::sqrt(2.0 * core.pairs));
        EXPECT_NEAR(core.detection / core.error, 1.96 * (1.0 + (1.96 * 1.96 + 1.0) / 4.0 / (core.pairs - 1.0)), 0.03);
        within += core.significant() ? 0 : 1;
    }
    EXPECT_GT(within, 360u);
    EXPECT_LT(within, 396u);
}

TEST(SiteDistance, WithoutPairsTheyAreTwoSamples) {
    const RayByRay made = rayByRay(6'000, 0.0, 1);
    const PointIndex first(made.points, scales.projectionRadius);
    const SeenSite second(made.points, made.met, scales.projectionRadius);
    for (const CoreDistance& core : siteDistances(coresOf(made.points, 50, 2.0), first, second, scales, Execution())) {
        ASSERT_EQ(core.pairs, 0u);
        EXPECT_NEAR(core.error,
                    std::sqrt(core.first.roughness * core.first.roughness / (core.first.points - 1.0) +
                              core.second.roughness * core.second.roughness / (core.second.points - 1.0)),
                    1e-12);
        EXPECT_TRUE(core.significant());
        EXPECT_NEAR(core.distance, 0.8 * core.normal.z(), 0.15);
    }
}

TEST(SiteDistance, RaysThatMeetAnotherSurfaceWidenTheError) {
    const RayByRay made = rayByRay(6'000, 0.01, 7);
    const PointIndex first(made.points, scales.projectionRadius);
    const SeenSite second(made.points, made.met, scales.projectionRadius);
    for (const CoreDistance& core : siteDistances(coresOf(made.points, 50, 2.0), first, second, scales, Execution())) {
        ASSERT_GT(core.pairs, 0u);
        ASSERT_LT(core.pairs, core.first.points);
        EXPECT_GT(core.error, 0.01);
        EXPECT_LT(core.error, std::sqrt(core.first.roughness * core.first.roughness / core.first.points +
                                        core.second.roughness * core.second.roughness / core.second.points));
    }
    const std::vector<Vec3> few(made.points.begin(), made.points.begin() + 3);
    const std::vector<Vec3> metOfFew(made.met.begin() + 1, made.met.begin() + 4);
    const PointIndex three(few, scales.projectionRadius);
    const SeenSite seen(few, metOfFew, scales.projectionRadius);
    EXPECT_TRUE(std::isnan(siteDistances(few, three, seen, scales, Execution()).front().detection))
        << "three points tell no roughness";
}

TEST(PointIndex, FindsWhatLiesInACylinderHoweverLong) {
    NormalNumbers numbers(10);
    std::vector<Vec3> places;
    for (int k = 0; k < 5'000; ++k) {
        places.emplace_back(numbers.next(), numbers.next(), 3.0 * numbers.next());
    }
    places.emplace_back(4e6, -1.0, 0.0);  // one of another site
    const Vec3 centre(0.1, -0.2, 0.3);
    for (const auto& [half, cube] : {std::pair(0.05, 0.3), {0.3, 0.02}, {1.0, 5.0}, {20.0, 1e5}}) {
        const PointIndex index(places, cube);
        const Vec3 axis = Vec3(0.2, half > 0.5 ? 0.1 : -3.0, 1.0).normalized();
        std::vector<double> expected;
        for (std::uint32_t i = 0; i < places.size(); ++i) {
            const Vec3 from = places[i] - centre;
            const double along = axis.dot(from);
            if (std::abs(along) <= half && from.squaredNorm() - along * along <= 0.3 * 0.3) {
                expected.push_back(along);
            }
        }
        std::vector<double> found;
        index.withinCylinder(centre, axis, 0.3, half, found);
        std::sort(found.begin(), found.end());
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(found, expected) << half;
        EXPECT_GT(found.size(), 0u);
    }
}

TEST(PointIndex, MomentsOfABallAreThoseOfItsPointsInWhateverOrder) {
    std::mt19937_64 random(11);  // NOLINT: the same points each time
    std::uniform_real_distribution<double> along(-2.0, 2.0);
    std::vector<Vec3> places;
    for (int i = 0; i < 20'000; ++i) {
        const double x = along(random);
        const double y = along(random);
        places.emplace_back(x, y, 0.3 * x - 0.1 * y + 0.001 * along(random));
    }
    const Vec3 centre(0.4, -0.3, 0.1);
    constexpr double radius = 0.75;
    std::vector<Vec3> inside;
    for (const Vec3& place : places) {
        if ((place - centre).norm() <= radius) {
            inside.push_back(place - centre);
        }
    }
    const BallMoments made = PointIndex(places, radius).moments(centre, radius);
    ASSERT_EQ(made.points, inside.size());
    Vec3 mean = Vec3::Zero();
    for (const Vec3& off : inside) {
        mean += off / static_cast<double>(inside.size());
    }
    Mat3 spread = Mat3::Zero();
    for (const Vec3& off : inside) {
        spread += (off - mean) * (off - mean).transpose();
    }
    constexpr double step = 1e-8 * radius;
    EXPECT_LT((made.mean - mean).norm(), step);
    EXPECT_LT((made.spread - spread).cwiseAbs().maxCoeff(), step * static_cast<double>(inside.size()));
    std::shuffle(places.begin(), places.end(), random);
    const BallMoments shuffled = PointIndex(places, 0.1 * radius).moments(centre, radius);
    EXPECT_EQ(shuffled.mean, made.mean);
    EXPECT_EQ(shuffled.spread, made.spread);
    EXPECT_EQ(PointIndex(places, radius).moments(Vec3(50.0, 0.0, 0.0), radius).points, 0U);
}

TEST(PointIndex, OrderKeepsEveryPlaceAndPutsNeighboursTogether) {
    const std::vector<Vec3> places = scan(10'000, 10.0, 11, 0.1, [](double, double) { return 0.0; });
    std::vector<Vec3> ordered = places;
    const std::vector<std::uint32_t> before = orderByCubes(ordered, 0.5);
    double steps = 0.0;
    double stepsBefore = 0.0;
    for (std::size_t k = 0; k < ordered.size(); ++k) {
        ASSERT_EQ(ordered[k], places[before[k]]);
        steps += k > 0 ? (ordered[k] - ordered[k - 1]).norm() : 0.0;
        stepsBefore += k > 0 ? (places[k] - places[k - 1]).norm() : 0.0;
    }
    EXPECT_LT(steps, 0.1 * stepsBefore);
    std::vector<Vec3> astray = places;
    astray.emplace_back(-3e6, -7e6, -100.0);
    orderByCubes(astray, 0.5);
    double stepsAstray = 0.0;
    for (std::size_t k = 1; k < astray.size(); ++k) {
        const double step = (astray[k] - astray[k - 1]).norm();
        stepsAstray += step < 1e6 ? step : 0.0;
    }
    EXPECT_LT(stepsAstray, 0.1 * stepsBefore) << "a stray far below takes no numbers from the others";
    CubeThinning thinning(0.5);
    std::vector<Vec3> firsts;
    std::copy_if(ordered.begin(), ordered.end(), std::back_inserter(firsts),
                 [&](const Vec3& place) { return thinning.takes(place); });
    EXPECT_EQ(firstOfCubes(ordered, 0.5), firsts);
    EXPECT_EQ(firstOfCubes({}, 0.5).size(), 0u);
}

TEST(PointIndex, TakesPointsOnOnePlaceAndNoneAtAll) {
    const PointIndex heap(std::vector<Vec3>(100'000, Vec3(1.0, 2.0, 3.0)), 0.1);
    std::vector<Vec3> found;
    heap.within(Vec3(1.0, 2.0, 3.0), 0.1, found);
    EXPECT_EQ(found.size(), 100'000u);
    const PointIndex none(std::vector<Vec3>{}, 1.0);
    std::vector<double> offsets;
    none.withinCylinder(Vec3::Zero(), Vec3::UnitZ(), 1.0, 1.0, offsets);
    EXPECT_TRUE(offsets.empty());
    EXPECT_EQ(none.places().size(), 0u);
}

TEST(PointIndex, HoldsEveryPlaceOnceWhetherTheyCameInOrderOrNot) {
    std::vector<Vec3> places = scan(20'000, 10.0, 12, 0.1, [](double x, double y) { return 0.2 * x + std::sin(y); });
    const auto lower = [](const Vec3& a, const Vec3& b) {
        return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    };
    std::vector<Vec3> sorted = places;
    std::sort(sorted.begin(), sorted.end(), lower);
    for (const bool ordered : {false, true}) {
        if (ordered) {
            orderByCubes(places, 0.5);
            std::swap(places[10], places[11]);
        }
        std::vector<Vec3> held = PointIndex(places, 0.5).places();
        std::sort(held.begin(), held.end(), lower);
        EXPECT_EQ(held, sorted) << ordered;
    }
    const PointIndex index(places, 0.5);
    for (const Vec3& centre : {Vec3(0.0, 0.0, 0.0), Vec3(4.0, -3.0, 1.0), places[0]}) {
        std::vector<Vec3> found;
        index.within(centre, 1.0, found);
        const auto inside =
            std::count_if(places.begin(), places.end(), [&](const Vec3& place) { return (place - centre).squaredNorm() <= 1.0; });
        EXPECT_EQ(found.size(), static_cast<std::size_t>(inside));
        EXPECT_EQ(index.moments(centre, 1.0).points, found.size());
    }
}

}  // namespace

}  // namespace rubble
