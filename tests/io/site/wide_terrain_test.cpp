#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <iomanip>
#include <limits>
#include <random>
#include <sstream>

#include "io/base/files.h"
#include "io/case/terrain_reader.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

/// Hills of 40 and 7 m with a long slope to the east.
double hills(double x, double y) {
    return 300.0 - 0.3 * x + 6.0 * std::sin(x / 40.0) * std::cos(y / 33.0) + std::sin(x / 7.0 + y / 9.0);
}

/// A raster of heights in one file.
struct WideTiff {
    int columns = 500;
    int rows = 400;
    std::array<double, 6> place{-250.0, 1.0, 0.0, 200.0, 0.0, -1.0};
    std::function<double(double, double)> height = hills;

    /// The part of it from a column and row on.
    WideTiff part(int column, int row, int width, int depth) const {
        WideTiff other = *this;
        other.columns = width;
        other.rows = depth;
        other.place[0] += column * place[1] + row * place[2];
        other.place[3] += column * place[4] + row * place[5];
        return other;
    }
    void write(const std::string& path) const {
        GDALAllRegister();
        GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
        GDALDatasetUniquePtr file(driver->Create(path.c_str(), columns, rows, 1, GDT_Float64, nullptr));
        std::array<double, 6> g = place;
        file->SetGeoTransform(g.data());
        GDALRasterBand* band = file->GetRasterBand(1);
        band->SetNoDataValue(-9999.0);
        band->SetUnitType("metre");
        std::vector<double> line(static_cast<std::size_t>(columns));
        for (int r = 0; r < rows; ++r) {
            for (int c = 0; c < columns; ++c) {
                const double x = place[0] + place[1] * (c + 0.5) + place[2] * (r + 0.5);
                const double y = place[3] + place[4] * (c + 0.5) + place[5] * (r + 0.5);
                line[static_cast<std::size_t>(c)] = height(x, y);
            }
            EXPECT_EQ(band->RasterIO(GF_Write, 0, r, columns, 1, line.data(), columns, 1, GDT_Float64, 0, 0, nullptr), CE_None);
        }
    }
};

class WideTerrain : public testing::Test {
protected:
    TemporaryFolder folder;
    Frame frame;
    /// 4 m by 2 m and 3 m high: the window reaches 30 m to each side.
    Aabb around{Vec3(-2.0, -1.0, 300.0), Vec3(2.0, 1.0, 303.0)};
    std::mt19937 random{3};

    TerrainInput read(const WideTiff& tiff, const std::string& name = "wide.tif") {
        tiff.write(folder / name);
        return openTerrain(folder / name, frame, around, Execution());
    }
    /// Both are one surface to the last bit within the window about the structure.
    void expectSameWindow(const TerrainGrid& a, const TerrainGrid& b) {
        ASSERT_EQ(a.window().min(), b.window().min());
        ASSERT_EQ(a.window().max(), b.window().max());
        ASSERT_EQ(a.cell(), b.cell());
        std::uniform_real_distribution xs(a.window().min().x(), a.window().max().x());
        std::uniform_real_distribution ys(a.window().min().y(), a.window().max().y());
        for (int i = 0; i < 2000; ++i) {
            const double x = xs(random);
            const double y = ys(random);
            ASSERT_EQ(a.height(x, y), b.height(x, y)) << x << " " << y;
            ASSERT_EQ(a.normal(x, y), b.normal(x, y)) << x << " " << y;
        }
    }
    void expectHills(const TerrainGrid& grid, double xMin, double xMax, double yMin, double yMax, double tolerance) {
        std::uniform_real_distribution xs(xMin, xMax);
        std::uniform_real_distribution ys(yMin, yMax);
        for (int i = 0; i < 2000; ++i) {
            const double x = xs(random);
            const double y = ys(random);
            ASSERT_NEAR(grid.height(x, y), hills(x, y), tolerance) << x << " " << y;
        }
    }
};

TEST_F(WideTerrain, WhatIsReadAroundTheWindowChangesNoBitWithin) {
    WideTiff tiff;
    const TerrainInput wide = read(tiff);
    EXPECT_EQ(wide.grid->nx(), 500u);
    EXPECT_EQ(wide.grid->ny(), 400u);
    // Exactly the pixels of the window: nothing lies around it.
    const TerrainInput narrow = read(tiff.part(217, 168, 66, 64), "narrow.tif");
    EXPECT_EQ(narrow.grid->nx(), 66u);
    expectSameWindow(*wide.grid, *narrow.grid);
    expectHills(*wide.grid, -249.0, 249.0, -199.0, 199.0, 0.02);
    EXPECT_EQ(wide.findings.list().size(), narrow.findings.list().size());
}

TEST_F(WideTerrain, CellsThatAreNotSquareGoOnFromThoseOfTheWindow) {
    WideTiff tiff;
    tiff.rows = 800;
    tiff.place[5] = -0.5;
    const TerrainInput wide = read(tiff);
    const TerrainInput narrow = read(tiff.part(217, 330, 66, 140), "narrow.tif");
    ASSERT_EQ(wide.grid->cell(), 0.5);
    expectSameWindow(*wide.grid, *narrow.grid);
    // A bilinear surface between heights 1 m apart.
    expectHills(*wide.grid, -249.0, 249.0, -199.0, 199.0, 0.02);
}

TEST_F(WideTerrain, ATurnedRasterIsReadToItsCorners) {
    WideTiff tiff;
    tiff.place = {-250.0, 0.8, 0.6, 0.0, 0.6, -0.8};
    const TerrainInput wide = read(tiff);
    EXPECT_GT(wide.grid->nx(), 600u);
    // Along the middle of the raster, 200 m from its near corner to beyond the window.
    for (double t = 20.0; t < 480.0; t += 1.0) {
        const double x = -250.0 + 0.8 * t + 0.6 * 200.0;
        const double y = 0.6 * t - 0.8 * 200.0;
        ASSERT_NEAR(wide.grid->height(x, y), hills(x, y), 0.02) << x << " " << y;
        ASSERT_EQ(wide.grid->source(x, y), TerrainGrid::Source::Raster);
    }
    const TerrainGrid& grid = *wide.grid;
    EXPECT_EQ(grid.source(grid.x0() + 1.0, grid.y0() + 1.0), TerrainGrid::Source::Ended) << "a corner of the box around it";
}

TEST_F(WideTerrain, NoDataAtTheEdgeIsBeyondTheRasterAndAHoleIsNot) {
    WideTiff tiff;
    tiff.height = [](double x, double y) {
        const bool collar = x > 180.0 + 5.0 * std::sin(y / 11.0);
        const bool hole = std::hypot(x - 100.0, y - 50.0) < 4.0;
        return collar ? -9999.0 : hole ? std::numeric_limits<double>::quiet_NaN() : hills(x, y);
    };
    const TerrainInput wide = read(tiff);
    const TerrainGrid& grid = *wide.grid;
    EXPECT_EQ(grid.source(170.0, 0.0), TerrainGrid::Source::Raster);
    EXPECT_EQ(grid.source(190.0, 0.0), TerrainGrid::Source::Ended);
    EXPECT_EQ(grid.source(249.0, -150.0), TerrainGrid::Source::Ended);
    EXPECT_EQ(grid.source(100.0, 50.0), TerrainGrid::Source::Raster) << "filled from all around";
    EXPECT_NEAR(grid.height(100.0, 50.0), hills(100.0, 50.0), 1.0);
    EXPECT_GT(wide.findings.count("terrain.wider_filled"), 40);
    EXPECT_LT(wide.findings.count("terrain.wider_filled"), 60);
    EXPECT_EQ(wide.findings.count("terrain.filled"), 0) << "of the window";
    EXPECT_TRUE(std::isfinite(grid.lowest()));
}

TEST_F(WideTerrain, NoDataWithinTheWindowCountsTheSame) {
    WideTiff tiff = WideTiff().part(230, 180, 40, 40);
    tiff.height = [](double x, double y) { return x > 15.0 ? -9999.0 : hills(x, y); };
    const TerrainInput wide = read(tiff);
    EXPECT_EQ(wide.grid->source(10.0, 0.0), TerrainGrid::Source::Raster);
    EXPECT_EQ(wide.grid->source(17.0, 0.0), TerrainGrid::Source::Ended);
}

TEST_F(WideTerrain, WhatCannotBeReadBeyondTheWindowIsAFinding) {
    const auto text = [](int rows) {
        std::ostringstream out;
        out << std::setprecision(15) << "ncols 120\nnrows 400\nxllcorner -60\nyllcorner -200\ncellsize 1\n";
        for (int r = 0; r < rows; ++r) {
            for (int c = 0; c < 120; ++c) {
                out << hills(-59.5 + c, 199.5 - r) << (c < 119 ? ' ' : '\n');
            }
        }
        return out.str();
    };
    std::ofstream(folder / "whole.asc") << text(400);
    std::ofstream(folder / "cut.asc") << text(300);
    const TerrainInput whole = openTerrain(folder / "whole.asc", frame, around, Execution());
    const TerrainInput cut = openTerrain(folder / "cut.asc", frame, around, Execution());
    EXPECT_EQ(whole.findings.count("terrain.wider_unread"), 0);
    EXPECT_EQ(cut.findings.count("terrain.wider_unread"), 1);
    expectSameWindow(*whole.grid, *cut.grid);
    EXPECT_EQ(cut.grid->source(0.0, -100.0), TerrainGrid::Source::Unread);
}

/// 60,000 by 60,000 heights, 29 GB, of which a file holds the 100 m about the structure: elsewhere it has blocks of zeros.
void writeHuge(const std::string& path) {
    GDALAllRegister();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    char** options = nullptr;
    for (const char* option : {"SPARSE_OK=TRUE", "TILED=YES", "BIGTIFF=YES", "COMPRESS=DEFLATE"}) {
        options = CSLAddString(options, option);
    }
    GDALDatasetUniquePtr file(driver->Create(path.c_str(), 60000, 60000, 1, GDT_Float64, options));
    CSLDestroy(options);
    std::array<double, 6> g{-30000.0, 1.0, 0.0, 30000.0, 0.0, -1.0};
    file->SetGeoTransform(g.data());
    GDALRasterBand* band = file->GetRasterBand(1);
    band->SetUnitType("metre");
    std::vector<double> heights;
    for (int r = 0; r < 100; ++r) {
        for (int c = 0; c < 100; ++c) {
            heights.push_back(hills(-49.5 + c, 49.5 - r));
        }
    }
    EXPECT_EQ(band->RasterIO(GF_Write, 29950, 29950, 100, 100, heights.data(), 100, 100, GDT_Float64, 0, 0, nullptr), CE_None);
}

/// kB, the most that this process ever had in memory.
long peakMemory() {
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    return use.ru_maxrss;
}

TEST_F(WideTerrain, ARasterOfGigabytesIsReadAsFarAsThereIsRoom) {
    const WideTiff tiff = WideTiff().part(200, 150, 100, 100);
    writeHuge(folder / "huge.tif");
    const long before = peakMemory();
    const TerrainInput huge = openTerrain(folder / "huge.tif", frame, around, Execution());
    const double nodes = static_cast<double>(huge.grid->nx()) * static_cast<double>(huge.grid->ny());
    EXPECT_LE(nodes, 8e6);
    EXPECT_GT(nodes, 7.9e6);
    EXPECT_EQ(huge.grid->cell(), 1.0);
    EXPECT_EQ(huge.grid->source(1000.0, -1000.0), TerrainGrid::Source::Raster);
    EXPECT_EQ(huge.grid->source(2000.0, 0.0), TerrainGrid::Source::Unread);
    EXPECT_EQ(huge.grid->source(0.0, -29000.0), TerrainGrid::Source::Unread);
    // A few copies of 64 MB while it is made, and what GDAL keeps of what it read.
    EXPECT_LT(peakMemory() - before, 900 * 1024);
    const TerrainInput narrow = read(tiff, "narrow.tif");
    expectSameWindow(*narrow.grid, *huge.grid);
}

}  // namespace
}  // namespace rubble::io
