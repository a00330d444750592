#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

std::string publicCloud(const std::string& name) {
    return sourcePath("tests/data/clouds/" + name);
}

class LasCloud : public testing::Test {
protected:
    TemporaryFolder m_folder;

    WholeCloud read(const MadeLas& las, const CloudRequest& request = {}) {
        return readCloud(layCloud(m_folder / "made.las", las.bytes()), request);
    }
    /// The id of the error that bytes are refused with; "read" if they are not.
    std::string refusal(const CloudBytes& bytes) {
        try {
            readCloud(layCloud(m_folder / "damaged.las", bytes));
        } catch (const Error& error) {
            return error.message().id;
        }
        return "read";
    }
};

std::vector<MadePoint> threePoints() {
    std::vector<MadePoint> points(3);
    points[0] = {{100, 200, 300}, 7, 1, 3, 2, false, 1234.5, {1, 256, 65535}};
    points[1] = {{-100, 2'000'000'000, -2'000'000'000}, 65535, 3, 3, 6, false, -0.25, {3, 4, 5}};
    points[2] = {{0, 1, 0}, 0, 2, 2, 31, false, 0.0, {0, 0, 0}};
    return points;
}

TEST_F(LasCloud, EveryPointFormatOfEveryVersionKeepsWhatItHolds) {
    for (int format = 0; format <= 10; ++format) {
        MadeLas las;
        las.format = format;
        las.minor = format < 6 ? format % 5 : 4;
        las.extra = static_cast<std::size_t>(format % 3) * 5;
        las.scale = Vec3(0.001, 1e-7, 0.01);
        las.offset = Vec3(500'000.0, -1.5, 1e6);
        las.points = threePoints();
        const WholeCloud cloud = read(las);
        ASSERT_EQ(cloud.points.size(), 3u) << format;
        EXPECT_EQ(cloud.head.format, "LAS");
        EXPECT_EQ(cloud.head.version, "1." + std::to_string(las.minor));
        EXPECT_EQ(cloud.points.places[1], Vec3(-100 * 0.001 + 500'000.0, 2'000'000'000 * 1e-7 - 1.5, -2'000'000'000 * 0.01 + 1e6));
        EXPECT_THAT(cloud.points.intensity, testing::ElementsAre(7.0F, 65535.0F, 0.0F));
        EXPECT_THAT(cloud.points.classes, testing::ElementsAre(2, 6, 31));
        EXPECT_THAT(cloud.points.returns, testing::ElementsAre(1, 3, 2));
        EXPECT_THAT(cloud.points.returnsOf, testing::ElementsAre(3, 3, 2));
        const LasLayout layout = *lasLayout(format);
        EXPECT_EQ(cloud.points.times.size(), layout.time >= 0 ? 3u : 0u) << format;
        EXPECT_EQ(cloud.points.colours.size(), layout.colour >= 0 ? 3u : 0u) << format;
        if (layout.time >= 0) {
            EXPECT_THAT(cloud.points.times, testing::ElementsAre(1234.5, -0.25, 0.0));
        }
        if (layout.colour >= 0) {
            EXPECT_THAT(cloud.points.colours[0], testing::ElementsAre(1, 256, 65535)) << format;
        }
        EXPECT_EQ(cloud.summary.findings.count("cloud.bounds_differ"), 0) << format;
    }
}

TEST_F(LasCloud, WithheldNoiseAndEchoesOfNothingAreLeftOutAndCounted) {
    MadeLas las;
    las.format = 6;
    las.minor = 4;
    las.points.resize(6);
    for (std::size_t p = 0; p < las.points.size(); ++p) {
        las.points[p].place = {static_cast<std::int32_t>(p), 0, 0};
    }
    las.points[1].withheld = true;
    las.points[2].kind = 7;
    las.points[3].kind = 18;
    las.points[5].place = {0, 0, 0};
    const WholeCloud cloud = read(las);
    ASSERT_EQ(cloud.points.size(), 1u);
    EXPECT_EQ(cloud.points.places[0].x(), 0.04);
    EXPECT_EQ(cloud.summary.findings.count("cloud.withheld"), 1);
    EXPECT_EQ(cloud.summary.findings.count("cloud.noise"), 2);
    EXPECT_EQ(cloud.summary.findings.count("cloud.no_return"), 2);
    std::uint64_t all = 0;
    for (const std::uint64_t count : cloud.summary.fates) {
        all += count;
    }
    EXPECT_EQ(all, 6u) << "every point met one fate";
}

TEST_F(LasCloud, ASinglePointAtTheOriginIsAPlace) {
    MadeLas las;
    las.points.resize(2);
    las.points[1].place = {5, 5, 5};
    EXPECT_EQ(read(las).points.size(), 2u);
}

TEST_F(LasCloud, AMillionPointsAtTheOriginLeaveNothing) {
    MadeLas las;
    las.points.resize(1'000'000);
    const WholeCloud cloud = read(las);
    EXPECT_EQ(cloud.points.size(), 0u);
    EXPECT_EQ(cloud.summary.findings.count("cloud.no_return"), 1'000'000);
    EXPECT_EQ(cloud.summary.findings.count("cloud.nothing_left"), 1);
    EXPECT_TRUE(cloud.summary.bounds.isEmpty());
}

TEST_F(LasCloud, FeetAndDegreesAreSaid) {
    MadeLas las;
    las.minor = 4;
    las.format = 6;
    las.points = threePoints();
    las.points[1].place = {400, 300, 100};
    // Oregon North in feet, heights of no stated unit.
    const WholeCloud feet = read(las, {"EPSG:2992", {}});
    EXPECT_NEAR(feet.head.units.metres, 0.3048, 1e-12);
    EXPECT_EQ(feet.summary.findings.count("cloud.height_unit_assumed"), 1);
    EXPECT_NEAR(feet.summary.metres.max().x(), 4.0 * 0.3048, 1e-12);
    EXPECT_NEAR(feet.summary.metres.max().z(), 3.0 * 0.3048, 1e-12);
    // Metres across, feet up.
    const WholeCloud mixed = read(las, {"EPSG:25832+6360", {}});
    EXPECT_EQ(mixed.head.units.metres, 1.0);
    EXPECT_NEAR(mixed.head.units.heightMetres, 1200.0 / 3937.0, 1e-12);
    EXPECT_EQ(mixed.summary.findings.count("cloud.height_unit_assumed"), 0);
    const WholeCloud degrees = read(las, {"EPSG:4326", {}});
    EXPECT_TRUE(degrees.head.units.degrees);
    EXPECT_TRUE(degrees.summary.metres.isEmpty());
    EXPECT_EQ(degrees.summary.findings.count("cloud.degrees"), 1);
    EXPECT_EQ(read(las).summary.findings.count("cloud.system_unknown"), 1);
    las.scale = Vec3(1e-7, 1e-7, 0.01);
    EXPECT_EQ(read(las).summary.findings.count("cloud.perhaps_degrees"), 1);
    EXPECT_THROW(read(las, {"EPSG:999999", {}}), UsageError);
}

TEST_F(LasCloud, TheSystemOfTheFileStandsBeforeTheOneAskedFor) {
    MadeLas las;
    las.minor = 4;
    las.format = 6;
    las.points = threePoints();
    las.wkt = "LOCAL_CS[\"building\",UNIT[\"foot\",0.3048]]";
    const WholeCloud local = read(las);
    EXPECT_EQ(local.summary.findings.count("cloud.system_local"), 1);
    EXPECT_EQ(local.summary.findings.count("cloud.height_unit_assumed"), 1);
    EXPECT_NEAR(local.summary.metres.max().x(), 0.3048, 1e-12);
    las.wkt = "LOCAL";
    EXPECT_EQ(read(las).summary.findings.count("cloud.system_unread"), 1);
    const WholeCloud keys = readCloud(publicCloud("1.0_1.las"), {"EPSG:25832", {}});
    EXPECT_EQ(keys.head.units.name, "NAD83 / UTM zone 15N");
    EXPECT_EQ(keys.head.crsFrom, "GeoTIFF keys");
    EXPECT_EQ(keys.summary.findings.count("cloud.system_kept"), 1);
    ASSERT_EQ(keys.points.size(), 1u);
    EXPECT_NEAR((keys.points.places[0] - Vec3(470692.44, 4602888.90, 16.0)).norm(), 0.0, 1e-9);
    EXPECT_EQ(keys.points.classes[0], 2);
}

TEST_F(LasCloud, WhatIsWrongWithTheHeadIsSaid) {
    MadeLas las;
    las.points = threePoints();
    CloudBytes cut = las.bytes();
    cut.erase(cut.end() - 25, cut.end());
    const WholeCloud fewer = readCloud(layCloud(m_folder / "cut.las", cut));
    EXPECT_EQ(fewer.points.size(), 1u);
    EXPECT_EQ(fewer.summary.findings.count("cloud.fewer_points"), 1);
    CloudBytes bounds = las.bytes();
    putNumber(bounds, 179, 77.0);
    EXPECT_EQ(readCloud(layCloud(m_folder / "b.las", bounds)).summary.findings.count("cloud.bounds_differ"), 1);
    CloudBytes records = las.bytes();
    putNumber(records, 100, std::uint32_t{4'000'000'000});
    EXPECT_EQ(readCloud(layCloud(m_folder / "r.las", records)).summary.findings.count("cloud.records_cut"), 4'000'000'000);
    CloudBytes scale = las.bytes();
    putNumber(scale, 131, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(refusal(scale), "cloud.las_scale");
    CloudBytes format = las.bytes();
    format[104] = 11;
    EXPECT_EQ(refusal(format), "cloud.las_format");
    CloudBytes record = las.bytes();
    putNumber(record, 105, std::uint16_t{19});
    EXPECT_EQ(refusal(record), "cloud.las_record");
    CloudBytes version = las.bytes();
    version[25] = 5;
    EXPECT_EQ(refusal(version), "cloud.las_version");
    CloudBytes start = las.bytes();
    putNumber(start, 96, std::uint32_t{100});
    EXPECT_EQ(refusal(start), "cloud.las_head");
    start.resize(100);
    EXPECT_EQ(refusal(start), "cloud.cut");
}

TEST_F(LasCloud, TimesThatAreNoNumbersAndPlantsAloneAreSaid) {
    MadeLas las;
    las.format = 1;
    las.points = threePoints();
    for (MadePoint& point : las.points) {
        point.kind = 5;
        point.time = std::numeric_limits<double>::quiet_NaN();
    }
    const WholeCloud cloud = read(las);
    EXPECT_EQ(cloud.points.size(), 3u);
    EXPECT_EQ(cloud.summary.findings.count("cloud.time_no_number"), 3);
    EXPECT_EQ(cloud.summary.findings.count("cloud.vegetation_only"), 1);
}

void expectEqual(const WholeCloud& packed, const WholeCloud& plain) {
    ASSERT_EQ(packed.points.size(), plain.points.size());
    EXPECT_EQ(packed.points.places, plain.points.places);
    EXPECT_EQ(packed.points.intensity, plain.points.intensity);
    EXPECT_EQ(packed.points.classes, plain.points.classes);
    EXPECT_EQ(packed.points.returns, plain.points.returns);
    EXPECT_EQ(packed.points.returnsOf, plain.points.returnsOf);
    if (!packed.points.colours.empty()) {
        EXPECT_EQ(packed.points.colours, plain.points.colours);
    }
    if (!packed.points.times.empty()) {
        EXPECT_EQ(packed.points.times, plain.points.times);
    }
}

TEST_F(LasCloud, PackedPointsAreThoseOfTheirTwinOneByOne) {
    const WholeCloud plain = readCloud(publicCloud("point-time-color.las"));
    ASSERT_EQ(plain.points.size(), 1065u);
    EXPECT_EQ(plain.summary.classes.at(1), 789u);
    EXPECT_EQ(plain.summary.classes.at(2), 276u);
    for (const char* name : {"point10", "point-time", "point-color", "point-time-color"}) {
        SCOPED_TRACE(name);
        const WholeCloud packed = readCloud(publicCloud(std::string(name) + ".laz"));
        EXPECT_EQ(packed.head.format, "LAZ");
        expectEqual(packed, plain);
    }
}

// Packed by LASzip 3.5.1 with all that a point can hold: several echoes, scanner channels in turn, colours, wave forms, an extra
// byte.
TEST_F(LasCloud, PackedPointsOfTheRarerFormatsAreThoseOfTheirTwin) {
    for (const int format : {4, 5, 6, 8, 9, 10}) {
        SCOPED_TRACE(format);
        const std::string name = "made-" + std::to_string(format);
        const WholeCloud plain = readCloud(publicCloud(name + ".las"));
        const WholeCloud packed = readCloud(publicCloud(name + ".laz"));
        EXPECT_EQ(packed.head.format, "LAZ");
        EXPECT_EQ(packed.head.unread, plain.head.unread);
        EXPECT_EQ(packed.summary.fates, plain.summary.fates);
        EXPECT_EQ(packed.summary.points() + static_cast<std::uint64_t>(packed.summary.findings.count("cloud.withheld")), 250u);
        EXPECT_GT(plain.summary.returns.size(), 3u);
        EXPECT_EQ(packed.points.colours, plain.points.colours);
        expectEqual(packed, plain);
    }
}

/// The order of points by what both kinds of a cloud keep.
std::vector<std::size_t> sortedByTimeAndPlace(const CloudBlock& points) {
    std::vector<std::size_t> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(points.times[a], points.returns[a]) < std::pair(points.times[b], points.returns[b]);
    });
    return order;
}

TEST_F(LasCloud, PointsInLayersAreThoseOfTheirTwinInAnotherOrder) {
    const WholeCloud layers = readCloud(publicCloud("1.2-with-color.copc.laz"));
    const WholeCloud plain = readCloud(publicCloud("1.2-with-color.las"));
    ASSERT_EQ(layers.points.size(), 1065u);
    ASSERT_EQ(plain.points.size(), 1065u);
    const std::vector<std::size_t> a = sortedByTimeAndPlace(layers.points);
    const std::vector<std::size_t> b = sortedByTimeAndPlace(plain.points);
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_NEAR((layers.points.places[a[i]] - plain.points.places[b[i]]).norm(), 0.0, 1e-6) << i;
        ASSERT_EQ(layers.points.times[a[i]], plain.points.times[b[i]]);
        ASSERT_EQ(layers.points.colours[a[i]], plain.points.colours[b[i]]);
        ASSERT_EQ(layers.points.intensity[a[i]], plain.points.intensity[b[i]]);
        ASSERT_EQ(layers.points.classes[a[i]], plain.points.classes[b[i]]);
        ASSERT_EQ(layers.points.returnsOf[a[i]], plain.points.returnsOf[b[i]]);
    }
}

CloudBytes contentOfCloud(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST_F(LasCloud, ThreadsUnpackWhatOneDoes) {
    for (const char* name : {"point-time-color.laz", "1.2-with-color.copc.laz"}) {
        const WholeCloud all = readCloud(publicCloud(name));
        for (const int threads : {1, 3, 16}) {
            const std::unique_ptr<PointCloud> cloud = openCloud(publicCloud(name));
            CloudBlock block;
            std::size_t at = 0;
            while (cloud->next(block, Execution().withThreads(threads))) {
                for (std::size_t i = 0; i < block.size(); ++i, ++at) {
                    ASSERT_EQ(block.places[i], all.points.places.at(at)) << name << threads;
                    ASSERT_EQ(block.colours[i], all.points.colours.at(at)) << name << threads;
                }
            }
            EXPECT_EQ(at, 1065u) << name << threads;
        }
    }
}

/// A LAZ of one chunk with that chunk three times, and the table of three chunks of 17,191 bytes as LASzip codes it.
CloudBytes threeChunks() {
    CloudBytes bytes = contentOfCloud(publicCloud("point-time-color.laz"));
    constexpr std::size_t chunkBytes = 17'191;
    std::uint32_t start = 0;
    std::memcpy(&start, &bytes[96], sizeof start);
    const std::string packer = "laszip encoded";
    const auto user = std::search(bytes.begin(), bytes.end(), packer.begin(), packer.end());
    // Points of a chunk stand 12 bytes behind the head of the record, which has 52 bytes from its user on.
    putNumber(bytes, static_cast<std::size_t>(user - bytes.begin()) + 52 + 12, std::uint32_t{1065});
    putNumber(bytes, 107, std::uint32_t{3 * 1065});
    putNumber(bytes, start, std::uint64_t{start + 8 + 3 * chunkBytes});
    bytes.resize(start + 8 + chunkBytes);
    const CloudBytes chunk(bytes.end() - chunkBytes, bytes.end());
    bytes.insert(bytes.end(), chunk.begin(), chunk.end());
    bytes.insert(bytes.end(), chunk.begin(), chunk.end());
    bytes.insert(bytes.end(), {0, 0, 0, 0, 3, 0, 0, 0, 0x78, 0x6d, 0x5c, 0x44, 1, 0, 0, 0});
    return bytes;
}

TEST_F(LasCloud, ChunksThatAreUnpackedTogetherDoNotMix) {
    const WholeCloud one = readCloud(publicCloud("point-time-color.laz"));
    const WholeCloud three = readCloud(layCloud(m_folder / "three.laz", threeChunks()));
    EXPECT_EQ(three.summary.findings.count("cloud.laz_table_missing"), 0);
    ASSERT_EQ(three.points.size(), 3195u);
    for (std::size_t i = 0; i < three.points.size(); ++i) {
        ASSERT_EQ(three.points.places[i], one.points.places[i % 1065]) << i;
        ASSERT_EQ(three.points.times[i], one.points.times[i % 1065]) << i;
        ASSERT_EQ(three.points.colours[i], one.points.colours[i % 1065]) << i;
        ASSERT_EQ(three.points.intensity[i], one.points.intensity[i % 1065]) << i;
        ASSERT_EQ(three.points.classes[i], one.points.classes[i % 1065]) << i;
    }
}

TEST_F(LasCloud, ATableOfChunksThatIsGoneCostsNoPoint) {
    for (const char* name : {"point-time-color.laz", "1.2-with-color.copc.laz"}) {
        CloudBytes bytes = contentOfCloud(publicCloud(name));
        std::uint32_t start = 0;
        std::memcpy(&start, &bytes[96], sizeof start);
        putNumber(bytes, start, std::uint64_t{3});
        const WholeCloud cloud = readCloud(layCloud(m_folder / name, bytes));
        EXPECT_EQ(cloud.points.size(), 1065u) << name;
        EXPECT_EQ(cloud.summary.findings.count("cloud.laz_table_missing"), 1) << name;
    }
}

TEST_F(LasCloud, APackedFileThatIsCutGivesThePointsInFrontOfTheCut) {
    const WholeCloud whole = readCloud(publicCloud("1.2-with-color.copc.laz"));
    CloudBytes bytes = contentOfCloud(publicCloud("1.2-with-color.copc.laz"));
    bytes.resize(bytes.size() * 6 / 10);
    const WholeCloud cut = readCloud(layCloud(m_folder / "cut.laz", bytes));
    ASSERT_GT(cut.points.size(), 500u);
    ASSERT_LT(cut.points.size(), 1000u);
    EXPECT_EQ(cut.summary.findings.count("cloud.fewer_points"), 1);
    EXPECT_TRUE(std::equal(cut.points.places.begin(), cut.points.places.end(), whole.points.places.begin()));
    EXPECT_TRUE(std::equal(cut.points.colours.begin(), cut.points.colours.end(), whole.points.colours.begin()));
}

TEST_F(LasCloud, PackedFilesThatAreCutOrChangedEndInWords) {
    for (const char* name : {"point-time-color.laz", "1.2-with-color.copc.laz", "point-time-color.las"}) {
        const CloudBytes whole = contentOfCloud(publicCloud(name));
        for (std::size_t part = 0; part < 60; ++part) {
            CloudBytes cut = whole;
            cut.resize(whole.size() * part / 60);
            if (refusal(cut) == "read") {
                // Points are told to be missing, or all are there and something behind them is.
                const CloudSummary summary = readCloud(m_folder / "damaged.las").summary;
                const Findings& found = summary.findings;
                const std::int64_t behind = found.count("cloud.records_cut") + found.count("cloud.laz_table_missing");
                EXPECT_TRUE(found.count("cloud.fewer_points") > 0 || (summary.points() == 1065 && behind > 0)) << name << part;
            }
            CloudBytes changed = whole;
            for (std::size_t k = 0; k < 8; ++k) {
                unsigned char& byte = changed[(part * 7919 + k * 104729) % changed.size()];
                byte = static_cast<unsigned char>(byte ^ (part * 31 + k + 1));
            }
            refusal(changed);
        }
    }
}

}  // namespace

}  // namespace rubble::io
