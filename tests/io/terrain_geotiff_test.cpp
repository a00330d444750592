#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <filesystem>
#include <functional>
#include <vector>

#include "core/base/error.h"
#include "io/case/terrain_reader.h"
#include "tests/support/error_id.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

/// A GeoTIFF as the tests want it.
struct Tiff {
    int columns = 40;
    int rows = 30;
    std::array<double, 6> place{-20.0, 1.0, 0.0, 15.0, 0.0, -1.0};
    int bands = 1;
    std::string crs;
    std::string heightUnit = "metre";
    double noData = -9999.0;
    double scale = 1.0;
    double offset = 0.0;
    GDALColorInterp meaning = GCI_GrayIndex;
    bool placed = true;
    std::string ourBand;                           ///< name of the bands of a map of our own; empty: it is none
    std::function<double(double, double)> height;  ///< of easting and northing in units of the file

    void write(const std::string& path) const {
        GDALAllRegister();
        GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
        GDALDatasetUniquePtr file(driver->Create(path.c_str(), columns, rows, bands, GDT_Float64, nullptr));
        std::array<double, 6> g = place;
        if (placed) {
            file->SetGeoTransform(g.data());
        }
        if (!ourBand.empty()) {
            file->SetMetadataItem("RUBBLE_CLASS", "debris map");
        }
        if (!crs.empty()) {
            OGRSpatialReference system;
            system.SetFromUserInput(crs.c_str());
            file->SetSpatialRef(&system);
        }
        for (int b = 1; b <= bands; ++b) {
            GDALRasterBand* band = file->GetRasterBand(b);
            band->SetNoDataValue(noData);
            band->SetUnitType(heightUnit.c_str());
            band->SetScale(scale);
            band->SetOffset(offset);
            band->SetColorInterpretation(meaning);
            band->SetDescription(ourBand.c_str());
            for (int r = 0; r < rows; ++r) {
                std::vector<double> row;
                for (int c = 0; c < columns; ++c) {
                    row.push_back(height(place[0] + place[1] * (c + 0.5), place[3] + place[5] * (r + 0.5)) + 100.0 * (b - 1));
                }
                EXPECT_EQ(band->RasterIO(GF_Write, 0, r, columns, 1, row.data(), columns, 1, GDT_Float64, 0, 0, nullptr), CE_None);
            }
        }
    }
};

double planeOfTiff(double x, double y) {
    return 2.0 + 0.1 * x - 0.05 * y;
}

class TerrainGeoTiff : public testing::Test {
protected:
    TemporaryFolder folder;
    std::string path = folder / "terrain.tif";
    Frame frame;
    Aabb around{Vec3(-2.0, -1.0, 2.0), Vec3(2.0, 1.0, 5.0)};
    Tiff tiff;

    void SetUp() override { tiff.height = planeOfTiff; }
    TerrainInput read() {
        tiff.write(path);
        return openTerrain(path, frame, around, Execution());
    }
    std::string refusal() {
        return idOfError([this] { read(); });
    }
    void expectPlane(const TerrainInput& terrain, double tolerance = 1e-9) {
        for (const double x : {-9.7, -1.0, 0.25, 9.5}) {
            for (const double y : {-8.9, 0.0, 7.3}) {
                EXPECT_NEAR(terrain.grid->height(x, y), planeOfTiff(x, y), tolerance) << x << " " << y;
            }
        }
    }
};

TEST_F(TerrainGeoTiff, NorthUpIsTheUsualWay) {
    const TerrainInput terrain = read();
    expectPlane(terrain);
    EXPECT_TRUE(terrain.findings.empty());
}

TEST_F(TerrainGeoTiff, RowsAndColumnsMayRunEitherWay) {
    tiff.place = {-20.0, 1.0, 0.0, -15.0, 0.0, 1.0};
    expectPlane(read());
    tiff.place = {20.0, -1.0, 0.0, 15.0, 0.0, -1.0};
    expectPlane(read());
    tiff.place = {20.0, -1.0, 0.0, -15.0, 0.0, 1.0};
    expectPlane(read());
}

TEST_F(TerrainGeoTiff, CellsThatAreNotSquareAreResampled) {
    tiff.rows = 120;
    tiff.place = {-20.0, 1.0, 0.0, 15.0, 0.0, -0.25};
    const TerrainInput terrain = read();
    EXPECT_EQ(terrain.grid->cell(), 0.25);
    EXPECT_EQ(terrain.findings.count("terrain.not_square"), 1);
    expectPlane(terrain);
}

TEST_F(TerrainGeoTiff, CellsBeyondAllProportionAreRefused) {
    tiff.place = {-20.0, 1e200, 0.0, 0.5, 0.0, -1e-200};
    EXPECT_EQ(refusal(), "terrain.elsewhere");
    tiff.place = {-5e199, 1e200, 0.0, 15.0, 0.0, -1.0};
    EXPECT_EQ(refusal(), "terrain.strip");
}

TEST_F(TerrainGeoTiff, FeetAreConverted) {
    tiff.height = [](double x, double y) { return planeOfTiff(x, y) / 0.3048; };
    tiff.heightUnit = "ft";
    const TerrainInput terrain = read();
    expectPlane(terrain);
    EXPECT_TRUE(terrain.findings.empty());
    tiff.heightUnit = "US survey foot";
    tiff.height = [](double x, double y) { return planeOfTiff(x, y) * 3937.0 / 1200.0; };
    expectPlane(read());
    tiff.heightUnit = "cubit";
    EXPECT_EQ(read().findings.count("terrain.height_unit_unknown"), 1);
}

TEST_F(TerrainGeoTiff, ACoordinateSystemInFeetIsConvertedToo) {
    constexpr double foot = 1200.0 / 3937.0;
    // California zone 3 in US survey feet.
    tiff.crs = "EPSG:2227";
    tiff.place = {-20.0 / foot, 1.0 / foot, 0.0, 15.0 / foot, 0.0, -1.0 / foot};
    tiff.height = [](double x, double y) { return planeOfTiff(foot * x, foot * y); };
    const TerrainInput terrain = read();
    EXPECT_NEAR(terrain.grid->cell(), 1.0, 1e-9);
    expectPlane(terrain);
}

TEST_F(TerrainGeoTiff, ScaleAndOffsetAreApplied) {
    tiff.scale = 0.01;
    tiff.offset = 50.0;
    tiff.height = [](double x, double y) { return (planeOfTiff(x, y) - 50.0) / 0.01; };
    expectPlane(read());
}

TEST_F(TerrainGeoTiff, OfSeveralBandsTheFirstIsTaken) {
    tiff.bands = 2;
    const TerrainInput terrain = read();
    expectPlane(terrain);
    EXPECT_EQ(terrain.findings.count("terrain.bands"), 1);
}

TEST_F(TerrainGeoTiff, GapsAreTheValuesThatTheFileNames) {
    tiff.noData = 7777.0;
    tiff.height = [](double x, double y) { return x > 3.0 && x < 6.0 && y > 0.0 ? 7777.0 : planeOfTiff(x, 0.0); };
    const TerrainInput terrain = read();
    EXPECT_EQ(terrain.findings.count("terrain.filled"), 3 * 15);
    EXPECT_LT(terrain.grid->highest(), 10.0);
}

TEST_F(TerrainGeoTiff, PicturesAndDegreesWithoutASystemAreRefused) {
    tiff.meaning = GCI_RedBand;
    EXPECT_EQ(refusal(), "terrain.picture");
    tiff.meaning = GCI_GrayIndex;
    tiff.crs = "EPSG:4326";
    EXPECT_EQ(refusal(), "terrain.degrees");
    tiff.crs = "";
    tiff.place = {-20.0, 1.0, 1.0, 15.0, -1.0, -1.0};
    EXPECT_EQ(refusal(), "terrain.flat_place");
}

TEST_F(TerrainGeoTiff, WhatHasNoPlaceAtTheSiteIsRefused) {
    tiff.placed = false;
    EXPECT_EQ(refusal(), "terrain.no_place");
    tiff.placed = true;
    tiff.crs = "EPSG:4326";
    frame.crs = "no system";
    EXPECT_EQ(refusal(), "terrain.degrees_unknown");
    frame.crs = "EPSG:32633";
    frame.origin << 451000, 5311000, 0;
    // Latitudes beyond the poles.
    tiff.place = {14.0, 0.1, 0.0, 700.0, 0.0, -0.1};
    EXPECT_EQ(refusal(), "terrain.nowhere");
    // Cells of a kilometre, turned, about a site of sixty metres.
    frame = Frame();
    tiff.crs.clear();
    tiff.place = {-20000.0, 1000.0, 100.0, 15000.0, 100.0, -1000.0};
    EXPECT_EQ(refusal(), "terrain.coarse");
}

TEST_F(TerrainGeoTiff, MapsOfOurOwnAreNoGround) {
    tiff.ourBand = "height";
    EXPECT_EQ(refusal(), "terrain.debris_map");
    tiff.ourBand = "mass";
    EXPECT_EQ(refusal(), "terrain.our_map");
}

TEST_F(TerrainGeoTiff, ADatumThatTheCaseDoesNotNameIsKeptAndSaid) {
    tiff.crs = "EPSG:32633+5773";
    tiff.place = {451000.0 - 20.0, 1.0, 0.0, 5311000.0 + 15.0, 0.0, -1.0};
    tiff.height = [](double x, double y) { return planeOfTiff(x - 451000.0, y - 5311000.0); };
    frame.crs = "EPSG:32633";
    frame.origin << 451000, 5311000, 0;
    const TerrainInput terrain = read();
    EXPECT_EQ(terrain.findings.count("terrain.datum_kept"), 1);
    expectPlane(terrain);
}

TEST_F(TerrainGeoTiff, AFileCutShortSaysFromWhere) {
    tiff.write(path);
    std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
    try {
        openTerrain(path, frame, around, Execution());
        FAIL() << "taken";
    } catch (const ParseError& error) {
        EXPECT_TRUE(error.message().id == "terrain.unreadable_rows" || error.message().id == "terrain.unknown_format")
            << error.what();
    }
}

}  // namespace
}  // namespace rubble::io
