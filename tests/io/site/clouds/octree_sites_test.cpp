#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include "core/base/error.h"
#include "io/site/clouds/octree/cloud_bulk.h"
#include "io/site/clouds/octree/cloud_octree.h"
#include "io/site/clouds/octree/far_sites.h"
#include "io/site/clouds/point_writer.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

/// A cloud of two fields of 40 m, each of so many points, and of strays.
std::shared_ptr<const CloudOctree> twoFields(const std::string& path, const Vec3& first, const Vec3& second, int points,
                                             int strays) {
    std::ofstream table(path);
    table.precision(12);
    std::mt19937 random(3);  // NOLINT: the same points each time
    std::uniform_real_distribution<double> along(0.0, 40.0);
    for (int i = 0; i < points; ++i) {
        for (const Vec3& corner : {first, second}) {
            table << corner.x() + along(random) << ' ' << corner.y() + along(random) << ' ' << corner.z() + 0.1 * along(random)
                  << '\n';
        }
        if (i < strays) {
            table << 3e6 * (i + 1) << ' ' << i << " 1\n";
        }
    }
    table.close();
    return openOctree(path, {{}, {"x", "y", "z"}}, Execution()).octree;
}

/// m, spacing of the finest nodes of a part that hold points of a field.
double finestAt(const CloudOctree& octree, const Vec3& corner, bool far) {
    double finest = 1e9;
    for (const OctreeNode& node : octree.nodes()) {
        if (node.far == far && node.box.exteriorDistance(corner + Vec3::Constant(2.0)) <= 0.0) {
            finest = std::min(finest, node.spacing);
        }
    }
    return finest;
}

}  // namespace

TEST(OctreeSites, TwoDenseOnesAreOneBulkWithDetailInBoth) {
    const TemporaryFolder folder;
    const Vec3 here(0.0, 0.0, 0.0);
    // 50 and 1,000 widths away.
    for (const double apart : {2'000.0, 40'000.0}) {
        SCOPED_TRACE(apart);
        const Vec3 there(apart, 0.3 * apart, 20.0);
        const auto octree = twoFields(folder / std::to_string(static_cast<int>(apart)) + ".xyz", here, there, 20'000, 3);
        EXPECT_EQ(octree->head().points, 40'003U);
        EXPECT_EQ(octree->head().farPoints, 3U) << "strays are no site";
        EXPECT_LT(octree->placeStep(), 1e-4);
        EXPECT_LT(finestAt(*octree, here, false), 1.0);
        EXPECT_NEAR(finestAt(*octree, here, false), finestAt(*octree, there, false), 1.0);
    }
}

TEST(OctreeSites, ThoseOfTwoSystemsKeepTheirDetailApart) {
    const TemporaryFolder folder;
    const Vec3 here(0.0, 0.0, 0.0);
    const Vec3 there(500'000.0, 5'400'000.0, 100.0);
    const auto octree = twoFields(folder / "systems.xyz", here, there, 20'000, 0);
    EXPECT_EQ(octree->head().points, 40'000U);
    EXPECT_EQ(octree->head().farPoints, 20'000U);
    EXPECT_LT(octree->placeStep(), 1e-7);
    EXPECT_LT(octree->farPlaceStep(), 1e-7);
    EXPECT_LT(std::max(octree->nodes().front().spacing, octree->nodes().back().spacing), 1.0);
}

TEST(OctreeSites, AHundredthOfThePlacesIsASiteAndFewerAreStrays) {
    std::mt19937 random(9);  // NOLINT: the same points each time
    std::uniform_real_distribution<double> along(0.0, 40.0);
    const auto holds = [&](int other) {
        CloudBulk bulk;
        for (int i = 0; i < 20'000; ++i) {
            bulk.add({along(random), along(random), 0.0});
            if (i < other) {
                bulk.add({5'000.0 + along(random), along(random), 0.0});
            }
        }
        return bulk.box({}).contains(Vec3(5'020.0, 20.0, 0.0));
    };
    EXPECT_TRUE(holds(20'000));
    EXPECT_TRUE(holds(400));
    EXPECT_FALSE(holds(100));
}

TEST(OctreeSites, TheSearchCanBeGivenUp) {
    CloudBulk bulk;
    for (int i = 0; i < 100; ++i) {
        bulk.add({1.0 * i, 0.0, 0.0});
    }
    const Execution execution;
    EXPECT_FALSE(bulk.box({}, execution).isEmpty());
    execution.cancel();
    EXPECT_THROW(bulk.box({}, execution), Cancelled);
    EXPECT_THROW(bulk.reach({}, execution), Cancelled);
}

TEST(OctreeSites, AFarOneIsLookedAtWhereItLiesAndStraysNever) {
    const TemporaryFolder folder;
    const double east = 200'000.0;
    const auto sitesOf = [&](const std::string& name, std::size_t bulk, std::size_t other, std::size_t strays, bool heaped) {
        WrittenCloud cloud;
        cloud.points = bulk + other + strays;
        cloud.box = Aabb(Vec3(-east, 0.0, 0.0), Vec3(east + 40.0, 40.0, 4.0));
        const std::string path = folder / name;
        std::mt19937 random(3);  // NOLINT: the same points each time
        std::uniform_real_distribution<double> along(0.0, 40.0);
        writePoints(path, cloud, [&](std::size_t k, WrittenPoint& point) {
            point.place = Vec3(along(random), along(random), 0.1 * along(random));
            if (k >= bulk + other) {
                point.place = Vec3(-east, static_cast<double>(k % 10), 0.0);
            } else if (k >= bulk) {
                point.place = heaped ? Vec3(east, 0.0, 0.0) : Vec3(point.place + Vec3(east, 0.0, 0.0));
            }
        });
        const PlacedOctree placed(path, {}, Frame(), Site(), std::nullopt, Execution());
        EXPECT_EQ(placed.octree().head().farPoints, other + strays);
        return FarSites(placed, Execution());
    };
    const Vec3 inBulk(20.0, 20.0, 2.0);
    const Vec3 besideBulk(20.0, -100.0, 60.0);
    const Vec3 atFar(east + 20.0, 20.0, 60.0);
    const Vec3 atStrays(-east, 0.0, 10.0);
    // A few points are one leaf, of many each site has nodes of its own.
    for (const std::size_t other : {4'000U, 40'000U}) {
        const FarSites far = sitesOf(std::to_string(other) + ".las", 5 * other, other, 2, false);
        EXPECT_FALSE(far.nearer(inBulk));
        EXPECT_FALSE(far.nearer(besideBulk));
        EXPECT_TRUE(far.nearer(atFar));
        EXPECT_FALSE(far.nearer(atStrays)) << "two strays are no site";
    }
    EXPECT_FALSE(sitesOf("strays.las", 20'000, 0, 2, false).nearer(atStrays));
    // Many points at one place are one place, as for the bulk.
    EXPECT_FALSE(sitesOf("heap.las", 20'000, 20'000, 0, true).nearer(atFar));
    EXPECT_FALSE(FarSites().nearer(atFar));
}

}  // namespace rubble::io
