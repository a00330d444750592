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
#include "io/case/terrain_reader.h"
#include "io/site/cause_evidence.h"
#include "io/site/survey_file.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

constexpr int rasterColumns = 40;
constexpr int rasterRows = 30;
/// What is stored where a mask says that there is nothing.
constexpr double wrong = 400.0;

double plane(double x, double y) {
    return 12.0 + 0.1 * x - 0.05 * y;
}

bool inGap(double x, double y) {
    return x > 4.0 && x < 8.0 && y > 3.0 && y < 7.0;
}

enum class Gap { None, NoData, Mask, Alpha };

/// A height model of 1 m cells around the zero of the local frame, and how its file states the heights.
struct HeightModel {
    std::string crs;
    Eigen::Vector2d middle{0.0, 0.0};  ///< in units of the file
    double step = 1.0;
    std::string unit = "metre";
    double scale = 1.0;
    double offset = 0.0;
    Gap gap = Gap::None;
    /// m, at a place of the file less its middle, in metres.
    std::function<double(double, double)> height = plane;
    double metres = 1.0;  ///< in a unit of height

    void write(const std::string& path) const {
        GDALAllRegister();
        GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
        const int bands = gap == Gap::Alpha ? 2 : 1;
        GDALDatasetUniquePtr file(driver->Create(path.c_str(), rasterColumns, rasterRows, bands, GDT_Float64, nullptr));
        std::array<double, 6> place{middle.x() - 0.5 * rasterColumns * step, step, 0.0,
                                    middle.y() + 0.5 * rasterRows * step,    0.0,  -step};
        file->SetGeoTransform(place.data());
        if (!crs.empty()) {
            OGRSpatialReference system;
            ASSERT_EQ(system.SetFromUserInput(crs.c_str()), OGRERR_NONE);
            file->SetSpatialRef(&system);
        }
        GDALRasterBand& band = *file->GetRasterBand(1);
        band.SetUnitType(unit.c_str());
        band.SetScale(scale);
        band.SetOffset(offset);
        if (gap == Gap::NoData) {
            band.SetNoDataValue(wrong);
        }
        std::vector<double> values;
        std::vector<double> there;
        for (int r = 0; r < rasterRows; ++r) {
            for (int c = 0; c < rasterColumns; ++c) {
                const double x = c + 0.5 - 0.5 * rasterColumns;
                const double y = 0.5 * rasterRows - r - 0.5;
                const bool none = gap != Gap::None && inGap(x, y);
                values.push_back(none ? wrong : (height(x, y) / metres - offset) / scale);
                there.push_back(none ? 0.0 : 255.0);
            }
        }
        fill(band, values);
        if (gap == Gap::Alpha) {
            file->GetRasterBand(2)->SetColorInterpretation(GCI_AlphaBand);
            fill(*file->GetRasterBand(2), there);
        }
        if (gap == Gap::Mask) {
            ASSERT_EQ(file->CreateMaskBand(GMF_PER_DATASET), CE_None);
            fill(*band.GetMaskBand(), there);
        }
    }

    static void fill(GDALRasterBand& band, std::vector<double>& values) {
        ASSERT_EQ(band.RasterIO(GF_Write, 0, 0, rasterColumns, rasterRows, values.data(), rasterColumns, rasterRows, GDT_Float64, 0,
                                0, nullptr),
                  CE_None);
    }
};

/// One raster of heights read through every door: as terrain, as survey and as evidence of a cause.
class HeightDoors : public testing::Test {
protected:
    TemporaryFolder m_folder;
    std::string m_path = m_folder / "heights.tif";
    Frame m_frame;
    Aabb m_around{Vec3(-1.0, -1.0, 12.0), Vec3(1.0, 1.0, 13.0)};
    HeightModel m_model;
    Findings m_said;  ///< by evidence

    SurfaceEvidence asEvidence(EvidenceFile::Kind kind = EvidenceFile::Kind::Surface) {
        SurfaceSettings settings;
        settings.cell = 1.0;
        return readEvidence({kind, m_path}, {m_frame, Site(), SiteSurface{}}, {}, settings, m_said, Execution());
    }
    SurveyInput asSurvey() { return readSurvey(m_path, m_frame, Site(), m_around, Execution()); }
    TerrainInput asTerrain() { return openTerrain(m_path, m_frame, m_around, Execution()); }

    static double at(const SurfaceEvidence& evidence, int i, int j) {
        const std::ptrdiff_t found = evidence.seen.find({j, i});
        return found < 0 ? std::nan("") : evidence.seen.heights[static_cast<std::size_t>(found)];
    }
    /// Writes the model and holds the doors against each other and against the plane.
    void expectSameHeights(double tolerance = 1e-5) {
        m_model.write(m_path);
        const TerrainInput terrain = asTerrain();
        const SurveyInput survey = asSurvey();
        const SurfaceEvidence evidence = asEvidence();
        for (const int i : {-9, -3, 0, 2}) {
            for (const int j : {-8, 0, 1, 7}) {
                const double x = i + 0.5;
                const double y = j + 0.5;
                EXPECT_NEAR(terrain.grid->height(x, y), plane(x, y), tolerance) << x << " " << y;
                EXPECT_NEAR(survey.survey.heights.at(x, y), terrain.grid->height(x, y), tolerance) << x << " " << y;
                EXPECT_NEAR(at(evidence, i, j), terrain.grid->height(x, y), tolerance) << x << " " << y;
            }
        }
        if (m_model.gap != Gap::None) {
            EXPECT_LT(terrain.grid->highest(), 20.0);
            EXPECT_TRUE(std::isnan(survey.survey.heights.at(6.0, 5.0)));
            EXPECT_TRUE(std::isnan(at(evidence, 6, 5)));
            EXPECT_FALSE(std::binary_search(evidence.looked.begin(), evidence.looked.end(), MapCell{5, 6})) << "not looked at";
        }
    }
    /// Every door refuses the file in the same words, which name it and say what to do.
    void expectRefused(const std::string& id) {
        const std::array<std::function<void()>, 4> doors{[&] { asTerrain(); }, [&] { asSurvey(); }, [&] { asEvidence(); },
                                                         [&] { asEvidence(EvidenceFile::Kind::Heights); }};
        for (std::size_t d = 0; d < doors.size(); ++d) {
            try {
                doors[d]();
                ADD_FAILURE() << "door " << d << " took it";
            } catch (const Error& error) {
                EXPECT_EQ(error.message().id, id) << "door " << d << ": " << error.what();
                EXPECT_NE(englishText(error.message()).find(m_path), std::string::npos);
                EXPECT_FALSE(englishText(error.remedy()).empty());
            }
        }
    }
    /// A picture of the site with its place.
    void writePicture(const char* driver, const std::string& name) {
        GDALAllRegister();
        m_path = m_folder / name;
        const GDALDatasetUniquePtr memory(
            GetGDALDriverManager()->GetDriverByName("MEM")->Create("", rasterColumns, rasterRows, 3, GDT_Byte, nullptr));
        std::array<double, 6> place{-20.0, 1.0, 0.0, 15.0, 0.0, -1.0};
        memory->SetGeoTransform(place.data());
        for (int b = 0; b < 3; ++b) {
            memory->GetRasterBand(b + 1)->SetColorInterpretation(static_cast<GDALColorInterp>(GCI_RedBand + b));
            memory->GetRasterBand(b + 1)->Fill(100.0);
        }
        const std::array<const char*, 2> options{"WORLDFILE=YES", nullptr};
        const bool tiff = std::string(driver) == "GTiff";
        const GDALDatasetUniquePtr file(GetGDALDriverManager()->GetDriverByName(driver)->CreateCopy(
            m_path.c_str(), memory.get(), FALSE, tiff ? nullptr : const_cast<char**>(options.data()), nullptr, nullptr));
        ASSERT_TRUE(file);
    }
};

TEST_F(HeightDoors, PlainMetres) {
    expectSameHeights();
}

TEST_F(HeightDoors, ScaleAndOffset) {
    m_model.scale = 0.01;
    m_model.offset = 50.0;
    expectSameHeights();
}

TEST_F(HeightDoors, FeetOfTheBand) {
    m_model.unit = "ft";
    m_model.metres = 0.3048;
    expectSameHeights();
}

TEST_F(HeightDoors, FeetOfTheVerticalSystem) {
    constexpr double foot = 1200.0 / 3937.0;
    m_model.crs = "EPSG:2227+6360";
    m_model.unit = "";
    m_model.metres = foot;
    m_model.step = 1.0 / foot;
    m_model.middle = {1828800.0 / foot, 640080.0 / foot};
    m_frame.crs = "EPSG:2227";
    m_frame.origin = {1828800, 640080, 0};
    expectSameHeights(1e-4);
}

TEST_F(HeightDoors, ValuesForNoData) {
    m_model.gap = Gap::NoData;
    expectSameHeights();
    EXPECT_EQ(m_said.count("survey.gaps"), 16);
    EXPECT_EQ(asSurvey().findings.count("survey.gaps"), 16);
}

TEST_F(HeightDoors, WhatIsAssumedIsSaidByAll) {
    m_model.unit = "";
    m_frame.crs = "EPSG:32633";
    expectSameHeights();
    const TerrainInput terrain = asTerrain();
    const SurveyInput survey = asSurvey();
    for (const char* id : {"terrain.height_unit", "terrain.crs_unknown"}) {
        EXPECT_EQ(terrain.findings.count(id), 1) << id;
        EXPECT_EQ(survey.findings.count(id), 1) << id;
        EXPECT_EQ(m_said.count(id), 1) << id;
    }
}

TEST_F(HeightDoors, Masks) {
    m_model.gap = Gap::Mask;
    expectSameHeights();
}

TEST_F(HeightDoors, TransparentPixels) {
    m_model.gap = Gap::Alpha;
    expectSameHeights();
    EXPECT_EQ(asTerrain().findings.count("terrain.bands"), 0) << "an opacity is no second height";
}

TEST_F(HeightDoors, AnotherSystem) {
    // On the equator at 12 degrees east, where the zones 32 and 33 meet: alike but for a turn of rounding.
    m_model.crs = "EPSG:32632";
    m_model.middle = {833978.113838, 0.0};
    m_frame.crs = "EPSG:32633";
    m_frame.origin = {166021, 0, 0};
    expectSameHeights(0.02);
    EXPECT_EQ(m_said.count("terrain.projected"), 1);
}

TEST_F(HeightDoors, PicturesAreRefused) {
    writePicture("GTiff", "picture.tif");
    expectRefused("terrain.picture");
    writePicture("PNG", "picture.png");
    expectRefused("terrain.picture");
    writePicture("JPEG", "picture.jpg");
    expectRefused("terrain.picture");
}

TEST_F(HeightDoors, FilesThatPointToOthersAreRefused) {
    m_model.write(m_path);
    const GDALDatasetUniquePtr source(GDALDataset::FromHandle(GDALOpen(m_path.c_str(), GA_ReadOnly)));
    m_path = m_folder / "heights.vrt";
    const GDALDatasetUniquePtr pointer(
        GetGDALDriverManager()->GetDriverByName("VRT")->CreateCopy(m_path.c_str(), source.get(), FALSE, nullptr, nullptr, nullptr));
    ASSERT_TRUE(pointer);
    expectRefused("terrain.points_elsewhere");
}

}  // namespace
}  // namespace rubble::io
