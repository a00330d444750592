#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "io/site/clouds/pcd_cloud.h"
#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

using testing::ElementsAre;

class OtherCloud : public testing::Test {
protected:
    TemporaryFolder m_folder;

    template <class Content>
    WholeCloud read(const Content& content, const CloudRequest& request = {}) {
        return readCloud(layCloud(m_folder / "cloud", content), request);
    }
    template <class Content>
    std::string refusal(const Content& content, const CloudRequest& request = {}) {
        try {
            read(content, request);
        } catch (const Error& error) {
            return error.message().id;
        }
        return "read";
    }
};

CloudBytes bytesOf(const std::string& text) {
    return {text.begin(), text.end()};
}

/// Appends a number in little or big end first.
template <class Number>
void append(CloudBytes& bytes, Number number, bool big = false) {
    CloudBytes own(sizeof number);
    std::memcpy(own.data(), &number, sizeof number);
    if (big) {
        std::reverse(own.begin(), own.end());
    }
    bytes.insert(bytes.end(), own.begin(), own.end());
}

const std::vector<Vec3> places{{1.5, -2.25, 3.0}, {4'000'000.5, 5.0, 6.0}};

std::string plyHead(const std::string& format, const std::string& real) {
    return "ply\nformat " + format + " 1.0\nelement camera 1\nproperty float focal\nelement vertex 2\nproperty " + real +
           " x\nproperty " + real + " y\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty " + real +
           " z\nproperty float scalar_Intensity\nproperty float nx\nend_header\n";
}

TEST_F(OtherCloud, PlyIsTheSameAsTextAndInBytesOfEitherEnd) {
    std::string text = plyHead("ascii", "double") + "50\n";
    for (const Vec3& p : places) {
        text += std::to_string(p.x()) + " " + std::to_string(p.y()) + " 10 20 255 " + std::to_string(p.z()) + " 0.5 1\n";
    }
    const WholeCloud plain = read(text);
    EXPECT_EQ(plain.points.places, places);
    EXPECT_THAT(plain.points.colours[1], ElementsAre(10, 20, 255));
    EXPECT_THAT(plain.points.intensity, ElementsAre(0.5F, 0.5F));
    EXPECT_THAT(plain.head.unread, ElementsAre("nx"));
    for (const bool big : {false, true}) {
        CloudBytes bytes = bytesOf(plyHead(big ? "binary_big_endian" : "binary_little_endian", "double"));
        append(bytes, 50.0F, big);
        for (const Vec3& p : places) {
            append(bytes, p.x(), big);
            append(bytes, p.y(), big);
            bytes.insert(bytes.end(), {10, 20, 255});
            append(bytes, p.z(), big);
            append(bytes, 0.5F, big);
            append(bytes, 1.0F, big);
        }
        const WholeCloud stored = read(bytes);
        EXPECT_EQ(stored.points.places, plain.points.places) << big;
        EXPECT_EQ(stored.points.colours, plain.points.colours);
        EXPECT_EQ(stored.points.intensity, plain.points.intensity);
        EXPECT_EQ(stored.summary.findings.count("cloud.coarse"), 0);
        bytes.pop_back();
        EXPECT_EQ(read(bytes).points.size(), 1u);
        EXPECT_EQ(read(bytes).summary.findings.count("cloud.fewer_points"), 1);
    }
}

TEST_F(OtherCloud, CoordinatesInSinglePrecisionFarFromTheOriginAreSaid) {
    CloudBytes bytes = bytesOf(
        "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
        "z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n");
    append(bytes, 494'000.0F);
    append(bytes, 4'878'000.0F);
    append(bytes, 100.0F);
    const WholeCloud cloud = read(bytes);
    EXPECT_NEAR(cloud.head.step, 0.29, 0.01);
    EXPECT_EQ(cloud.summary.findings.count("cloud.coarse"), 1);
    EXPECT_EQ(cloud.summary.findings.count("cloud.faces_left"), 2);
    EXPECT_EQ(read(std::string("x,y,z\n4.94e5,4.878e6,100\n4.95e5,4.878e6,100\n")).summary.findings.count("cloud.coarse"), 1);
}

std::string pcdHead(const std::string& data) {
    return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z rgb normal intensity\nSIZE 8 8 8 4 4 2\n"
           "TYPE F F F F F U\nCOUNT 1 1 1 1 3 1\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 5 1 0 0 0\nPOINTS 2\nDATA " +
           data + "\n";
}

float packedColour(std::uint32_t rgb) {
    return std::bit_cast<float>(rgb);
}

/// LZF of literals alone, but for a run of zeros at the end.
CloudBytes packedByLzf(const CloudBytes& whole) {
    CloudBytes packed;
    for (std::size_t at = 0; at < whole.size();) {
        const std::size_t count = std::min<std::size_t>(32, whole.size() - at);
        packed.push_back(static_cast<unsigned char>(count - 1));
        packed.insert(packed.end(), whole.begin() + static_cast<std::ptrdiff_t>(at),
                      whole.begin() + static_cast<std::ptrdiff_t>(at + count));
        at += count;
    }
    return packed;
}

TEST_F(OtherCloud, PcdIsTheSameInItsThreeCodings) {
    std::string text = pcdHead("ascii");
    CloudBytes records = bytesOf(pcdHead("binary"));
    std::array<CloudBytes, 6> columns;
    for (const Vec3& p : places) {
        text += std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + " 660510 0 0 1 77\n";
        for (int axis = 0; axis < 3; ++axis) {
            append(records, p[axis]);
            append(columns[static_cast<std::size_t>(axis)], p[axis]);
        }
        append(records, packedColour(0x0a141e));
        append(columns[3], packedColour(0x0a141e));
        for (int k = 0; k < 3; ++k) {
            append(records, k == 2 ? 1.0F : 0.0F);
            append(columns[4], k == 2 ? 1.0F : 0.0F);
        }
        append(records, std::uint16_t{77});
        append(columns[5], std::uint16_t{77});
    }
    CloudBytes together;
    for (const CloudBytes& column : columns) {
        together.insert(together.end(), column.begin(), column.end());
    }
    CloudBytes packed = bytesOf(pcdHead("binary_compressed"));
    const CloudBytes lzf = packedByLzf(together);
    append(packed, static_cast<std::uint32_t>(lzf.size()));
    append(packed, static_cast<std::uint32_t>(together.size()));
    packed.insert(packed.end(), lzf.begin(), lzf.end());
    for (const CloudBytes& file : {bytesOf(text), records, packed}) {
        const WholeCloud cloud = read(file);
        EXPECT_EQ(cloud.head.format, "PCD");
        EXPECT_EQ(cloud.points.places, places) << cloud.head.coding;
        EXPECT_THAT(cloud.points.colours[0], ElementsAre(10, 20, 30)) << cloud.head.coding;
        EXPECT_THAT(cloud.points.intensity, ElementsAre(77.0F, 77.0F));
        ASSERT_EQ(cloud.head.scans.size(), 1u);
        EXPECT_EQ(cloud.head.scans[0].pose.position, Vec3(0.0, 0.0, 5.0));
        EXPECT_EQ(cloud.summary.findings.count("cloud.viewpoint"), 1);
    }
    packed.pop_back();
    EXPECT_EQ(refusal(packed), "cloud.cut");
}

TEST_F(OtherCloud, LzfCopiesFromWhatItUnpacked) {
    CloudBytes unpacked(20);
    // "ab", then 10 bytes from 2 back, then 8 bytes from 1 back.
    EXPECT_TRUE(unpackLzf({1, 'a', 'b', 7 << 5, 1, 1, 6 << 5, 0}, unpacked));
    EXPECT_EQ(std::string(unpacked.begin(), unpacked.end()),
              "abababababab"
              "bbbbbbbb");
    EXPECT_FALSE(unpackLzf({1, 'a', 'b', 7 << 5, 1, 9}, unpacked)) << "from before the beginning";
    EXPECT_FALSE(unpackLzf({1, 'a', 'b'}, unpacked)) << "too few";
    EXPECT_FALSE(unpackLzf({31, 'a'}, unpacked));
    EXPECT_FALSE(unpackLzf({0, 'a', 7 << 5}, unpacked));
}

TEST_F(OtherCloud, PtxScansAreBroughtToTheirPlaces) {
    const std::string matrix = "0 1 0 0\n-1 0 0 0\n0 0 1 0\n";
    const std::string scan = "2\n1\n10 20 30\n0 1 0\n-1 0 0\n0 0 1\n" + matrix + "10 20 30 1\n";
    const WholeCloud cloud = read(scan + "1 0 0 0.5 1 2 3\n0 0 0 0.5 0 0 0\n" + scan + "0 2 1 0.25 9 8 7\n1 1 1 0.5 1 1 1\n");
    ASSERT_EQ(cloud.points.size(), 3u);
    // x goes to y, as the rows of the matrix say.
    EXPECT_EQ(cloud.points.places[0], Vec3(10.0, 21.0, 30.0));
    EXPECT_EQ(cloud.points.places[1], Vec3(8.0, 20.0, 31.0));
    EXPECT_THAT(cloud.points.scans, ElementsAre(0, 1, 1));
    EXPECT_THAT(cloud.points.colours[1], ElementsAre(9, 8, 7));
    EXPECT_EQ(cloud.summary.findings.count("cloud.no_return"), 1);
    EXPECT_EQ(cloud.head.scans[0].pose.position, Vec3(10.0, 20.0, 30.0));
    EXPECT_NEAR((cloud.head.scans[0].pose * Vec3(1.0, 0.0, 0.0) - Vec3(10.0, 21.0, 30.0)).norm(), 0.0, 1e-12);
    EXPECT_EQ(read(scan + "1 0 0 0.5 1 2 3\n").summary.findings.count("cloud.fewer_points"), 1);
    // The first scan ends a line too soon: what follows is the head of the second, and no point.
    const WholeCloud early = read(scan + "1 0 0 0.5 1 2 3\n" + scan + "0 2 1 0.25 9 8 7\n1 1 1 0.5 1 1 1\n");
    EXPECT_EQ(early.points.places, cloud.points.places);
    EXPECT_EQ(early.summary.findings.count("cloud.fewer_points"), 1);
    EXPECT_EQ(refusal("2\n1\n10 20 30\n0 1\n"), "cloud.ptx");
    EXPECT_EQ(refusal("100000000000\n100000000000\n" + scan.substr(4)), "cloud.ptx");
}

TEST_F(OtherCloud, PtsTellsItsColumnsByTheirNumber) {
    const WholeCloud all = read(std::string("2\n1 2 3 -100 10 20 30\n4 5 6 2047 1 1 1\n1\n7 8 9 0 2 2 2\n"));
    EXPECT_EQ(all.head.format, "PTS");
    EXPECT_THAT(all.points.intensity, ElementsAre(-100.0F, 2047.0F, 0.0F));
    EXPECT_THAT(all.points.colours[0], ElementsAre(10, 20, 30));
    EXPECT_EQ(all.head.promised, 3u);
    EXPECT_EQ(all.summary.findings.count("cloud.fewer_points"), 0);
    EXPECT_TRUE(read(std::string("1\n1 2 3 4 5 6\n")).points.intensity.empty());
    EXPECT_EQ(read(std::string("9\n1 2 3\n")).summary.findings.count("cloud.fewer_points"), 1);
}

TEST_F(OtherCloud, TablesNameTheirColumnsOrAreAskedTo) {
    const WholeCloud named = read(std::string("Time;Northing;Easting;Height;Class\n1,5;2,5;1,25;3;2\n2;5;4;6,125;7\n"));
    ASSERT_EQ(named.points.size(), 1u);
    EXPECT_EQ(named.points.places[0], Vec3(1.25, 2.5, 3.0));
    EXPECT_EQ(named.summary.findings.count("cloud.noise"), 1);
    const WholeCloud cloudCompare = read(std::string("//X Y Z R G B\n1 2 3 255 0 9\n"));
    EXPECT_THAT(cloudCompare.points.colours[0], ElementsAre(255, 0, 9));
    EXPECT_EQ(cloudCompare.head.fullColour, 255.0);
    const WholeCloud wide = read(std::string("X,Y,Z,Red,Green,Blue\n1,2,3,40960,0,9\n"));
    EXPECT_THAT(wide.points.colours[0], ElementsAre(40960, 0, 9));
    EXPECT_EQ(wide.head.fullColour, 65535.0);
    const WholeCloud shares = read(std::string("X,Y,Z,Red,Green,Blue\n1,2,3,0.5,0,1\n"));
    EXPECT_THAT(shares.points.colours[0], ElementsAre(128, 0, 255));
    const WholeCloud bare = read(std::string("1 2 3 4\n5 6 7 8\n\n# words\n9 10 11\nnan 1 1\n1 2\n"));
    EXPECT_EQ(bare.points.size(), 3u);
    EXPECT_EQ(bare.summary.findings.count("cloud.columns_assumed"), 1);
    EXPECT_EQ(bare.summary.findings.count("cloud.not_finite"), 1);
    EXPECT_EQ(bare.summary.findings.count("cloud.lines_unread"), 1);
    const WholeCloud marked =
        read(std::string("\xef\xbb\xbf"
                         "1,2,3\r\n4,5,6\r\n"));
    EXPECT_EQ(marked.points.size(), 2u) << "behind the mark of UTF-8";
    CloudRequest request;
    request.columns = {"skip", "z", "y", "x", "intensity"};
    const WholeCloud asked = read(std::string("0,1,2,3,4\n0,5,6,7,8\n"), request);
    EXPECT_EQ(asked.points.places[0], Vec3(3.0, 2.0, 1.0));
    EXPECT_EQ(asked.points.intensity[1], 8.0F);
    EXPECT_EQ(asked.summary.findings.count("cloud.columns_assumed"), 0);
    request.columns = {"x", "y", "height of fall"};
    EXPECT_EQ(refusal("1 2 3\n", request), "cloud.column_unknown");
    request.columns = {"x", "y"};
    EXPECT_EQ(refusal("1 2 3\n", request), "cloud.columns_without_place");
}

TEST_F(OtherCloud, WhereColumnsAreGivenOnlyALineWithoutAPlaceIsAHeading) {
    CloudRequest request;
    request.columns = {"skip", "y", "x", "z", "skip"};
    const std::string points = "101,5400001.5,500002.5,12.25,TOPO\n102,5400003,500004,12.5,EDGE\n";
    const WholeCloud bare = read(points, request);
    ASSERT_EQ(bare.points.size(), 2u) << "words in other columns make no heading";
    EXPECT_EQ(bare.points.places[0], Vec3(500002.5, 5400001.5, 12.25));
    const WholeCloud headed = read("P,N,E,Z,D\n" + points, request);
    EXPECT_EQ(headed.points.places, bare.points.places);
    EXPECT_EQ(headed.summary.findings.count("cloud.lines_unread"), 0);
    EXPECT_EQ(read("P,N (ft),E (ft),Z (ft),D\n" + points, request).head.units.metres, 0.3048) << "a unit counts in any case";
}

TEST_F(OtherCloud, LinesThatAreNoPointsAreCountedWithTheirPlace) {
    const WholeCloud table = read(std::string("# made by hand\nx,y,z\n1,2,3\n4,five,6\n7,8\n\n9,10,11\n12,,13\n"));
    EXPECT_EQ(table.points.size(), 2u);
    EXPECT_EQ(table.summary.findings.count("cloud.lines_unread"), 3);
    EXPECT_EQ(table.summary.findings.count("cloud.not_finite"), 0) << "a word is no number, not one that is not finite";
    const auto line = [](const WholeCloud& cloud) {
        for (const Finding& finding : cloud.summary.findings.list()) {
            if (finding.what.id == "cloud.lines_unread") {
                return englishText(finding.what);
            }
        }
        return std::string();
    };
    EXPECT_THAT(line(table), testing::HasSubstr("the first of them line 4:"));
    const std::string head = "2\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
    EXPECT_THAT(line(read(head + "1 2 3 0.5\n1 2")), testing::HasSubstr("the first of them line 12:"));
}

TEST_F(OtherCloud, HeadingsNameTheUnitsOfTheirColumns) {
    for (const char* heading :
         {"Easting (m),Northing [m],Height (metres)", "x_m,y_m,z_m", "X(M),Y(M),Z(M)", "E (m),N (m),Elevation_m"}) {
        const WholeCloud metres = read(std::string(heading) + "\n1,2,3\n");
        ASSERT_EQ(metres.points.size(), 1u) << heading;
        EXPECT_TRUE(metres.head.units.metresStated && metres.head.units.heightStated);
        EXPECT_EQ(metres.summary.metres.max(), Vec3(1.0, 2.0, 3.0));
        EXPECT_EQ(metres.summary.findings.count("cloud.system_unknown"), 0);
    }
    const WholeCloud feet = read(std::string("Easting (ft) Northing (ft) Height (m)\n10 20 3\n"));
    EXPECT_EQ(feet.summary.metres.max(), Vec3(3.048, 6.096, 3.0)) << "each by its own unit, also where blanks part the columns";
    const WholeCloud survey = read(std::string("x_us_ft,y_us_ft,z_us_ft\n3937,0,3937\n"));
    EXPECT_NEAR((survey.summary.metres.max() - Vec3(1200.0, 0.0, 1200.0)).norm(), 0.0, 1e-9);
    EXPECT_EQ(read(std::string("x_ft,y_ft,z\n1,2,3\n")).summary.findings.count("cloud.height_unit_assumed"), 1);
    EXPECT_EQ(refusal("x (varas),y (varas),z (m)\n1,2,3\n"), "cloud.unit_unknown");
    EXPECT_EQ(refusal("x_ft,y_m,z_m\n1,2,3\n"), "cloud.units_of_plan");
    CloudRequest request;
    request.crs = "EPSG:25832";
    EXPECT_EQ(refusal("x_ft,y_ft,z_ft\n1,2,3\n", request), "cloud.unit_differs");
    EXPECT_EQ(read(std::string("x_m,y_m,z_ft\n1,2,10\n"), request).summary.metres.max().z(), 3.048);
    request.crs = "EPSG:2277";  // US survey feet
    EXPECT_NEAR(read(std::string("x_ft,y_ft,z_ft\n10,10,10\n"), request).summary.metres.max().x(), 3.0480061, 1e-6);
    request.crs = "EPSG:4326";
    EXPECT_EQ(refusal("x_m,y_m,z_m\n1,2,3\n", request), "cloud.unit_differs");
}

TEST_F(OtherCloud, OtherFilesAreNoClouds) {
    for (const std::string& other : {std::string("hello world\n"),
                                     std::string("\x7f"
                                                 "ELF\0\1\2",
                                                 7),
                                     std::string("a,b,c\n1,2,3\n"), std::string("{\"x\": 1}\n"), std::string("\n\n")}) {
        EXPECT_EQ(refusal(other), "cloud.unknown") << other;
    }
    EXPECT_EQ(refusal(""), "cloud.empty");
    EXPECT_EQ(refusal(std::string(200'000, '1')), "cloud.unknown");
    EXPECT_THROW(openCloud(m_folder / "nothing.las"), WorldError);
    EXPECT_THROW(openCloud(m_folder.path()), WorldError);
}

TEST_F(OtherCloud, HeadsThatLieEndInWords) {
    EXPECT_EQ(refusal("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n1\n"), "cloud.ply");
    EXPECT_EQ(refusal("ply\nformat ascii 1.0\nelement face 3\nproperty float x\nend_header\n1\n"), "cloud.ply");
    EXPECT_EQ(refusal("VERSION 0.7\nFIELDS x y z\nSIZE 4 4 3\nTYPE F F F\nCOUNT 1 1 1\nDATA ascii\n"), "cloud.pcd");
    EXPECT_EQ(refusal("VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 99999999999999\nDATA binary\n"),
              "cloud.pcd");
    const std::string head = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1000000000\nHEIGHT 1000\n";
    EXPECT_EQ(read(head + "DATA ascii\n1 2 3\n").summary.findings.count("cloud.fewer_points"), 1);
    EXPECT_EQ(read(head + "DATA binary\n123456789012").points.size(), 1u);
    EXPECT_EQ(refusal(head + std::string("DATA binary_compressed\n\x10\0\0\0\xff\xff\xff\x7f", 31)), "cloud.pcd");
}

}  // namespace

}  // namespace rubble::io
