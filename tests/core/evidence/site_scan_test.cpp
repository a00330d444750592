#include "core/evidence/clouds/site_scan.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/error.h"
#include "core/base/sequence.h"
#include "core/evidence/clouds/cloud_distance.h"
#include "tests/support/run_tests.h"

namespace rubble {

namespace {

/// Triangles of a site that a test puts together.
struct ScannedSite {
    std::vector<Vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    void addFace(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        const auto first = static_cast<std::uint32_t>(points.size());
        points.insert(points.end(), {a, b, c, d});
        triangles.push_back({first, first + 1, first + 2});
        triangles.push_back({first, first + 2, first + 3});
    }
    void addGround(double half) { addFace({-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}); }
    void addBox(const OrientedBox& box) {
        const auto corner = [&](int k) {
            const Vec3 side((k & 1) != 0 ? 1.0 : -1.0, (k & 2) != 0 ? 1.0 : -1.0, (k & 4) != 0 ? 1.0 : -1.0);
            return Vec3(box.centre + box.orientation * side.cwiseProduct(box.halfExtents));
        };
        for (const auto& f : {std::array{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}) {
            addFace(corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3]));
        }
    }
    SurfaceTree tree() const { return {points, triangles}; }
};

/// Boxes that lie about on level ground, on each other in the middle.
ScannedSite heapOfBoxes(int count) {
    ScannedSite site;
    site.addGround(60.0);
    Sequence numbers(7);
    for (int k = 0; k < count; ++k) {
        OrientedBox box;
        const double away = 8.0 * std::sqrt(numbers.between(0.0, 1.0));
        const double angle = numbers.between(0.0, 2.0 * std::numbers::pi);
        box.centre = {away * std::cos(angle), away * std::sin(angle), numbers.between(0.1, 0.2 + 0.2 * (8.0 - away))};
        box.orientation = numbers.turn();
        box.halfExtents = {numbers.between(0.2, 0.8), numbers.between(0.2, 0.6), numbers.between(0.1, 0.4)};
        site.addBox(box);
    }
    return site;
}

TEST(SurfaceTree, MeetsWhatASearchThroughAllTrianglesMeets) {
    const ScannedSite site = heapOfBoxes(200);
    const SurfaceTree tree = site.tree();
    Sequence numbers(3);
    int met = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec3 from(numbers.between(-12, 12), numbers.between(-12, 12), numbers.between(-1, 6));
        const Vec3 direction = k % 5 == 0 ? Vec3(-Vec3::UnitZ()) : numbers.direction();
        double nearest = 50.0;
        for (const auto& corners : site.triangles) {
            const Vec3& a = site.points[corners[0]];
            const Vec3 normal = (site.points[corners[1]] - a).cross(site.points[corners[2]] - a);
            const double range = normal.dot(a - from) / normal.dot(direction);
            if (!(range >= 0.0) || range >= nearest) {
                continue;
            }
            const Vec3 at = from + range * direction;
            bool inside = true;
            for (std::size_t c = 0; c < 3; ++c) {
                const Vec3& one = site.points[corners[c]];
                inside = inside && normal.dot((site.points[corners[(c + 1) % 3]] - one).cross(at - one)) >= 0.0;
            }
            nearest = inside ? range : nearest;
        }
        const auto hit = tree.firstHit(from, direction, 50.0);
        ASSERT_EQ(hit.has_value(), nearest < 50.0) << k;
        if (hit) {
            EXPECT_NEAR(hit->range, nearest, 1e-9);
            ++met;
        }
    }
    EXPECT_GT(met, 1000);
    EXPECT_FALSE(SurfaceTree({}, {}).firstHit(Vec3::Zero(), Vec3::UnitX(), 1.0));
    EXPECT_FALSE(SurfaceTree({Vec3::Zero(), Vec3::UnitX(), Vec3(2, 0, 0)}, {{0, 1, 2}}).firstHit({0.5, 0, 1}, -Vec3::UnitZ(), 9.0))
        << "a line has no area";
}

TEST(SurfaceTree, MeetsTheSameFromAfarAndWhereverTheSiteLies) {
    const ScannedSite site = heapOfBoxes(200);
    const SurfaceTree tree = site.tree();
    // Places on steps that both sites can hold: they are the same to the last bit.
    ScannedSite rounded = site;
    for (Vec3& point : rounded.points) {
        point = (1024.0 * point).array().round() / 1024.0;
    }
    const Vec3 away(482'304.0, 5'402'112.0, 768.0);
    ScannedSite moved = rounded;
    for (Vec3& point : moved.points) {
        point += away;
    }
    const SurfaceTree here = rounded.tree();
    const SurfaceTree there = moved.tree();
    Sequence numbers(5);
    for (int k = 0; k < 2000; ++k) {
        const Vec3 from(std::round(numbers.between(-12, 12)), std::round(numbers.between(-12, 12)), 7.0);
        Vec3 direction = numbers.direction();
        direction.z() = -std::abs(direction.z());
        const auto near = here.firstHit(from, direction, 200.0);
        const auto far = there.firstHit(from + away, direction, 200.0);
        ASSERT_EQ(near.has_value(), far.has_value()) << k;
        if (near) {
            ASSERT_EQ(near->triangle, far->triangle) << k;
            ASSERT_EQ(near->range, far->range) << k;
        }
        // The same ray begun 100 km before.
        const auto met = tree.firstHit(from, direction, 200.0);
        const auto late = tree.firstHit(from - 1e5 * direction, direction, 1e5 + 200.0);
        ASSERT_EQ(met.has_value(), late.has_value()) << k;
        if (met) {
            ASSERT_NEAR(met->range, late->range - 1e5, 1e-7) << k;
        }
    }
}

TEST(SurfaceTree, ARayThatIsNoNumberMeetsNothing) {
    const SurfaceTree tree = heapOfBoxes(20).tree();
    const Vec3 none = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(tree.firstHit({0.0, 0.0, 9.0}, none, 50.0));
    EXPECT_FALSE(tree.firstHit(none, -Vec3::UnitZ(), 50.0));
    EXPECT_TRUE(tree.firstHit({0.0, 0.0, 9.0}, -Vec3::UnitZ(), 50.0));
}

TEST(SiteScan, ABoxThrowsAShadow) {
    ScannedSite site;
    site.addGround(60.0);
    site.addBox({{10.0, 0.0, 1.0}, Quat::Identity(), {0.5, 2.0, 1.0}});
    ScanSettings settings;
    settings.scanners = {{0.0, 0.0, 3.0}};
    settings.step = 0.01;
    settings.range = 40.0;
    settings.noise = 0.0;
    const SiteScan scan = scanSite(site.tree(), settings, Execution());
    ASSERT_GT(scan.places.size(), 20'000u);
    EXPECT_EQ(scan.echoes[0], scan.places.size());
    EXPECT_EQ(scan.rays[0], 125'664u) << "one to each square of the step on the sphere";
    std::size_t onBox = 0;
    for (std::size_t k = 0; k < scan.places.size(); ++k) {
        const Vec3& at = scan.places[k];
        onBox += scan.triangles[k] >= 2 ? 1 : 0;
        // From 3 m up the shadow of what is 2 m high ends three times as far away.
        const bool shadow = at.x() > 10.51 && at.x() < 28.5 && std::abs(at.y()) < 1.9 * at.x() / 10.5;
        EXPECT_FALSE(shadow && at.z() < 1e-9) << at.transpose();
        EXPECT_LE((at - settings.scanners[0]).norm(), 40.0 + 1e-9);
    }
    EXPECT_GT(onBox, 300u);
    EXPECT_EQ(scanSite(site.tree(), settings, Execution().withThreads(1)).places, scan.places);
    settings.seed = 2;
    EXPECT_NE(scanSite(site.tree(), settings, Execution()).places, scan.places);
    settings.step = 1e-6;
    EXPECT_THROW(scanSite(site.tree(), settings, Execution()), UsageError);
    settings.scanners.clear();
    EXPECT_THROW(scanSite(site.tree(), settings, Execution()), UsageError);
}

/// The share of the cores of a scan whose distance to a site is within the level of detection, and how many have one.
struct Covered {
    std::size_t cores = 0;
    std::size_t within = 0;
    double share() const { return static_cast<double>(within) / static_cast<double>(cores); }
};

/// By the points in the cylinder: fewer than 20, and as many or more.
std::array<Covered, 2> covered(const SurfaceTree& tree, const SiteScan& scan, const ScanSettings& settings, const Vec3& moved) {
    const CloudDistanceSettings scales{0.5, 0.25, 3.0, 0.0};
    std::vector<Vec3> cloud = scan.places;
    std::vector<std::uint16_t> scanners;
    for (Vec3& place : cloud) {
        place += moved;
    }
    for (const std::uint32_t before : orderByCubes(cloud, scales.projectionRadius)) {
        scanners.push_back(scan.scanners[before]);
    }
    std::vector<Vec3> cores = firstOfCubes(cloud, scales.projectionRadius);
    std::erase_if(cores, [](const Vec3& core) { return core.head<2>().norm() > 9.0; });
    const SeenSite second(cloud, seenAlike(tree, cloud, {settings.scanners, scanners}, Execution()).places,
                          scales.projectionRadius);
    const PointIndex first(std::move(cloud), scales.projectionRadius);
    std::array<Covered, 2> made;
    for (const CoreDistance& core : siteDistances(cores, first, second, scales, Execution())) {
        if (std::isfinite(core.detection)) {
            Covered& one = made[core.first.points < 20 ? 0 : 1];
            ++one.cores;
            one.within += core.significant() ? 0 : 1;
        }
    }
    return made;
}

TEST(SiteScan, TheScanOfASiteLiesWithinTheLevelOfDetection) {
    const SurfaceTree tree = heapOfBoxes(300).tree();
    ScanSettings settings;
    settings.scanners = {{20.0, 3.0, 4.0}, {-14.0, 15.0, 2.0}, {-8.0, -18.0, 6.0}};
    settings.step = 0.006;
    settings.range = 60.0;
    settings.noise = 0.01;
    std::array<Covered, 2> all;
    for (std::uint64_t seed = 1; seed <= sizedTo<std::uint64_t>(4, 20); ++seed) {
        settings.seed = seed;
        const SiteScan scan = scanSite(tree, settings, Execution());
        const std::array<Covered, 2> itself = covered(tree, scan, settings, Vec3::Zero());
        for (std::size_t k = 0; k < all.size(); ++k) {
            // With some 1,500 distances the share of one scan strays from 0.95 by 0.006.
            EXPECT_GT(itself[k].cores, 500u);
            EXPECT_GT(itself[k].share(), 0.92) << seed << ", " << k;
            EXPECT_LT(itself[k].share(), 0.98) << seed << ", " << k;
            all[k].cores += itself[k].cores;
            all[k].within += itself[k].within;
        }
        const std::array<Covered, 2> moved = covered(tree, scan, settings, {0.0, 0.0, 0.2});
        EXPECT_LT(moved[1].share(), 0.4) << seed;
    }
    for (const Covered& each : all) {
        EXPECT_GT(each.share(), 0.935);
        EXPECT_LT(each.share(), 0.97);
    }
}

TEST(SiteScan, EachRayGoesThroughItsPointAndMissesLeaveNone) {
    ScannedSite site;
    site.addGround(10.0);
    const SurfaceTree tree = site.tree();
    const std::vector<Vec3> scanners{{0.0, 0.0, 2.0}};
    const std::vector<Vec3> points{{3.0, 1.0, 1.0}, {3.0, 1.0, 3.0}, {0.0, 4.0, -0.5}};
    const MetAlike met = seenAlike(tree, points, {scanners, {}}, Execution());
    ASSERT_EQ(met.places.size(), points.size());
    EXPECT_NEAR((met.places[0] - Vec3(6.0, 2.0, 0.0)).norm(), 0.0, 1e-9);
    EXPECT_FALSE(met.places[1].allFinite());
    EXPECT_EQ(met.triangles[1], noTriangle);
    EXPECT_NEAR((met.places[2] - Vec3(0.0, 3.2, 0.0)).norm(), 0.0, 1e-9);
    const MetAlike above = seenAlike(tree, points, {}, Execution());
    EXPECT_NEAR((above.places[1] - Vec3(3.0, 1.0, 0.0)).norm(), 0.0, 1e-9);
}

}  // namespace

}  // namespace rubble
