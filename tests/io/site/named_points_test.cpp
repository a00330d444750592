#include "io/site/surveys/named_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <sstream>

#include "core/base/error.h"
#include "io/site/point_pairs.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

using testing::HasSubstr;

class NamedPoints : public testing::Test {
protected:
    std::string lay(const char* name, const std::string& text) {
        std::ofstream(m_folder / name) << text;
        return m_folder / name;
    }
    std::vector<NamedPoint> read(const std::string& path) { return readNamedPoints(path, m_said, Execution()); }
    std::string refusal(const std::function<void()>& act) {
        try {
            act();
        } catch (const Error& error) {
            EXPECT_FALSE(error.remedy().empty());
            return englishText(error.message());
        }
        return "";
    }

    TemporaryFolder m_folder;
    Findings m_said;
};

TEST_F(NamedPoints, OfATableAreReadByItsHeadingInAnyOrder) {
    const auto points = read(lay("station.csv",
                                 "Northing;Point;Elevation;Easting;Code\n"
                                 "5400002,5;P1;101,25;500001,5;edge\n"
                                 "5400004;;102;500003;top\n"
                                 "5400006;P2;103;500004;top\n"));
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[1].name, "P2");
    EXPECT_EQ(points[0].place, Vec3(500001.5, 5400002.5, 101.25));
    EXPECT_EQ(m_said.count("control.unnamed"), 1);
}

TEST_F(NamedPoints, OfATableInFeetAreInMetres) {
    const auto points = read(lay("feet.csv", "Point,Easting (ft),Northing [ft],Height_m\nP1,10,20,3\n"));
    ASSERT_EQ(points.size(), 1u);
    EXPECT_EQ(points[0].place, Vec3(3.048, 6.096, 3.0));
    EXPECT_THAT(refusal([&] { read(lay("other.csv", "Point,x (varas),y,z\nP1,10,20,3\n")); }), HasSubstr("no unit of length"));
}

TEST_F(NamedPoints, OfADrawingAreCalledByTheTextBesideThem) {
    std::string text;
    const auto put = [&text](int code, const auto& value) {
        std::ostringstream line;
        line.precision(12);
        line << code << '\n' << value << '\n';
        text += line.str();
    };
    put(0, "SECTION");
    put(2, "ENTITIES");
    for (const auto& [x, z] : {std::pair(10.0, 101.0), std::pair(20.0, 102.0), std::pair(30.0, 103.0), std::pair(40.0, 0.0)}) {
        put(0, "POINT");
        put(8, "points");
        put(10, 500000.0 + x);
        put(20, 5400000.0);
        put(30, z);
    }
    // Beside the first, a little farther from it, too far from the third, beside the one without a height.
    for (const auto& [x, name] :
         {std::pair(10.3, "A"), std::pair(10.6, "B"), std::pair(20.2, "C"), std::pair(33.0, "D"), std::pair(40.1, "E")}) {
        put(0, "TEXT");
        put(8, "names");
        put(10, 500000.0 + x);
        put(20, 5400000.0);
        put(30, 0.0);
        put(40, 0.2);
        put(1, name);
    }
    put(0, "ENDSEC");
    put(0, "EOF");
    const auto points = read(lay("site.dxf", text));
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[0].name, "A");
    EXPECT_EQ(points[0].place, Vec3(500010.0, 5400000.0, 101.0));
    EXPECT_EQ(points[1].name, "C");
    EXPECT_EQ(m_said.count("control.unnamed"), 1);
    EXPECT_EQ(m_said.count("control.level"), 1);
}

TEST_F(NamedPoints, WhatTellsNoPointIsRefused) {
    EXPECT_THAT(refusal([&] { read(lay("a.csv", "Easting,Northing,Elevation\n1,2,3\n")); }),
                HasSubstr("does not name the columns"));
    EXPECT_THAT(refusal([&] { read(lay("b.csv", "1,500000,5400000,101\n2,500001,5400001,102\n")); }), HasSubstr("first line"));
    EXPECT_THAT(refusal([&] { read(lay("c.csv", "name,x_m,y_m,z_m\nA,1,2,3\nA,1,2,4\n")); }), HasSubstr("A twice"));
    EXPECT_THAT(refusal([&] { read(lay("d.csv", "name,x,y,z\nA,1,two,3\n")); }), HasSubstr("line 2 has \"two\""));
    EXPECT_THAT(refusal([&] { read(lay("e.dxf", "no drawing\n")); }), HasSubstr("DXF"));
    EXPECT_THAT(refusal([&] { read(lay("f.csv", "name,x,y,z\n")); }), HasSubstr("no point"));
}

TEST_F(NamedPoints, AreControlOfAPhotographByTheirNames) {
    const std::string picture = lay("picture.csv", "name,picture_x_px,picture_y_px\nP2,30,40\nP1,10,20\n");
    EXPECT_TRUE(needsNamedPoints(picture));
    EXPECT_FALSE(needsNamedPoints(lay("whole.csv", "name,picture_x_px,picture_y_px,x_m,y_m,z_m\nA,1,2,3,4,5\n")));
    const std::vector<NamedPoint> measured{{"P1", {500001, 5400002, 101}}, {"P2", {500003, 5400004, 102}}, {"P3", {0, 0, 0}}};
    const Vec3 origin(500000, 5400000, 100);
    const auto pairs = readPointPairs(picture, measured, [&](const Vec3& place) -> Vec3 { return place - origin; });
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_EQ(pairs[0].picture, Eigen::Vector2d(30, 40));
    EXPECT_EQ(pairs[0].model, Vec3(3, 4, 2));
    EXPECT_THAT(refusal([&] {
                    readPointPairs(lay("other.csv", "name,picture_x_px,picture_y_px\nP9,1,2\nP1,3,4\n"), measured,
                                   [](const Vec3& place) { return place; });
                }),
                HasSubstr("P9"));
}

TEST_F(NamedPoints, PairsOfASurveyThatWereWrittenAreReadBack) {
    Frame frame;
    frame.origin << 500000.0, 5400000.0, 100.0;
    Site site;
    site.heightShift = 45.5;
    const std::vector<PlacePair> pairs{{"1", {1, 2, 3}, {4, 5, 6}}, {"2", {-7.125, 8, 9}, {10, 11, 12.5}}};
    writePlacePairs(m_folder / "pairs.csv", pairs, frame, site);
    const PlacePairTable read = readPlacePairs(m_folder / "pairs.csv");
    EXPECT_TRUE(read.metres);
    ASSERT_EQ(read.pairs.size(), 2u);
    EXPECT_EQ(read.pairs[1].placed, Vec3(500010, 5400011, 112.5));
    EXPECT_FALSE(read.pairs[1].deviation);
    // As a survey has it: before the datum shift of the case is added.
    EXPECT_EQ(read.pairs[1].surveyed, Vec3(499992.875, 5400008, 109 - 45.5));
}

TEST_F(NamedPoints, PairsMayStateHowAccurateTheirPointsAre) {
    const std::string heading = "name,survey_x,survey_y,survey_z,x_m,y_m,z_m,deviation_m\n";
    const PlacePairTable read = readPlacePairs(lay("pairs.csv", heading + "a,1,2,3,4,5,6,0.02\nb,1,2,3,4,5,6,\n"));
    EXPECT_EQ(read.pairs[0].deviation, 0.02);
    EXPECT_FALSE(read.pairs[1].deviation);
    writePlacePairs(m_folder / "again.csv", read.pairs, {}, {});
    const PlacePairTable again = readPlacePairs(m_folder / "again.csv");
    EXPECT_EQ(again.pairs[0].deviation, 0.02);
    EXPECT_FALSE(again.pairs[1].deviation);
    EXPECT_THAT(refusal([&] { readPlacePairs(lay("pairs.csv", heading + "a,1,2,3,4,5,6,-0.02\n")); }), HasSubstr("below zero"));
}

}  // namespace

}  // namespace rubble::io
