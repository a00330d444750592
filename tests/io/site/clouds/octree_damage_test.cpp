#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

#include "core/base/error.h"
#include "io/site/clouds/octree/cloud_octree.h"
#include "tests/io/site/clouds/forged_octree.h"
#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

void lay(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

/// The bytes of an octree of a few hundred points, some of them far.
std::string smallOctree(const TemporaryFolder& folder) {
    MadeLas las;
    las.minor = 2;
    las.format = 2;
    las.scale = Vec3::Constant(0.001);
    std::mt19937 random(11);  // NOLINT: the same points each time
    std::uniform_int_distribution<std::int32_t> along(0, 50'000);
    for (int i = 0; i < 400; ++i) {
        MadePoint point;
        point.place = {along(random), along(random), along(random) / 5};
        point.kind = 2;
        las.points.push_back(point);
    }
    las.points.back().place = {900'000'000, 0, 0};
    const std::string kept = openOctree(layCloud(folder / "small.las", las.bytes()), {}, Execution()).octree->path();
    std::ifstream in(kept, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Reads all that an octree has; false: it is refused. What is taken are numbers.
bool readsSoundly(const std::string& path) {
    try {
        const CloudOctree octree(path);
        for (std::size_t n = 0; n < octree.nodes().size(); ++n) {
            const OctreeNode& node = octree.nodes()[n];
            EXPECT_TRUE(!node.parent || *node.parent < n);
            EXPECT_GT(node.spacing, 0.0);
            EXPECT_TRUE(node.box.min().allFinite() && node.box.max().allFinite());
            const CloudBlock block = octree.read(n);
            EXPECT_TRUE(std::all_of(block.places.begin(), block.places.end(), [](const Vec3& place) { return place.allFinite(); }));
            EXPECT_TRUE(
                std::all_of(block.intensity.begin(), block.intensity.end(), [](float each) { return std::isfinite(each); }));
        }
        return true;
    } catch (const ParseError&) {
        return false;
    }
}

}  // namespace

TEST(OctreeDamage, AnyBytesWithDigestsThatFitAreRefusedOrAreNumbers) {
    const TemporaryFolder folder;
    const std::string sound = smallOctree(folder);
    const std::string path = folder / "changed.octree";
    std::string same = sound;
    putOctreeRight(same);
    ASSERT_EQ(same, sound);
    std::mt19937 random(23);  // NOLINT: the same changes each time
    int taken = 0;
    constexpr int rounds = 20'000;
    for (int round = 0; round < rounds; ++round) {
        std::string bytes = sound;
        const std::size_t changes = 1 + random() % 4;
        for (std::size_t c = 0; c < changes; ++c) {
            // Mostly in table and foot, which say what all else is.
            const std::size_t tail = std::min<std::size_t>(bytes.size(), sizeof(OctreeFoot) + 4 * sizeof(OctreeRow));
            const std::size_t at = random() % 4 == 0 ? random() % bytes.size() : bytes.size() - 1 - random() % tail;
            const int kind = static_cast<int>(random() % 4);
            if (kind == 0) {
                bytes[at] = static_cast<char>(random());
            } else if (kind == 1) {
                bytes[at] = static_cast<char>(bytes[at] ^ 1 << random() % 8);
            } else if (kind == 2) {
                std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), std::min<std::size_t>(8, bytes.size() - at), '\xff');
            } else {
                bytes.erase(at, 1 + random() % 64);
            }
        }
        putOctreeRight(bytes);
        lay(path, bytes);
        taken += readsSoundly(path) ? 1 : 0;
    }
    EXPECT_GT(taken, rounds / 100) << "changes must come behind the digests";
    EXPECT_LT(taken, rounds);
}

TEST(OctreeDamage, CubesAndIntensitiesThatAreNoNumbersAreRefused) {
    const TemporaryFolder folder;
    const std::string sound = smallOctree(folder);
    const std::string path = folder / "changed.octree";
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refused = [&](const auto& change) {
        std::string bytes = sound;
        OctreeFoot foot;
        std::memcpy(&foot, &bytes[bytes.size() - sizeof foot], sizeof foot);
        change(foot, bytes);
        std::memcpy(&bytes[bytes.size() - sizeof foot], &foot, sizeof foot);
        putOctreeRight(bytes);
        lay(path, bytes);
        return !readsSoundly(path);
    };
    EXPECT_FALSE(refused([](OctreeFoot&, std::string&) {}));
    EXPECT_TRUE(refused([](OctreeFoot& foot, std::string&) { foot.cube.low[1] = nan; }));
    EXPECT_TRUE(refused([](OctreeFoot& foot, std::string&) { foot.farCube.step[2] = 0.0; }));
    EXPECT_TRUE(refused([](OctreeFoot& foot, std::string&) { foot.cube.step[0] = 1e305; }));
    EXPECT_TRUE(refused([](OctreeFoot& foot, std::string&) { foot.cube.side = -1.0; }));
    EXPECT_TRUE(refused([](OctreeFoot& foot, std::string&) { foot.cube.side = 1e-310; }));
    EXPECT_TRUE(refused([](OctreeFoot& foot, std::string&) { foot.intensityMost = static_cast<float>(nan); }));
    EXPECT_TRUE(refused([](OctreeFoot&, std::string& bytes) { bytes.replace(octreeStart + 12, 4, 4, '\xff'); }));
}

}  // namespace rubble::io
