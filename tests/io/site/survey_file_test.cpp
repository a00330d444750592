#include "io/site/survey_file.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>

#include "core/evidence/surveys/survey_comparison.h"
#include "io/exports/survey_files.h"
#include "io/site/clouds/point_writer.h"
#include "io/site/surveys/evidence_origin.h"
#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/error_id.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

class SurveyFile : public testing::Test {
protected:
    TemporaryFolder folder;
    Frame frame;

    /// A square of 10 m with a hole of 2 m, moved by an origin, in a format.
    std::string writeSquare(const char* format, const std::string& name, const char* crs, double x0, double y0) {
        GDALAllRegister();
        const std::string path = folder / name;
        GDALDatasetUniquePtr file(
            GetGDALDriverManager()->GetDriverByName(format)->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
        OGRSpatialReference system;
        system.SetFromUserInput(crs);
        system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        OGRLayer* layer = file->CreateLayer("outline", &system, wkbPolygon, nullptr);
        OGRPolygon polygon;
        const auto ring = [&](double low, double high) {
            OGRLinearRing line;
            for (const auto& [x, y] :
                 {std::pair(low, low), std::pair(high, low), std::pair(high, high), std::pair(low, high), std::pair(low, low)}) {
                line.addPoint(x0 + x, y0 + y);
            }
            polygon.addRing(&line);
        };
        ring(0.0, 10.0);
        ring(4.0, 6.0);
        OGRFeature feature(layer->GetLayerDefn());
        feature.SetGeometry(&polygon);
        EXPECT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
        return path;
    }
    std::string refusal(const std::string& name, const SurveyRequest& request = {}) const {
        return idOfError([&] { readSurvey(folder / name, frame, Site(), Aabb(), Execution(), request); });
    }
    /// A GeoJSON of one polygon.
    std::string writePolygon(const std::string& name, const std::string& corners, const std::string& properties = {}) const {
        std::ofstream(folder / name) << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{)" << properties
                                     << R"(},"geometry":{"type":"Polygon","coordinates":[[)" << corners << "]]}}]}";
        return folder / name;
    }
    double areaOf(const Survey& survey) {
        SurveySettings settings;
        settings.cell = 0.25;
        return compareWithSurvey(PieceRaster(), survey, SiteSurface(), Eigen::Vector2d::Zero(), settings, Execution()).survey.area;
    }
};

TEST_F(SurveyFile, OutlinesOfEveryFormatHaveTheirArea) {
    frame.crs = "EPSG:32633";
    frame.origin << 451000, 5311000, 0;
    for (const auto& [format, name] :
         {std::pair("GPKG", "a.gpkg"), std::pair("ESRI Shapefile", "a.shp"), std::pair("FlatGeobuf", "a.fgb")}) {
        const SurveyInput input =
            readSurvey(writeSquare(format, name, "EPSG:32633", 451003.0, 5311007.0), frame, Site(), Aabb(), Execution());
        EXPECT_TRUE(input.survey.isFootprint) << name;
        EXPECT_NEAR(areaOf(input.survey), 96.0, 1e-9) << name;
        EXPECT_NEAR(input.survey.bounds().first.x(), 3.0, 1e-6) << name;
        EXPECT_NEAR(input.survey.bounds().second.y(), 17.0, 1e-6) << name;
        EXPECT_EQ(input.sha256.size(), 64u);
    }
}

TEST_F(SurveyFile, DegreesAreProjected) {
    // 1e-4 degrees are 7.4 and 11.1 m there.
    std::ofstream(folder / "a.geojson")
        << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":)"
        << R"([[[14.3450,47.9500],[14.3451,47.9500],[14.3451,47.9501],[14.3450,47.9501],[14.3450,47.9500]]]}}]})";
    frame.crs = "EPSG:32633";
    const SurveyInput input = readSurvey(folder / "a.geojson", frame, Site(), Aabb(), Execution());
    const auto [low, high] = input.survey.bounds();
    EXPECT_NEAR(high.x() - low.x(), 7.5, 0.3);
    EXPECT_NEAR(high.y() - low.y(), 11.1, 0.3);
    EXPECT_EQ(input.findings.count("survey.projected"), 1);
    frame.crs.clear();
    EXPECT_EQ(refusal("a.geojson"), "survey.degrees");
}

TEST_F(SurveyFile, AnOutlineWithoutItsSystemIsSaid) {
    frame.crs = "EPSG:32633";
    frame.origin << 451000, 5311000, 0;
    const std::string path = writeSquare("ESRI Shapefile", "a.shp", "EPSG:32633", 451003.0, 5311007.0);
    EXPECT_EQ(readSurvey(path, frame, Site(), Aabb(), Execution()).findings.count("survey.unplaced"), 0);
    std::filesystem::remove(folder / "a.prj");
    EXPECT_EQ(readSurvey(path, frame, Site(), Aabb(), Execution()).findings.count("survey.unplaced"), 1);
}

TEST_F(SurveyFile, WhatWasMadeOfASimulatedRunIsSaidToBeNoEvidence) {
    frame.crs = "EPSG:32633";
    const std::string path = writePolygon("a.geojson", "[14.345,47.95],[14.346,47.95],[14.346,47.951],[14.345,47.95]");
    const auto note = [&](const std::string& provenance, const std::string& run) {
        std::ofstream(path + ".provenance.json") << provenance;
        SurveyRequest request;
        request.run = run;
        const SurveyInput input = readSurvey(path, frame, Site(), Aabb(), Execution(), request);
        return std::array{static_cast<std::int64_t>(input.ofRun.size()), input.findings.count("evidence.of_run"),
                          input.findings.count("evidence.of_this_run")};
    };
    const std::string of = R"({"build":"Rubble 0.2.0","fingerprint":"00112233445566778899aabbccddeeff"})";
    EXPECT_EQ(note(of, {}), (std::array<std::int64_t, 3>{32, 1, 0}));
    EXPECT_EQ(note(of, "ffffffffffffffffffffffffffffffff"), (std::array<std::int64_t, 3>{32, 1, 0}));
    EXPECT_EQ(note(of, "00112233445566778899aabbccddeeff"), (std::array<std::int64_t, 3>{32, 0, 1}));
    for (const char* none : {"", "{", "[1]", R"({"build":"x","fingerprint":7})",
                             R"({"build":"Rubble 0.2.0","fingerprint":"0011","simulated":false})"}) {
        EXPECT_EQ(note(none, {}), (std::array<std::int64_t, 3>{0, 0, 0})) << none;
    }
    // Who drew the area to be compared is of no account.
    std::ofstream(path + ".provenance.json") << of;
    Findings findings;
    readScope(path, frame, Site(), findings, Execution());
    EXPECT_EQ(findings.count("evidence.of_run"), 0);
}

/// A sheet of points as a scan of a run would be written.
std::string writeScanOf(const std::string& path, const std::string& run) {
    WrittenCloud cloud;
    cloud.points = 400;
    cloud.run = run;
    for (int k = 0; k < 400; ++k) {
        cloud.box.extend(Vec3(k % 20, k / 20, 0.01 * (k % 7)));
    }
    writePoints(path, cloud, [&](std::size_t k, WrittenPoint& point) {
        point.place = Vec3(static_cast<double>(k % 20), static_cast<double>(k / 20), 0.01 * static_cast<double>(k % 7));
    });
    return path;
}

TEST_F(SurveyFile, AScanOfARunIsKnownByItsContentUnderAnyName) {
    const std::string of = "00112233445566778899aabbccddeeff";
    const Aabb window(Vec3(0.0, 0.0, 0.0), Vec3(20.0, 20.0, 1.0));
    const auto read = [&](const std::string& path, const std::string& run) {
        SurveyRequest request;
        request.run = run;
        return readSurvey(path, frame, Site(), window, Execution(), request);
    };
    for (const char* name : {"site.las", "site.ply"}) {
        const std::string path = writeScanOf(folder / name, of);
        EXPECT_EQ(read(path, {}).ofRun, of) << name;
        const SurveyInput held = read(path, of);
        ASSERT_FALSE(held.findings.empty());
        EXPECT_EQ(held.findings.list().front().what.id, "evidence.of_this_run") << "before all else: " << name;
        EXPECT_EQ(read(path, "ffffffffffffffffffffffffffffffff").findings.list().front().what.id, "evidence.of_run") << name;
        EXPECT_EQ(surveyOriginOf(path, {}).run, of) << name;
    }
    // What says no fingerprint in hex says none; such a file, as one that was written before, is ours all the same.
    for (const char* none : {"", "0011", "00112233445566778899aabbccddeefg"}) {
        const SurveyInput old = read(writeScanOf(folder / "old.las", none), of);
        EXPECT_TRUE(old.ofRun.empty()) << none;
        EXPECT_EQ(old.findings.count("evidence.ours"), 1) << none;
        EXPECT_TRUE(surveyOriginOf(writeScanOf(folder / "old.ply", none), {}).run.empty()) << none;
    }
    // A cloud of another program is measured as far as anybody knows.
    MadeLas las;
    for (int k = 0; k < 400; ++k) {
        las.points.emplace_back().place = {100 * (k % 20), 100 * (k / 20), k % 7};
    }
    EXPECT_TRUE(surveyOriginOf(layCloud(folder / "measured.las", las.bytes()), {}).measured());
}

TEST_F(SurveyFile, WhatHasNoPlaceInTheCaseIsRefused) {
    frame.crs = "EPSG:32633";
    writePolygon("a.geojson", "[1000,1000],[1010,1000],[1010,1004],[1000,1000]");
    EXPECT_EQ(refusal("a.geojson"), "survey.corner") << "no degrees of the Earth";
    frame.crs = "+proj=merc +R=1737400 +units=m +no_defs";
    const std::string corners = "[14.345,47.95],[14.346,47.95],[14.346,47.951],[14.345,47.95]";
    writePolygon("b.geojson", corners);
    const std::string moon = refusal("b.geojson");
    EXPECT_TRUE(moon == "survey.no_way" || moon == "survey.corner" || moon.empty()) << moon;
}

TEST_F(SurveyFile, LiveStructureOfOurOwnOutlinesIsLeftOutAndCounted) {
    frame.crs = "EPSG:32633";
    const std::string live = R"("of":"live structure")";
    const std::string corners = "[14.345,47.95],[14.346,47.95],[14.346,47.951],[14.345,47.95]";
    const std::string path = writePolygon("a.geojson", corners, live);
    SurveyRequest request;
    EXPECT_EQ(refusal("a.geojson", request), "survey.no_polygon") << "nothing else is in it";
    std::ofstream(path) << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{)" << live
                        << R"(},"geometry":{"type":"Polygon","coordinates":[[)" << corners
                        << R"(]]}},{"type":"Feature","properties":{"of":"fragments"},"geometry":{"type":"Polygon","coordinates":[[)"
                        << corners << "]]}}]}";
    EXPECT_EQ(readSurvey(path, frame, Site(), Aabb(), Execution(), request).findings.count("survey.live"), 1);
    request.withFallen = true;
    EXPECT_EQ(readSurvey(path, frame, Site(), Aabb(), Execution(), request).findings.count("survey.live"), 0);
}

TEST_F(SurveyFile, AnOutlineOfMillionsOfCornersIsRefused) {
    GDALAllRegister();
    {
        GDALDatasetUniquePtr file(GetGDALDriverManager()
                                      ->GetDriverByName("FlatGeobuf")
                                      ->Create((folder / "many.fgb").c_str(), 0, 0, 0, GDT_Unknown, nullptr));
        ASSERT_TRUE(file);
        OGRLayer* layer = file->CreateLayer("outline", nullptr, wkbPolygon, nullptr);
        OGRLinearRing ring;
        constexpr int corners = 2'000'001;
        ring.setNumPoints(corners);
        for (int p = 0; p < corners; ++p) {
            const double angle = 2.0 * M_PI * p / (corners - 1);
            ring.setPoint(p, 100.0 * std::cos(angle), 100.0 * std::sin(angle));
        }
        OGRPolygon polygon;
        polygon.addRing(&ring);
        OGRFeature feature(layer->GetLayerDefn());
        feature.SetGeometry(&polygon);
        ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
    }
    EXPECT_EQ(refusal("many.fgb"), "survey.too_many");
}

TEST_F(SurveyFile, OutlinesThatOverlapCoverWhatTheyCoverTogether) {
    std::ofstream(folder / "a.geojson")
        << R"({"type":"FeatureCollection","features":[)"
        << R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":)"
        << R"([[[1000,1000],[1010,1000],[1010,1004],[1000,1004],[1000,1000]]]}},)"
        << R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":)"
        << R"([[[1006,1000],[1016,1000],[1016,1004],[1006,1004],[1006,1000]]]}},)"
        << R"({"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[1003,1001]}}]})";
    frame.origin << 1000, 1000, 0;
    const SurveyInput input = readSurvey(folder / "a.geojson", frame, Site(), Aabb(), Execution());
    EXPECT_NEAR(areaOf(input.survey), 64.0, 1e-9);
    EXPECT_EQ(input.findings.count("survey.other_shapes"), 1);
    EXPECT_EQ(input.findings.count("survey.no_degrees"), 1) << "GeoJSON says degrees";
    SurveyRequest heights;
    heights.holds = SurveyRequest::Holds::Heights;
    EXPECT_EQ(refusal("a.geojson", heights), "terrain.unknown_format");
    SurveyRequest outline;
    outline.holds = SurveyRequest::Holds::Outline;
    std::ofstream(folder / "a.asc") << "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 1\n1 1\n";
    EXPECT_EQ(refusal("a.asc", outline), "survey.no_outline");
}

TEST_F(SurveyFile, NeitherHeightsNorPolygonsAreRefused) {
    EXPECT_EQ(refusal("none.tif"), "survey.missing");
    std::ofstream(folder / "a.txt") << "nothing of the kind\n";
    EXPECT_EQ(refusal("a.txt"), "terrain.unknown_format");
    std::ofstream(folder / "b.geojson")
        << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":)"
        << R"({"type":"Point","coordinates":[1,2]}}]})";
    frame.crs = "EPSG:32633";
    EXPECT_EQ(refusal("b.geojson"), "survey.no_polygon");
}

TEST_F(SurveyFile, HeightsKeepTheirGaps) {
    const AsciiGrid around{20, 20, -10.0, -10.0};
    around.write(folder / "a.asc", [](double x, double y) {
        return x < -5.0 ? std::numeric_limits<double>::quiet_NaN() : x < 5.0 && y > 0.0 ? 2.0 : 0.0;
    });
    const SurveyInput input = readSurvey(folder / "a.asc", frame, Site(), Aabb(), Execution());
    EXPECT_FALSE(input.survey.isFootprint);
    EXPECT_TRUE(std::isnan(input.survey.heights.at(-8.0, 3.0)));
    EXPECT_EQ(input.survey.heights.at(0.0, 3.0), 2.0);
    EXPECT_EQ(input.survey.heights.at(0.0, -3.0), 0.0);
}

/// A wall of 3 m, and debris of 1 m that lies 30 heights east of it; the survey reaches 60 heights.
class SurveyOfALongRun : public SurveyFile {
protected:
    Aabb m_structure{Vec3(-2.0, -1.0, 0.0), Vec3(2.0, 1.0, 3.0)};
    Aabb m_debris{Vec3(0.0, -2.0, 0.0), Vec3(92.0, 2.0, 1.0)};

    static double surface(double x, double y) { return x > 88.0 && x < 92.0 && std::abs(y) < 2.0 ? 1.0 : 0.0; }
    SurveyComparison compared(const SiteWindow& window, const Site& site = Site(), const SurveyRequest& request = {}) const {
        const SurveyInput input = readSurvey(folder / "a.asc", frame, site, window, Execution(), request);
        MapPiece piece;
        piece.centre = piece.box.centre = Vec3(90.0, 0.0, 0.5);
        piece.box.halfExtents = Vec3(2.0, 2.0, 0.5);
        SurveySettings settings;
        settings.leastHeight = 0.5;
        return compareWithSurvey(rasterOf(std::vector{piece}, settings.cell, SiteSurface{}, Execution()), input.survey,
                                 SiteSurface(), Eigen::Vector2d::Zero(), settings, Execution());
    }
};

TEST_F(SurveyOfALongRun, DebrisBeyondTenHeightsIsCompared) {
    AsciiGrid{400, 100, -200.0, -50.0}.write(folder / "a.asc", surface);
    const SurveyComparison cut = compared(m_structure);
    EXPECT_EQ(cut.survey.area, 0.0) << "what only knows the structure reads ten heights";
    EXPECT_NEAR(cut.unsurveyedArea, 16.0, 1e-9);
    const SurveyComparison whole = compared({m_structure, m_debris});
    EXPECT_NEAR(whole.survey.area, 16.0, 1e-9);
    EXPECT_NEAR(whole.iou, 1.0, 1e-12);
    EXPECT_EQ(whole.unsurveyedArea, 0.0);
    // Two heights around the debris, no more: a survey of a region is not read for one stone.
    EXPECT_TRUE(
        std::isnan(readSurvey(folder / "a.asc", frame, Site(), {m_structure, m_debris}, Execution()).survey.heights.at(120, 0)));
}

TEST_F(SurveyOfALongRun, SoIsThatOfATurnedFrameAndOfAMovedSurvey) {
    // The frame is turned by 90 degrees against the file: east of the wall is north of it.
    Site site;
    site.controlPoints = {{"a", Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.0, 0.0), true},
                          {"b", Vec3(10.0, 0.0, 0.0), Vec3(0.0, 10.0, 0.0), true}};
    AsciiGrid{100, 400, -50.0, -200.0}.write(folder / "a.asc", [](double x, double y) { return surface(y, -x); });
    EXPECT_NEAR(compared({m_structure, m_debris}, site).survey.area, 16.0, 1.0);
    EXPECT_EQ(compared(m_structure, site).survey.area, 0.0);
    // The file lies 500 m too far east, which the registration of the case says.
    AsciiGrid{400, 100, 300.0, -50.0}.write(folder / "a.asc", [](double x, double y) { return surface(x - 500.0, y); });
    SurveyRequest request;
    request.registration.emplace();
    request.registration->shift = Vec3(-500.0, 0.0, 0.0);
    EXPECT_NEAR(compared({m_structure, m_debris}, Site(), request).survey.area, 16.0, 1e-9);
}

TEST_F(SurveyFile, TheDifferenceMapComesBackThroughGdal) {
    frame.crs = "EPSG:32633";
    frame.origin << 451000, 5311000, 0;
    const SurveyInput input =
        readSurvey(writeSquare("GPKG", "a.gpkg", "EPSG:32633", 451003.0, 5311007.0), frame, Site(), Aabb(), Execution());
    const SurveyComparison made =
        compareWithSurvey(PieceRaster(), input.survey, SiteSurface(), Eigen::Vector2d::Zero(), SurveySettings(), Execution());
    MapOrigin origin;
    origin.frame = frame;
    origin.provenance = "{}";
    origin.facts = {{"RUBBLE_CLASS", "simulated less surveyed"}};
    const std::string path = folder / "d.tif";
    writeSurveyTiff(path, made, origin, Execution());
    GDALDatasetUniquePtr file(GDALDataset::FromHandle(GDALOpen(path.c_str(), GA_ReadOnly)));
    ASSERT_TRUE(file);
    EXPECT_EQ(file->GetRasterCount(), 3);
    EXPECT_STREQ(file->GetMetadataItem("RUBBLE_CLASS"), "simulated less surveyed");
    EXPECT_STREQ(file->GetSpatialRef()->GetAuthorityCode(nullptr), "32633");
    std::array<double, 6> g{};
    file->GetGeoTransform(g.data());
    // A place 1 m into the square from its south-west corner.
    const int column = static_cast<int>(std::floor((451004.0 - g[0]) / g[1]));
    const int row = static_cast<int>(std::floor((5311008.0 - g[3]) / g[5]));
    double value = 0.0;
    ASSERT_EQ(file->GetRasterBand(1)->RasterIO(GF_Read, column, row, 1, 1, &value, 1, 1, GDT_Float64, 0, 0, nullptr), CE_None);
    EXPECT_EQ(value, -1.0);
    ASSERT_EQ(file->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, 1, 1, &value, 1, 1, GDT_Float64, 0, 0, nullptr), CE_None);
    EXPECT_EQ(value, -9999.0);
}

}  // namespace
}  // namespace rubble::io
