#include "io/case/terrain_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <random>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/site/height_raster.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/error_id.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

/// A grid of 30 x 20 cells, and what it says of each.
struct SaidGrid : AsciiGrid {
    std::function<std::string(double, double)> text;

    void write(const std::string& path) const { writeText(path, text); }
};

double plane(double x, double y) {
    return 2.0 + 0.1 * x - 0.05 * y;
}

SaidGrid planeGrid() {
    SaidGrid grid{{30, 20, -15.0, -10.0}, {}};
    grid.text = [](double x, double y) { return AsciiGrid::textOf(plane(x, y)); };
    return grid;
}

const char* metricProjection =
    R"(PROJCS["WGS 84 / UTM zone 33N",GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],)"
    R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],)"
    R"(PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",15],PARAMETER["scale_factor",0.9996],)"
    R"(PARAMETER["false_easting",500000],PARAMETER["false_northing",0],UNIT["metre",1],AUTHORITY["EPSG","32633"]])";

class TerrainReader : public testing::Test {
protected:
    TemporaryFolder folder;
    std::string path = folder / "terrain.asc";
    Frame frame;
    /// A structure 4 m long, 2 m wide, 3 m high.
    Aabb around{Vec3(-2.0, -1.0, 2.0), Vec3(2.0, 1.0, 5.0)};
    Execution execution;

    TerrainInput read() { return openTerrain(path, frame, around, execution); }
    void write(const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
    std::string errorOf() {
        try {
            read();
        } catch (const Error& error) {
            EXPECT_FALSE(englishText(error.remedy()).empty());
            EXPECT_NE(englishText(error.message()).find("terrain.asc"), std::string::npos) << error.what();
            return error.message().id;
        }
        return "no error";
    }
};

TEST_F(TerrainReader, APlaneComesOutWhereItIs) {
    planeGrid().write(path);
    const TerrainInput terrain = read();
    ASSERT_TRUE(terrain.grid);
    EXPECT_EQ(terrain.grid->nx(), 30u);
    EXPECT_EQ(terrain.grid->ny(), 20u);
    for (const double x : {-14.5, -3.2, 0.0, 7.75, 14.5}) {
        for (const double y : {-9.5, -1.0, 3.3, 9.5}) {
            EXPECT_NEAR(terrain.grid->height(x, y), plane(x, y), 1e-12);
        }
    }
    EXPECT_EQ(terrain.sha256, sha256OfFile(path));
    EXPECT_EQ(terrain.findings.count("terrain.height_unit"), 1);
}

TEST_F(TerrainReader, TheOriginAndTheUpAxisOfTheFrameAreTakenOff) {
    SaidGrid grid = planeGrid();
    grid.west += 400000.0;
    grid.south += 5300000.0;
    grid.text = [](double x, double y) { return AsciiGrid::textOf(100.0 + plane(x - 400000.0, y - 5300000.0)); };
    grid.write(path);
    frame.origin << 400000, 5300000, 100;
    // Coordinates of 5.3e6 m keep 1e-9 m.
    EXPECT_NEAR(read().grid->height(1.25, -0.75), plane(1.25, -0.75), 1e-9);
    // With y up in the FE file, its x, -z and y are easting, northing and height.
    frame.upAxis = "y";
    frame.origin << 400000, 100, -5300000;
    EXPECT_NEAR(read().grid->height(1.25, -0.75), plane(1.25, -0.75), 1e-9);
    // The unit of the FE file is not that of the terrain.
    frame.metresPerUnit = 0.001;
    EXPECT_NEAR(read().grid->height(1.25, -0.75), plane(1.25, -0.75), 1e-9);
}

TEST_F(TerrainReader, ReadsAllOfARasterAroundTheWindowAboutTheStructure) {
    SaidGrid grid = planeGrid();
    grid.columns = 900;
    grid.rows = 700;
    grid.west = -450.0;
    grid.south = -350.0;
    grid.write(path);
    const TerrainInput terrain = read();
    EXPECT_EQ(terrain.grid->nx(), 900u);
    EXPECT_EQ(terrain.grid->ny(), 700u);
    EXPECT_NEAR(terrain.grid->height(-431.0, 320.0), plane(-431.0, 320.0), 1e-12);
    // Ten times 3 m to each side of 4 m by 2 m, and one node beyond where none lies on the edge.
    const Aabb& window = terrain.grid->window();
    EXPECT_NEAR(window.sizes().x(), 64.0, 1.0);
    EXPECT_NEAR(window.sizes().y(), 62.0, 1.0);
    EXPECT_LE(window.min().x(), -32.0);
    EXPECT_GT(window.min().x(), -34.0);
    EXPECT_EQ(terrain.grid->source(-450.0, 0.0), TerrainGrid::Source::Raster);
    EXPECT_EQ(terrain.grid->source(-450.6, 0.0), TerrainGrid::Source::Ended);
}

TEST_F(TerrainReader, GapsAreFilledFromTheirRimsAndCounted) {
    SaidGrid grid = planeGrid();
    grid.text = [](double x, double y) {
        return std::hypot(x - 3.0, y) < 2.2 ? "-9999" : x > 14.0 ? "nan" : AsciiGrid::textOf(5.0);
    };
    grid.write(path);
    const TerrainInput terrain = read();
    EXPECT_EQ(terrain.grid->lowest(), 5.0);
    EXPECT_EQ(terrain.grid->highest(), 5.0);
    EXPECT_EQ(terrain.findings.count("terrain.filled"), 16 + 20);
}

TEST_F(TerrainReader, HeightsInAnotherUnitAreNoGaps) {
    // 123 m in cm.
    SaidGrid grid = planeGrid();
    grid.text = [](double, double) { return "12300"; };
    grid.write(path);
    EXPECT_EQ(idOfError([&] { read(); }), "terrain.no_land_all");
    grid.text = [](double, double) { return "-32768"; };
    grid.write(path);
    EXPECT_NE(idOfError([&] { read(); }), "terrain.no_land_all") << "a mark for no data";
}

TEST_F(TerrainReader, AMarkForNoDataThatTheFileDoesNotNameIsSeen) {
    SaidGrid grid = planeGrid();
    grid.text = [](double x, double) { return x < -14.0 ? "-32768" : "4"; };
    grid.write(path);
    const TerrainInput terrain = read();
    EXPECT_EQ(terrain.findings.count("terrain.no_land"), 20);
    EXPECT_EQ(terrain.findings.count("terrain.filled"), 20);
    EXPECT_EQ(terrain.grid->lowest(), 4.0);
}

TEST_F(TerrainReader, WhatIsMostlyOrAllGapIsRefused) {
    SaidGrid grid = planeGrid();
    grid.text = [](double x, double) { return x < 1.0 ? "-9999" : "4"; };
    grid.write(path);
    EXPECT_EQ(errorOf(), "terrain.gaps");
    grid.text = [](double x, double) { return x < -14.0 ? "-9999" : "nan"; };
    grid.write(path);
    EXPECT_EQ(errorOf(), "terrain.gaps");
}

TEST_F(TerrainReader, MissingEmptyCutAndForeignFilesAreNamed) {
    EXPECT_EQ(errorOf(), "terrain.missing");
    write("");
    EXPECT_EQ(errorOf(), "terrain.empty");
    write("no raster at all\n");
    EXPECT_EQ(errorOf(), "terrain.unknown_format");
    planeGrid().write(path);
    std::ifstream in(path);
    const std::string whole(std::istreambuf_iterator<char>(in), {});
    write(whole.substr(0, whole.size() / 2));
    EXPECT_EQ(errorOf(), "terrain.unreadable_rows");
    write(whole.substr(0, 40));
    EXPECT_EQ(errorOf(), "terrain.unknown_format");
    std::filesystem::remove(path);
    std::filesystem::create_directory(path);
    EXPECT_EQ(errorOf(), "terrain.no_file");
}

TEST_F(TerrainReader, ATerrainElsewhereSaysWhere) {
    SaidGrid grid = planeGrid();
    grid.west += 400000.0;
    grid.write(path);
    EXPECT_EQ(errorOf(), "terrain.elsewhere");
}

TEST_F(TerrainReader, ATerrainThatEndsUnderTheStructureIsFound) {
    planeGrid().write(path);
    around = Aabb(Vec3(-20.0, -1.0, 2.0), Vec3(2.0, 1.0, 5.0));
    EXPECT_EQ(read().findings.count("terrain.short"), 1);
}

TEST_F(TerrainReader, ATerrainFarAboveOrBelowIsFound) {
    SaidGrid grid = planeGrid();
    grid.text = [](double, double) { return "312"; };
    grid.write(path);
    EXPECT_EQ(read().findings.count("terrain.far_off"), 1);
    grid.text = [](double, double) { return "-80"; };
    grid.write(path);
    EXPECT_EQ(read().findings.count("terrain.far_off"), 1);
    grid.text = [](double, double) { return "-8"; };
    grid.write(path);
    EXPECT_EQ(read().findings.count("terrain.far_off"), 0);
}

// Squares of their shorter side could not be counted.
TEST_F(TerrainReader, CellsOfNoWidthAreRefused) {
    around = {};
    write("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ndx 1e-300\ndy 1\nNODATA_value -9999\n1 2\n3 4\n");
    EXPECT_NE(errorOf(), "no error");
}

TEST_F(TerrainReader, AHeaderThatPromisesMoreThanThereIsIsRefused) {
    write("ncols 100000\nnrows 100000\nxllcorner -500\nyllcorner -500\ncellsize 0.01\n1 1\n");
    try {
        read();
        FAIL() << "taken";
    } catch (const Error& error) {
        EXPECT_EQ(error.message().id, "terrain.cut") << error.what();
    }
}

TEST_F(TerrainReader, AStripIsNoSurface) {
    SaidGrid grid = planeGrid();
    grid.rows = 1;
    grid.south = 0.0;
    grid.write(path);
    EXPECT_EQ(errorOf(), "terrain.too_few");
}

TEST_F(TerrainReader, CoordinateSystemsAreHeldAgainstEachOther) {
    planeGrid().write(path);
    std::ofstream(folder / "terrain.prj") << metricProjection;
    frame.crs = "EPSG:32633";
    const TerrainInput terrain = read();
    EXPECT_EQ(terrain.crs, "WGS 84 / UTM zone 33N");
    EXPECT_EQ(terrain.findings.count("terrain.crs_unknown"), 0);
    // Projected from one zone to the next it lies hundreds of kilometres from the structure.
    frame.crs = "EPSG:25832";
    EXPECT_EQ(errorOf(), "terrain.elsewhere");
    frame.crs = "my village";
    EXPECT_EQ(read().findings.count("terrain.crs_unknown"), 1);
    frame.crs = "";
    EXPECT_EQ(read().findings.count("terrain.crs_unknown"), 0);
    std::ofstream(folder / "terrain.prj") << R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],)"
                                             R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])";
    EXPECT_EQ(errorOf(), "terrain.degrees");
}

TEST_F(TerrainReader, CancelsBetweenRows) {
    planeGrid().write(path);
    execution.cancel();
    EXPECT_THROW(read(), Cancelled);
}

TEST(HeightRaster, SquareCellsKeepAPlane) {
    HeightGrid raster;
    raster.x0 = 3.0;
    raster.y0 = -2.0;
    raster.dx = 2.0;
    raster.dy = 0.7;
    raster.nx = 11;
    raster.ny = 9;
    for (std::size_t j = 0; j < raster.ny; ++j) {
        for (std::size_t i = 0; i < raster.nx; ++i) {
            raster.heights.push_back(
                plane(raster.x0 + raster.dx * static_cast<double>(i), raster.y0 + raster.dy * static_cast<double>(j)));
        }
    }
    const HeightGrid even = withSquareCells(raster);
    EXPECT_EQ(even.dx, 0.7);
    EXPECT_EQ(even.dy, 0.7);
    EXPECT_EQ(static_cast<double>(even.heights.size()), squareNodeCount(2.0, 0.7, 11, 9));
    EXPECT_GE(even.x0 + even.dx * static_cast<double>(even.nx - 1), 3.0 + 20.0 - 1e-3);
    for (std::size_t j = 0; j < even.ny; ++j) {
        for (std::size_t i = 0; i + 1 < even.nx; ++i) {
            const double x = even.x0 + even.dx * static_cast<double>(i);
            const double y = even.y0 + even.dy * static_cast<double>(j);
            EXPECT_NEAR(even.heights[j * even.nx + i], plane(x, y), 1e-12);
        }
    }
}

TEST(HeightRaster, GapsTakeTheMeanOfTheirRim) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    HeightGrid raster;
    raster.nx = 5;
    raster.ny = 1;
    raster.heights = {none, 2.0, none, 6.0, none};
    fillGaps(raster);
    EXPECT_EQ(raster.heights, (std::vector<double>{2.0, 2.0, 4.0, 6.0, 6.0}));
}

// The ground between trees, as a cloud has it: its gaps hang together, and with the edge, by ways of a few nodes.
TEST(HeightRaster, PoresBetweenPointsHaveNotEndedWhereTheyReachTheEdge) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    HeightGrid raster;
    raster.dx = raster.dy = 1.0;
    raster.nx = 60;
    raster.ny = 50;
    raster.heights.assign(raster.nx * raster.ny, 5.0);
    std::mt19937 random(3);
    for (double& height : raster.heights) {
        height = random() % 100 < 55 ? none : height;
    }
    // A stretch of the edge itself may be ragged, nothing within.
    const auto ragged = [&](std::size_t k) {
        const std::size_t i = k % raster.nx;
        const std::size_t j = k / raster.nx;
        return std::min({i, j, raster.nx - 1 - i, raster.ny - 1 - j}) < 3;
    };
    const std::vector<std::uint8_t> pores = outerGaps(raster);
    for (std::size_t k = 0; k < pores.size(); ++k) {
        EXPECT_TRUE(pores[k] == 0 || ragged(k)) << k % raster.nx << ", " << k / raster.nx;
    }
    EXPECT_LT(std::count(pores.begin(), pores.end(), 1), 30);
    const auto at = [&](std::size_t i, std::size_t j) -> double& { return raster.heights[j * raster.nx + i]; };
    for (std::size_t j = 0; j < raster.ny; ++j) {
        std::fill_n(&at(40, j), 20, none);
        at(39, j) = 5.0;
    }
    const std::vector<std::uint8_t> ended = outerGaps(raster);
    ASSERT_EQ(ended.size(), raster.heights.size());
    for (std::size_t k = 0; k < ended.size(); ++k) {
        const bool beyond = k % raster.nx >= 40;
        EXPECT_TRUE(ended[k] == (beyond ? 1 : 0) || (!beyond && ragged(k))) << k % raster.nx << ", " << k / raster.nx;
    }
}

TEST(HeightRaster, FlippingTwiceChangesNothing) {
    HeightGrid raster;
    raster.nx = 3;
    raster.ny = 2;
    raster.heights = {1, 2, 3, 4, 5, 6};
    flipRows(raster);
    EXPECT_EQ(raster.heights, (std::vector<double>{4, 5, 6, 1, 2, 3}));
    flipColumns(raster);
    EXPECT_EQ(raster.heights, (std::vector<double>{6, 5, 4, 3, 2, 1}));
}

}  // namespace
}  // namespace rubble::io
