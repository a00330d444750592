#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <vector>

#include "core/base/error.h"
#include "io/case/case_file.h"
#include "io/case/site_reader.h"
#include "io/case/terrain_reader.h"
#include "io/site/orthophoto_file.h"
#include "io/site/site_mesh_file.h"
#include "tests/support/error_id.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

constexpr double east = 451000.0;
constexpr double north = 5311000.0;

double planeOfSite(double x, double y) {
    return 2.0 + 0.1 * x - 0.05 * y;
}

/// A raster of numbers by place.
struct Raster {
    int columns = 80;
    int rows = 60;
    std::array<double, 6> place{-40.0, 1.0, 0.0, 30.0, 0.0, -1.0};
    std::string crs;
    int bands = 1;
    GDALDataType type = GDT_Float64;
    std::function<double(double, double, int)> value;  ///< of the system's coordinates and the band

    void write(const std::string& path) const {
        GDALAllRegister();
        const char* sparse[] = {"TILED=YES", "COMPRESS=DEFLATE", nullptr};
        GDALDatasetUniquePtr file(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), columns, rows, bands, type,
                                                                                           const_cast<char**>(sparse)));
        std::array<double, 6> g = place;
        file->SetGeoTransform(g.data());
        if (!crs.empty()) {
            OGRSpatialReference system;
            ASSERT_EQ(system.SetFromUserInput(crs.c_str()), OGRERR_NONE);
            file->SetSpatialRef(&system);
        }
        for (int b = 1; b <= bands; ++b) {
            GDALRasterBand* band = file->GetRasterBand(b);
            if (bands == 1) {
                band->SetNoDataValue(-9999.0);
                band->SetUnitType("metre");
            }
            for (int r = 0; r < rows; ++r) {
                std::vector<double> row;
                for (int c = 0; c < columns; ++c) {
                    const double x = place[0] + place[1] * (c + 0.5) + place[2] * (r + 0.5);
                    const double y = place[3] + place[4] * (c + 0.5) + place[5] * (r + 0.5);
                    row.push_back(value(x, y, b));
                }
                ASSERT_EQ(band->RasterIO(GF_Write, 0, r, columns, 1, row.data(), columns, 1, GDT_Float64, 0, 0, nullptr), CE_None);
            }
        }
    }
};

class TerrainSite : public testing::Test {
protected:
    TemporaryFolder folder;
    std::string path = folder / "terrain.tif";
    Frame frame;
    Site site;
    Aabb around{Vec3(-5.0, -3.0, 2.0), Vec3(5.0, 3.0, 3.0)};
    Raster raster;

    void SetUp() override {
        raster.value = [](double x, double y, int) { return planeOfSite(x, y); };
    }
    TerrainInput read() {
        raster.write(path);
        return openTerrain(path, frame, around, Execution(), site);
    }
    void expectPlane(const TerrainInput& terrain, double tolerance) {
        for (const double x : {-6.0, -1.0, 0.25, 5.5}) {
            for (const double y : {-5.0, 0.0, 4.3}) {
                EXPECT_NEAR(terrain.grid->height(x, y), planeOfSite(x, y), tolerance) << x << " " << y;
            }
        }
    }
};

TEST_F(TerrainSite, DegreesAreProjectedToTheSystemOfTheCase) {
    frame.crs = "EPSG:32633";
    frame.origin << 451000, 5311000, 100;
    OGRSpatialReference utm;
    OGRSpatialReference degrees;
    utm.SetFromUserInput("EPSG:32633");
    degrees.SetFromUserInput("EPSG:4326");
    utm.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> there(OGRCreateCoordinateTransformation(&degrees, &utm));
    const std::unique_ptr<OGRCoordinateTransformation> back(OGRCreateCoordinateTransformation(&utm, &degrees));
    double x = east;
    double y = north;
    ASSERT_TRUE(back->Transform(1, &x, &y));
    raster.crs = "EPSG:4326";
    raster.place = {x - 40.0e-5, 1e-5, 0.0, y + 30.0e-5, 0.0, -1e-5};
    raster.value = [&](double lon, double lat, int) {
        there->Transform(1, &lon, &lat);
        return 100.0 + planeOfSite(lon - east, lat - north);
    };
    const TerrainInput terrain = read();
    expectPlane(terrain, 1e-4);
    EXPECT_EQ(terrain.findings.count("terrain.projected"), 1);
    // A degree of longitude is shorter there than one of latitude.
    EXPECT_NEAR(terrain.grid->cell(), 0.745, 0.02);
}

TEST_F(TerrainSite, ATurnedRasterLiesWhereItsCornersSay) {
    raster.place = {-40.0, 0.8, 0.6, 20.0, 0.6, -0.8};
    raster.columns = 100;
    raster.rows = 100;
    raster.place = {-50.0, 0.8, 0.6, 10.0, 0.6, -0.8};
    expectPlane(read(), 1e-9);
}

TEST_F(TerrainSite, ControlPointsTakeThePlaceOfTheOrigin) {
    // The local frame is turned by 30 degrees and lies at the site of the world.
    const double c = std::cos(M_PI / 6.0);
    const double s = std::sin(M_PI / 6.0);
    for (const Vec3& local : {Vec3(0, 0, 0), Vec3(10, 2, 1), Vec3(-4, 8, 3)}) {
        site.controlPoints.push_back(
            {"p", local, Vec3(east + c * local.x() - s * local.y(), north + s * local.x() + c * local.y(), 512.0 + local.z()),
             true});
    }
    raster.place = {east - 40.0, 1.0, 0.0, north + 30.0, 0.0, -1.0};
    raster.value = [&](double x, double y, int) {
        const double u = x - east;
        const double v = y - north;
        return 512.0 + planeOfSite(c * u + s * v, -s * u + c * v);
    };
    const TerrainInput terrain = read();
    expectPlane(terrain, 1e-6);
    ASSERT_TRUE(terrain.fit.has_value());
    EXPECT_LT(terrain.fit->rmsPlan, 1e-6);
    site.controlPoints.resize(1);
    EXPECT_THROW(read(), ParseError);  // one point says nothing: by the origin the raster lies elsewhere
}

TEST_F(TerrainSite, SpikesAreTakenOutAndWallsStay) {
    raster.value = [](double x, double y, int) {
        const bool spike = std::abs(x - 3.5) < 0.1 && std::abs(y - 1.5) < 0.1;
        return spike ? 80.0 : y > 4.0 ? planeOfSite(x, y) + 12.0 : planeOfSite(x, y);
    };
    const TerrainInput terrain = read();
    EXPECT_EQ(terrain.findings.count("terrain.spikes"), 1);
    EXPECT_NEAR(terrain.grid->height(3.5, 1.5), planeOfSite(3.5, 1.5), 1e-9);
    EXPECT_NEAR(terrain.grid->height(2.0, 6.5), planeOfSite(2.0, 6.5) + 12.0, 1e-9);
}

TEST_F(TerrainSite, TooManyHeightsAreAveraged) {
    around = Aabb(Vec3(-5.0, -3.0, 2.0), Vec3(5.0, 3.0, 4.0));
    raster.columns = raster.rows = 3000;
    raster.place = {-15.0, 0.01, 0.0, 15.0, 0.0, -0.01};
    raster.type = GDT_Float32;
    const TerrainInput terrain = read();
    EXPECT_EQ(terrain.findings.count("terrain.reduced"), 1);
    EXPECT_NEAR(terrain.grid->cell(), 0.02, 1e-12);
    expectPlane(terrain, 1e-6);
}

TEST_F(TerrainSite, AnotherVerticalDatumIsNamed) {
    raster.crs = "EPSG:32633+5773";
    raster.place = {east - 40.0, 1.0, 0.0, north + 30.0, 0.0, -1.0};
    raster.value = [](double x, double y, int) { return planeOfSite(x - east, y - north); };
    frame.crs = "EPSG:32633+5621";
    frame.origin << 451000, 5311000, 0;
    const TerrainInput terrain = read();
    EXPECT_NE(terrain.verticalDatum.find("EGM96"), std::string::npos) << terrain.verticalDatum;
    EXPECT_EQ(terrain.findings.count("terrain.other_datum"), 1);
    // Heights of control points count from the datum of the case: they do not bridge the two either.
    site.controlPoints = {{"west", Vec3(0.0, 0.0, 0.0), Vec3(east, north, 100.0), true},
                          {"east", Vec3(10.0, 0.0, 0.0), Vec3(east + 10.0, north, 100.0), true}};
    EXPECT_EQ(read().findings.count("terrain.other_datum"), 1);
    site.controlPoints.clear();
    site.heightShift = 0.75;
    const TerrainInput shifted = read();
    EXPECT_EQ(shifted.findings.count("terrain.other_datum"), 0);
    EXPECT_NEAR(shifted.grid->height(1.0, 1.0), terrain.grid->height(1.0, 1.0) + 0.75, 1e-9);
}

TEST_F(TerrainSite, AnOrthophotoLiesInTheFrame) {
    raster.bands = 3;
    raster.type = GDT_Byte;
    // Red in the east, green in the north.
    raster.value = [](double x, double y, int band) {
        return band == 1 ? (x > 0.0 ? 200 : 10) : band == 2 ? (y > 0.0 ? 220 : 20) : 30;
    };
    raster.write(path);
    Findings findings;
    const auto picture = readOrthophoto(path, frame, site, Aabb(), Execution(), findings);
    ASSERT_EQ(picture->rgba.size(), 4u * static_cast<std::size_t>(picture->width * picture->height));
    const auto at = [&](double x, double y) {
        const int column = static_cast<int>((x - picture->x0) / picture->pixel);
        const int row = static_cast<int>((y - picture->y0) / picture->pixel);
        return &picture->rgba[4 * static_cast<std::size_t>(row * picture->width + column)];
    };
    EXPECT_EQ(at(10.0, 10.0)[0], 200);
    EXPECT_EQ(at(10.0, 10.0)[1], 220);
    EXPECT_EQ(at(-10.0, -10.0)[0], 10);
    EXPECT_EQ(at(-10.0, -10.0)[1], 20);
    EXPECT_EQ(at(-10.0, -10.0)[3], 255);
    raster.bands = 1;
    raster.type = GDT_Float64;
    raster.write(path);
    EXPECT_THROW(readOrthophoto(path, frame, site, Aabb(), Execution(), findings), ParseError);
}

constexpr const char* objText = "v 0 0 5\nv 4 0 5\nv 4 3 5\nv 0 3 5\nf 1 2 3 4\n";
constexpr const char* plyText =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 5\n4 0 5\n4 3 5\n3 0 1 2\n";
// A triangle (0, 5, 0), (4, 5, 0), (4, 5, -3), y up.
constexpr const char* gltfText =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,5,-3],"max":[4,5,0]}],)"
    R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36}],)"
    R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAoEAAAAAAAACAQAAAoEAAAAAAAACAQAAAoEAAAEDA"}]})";

TEST_F(TerrainSite, MeshesOfEveryFormatAreRead) {
    for (const auto& [name, text] : {std::pair("a.obj", objText), std::pair("a.ply", plyText), std::pair("a.gltf", gltfText)}) {
        const std::string mesh = folder / name;
        std::ofstream(mesh) << text;
        const SiteMesh read = readSiteMesh(mesh, frame, site, Execution()).mesh;
        EXPECT_GE(read.triangles.size(), 1u) << name;
        Aabb box;
        for (const Vec3& p : read.points) {
            box.extend(p);
        }
        EXPECT_LT((box.min() - Vec3(0, 0, 5)).norm(), 1e-6) << name << box.min().transpose();
        EXPECT_LT((box.max() - Vec3(4, 3, 5)).norm(), 1e-6) << name << box.max().transpose();
    }
}

TEST_F(TerrainSite, DamagedMeshesAreRefused) {
    const std::string whole(gltfText);
    for (const auto& [name, text] :
         {std::pair(std::string("a.obj"), std::string("f 1 2 3\n")),
          std::pair(std::string("b.ply"), std::string(plyText).substr(0, 150)),
          std::pair(std::string("c.gltf"), whole.substr(0, 300)), std::pair(std::string("d.glb"), std::string("glTF")),
          std::pair(std::string("e.txt"), std::string(objText))}) {
        const std::string mesh = folder / name;
        std::ofstream(mesh) << text;
        EXPECT_THROW(readSiteMesh(mesh, frame, site, Execution()), ParseError) << name;
    }
    EXPECT_THROW(readSiteMesh(folder / "none.obj", frame, site, Execution()), WorldError);
}

TEST_F(TerrainSite, AWallIsNoGround) {
    const std::string wall = folder / "wall.obj";
    std::ofstream(wall) << "v -4 0 0\nv 4 0 0\nv 4 0 5\nf 1 2 3\n";
    EXPECT_EQ(idOfError([&] { openTerrain(wall, frame, around, Execution()); }), "terrain.mesh_upright");
}

TEST_F(TerrainSite, SurroundingsRaiseTheTerrainWhenAsked) {
    raster.write(path);
    std::ofstream(folder / "house.obj") << objText;
    Mesh fe;
    fe.nodes = {around.min(), around.max()};
    Case theCase;
    theCase.inputs = {{"terrain-1", InputRole::Terrain, "terrain.tif", ""},
                      {"surroundings-1", InputRole::Surroundings, "house.obj", ""}};
    const std::string casePath = folder / "a.rubble";
    const TerrainInput shown = openSiteOfCase(theCase, casePath, fe, Execution());
    EXPECT_FALSE(shown.collided);
    ASSERT_TRUE(shown.surroundings);
    EXPECT_NEAR(shown.grid->height(2.0, 1.5), planeOfSite(2.0, 1.5), 1e-9);
    theCase.site.collide = true;
    const TerrainInput raised = openSiteOfCase(theCase, casePath, fe, Execution());
    EXPECT_TRUE(raised.collided);
    EXPECT_NEAR(raised.grid->height(2.0, 1.5), 5.0, 1e-6);
    EXPECT_NEAR(raised.grid->height(-2.0, -1.5), planeOfSite(-2.0, -1.5), 1e-9);
    // The run finds the same ground again by what it put down.
    RunOrigin origin;
    recordSite(origin, raised, theCase.site);
    ASSERT_EQ(origin.surroundings.size(), 1u);
    const TerrainInput again = openTerrain(path, frame, around, Execution(), origin.site);
    EXPECT_EQ(raisedTerrain(*again.grid, origin.surroundings, frame, origin.site, Execution())->digest(), raised.grid->digest());
    theCase.inputs.erase(theCase.inputs.begin());
    EXPECT_EQ(openSiteOfCase(theCase, casePath, fe, Execution()).findings.count("surroundings.no_terrain"), 1);
}

TEST_F(TerrainSite, ARunKeepsTheOffsetsOfItsMeshes) {
    raster.write(path);
    std::ofstream(folder / "house.obj") << "v 5000 0 -95\nv 5004 0 -95\nv 5004 3 -95\nv 5000 3 -95\nf 1 2 3 4\n";
    std::ofstream(folder / "house_offset.xyz") << "-5000 0 100\n";
    Mesh fe;
    fe.nodes = {around.min(), around.max()};
    Case theCase;
    theCase.site.collide = true;
    theCase.inputs = {{"terrain-1", InputRole::Terrain, "terrain.tif", ""},
                      {"surroundings-1", InputRole::Surroundings, "house.obj", ""}};
    const TerrainInput raised = openSiteOfCase(theCase, folder / "a.rubble", fe, Execution());
    EXPECT_NEAR(raised.grid->height(2.0, 1.5), 5.0, 1e-6);
    EXPECT_EQ(raised.findings.count("surroundings.offset_file"), 1);
    RunOrigin origin;
    recordSite(origin, raised, theCase.site);
    ASSERT_EQ(origin.surroundings.size(), 1u);
    EXPECT_EQ(origin.surroundings.front().offset, Vec3(-5000, 0, 100));
    // The run does not lean on the file beside the mesh.
    std::filesystem::remove(folder / "house_offset.xyz");
    const TerrainInput again = openTerrain(path, frame, around, Execution(), origin.site);
    EXPECT_EQ(raisedTerrain(*again.grid, origin.surroundings, frame, origin.site, Execution())->digest(), raised.grid->digest());
    EXPECT_THROW(openSiteOfCase(theCase, folder / "a.rubble", fe, Execution()), ParseError) << "the house is 5 km away now";
    theCase.site.collide = false;
    EXPECT_EQ(openSiteOfCase(theCase, folder / "a.rubble", fe, Execution()).findings.count("surroundings.elsewhere"), 1);
    theCase.inputs[1].offset = Vec3(-5000, 0, 100);
    EXPECT_TRUE(openSiteOfCase(theCase, folder / "a.rubble", fe, Execution()).surroundings);
}

TEST_F(TerrainSite, SurroundingsStandWhereverTheTerrainIs) {
    raster.columns = raster.rows = 200;
    raster.place = {-100.0, 1.0, 0.0, 100.0, 0.0, -1.0};
    raster.write(path);
    // 60 m off, which is more than ten heights of the structure.
    std::ofstream(folder / "house.obj") << "v 60 0 30\nv 64 0 30\nv 64 3 30\nv 60 3 30\nf 1 2 3 4\n";
    Mesh fe;
    fe.nodes = {around.min(), around.max()};
    ASSERT_LT(SiteWindow(around).plan().max().x(), 60.0);
    Case theCase;
    theCase.site.collide = true;
    theCase.inputs = {{"terrain-1", InputRole::Terrain, "terrain.tif", ""},
                      {"surroundings-1", InputRole::Surroundings, "house.obj", ""}};
    const std::string casePath = folder / "a.rubble";
    const TerrainInput raised = openSiteOfCase(theCase, casePath, fe, Execution());
    EXPECT_NEAR(raised.grid->height(62.0, 1.5), 30.0, 1e-6);
    const auto shown = [&](const TerrainGrid* terrain) {
        return openSurroundingsOfCase(theCase, casePath, fe, frame, site, terrain, Execution());
    };
    EXPECT_TRUE(shown(raised.grid.get()).surroundings);
    EXPECT_EQ(shown(nullptr).findings.count("surroundings.elsewhere"), 1);
}

TEST_F(TerrainSite, WhatIsOnlyShownDoesNotKeepACaseFromOpening) {
    raster.write(path);
    Mesh fe;
    fe.nodes = {around.min(), around.max()};
    Case theCase;
    theCase.inputs = {{"terrain-1", InputRole::Terrain, "terrain.tif", ""},
                      {"orthophoto-1", InputRole::Orthophoto, "none.tif", ""},
                      {"surroundings-1", InputRole::Surroundings, "none.obj", ""}};
    const TerrainInput site_ = openSiteOfCase(theCase, folder / "a.rubble", fe, Execution());
    EXPECT_TRUE(site_.grid);
    EXPECT_EQ(site_.findings.count("orthophoto.missing"), 1);
    EXPECT_EQ(site_.findings.count("surroundings.missing"), 1);
}

TEST(CaseSite, IsKeptInTheCaseFile) {
    Case theCase;
    theCase.site.controlPoints = {{"north pier", Vec3(1, 2, 3), Vec3(451000.25, 5311000.5, 512.125), true},
                                  {"mark 4", Vec3(4, 5, 6), Vec3::Zero(), false}};
    theCase.site.heightShift = -0.375;
    theCase.site.collide = true;
    theCase.inputs = {{"o", InputRole::Orthophoto, "o.tif", ""}, {"m", InputRole::Surroundings, "m.obj", ""}};
    theCase.inputs[1].offset = Vec3(451000.5, 5311000.0, -3.25);
    const Case again = caseFromText(caseText(theCase), "a.rubble");
    EXPECT_EQ(again, theCase);
    EXPECT_EQ(again.inputs[1].offset, theCase.inputs[1].offset);
    theCase.site = Site();
    EXPECT_EQ(caseText(theCase).find("\"site\""), std::string::npos);
}

}  // namespace
}  // namespace rubble::io
