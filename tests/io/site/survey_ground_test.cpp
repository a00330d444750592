#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "core/evidence/surveys/survey_comparison.h"
#include "io/case/terrain_reader.h"
#include "io/site/survey_file.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

constexpr int townSide = 80;

/// A surface model of a slope with a house that is turned against every grid, a pole and, if asked for, a mark that no file names.
double townAt(double x, double y) {
    const double along = std::cos(0.4) * x + std::sin(0.4) * y;
    const double across = -std::sin(0.4) * x + std::cos(0.4) * y;
    const double house = std::abs(along - 2.0) < 7.0 && std::abs(across) < 4.0 ? 6.0 : 0.0;
    return 50.0 + 0.1 * x - 0.07 * y + 0.4 * std::sin(0.5 * x + 0.3 * y) + house;
}

/// How a raster of the town lies, and the case that it is read into.
struct TownRaster {
    std::string name;
    std::array<double, 6> place{-40.0, 1.0, 0.0, 40.0, 0.0, -1.0};
    std::string crs;
    Frame frame;
    Site site;
    bool turned = false;
};

void PrintTo(const TownRaster& town, std::ostream* out) {
    *out << town.name;
}

std::vector<TownRaster> towns() {
    std::vector<TownRaster> all(5);
    all[0].name = "upright";
    all[1].name = "turned";
    all[1].place = {-52.0, 0.8, 0.6, 8.0, 0.6, -0.8};
    all[1].turned = true;
    all[2].name = "degrees";
    all[2].crs = "EPSG:4326";
    all[2].place = {12.0 - 40.0e-5, 1.0e-5, 0.0, 48.0 + 30.0e-5, 0.0, -0.75e-5};
    all[2].frame.crs = "EPSG:32633";
    all[2].frame.origin << 276224, 5320655, 0;
    all[2].turned = true;
    all[3].name = "a quarter of a cell off";
    all[3].site.controlPoints = {{"a", Vec3(0.0, 0.0, 0.0), Vec3(0.25, 0.25, 0.0), true},
                                 {"b", Vec3(30.0, 0.0, 0.0), Vec3(30.25, 0.25, 0.0), true}};
    all[4].name = "turned by control points";
    all[4].site.controlPoints = {{"a", Vec3(0.0, 0.0, 0.0), Vec3(1.0, 2.0, 0.0), true},
                                 {"b", Vec3(30.0, 0.0, 0.0), Vec3(1.0 + 24.0, 2.0 + 18.0, 0.0), true}};
    all[4].turned = true;
    return all;
}

class SurveyOfTheGround : public testing::TestWithParam<TownRaster> {
protected:
    TemporaryFolder m_folder;
    Aabb m_around{Vec3(-3.0, -3.0, 50.0), Vec3(3.0, 3.0, 52.0)};

    /// @param height  m, of a column and a row of the file, counted as places of the town
    std::string write(const std::string& name, const std::function<double(double, double)>& height) {
        GDALAllRegister();
        const std::string path = m_folder / name;
        GDALDatasetUniquePtr file(
            GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), townSide, townSide, 1, GDT_Float64, nullptr));
        std::array<double, 6> g = GetParam().place;
        file->SetGeoTransform(g.data());
        if (!GetParam().crs.empty()) {
            OGRSpatialReference system;
            system.SetFromUserInput(GetParam().crs.c_str());
            file->SetSpatialRef(&system);
        }
        file->GetRasterBand(1)->SetUnitType("metre");
        std::vector<double> values;
        for (int row = 0; row < townSide; ++row) {
            for (int column = 0; column < townSide; ++column) {
                values.push_back(height(column + 0.5 - 0.5 * townSide, 0.5 * townSide - row - 0.5));
            }
        }
        EXPECT_EQ(file->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, townSide, townSide, values.data(), townSide, townSide,
                                                   GDT_Float64, 0, 0, nullptr),
                  CE_None);
        return path;
    }
    SurveyInput survey(const std::string& path, const std::string& ground) {
        SurveyRequest request;
        request.ground = ground;
        return readSurvey(path, GetParam().frame, GetParam().site, m_around, Execution(), request);
    }
    TerrainInput terrain(const std::string& path) {
        return openTerrain(path, GetParam().frame, m_around, Execution(), GetParam().site);
    }
};

TEST_P(SurveyOfTheGround, ASurveyThatEqualsTheTerrainIsNothing) {
    const std::string path = write("town.tif", [](double x, double y) {
        const bool pole = std::abs(x - 9.5) < 0.1 && std::abs(y + 7.5) < 0.1;
        return pole ? 95.0 : townAt(x, y);
    });
    const TerrainInput ground = terrain(path);
    EXPECT_EQ(ground.findings.count("terrain.spikes"), 1);
    const SurveyInput same = survey(path, path);
    EXPECT_EQ(same.findings.count("terrain.spikes"), 1) << "taken out of both";
    SurveySettings settings;
    settings.leastHeight = 0.01;
    const SiteSurface surface{true, 0.0, ground.grid};
    const SurveyComparison made =
        compareWithSurvey(PieceRaster(), same.survey, surface, Eigen::Vector2d::Zero(), settings, Execution());
    EXPECT_EQ(made.survey.area, 0.0);
    EXPECT_EQ(made.survey.volume, 0.0);
    EXPECT_EQ(made.noise.source, SurveyNoise::Source::Estimated);
    EXPECT_LT(made.noise.deviation, 1e-6);
    // Only around the pole the ground is filled and the survey has a gap: nothing is made of it.
    // The way back from a projection is found to a millionth of a pixel.
    EXPECT_LT(made.volumes.fill + made.volumes.cut, 1e-3);
    // Ground that did not have to be interpolated needs no file of its own.
    if (!GetParam().turned) {
        const SurveyInput plain = survey(path, "");
        EXPECT_EQ(
            compareWithSurvey(PieceRaster(), plain.survey, surface, Eigen::Vector2d::Zero(), settings, Execution()).survey.area,
            0.0);
    }
}

TEST_P(SurveyOfTheGround, ResamplingIsSaidAndAShiftTakesNone) {
    const std::string path = write("town.tif", townAt);
    const TerrainInput ground = terrain(path);
    const SurveyInput read = survey(path, path);
    EXPECT_EQ(ground.findings.count("terrain.resampled"), GetParam().turned ? 1 : 0);
    EXPECT_EQ(read.findings.count("terrain.turned"), GetParam().turned ? 1 : 0);
    EXPECT_EQ(read.survey.heights.lattice.has_value(), GetParam().turned);
    for (const Finding& finding : ground.findings.list()) {
        if (finding.what.id == "terrain.resampled") {
            // The walls of the house are 6 m high; what lies beside them is smooth.
            EXPECT_GT(std::get<double>(finding.what.arguments[2].value), 0.3);
            EXPECT_LT(std::get<double>(finding.what.arguments[2].value), 6.0);
        }
    }
    if (!GetParam().turned) {
        // Heights of the file stand at its nodes as they are.
        const double off = GetParam().site.controlPoints.empty() ? 0.0 : 0.25;
        for (const double x : {-20.5, 3.5, 11.5}) {
            EXPECT_EQ(ground.grid->height(x - off, 4.5 - off), townAt(x, 4.5));
            EXPECT_EQ(read.survey.heights.at(x - off, 4.5 - off), townAt(x, 4.5));
        }
    }
}

TEST_P(SurveyOfTheGround, HeightsOfTheFileAreInterpolatedOnce) {
    const SurveyInput read = survey(write("town.tif", townAt), "");
    const SurveyHeights& heights = read.survey.heights;
    // Where the file has a height that is what the survey says, and half-way between two their mean.
    int seen = 0;
    for (std::size_t row = 2; row + 2 < heights.ny; row += 7) {
        for (std::size_t column = 2; column + 2 < heights.nx; column += 7) {
            const auto c = static_cast<double>(column);
            const auto r = static_cast<double>(row);
            const Eigen::Vector2d at = heights.placeOf(c, r);
            const Eigen::Vector2d between = heights.placeOf(c + 0.5, r);
            const double own = heights.heights[row * heights.nx + column];
            if (at.allFinite() && between.allFinite() && at.cwiseAbs().maxCoeff() < 15.0) {
                EXPECT_NEAR(heights.at(at.x(), at.y()), own, 1e-5);
                EXPECT_NEAR(heights.at(between.x(), between.y()), 0.5 * (own + heights.heights[row * heights.nx + column + 1]),
                            1e-5);
                ++seen;
            }
        }
    }
    EXPECT_GT(seen, 8);
}

TEST_P(SurveyOfTheGround, MarksThatNoFileNamesSpoilNoNeighbour) {
    const std::string path = write("town.tif", [](double x, double y) {
        const bool mark = x > 5.0 && x < 9.0 && y > 5.0 && y < 9.0;
        return mark ? -99999.0 : 50.0 + 0.1 * x;
    });
    const TerrainInput ground = terrain(path);
    EXPECT_GT(ground.findings.count("terrain.no_land"), 0);
    EXPECT_GT(ground.grid->lowest(), 40.0);
    const SurveyInput read = survey(path, "");
    for (const double height : read.survey.heights.heights) {
        EXPECT_TRUE(std::isnan(height) || height > 40.0) << height;
    }
}

INSTANTIATE_TEST_SUITE_P(Rasters, SurveyOfTheGround, testing::ValuesIn(towns()));

}  // namespace
}  // namespace rubble::io
