#include "io/site/place_check.h"

#include <gtest/gtest.h>

namespace rubble::io {
namespace {

class PlaceOfACase : public testing::Test {
protected:
    Frame frame;
    Site site;

    void SetUp() override { frame.crs = "EPSG:25832"; }
    void tie(std::vector<std::pair<Vec3, Vec3>> pairs) {
        site.controlPoints.clear();
        for (const auto& [local, world] : pairs) {
            site.controlPoints.push_back({"P" + std::to_string(site.controlPoints.size()), local, world, true});
        }
    }
    /// Four corners of a site at a place, its y to the north or to the south.
    void tieSquare(const Vec3& at, double north = 1.0) {
        tie({{Vec3(0, 0, 0), at},
             {Vec3(100, 0, 0), at + Vec3(100, 0, 0)},
             {Vec3(0, 50, 0), at + Vec3(0, 50 * north, 0)},
             {Vec3(100, 50, 0), at + Vec3(100, 50 * north, 0)}});
    }
    std::string found() const {
        std::string ids;
        const Findings all = checkPlace(frame, site);
        for (const Finding& finding : all.list()) {
            ids += (ids.empty() ? "" : " ") + finding.what.id;
            said = englishText(finding.what);
        }
        return ids;
    }
    mutable std::string said;
};

const Vec3 essen(356500, 5699500, 120);

TEST_F(PlaceOfACase, WhatIsRightIsNotSpokenOf) {
    tieSquare(essen);
    EXPECT_EQ(found(), "");
    site.controlPoints[1].world.x() += 0.2;
    EXPECT_EQ(found(), "") << "two decimetres in a hundred metres";
    frame.crs.clear();
    EXPECT_EQ(found(), "");
    site.controlPoints.clear();
    EXPECT_EQ(found(), "");
    frame.crs = "EPSG:25832";
    frame.origin = {356500, 5699500, 0};
    EXPECT_EQ(found(), "");
    frame.crs = "+proj=tmerc +lon_0=7 +ellps=GRS80 +x_0=356500 +y_0=0";
    EXPECT_EQ(found(), "") << "without an area of use";
}

TEST_F(PlaceOfACase, ResidualsAndMirrorsAreTold) {
    tieSquare(essen, -1.0);
    EXPECT_EQ(found(), "site.mirrored");
    tieSquare(essen);
    for (ControlPoint& point : site.controlPoints) {
        std::swap(point.local.x(), point.local.y());
    }
    EXPECT_EQ(found(), "site.mirrored") << "x and y changed for each other";
    tieSquare(essen);
    site.controlPoints[3].world += Vec3(4.0, 0.0, 0.0);
    EXPECT_NE(found().find("site.residual"), std::string::npos);
    EXPECT_NE(found().find("site.scale"), std::string::npos) << "it pulls the scale along";
    tieSquare(essen);
    site.controlPoints[2].world.z() = 0.0;
    EXPECT_EQ(found(), "site.height_residual");
    EXPECT_NE(said.find("\"P2\" is 90 m off"), std::string::npos) << said;
}

TEST_F(PlaceOfACase, OtherUnitsAreTold) {
    frame.crs.clear();
    tie({{Vec3(0, 0, 0), essen}, {Vec3(100, 0, 0), essen + Vec3(328.083, 0, 0)}});
    EXPECT_EQ(found(), "site.scale");
    EXPECT_NE(said.find("0.3048 times"), std::string::npos) << "a model in metres is too small among feet: " << said;
    frame.crs = "EPSG:2263";
    tie({{Vec3(0, 0, 0), Vec3(990000, 200000, 32.8)}, {Vec3(100, 0, 0), Vec3(990328.0833333, 200000, 32.8)}});
    EXPECT_EQ(found(), "site.not_metres site.scale");
    const double foot = 1200.0 / 3937.0;
    for (ControlPoint& point : site.controlPoints) {
        point.world *= foot;
    }
    EXPECT_EQ(found(), "") << "metres in a system that counts in feet";
    site.controlPoints.pop_back();
    EXPECT_EQ(found(), "site.untied site.one_point");
}

TEST_F(PlaceOfACase, PlacesOutsideTheSystemAreTold) {
    tie({{Vec3(0, 0, 0), Vec3(5699500, 356500, 0)}, {Vec3(100, 0, 0), Vec3(5699500, 356600, 0)}});
    EXPECT_EQ(found(), "site.swapped");
    tieSquare(Vec3(356500, 699500, 0));
    EXPECT_EQ(found(), "site.outside_area");
    tieSquare(Vec3(356500, 1e8, 0));
    EXPECT_TRUE(found() == "site.nowhere" || found() == "site.outside_area") << found();
    site.controlPoints.clear();
    EXPECT_EQ(found(), "site.untied");
    frame.origin = {5699500, 356500, 0};
    EXPECT_EQ(found(), "site.swapped") << "by the origin of the frame alone";
    // Across the date line.
    frame.crs = "EPSG:3832";
    frame.origin = {3000000, -2000000, 0};
    EXPECT_EQ(found().find("outside_area"), std::string::npos) << found();
}

TEST_F(PlaceOfACase, SystemsThatCannotPlaceACaseAreTold) {
    frame.origin = {356500, 5699500, 0};
    frame.crs = "EPSG:nothing";
    EXPECT_EQ(found(), "site.system_unknown");
    frame.crs = "EPSG:4326";
    EXPECT_EQ(found(), "site.system_in_degrees");
    frame.crs = "EPSG:4978";
    EXPECT_EQ(found(), "site.system_in_degrees");
    // Lengths of the web's projection are those of the equator.
    frame.crs = "EPSG:3857";
    frame.origin = {771000, 6699000, 0};
    EXPECT_EQ(found(), "site.stretched");
    EXPECT_NE(said.find("1.6"), std::string::npos) << said;
    tie({{Vec3(0, 0, 0), Vec3(771000, 6699000, 0)}, {Vec3(100, 0, 0), Vec3(771160.6, 6699000, 0)}});
    EXPECT_EQ(found(), "") << "points take the stretch up";
}

}  // namespace
}  // namespace rubble::io
