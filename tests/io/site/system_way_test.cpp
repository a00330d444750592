#include "io/site/system_way.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <fstream>

#include "io/case/terrain_reader.h"
#include "io/site/outline_file.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

SystemWay wayBetween(const std::string& from, const std::string& to, const Eigen::Vector2d& degrees) {
    OGRSpatialReference a;
    OGRSpatialReference b;
    EXPECT_TRUE(setFromText(a, from));
    EXPECT_TRUE(setFromText(b, to));
    return systemWay(a, b, degrees);
}

TEST(SystemWay, ProjIsAskedForItsAccuracy) {
    EXPECT_FALSE(wayBetween("EPSG:25832", "EPSG:25833", {9.0, 51.0}).changes) << "one datum";
    EXPECT_FALSE(wayBetween("EPSG:4258", "EPSG:25832", {7.0, 51.0}).changes);
    EXPECT_FALSE(wayBetween("EPSG:25832", "EPSG:25832", {7.0, 51.0}).changes);
    const SystemWay metre = wayBetween("EPSG:4326", "EPSG:25832", {7.0, 51.0});
    EXPECT_TRUE(metre.changes);
    EXPECT_NEAR(metre.accuracy, 1.0, 0.01) << metre.operation;
    // The grid of Great Britain is no part of PROJ itself; where somebody installed it, places are exact.
    const SystemWay britain = wayBetween("EPSG:4326", "EPSG:27700", {1.716, 52.658});
    if (britain.missingGrids.empty()) {
        EXPECT_LE(britain.accuracy, 1.1);
    } else {
        EXPECT_EQ(britain.missingGrids.front().find("uk_os_OSTN15"), 0u) << britain.missingGrids.front();
        EXPECT_GT(britain.accuracy, 1.5);
        EXPECT_LT(britain.bestAccuracy, britain.accuracy);
    }
}

class SystemsOfFiles : public testing::Test {
protected:
    TemporaryFolder folder;
    Frame frame;

    Findings outline(const std::string& system, const std::string& corners) {
        const std::string path = folder / "a.geojson";
        const std::string crs =
            system.empty() ? "" : R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::)" + system + R"("}},)";
        std::ofstream(path) << R"({"type":"FeatureCollection",)" << crs
                            << R"("features":[{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[)"
                            << corners << "]]}}]}";
        return readOutline(path, frame, Site(), true, Execution())->findings;
    }
};

TEST_F(SystemsOfFiles, AnOutlineSaysHowWellItLies) {
    frame.crs = "EPSG:27700";
    frame.origin = {651400, 313170, 0};
    const Findings found = outline("4326", "[1.71607,52.65800],[1.71608,52.65800],[1.71608,52.65801],[1.71607,52.65800]");
    const auto said = found.count("site.grid_missing") + found.count("site.way_accuracy");
    EXPECT_EQ(said, 1) << "good to metres without the grid, to one metre with it: WGS 84 itself is no better known";
    frame.crs = "EPSG:25832";
    frame.origin = {356500, 5699500, 0};
    EXPECT_EQ(outline("25832", "[356500,5699500],[356520,5699500],[356520,5699520],[356500,5699500]").list().size(), 0u);
}

TEST_F(SystemsOfFiles, ACaseWithoutASystemIsTold) {
    frame.origin = {356500, 5699500, 0};
    const std::string corners = "[356500,5699500],[356520,5699500],[356520,5699520],[356500,5699500]";
    EXPECT_EQ(outline("25832", corners).count("site.system_assumed"), 1);
    const std::string path = folder / "a.tif";
    GDALAllRegister();
    const auto write = [&](const char* system) {
        GDALDatasetUniquePtr file(
            GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), 8, 8, 1, GDT_Float32, nullptr));
        std::array<double, 6> place{356496.0, 1.0, 0.0, 5699504.0, 0.0, -1.0};
        file->SetGeoTransform(place.data());
        OGRSpatialReference crs;
        if (setFromText(crs, system)) {
            file->SetSpatialRef(&crs);
        }
        file->GetRasterBand(1)->SetUnitType("m");
        ASSERT_EQ(file->GetRasterBand(1)->Fill(3.0), CE_None);
    };
    const auto found = [&](const char* id) { return openTerrain(path, frame, Aabb(), Execution()).findings.count(id); };
    write("EPSG:25832");
    EXPECT_EQ(found("site.system_assumed"), 1);
    write("");
    EXPECT_EQ(found("site.system_assumed"), 0);
    frame.crs = "EPSG:25832";
    EXPECT_EQ(found("terrain.crs_unknown"), 1);
    // Ellipsoidal heights are named, so that they are not taken for those of a case above the sea.
    frame.crs = "EPSG:25832+7837";
    write("EPSG:25832+7837");
    EXPECT_EQ(found("terrain.other_datum"), 0);
    write("EPSG:5555");
    EXPECT_EQ(openTerrain(path, frame, Aabb(), Execution()).verticalDatum, "DHHN92 height");
}

}  // namespace
}  // namespace rubble::io
