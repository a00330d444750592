#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "io/site/clouds/e57/e57_source.h"
#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

std::string publicE57(const std::string& name) {
    return sourcePath("tests/data/clouds/" + name);
}

std::string wrapped(const std::string& scans, const std::string& images = "") {
    return "<?xml version=\"1.0\"?><e57Root type=\"Structure\" xmlns=\"http://www.astm.org/COMMIT/E57/2010-e57-v1.0\">"
           "<data3D type=\"Vector\">" +
           scans + "</data3D><images2D type=\"Vector\">" + images + "</images2D></e57Root>";
}

std::string pointsXml(std::uint64_t place, std::size_t count, const std::string& fields) {
    return "<points type=\"CompressedVector\" fileOffset=\"" + std::to_string(place) + "\" recordCount=\"" + std::to_string(count) +
           "\"><prototype type=\"Structure\">" + fields + "</prototype></points>";
}

std::string scaledFields(int least, int most) {
    std::string text;
    for (const char* axis : {"X", "Y", "Z"}) {
        text += "<cartesian" + std::string(axis) + " type=\"ScaledInteger\" minimum=\"" + std::to_string(least) + "\" maximum=\"" +
                std::to_string(most) + "\" scale=\"1e-3\" offset=\"0.5\"/>";
    }
    return text;
}

class E57Cloud : public testing::Test {
protected:
    TemporaryFolder m_folder;

    WholeCloud read(const CloudBytes& bytes) { return readCloud(layCloud(m_folder / "made.e57", bytes)); }
    std::string refusal(const CloudBytes& bytes) {
        try {
            read(bytes);
        } catch (const Error& error) {
            return error.message().id;
        }
        return "read";
    }
};

TEST_F(E57Cloud, ChecksumsAreThoseOfCastagnoli) {
    const std::string digits = "123456789";
    EXPECT_EQ(crc32c(reinterpret_cast<const unsigned char*>(digits.data()), digits.size()), 0xe3069283U);
}

TEST_F(E57Cloud, WholeNumbersOfAnyBitsKeepTheirValuesAcrossPackets) {
    for (const std::uint32_t bits : {1U, 3U, 8U, 13U, 19U, 31U}) {
        const int least = -(1 << (bits - 1));
        const int most = (1 << (bits - 1)) - 1;
        const std::uint64_t mask = (std::uint64_t{1} << bits) - 1;
        std::vector<MadeE57::Column> columns(3, {bits, {}});
        constexpr std::size_t count = 1000;
        for (std::size_t p = 0; p < count; ++p) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                columns[axis].raw.push_back((p * 2654435761U + axis * 40503U + 1) & mask);
            }
        }
        MadeE57 made;
        const std::uint64_t place = made.addPoints(columns, 77);
        const WholeCloud cloud = read(made.bytes(
            wrapped("<vectorChild type=\"Structure\">" + pointsXml(place, count, scaledFields(least, most)) + "</vectorChild>")));
        ASSERT_EQ(cloud.points.size(), count) << bits;
        for (std::size_t p = 0; p < count; ++p) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double whole = static_cast<double>(columns[axis].raw[p]) + least;
                ASSERT_EQ(cloud.points.places[p][static_cast<Eigen::Index>(axis)], whole * 1e-3 + 0.5) << bits << ' ' << p;
            }
        }
    }
}

TEST_F(E57Cloud, ScansStandWhereTheirPosesSay) {
    const auto real = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    MadeE57 made;
    const std::uint64_t first = made.addPoints({{64, {real(1.0)}}, {64, {real(2.0)}}, {64, {real(3.0)}}}, 1);
    // Marked as invalid; at the scanner, where nothing can be; sound.
    const std::uint64_t second = made.addPoints({{64, {real(9.0), real(0.0), real(1.0)}},
                                                 {64, {real(9.0), real(0.0), real(0.0)}},
                                                 {64, {real(9.0), real(0.0), real(0.0)}},
                                                 {2, {2, 0, 0}}},
                                                2);
    const std::string fields = "<cartesianX type=\"Float\"/><cartesianY type=\"Float\"/><cartesianZ type=\"Float\"/>";
    const std::string state = "<cartesianInvalidState type=\"Integer\" minimum=\"0\" maximum=\"2\"/>";
    // A quarter turn about z.
    const std::string pose =
        "<pose type=\"Structure\"><rotation type=\"Structure\"><w type=\"Float\">0.70710678118654757</w><x type=\"Float\"/>"
        "<y type=\"Float\"/><z type=\"Float\">0.70710678118654757</z></rotation><translation type=\"Structure\">"
        "<x type=\"Float\">100</x><y type=\"Float\">200</y><z type=\"Float\">3e+1</z></translation></pose>";
    const WholeCloud cloud =
        read(made.bytes(wrapped("<vectorChild type=\"Structure\">" + pointsXml(first, 1, fields) +
                                "</vectorChild><vectorChild type=\"Structure\"><name type=\"String\"><![CDATA[East & up]]>"
                                "</name>" +
                                pose + pointsXml(second, 3, fields + state) + "</vectorChild>")));
    ASSERT_EQ(cloud.points.size(), 2u);
    EXPECT_EQ(cloud.points.places[0], Vec3(1.0, 2.0, 3.0));
    EXPECT_NEAR((cloud.points.places[1] - Vec3(100.0, 201.0, 30.0)).norm(), 0.0, 1e-12);
    EXPECT_THAT(cloud.points.scans, testing::ElementsAre(0, 1));
    EXPECT_THAT(cloud.summary.scans, testing::ElementsAre(1u, 1u));
    EXPECT_EQ(cloud.summary.findings.count("cloud.invalid"), 1);
    EXPECT_EQ(cloud.summary.findings.count("cloud.no_return"), 1);
    ASSERT_EQ(cloud.head.scans.size(), 2u);
    EXPECT_FALSE(cloud.head.scans[0].pose.stated);
    EXPECT_EQ(cloud.head.scans[1].name, "East & up");
    EXPECT_EQ(cloud.head.scans[1].pose.position, Vec3(100.0, 200.0, 30.0));
    EXPECT_EQ(cloud.summary.findings.count("cloud.system_unknown"), 0) << "an E57 is in metres";
    EXPECT_EQ(cloud.summary.findings.count("cloud.pose_missing"), 1);
}

TEST_F(E57Cloud, ColumnsThatAreNotReadArePassedOver) {
    MadeE57 made;
    const std::uint64_t place =
        made.addPoints({{8, {1, 2, 3}}, {7, {5, 5, 5}}, {8, {4, 5, 6}}, {24, {9, 9, 9}}, {8, {7, 8, 9}}}, 2);
    const std::string fields =
        "<cartesianX type=\"Integer\" minimum=\"0\" maximum=\"255\"/>"
        "<own:quality type=\"Integer\" minimum=\"0\" maximum=\"100\"/>"
        "<cartesianY type=\"Integer\" minimum=\"0\" maximum=\"255\"/><own:label type=\"String\"/>"
        "<cartesianZ type=\"Integer\" minimum=\"0\" maximum=\"255\"/>";
    const WholeCloud cloud =
        read(made.bytes(wrapped("<vectorChild type=\"Structure\">" + pointsXml(place, 3, fields) + "</vectorChild>")));
    ASSERT_EQ(cloud.points.size(), 3u);
    EXPECT_EQ(cloud.points.places[2], Vec3(3.0, 6.0, 9.0));
    EXPECT_THAT(cloud.head.unread, testing::ElementsAre("own:quality", "own:label"));
}

TEST_F(E57Cloud, PublicFilesHoldWhatTheyAreKnownToHold) {
    const WholeCloud spherical = readCloud(publicE57("tiny_spherical.e57"));
    EXPECT_EQ(spherical.points.size(), 180u);
    EXPECT_EQ(spherical.summary.findings.count("cloud.invalid"), 180);
    for (const Vec3& place : spherical.points.places) {
        EXPECT_NEAR(place.norm(), 1.0, 0.5);
    }
    const WholeCloud merged = readCloud(publicE57("A_merged_B.e57"));
    EXPECT_EQ(merged.points.size(), 6u);
    EXPECT_EQ(merged.head.fullColour, 255.0);
    EXPECT_EQ(readCloud(publicE57("las2e57_no_images_tag.e57")).points.size(), 153u);
    EXPECT_THAT(readCloud(publicE57("scaled_integer_intensity.e57")).points.intensity,
                testing::ElementsAre(testing::FloatNear(-66.6F, 1e-5F), testing::FloatNear(66.6F, 1e-5F)));
    const WholeCloud states = readCloud(publicE57("cartesian_invalid_state_single.e57"));
    ASSERT_EQ(states.points.size(), 1u);
    EXPECT_EQ(states.points.places[0], Vec3(-1.0, -2.0, -3.0));
}

TEST_F(E57Cloud, PicturesInTheFileAreTakenOutWhole) {
    const std::string path = publicE57("tiny_pc_and_images.e57");
    const WholeCloud cloud = readCloud(path);
    ASSERT_EQ(cloud.head.photographs.size(), 4u);
    const CloudPhotograph& pinhole = cloud.head.photographs[2];
    EXPECT_EQ(pinhole.projection, "pinhole");
    EXPECT_EQ(pinhole.width, 100);
    EXPECT_EQ(pinhole.focal, 0.0) << "its pixels are 0.044 m wide and 0.033 m high";
    EXPECT_EQ(cloud.summary.findings.count("cloud.pixels_not_square"), 1);
    EXPECT_EQ(photographOfE57(path, pinhole).size(), 1073u);
    const CloudBytes png = photographOfE57(path, cloud.head.photographs[1]);
    EXPECT_EQ(std::string(png.begin() + 1, png.begin() + 4), "PNG");
    EXPECT_EQ(std::string(png.end() - 8, png.end() - 4), "IEND");
    const CloudBytes jpeg = photographOfE57(path, cloud.head.photographs[0]);
    EXPECT_EQ(jpeg[0], 0xff);
    EXPECT_EQ(jpeg.back(), 0xd9);
    // A rotation of length 1.1 in the file.
    EXPECT_EQ(cloud.summary.findings.count("cloud.pose_no_rotation"), 1);
}

TEST_F(E57Cloud, DamageIsNamed) {
    MadeE57 made;
    const std::uint64_t place = made.addPoints({{8, {1, 2, 3}}, {8, {1, 2, 3}}, {8, {1, 2, 3}}}, 3);
    const auto xml = [&](std::uint64_t at, std::size_t count) {
        return wrapped("<vectorChild type=\"Structure\">" + pointsXml(at, count, scaledFields(0, 255)) + "</vectorChild>");
    };
    const CloudBytes sound = made.bytes(xml(place, 3));
    EXPECT_EQ(refusal(sound), "read");
    CloudBytes flipped = sound;
    flipped[place + 40] ^= 1;
    EXPECT_EQ(refusal(flipped), "cloud.e57_checksum");
    const WholeCloud fewer = read(made.bytes(xml(place, 1'000'000'000)));
    EXPECT_EQ(fewer.points.size(), 3u);
    EXPECT_EQ(fewer.summary.findings.count("cloud.fewer_points"), 1);
    EXPECT_EQ(refusal(made.bytes(xml(place + 4, 3))), "cloud.e57_packet");
    EXPECT_EQ(refusal(made.bytes(xml(1'000'000, 3))), "cloud.cut");
    EXPECT_EQ(refusal(made.bytes("<e57Root><data3D>")), "cloud.e57_xml");
    CloudBytes cut = sound;
    cut.pop_back();
    EXPECT_EQ(refusal(cut), "cloud.cut");
    // Columns of no bits would give points without end.
    MadeE57 still;
    const std::uint64_t none = still.addPoints({{0, {0}}, {0, {0}}, {0, {0}}}, 1);
    const WholeCloud endless = read(still.bytes(wrapped(
        "<vectorChild type=\"Structure\">" + pointsXml(none, std::size_t{1} << 60, scaledFields(3, 3)) + "</vectorChild>")));
    EXPECT_LE(endless.points.size(), cloudBlockPoints);
    EXPECT_EQ(endless.summary.findings.count("cloud.fewer_points"), 1);
}

}  // namespace

}  // namespace rubble::io
