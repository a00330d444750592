#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>

#include "core/evidence/surveys/survey_comparison.h"
#include "core/fe/frame_transform.h"
#include "io/exports/map_files.h"
#include "io/exports/survey_files.h"
#include "io/site/cause_evidence.h"
#include "io/site/map_place.h"
#include "io/site/survey_file.h"
#include "tests/core/analysis/debris_scene.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

/// A case whose local frame lies somewhere on Earth, and where by a formula of its own.
struct Lies {
    std::string name;
    Frame frame;
    Site site;
    std::function<Eigen::Vector2d(const Eigen::Vector2d&)> world;  ///< m, easting and northing
    double zero = 0.0;                                             ///< m, height of the local zero
    double scale = 1.0;
    double angle = 0.0;  ///< rad
};

void PrintTo(const Lies& lies, std::ostream* out) {
    *out << lies.name;
}

Lies byOrigin(const std::string& upAxis, std::array<std::int64_t, 3> origin) {
    Lies lies;
    lies.name = "origin, up " + upAxis;
    lies.frame.origin = {origin[0], origin[1], origin[2]};
    lies.frame.upAxis = upAxis;
    lies.frame.crs = "EPSG:25832";
    lies.world = [](const Eigen::Vector2d& local) { return Eigen::Vector2d(local.x() + 500000.0, local.y() + 5700000.0); };
    lies.zero = 100.0;
    return lies;
}

/// Three control points of a frame that is turned and scaled; the origin of the frame says something else.
Lies byPoints(double degrees, double scale) {
    Lies lies;
    lies.name = "control points, " + std::to_string(degrees) + " degrees";
    lies.frame.origin = {7, 8, 9};
    lies.frame.crs = "EPSG:25832";
    lies.angle = degrees / 180.0 * M_PI;
    lies.scale = scale;
    lies.zero = 250.5;
    lies.world = [angle = lies.angle, scale](const Eigen::Vector2d& local) {
        return Eigen::Vector2d(612345.25 + scale * (std::cos(angle) * local.x() - std::sin(angle) * local.y()),
                               5654321.75 + scale * (std::sin(angle) * local.x() + std::cos(angle) * local.y()));
    };
    for (const Vec3& local : {Vec3(0, 0, 0), Vec3(80, 5, 3), Vec3(-10, 60, 7)}) {
        const Eigen::Vector2d at = lies.world(local.head<2>());
        lies.site.controlPoints.push_back({"P", local, Vec3(at.x(), at.y(), local.z() + lies.zero), true});
    }
    return lies;
}

class WorldPlace : public testing::TestWithParam<Lies> {
protected:
    void SetUp() override {
        GDALAllRegister();
        for (std::size_t f = 0; f < m_debris.fragments.size(); ++f) {
            m_set.list.emplace_back().component = ComponentId{};
        }
        const std::vector<double> none(m_debris.fragments.size(), 1.0);
        m_pieces = mapPieces(m_set, m_debris, none, {});
        MapSettings settings;
        settings.cell = 0.5;
        m_map = makeDebrisMap(3.5, m_pieces, false, nullptr, {"all"}, SiteSurface{}, settings, Execution());
        m_origin.frame = GetParam().frame;
        m_origin.site = GetParam().site;
        m_origin.facts = {{"RUBBLE_CLASS", "simulated"}};
        m_origin.provenance = "{}";
    }
    GDALDatasetUniquePtr open(const std::string& path, unsigned kind) {
        return GDALDatasetUniquePtr(GDALDataset::FromHandle(GDALOpenEx(path.c_str(), kind, nullptr, nullptr, nullptr)));
    }
    Eigen::Vector2d middle(const MapCell& cell) const { return m_map.cell * Eigen::Vector2d(cell.i + 0.5, cell.j + 0.5); }
    void writePackage(const std::string& path) {
        const std::vector<double> arrivals(m_debris.fragments.size(), 1.0);
        writeMapPackage(path, m_map, {&m_set, &m_debris, {}, arrivals, {}}, 0.5, m_origin, Execution());
    }

    const Lies& m_lies = GetParam();
    TemporaryFolder m_folder;
    Debris m_debris = analysis_scene::randomField(4, 120, 8.0);
    FragmentSet m_set;
    std::vector<MapPiece> m_pieces;
    DebrisMap m_map;
    MapOrigin m_origin;
};

TEST_P(WorldPlace, ThePixelOfACellIsWhereTheCellIsOnEarth) {
    const std::string path = m_folder / "map.tif";
    writeMapTiff(path, m_map, m_map.present(), m_origin, Execution());
    const GDALDatasetUniquePtr file = open(path, GDAL_OF_RASTER);
    ASSERT_TRUE(file);
    ASSERT_NE(file->GetSpatialRef(), nullptr);
    EXPECT_STREQ(file->GetSpatialRef()->GetAuthorityCode(nullptr), "25832");
    std::array<double, 6> g{};
    std::array<double, 6> back{};
    ASSERT_EQ(file->GetGeoTransform(g.data()), CE_None);
    ASSERT_TRUE(GDALInvGeoTransform(g.data(), back.data()));
    EXPECT_EQ(g[2] != 0.0, m_lies.angle != 0.0) << "turned as the frame is, and no more";
    EXPECT_NEAR(std::hypot(g[1], g[4]), m_lies.scale * m_map.cell, 1e-9);
    GDALRasterBand& mass = *file->GetRasterBand(3);
    ASSERT_STREQ(mass.GetDescription(), "mass");
    for (std::size_t c = 0; c < m_map.cells.size(); ++c) {
        const Eigen::Vector2d at = m_lies.world(middle(m_map.cells[c]));
        const double column = back[0] + at.x() * back[1] + at.y() * back[2];
        const double row = back[3] + at.x() * back[4] + at.y() * back[5];
        // The middle of a pixel: coordinates of millions hold nine places.
        EXPECT_NEAR(column - std::floor(column), 0.5, 1e-6);
        EXPECT_NEAR(row - std::floor(row), 0.5, 1e-6);
        double value = 0.0;
        ASSERT_EQ(
            mass.RasterIO(GF_Read, static_cast<int>(column), static_cast<int>(row), 1, 1, &value, 1, 1, GDT_Float64, 0, 0, nullptr),
            CE_None);
        const double expected = m_map.layer(MapLayer::Mass)[c];
        EXPECT_EQ(value, std::isnan(expected) ? -9999.0 : expected);
    }
}

TEST_P(WorldPlace, OutlinesAndFragmentsOfAPackageAreWhereTheyAreOnEarth) {
    const std::string path = m_folder / "map.gpkg";
    writePackage(path);
    const GDALDatasetUniquePtr file = open(path, GDAL_OF_VECTOR);
    ASSERT_TRUE(file);
    EXPECT_STREQ(file->GetLayer(0)->GetSpatialRef()->GetAuthorityCode(nullptr), "25832");
    std::size_t seen = 0;
    for (const OGRFeatureUniquePtr& feature : *file->GetLayerByName("fragments")) {
        const auto f = static_cast<std::size_t>(feature->GetFieldAsInteger64("fragment_id"));
        const Vec3& centre = m_debris.fragments[f].centre;
        const Eigen::Vector2d at = m_lies.world(centre.head<2>());
        OGRPoint found;
        feature->GetGeometryRef()->toPolygon()->Centroid(&found);
        EXPECT_NEAR(found.getX(), at.x(), 1e-5);
        EXPECT_NEAR(found.getY(), at.y(), 1e-5);
        EXPECT_NEAR(feature->GetFieldAsDouble("centre_z_m"), centre.z() + m_lies.zero, 1e-9);
        ++seen;
    }
    EXPECT_EQ(seen, m_debris.fragments.size());
    double area = 0.0;
    for (const OGRFeatureUniquePtr& feature : *file->GetLayerByName("footprint")) {
        area += feature->GetGeometryRef()->toPolygon()->get_Area();
    }
    EXPECT_NEAR(area, m_lies.scale * m_lies.scale * m_map.ledger.footprintArea, 1e-3 * area);
    // Every corner of a contour lies between the middles of cells: turned back it is within the map.
    for (const OGRFeatureUniquePtr& feature : *file->GetLayerByName("contours")) {
        OGREnvelope box;
        feature->GetGeometryRef()->getEnvelope(&box);
        const Eigen::Vector2d middleOf = m_lies.world(Eigen::Vector2d::Zero());
        EXPECT_LT(std::hypot(0.5 * (box.MinX + box.MaxX) - middleOf.x(), 0.5 * (box.MinY + box.MaxY) - middleOf.y()), 20.0);
    }
}

TEST_P(WorldPlace, ATableHasEastingAndNorthing) {
    const std::string path = m_folder / "map.csv";
    writeMapCsv(path, m_map, {MapLayer::Mass}, m_origin, Execution());
    std::ifstream in(path);
    std::string line;
    std::getline(in, line);
    for (const MapCell& cell : m_map.cells) {
        ASSERT_TRUE(std::getline(in, line));
        double x = 0.0;
        double y = 0.0;
        ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf", &x, &y), 2);
        EXPECT_NEAR(x, m_lies.world(middle(cell)).x(), 1e-8);
        EXPECT_NEAR(y, m_lies.world(middle(cell)).y(), 1e-8);
    }
}

TEST_P(WorldPlace, WhatIsWrittenComesBackWhereItWas) {
    const std::string tiff = m_folder / "map.tif";
    writeMapTiff(tiff, m_map, m_map.present(), m_origin, Execution());
    SurfaceSettings settings;
    settings.cell = m_map.cell;
    Findings said;
    const auto read = [&](EvidenceFile::Kind kind, const std::string& path) {
        return readEvidence({kind, path}, {m_lies.frame, m_lies.site, SiteSurface{}}, {}, settings, said, Execution());
    };
    const SurfaceEvidence heights = read(EvidenceFile::Kind::Heights, tiff);
    std::size_t high = 0;
    for (std::size_t c = 0; c < m_map.cells.size(); ++c) {
        const double height = m_map.layer(MapLayer::Height)[c];
        high += height > 0.0;
        const std::ptrdiff_t at = heights.seen.find(m_map.cells[c]);
        ASSERT_EQ(at >= 0, height > 0.0);
        if (at >= 0) {
            EXPECT_NEAR(heights.seen.heights[static_cast<std::size_t>(at)], height, 1e-5);
        }
    }
    EXPECT_EQ(heights.seen.cells.size(), high);
    const std::string package = m_folder / "map.gpkg";
    writePackage(package);
    EXPECT_EQ(read(EvidenceFile::Kind::Footprint, package).seen.cells, m_map.cells);
}

/// A height model along east and north, as a survey has it, of level ground with a ridge of the local frame on it.
std::string surveyOfRidge(const std::string& path, const Lies& lies, const std::function<double(const Eigen::Vector2d&)>& height) {
    constexpr int side = 160;
    constexpr double step = 0.25;
    const Eigen::Vector2d corner = lies.world(Eigen::Vector2d::Zero()) + Eigen::Vector2d(-0.5, 0.5) * side * step;
    GDALDatasetUniquePtr file(
        GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), side, side, 1, GDT_Float64, nullptr));
    std::array<double, 6> g{corner.x(), step, 0.0, corner.y(), 0.0, -step};
    file->SetGeoTransform(g.data());
    OGRSpatialReference system;
    system.SetFromUserInput(lies.frame.crs.c_str());
    file->SetSpatialRef(&system);
    const Eigen::Vector2d zero = lies.world(Eigen::Vector2d::Zero());
    std::vector<double> heights;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const Eigen::Vector2d off = corner + step * Eigen::Vector2d(column + 0.5, -row - 0.5) - zero;
            const Eigen::Vector2d local(std::cos(lies.angle) * off.x() + std::sin(lies.angle) * off.y(),
                                        -std::sin(lies.angle) * off.x() + std::cos(lies.angle) * off.y());
            heights.push_back(lies.zero + height(local / lies.scale));
        }
    }
    EXPECT_EQ(file->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, side, side, heights.data(), side, side, GDT_Float64, 0, 0, nullptr),
              CE_None);
    return path;
}

TEST_P(WorldPlace, ASurveyInTheSystemLiesOnTheDebrisItShows) {
    MapPiece ridge;
    ridge.centre = ridge.box.centre = Vec3(3.0, 1.0, 1.0);
    ridge.box.orientation = Quat::Identity();
    ridge.box.halfExtents = Vec3(6.0, 2.0, 1.0);
    ridge.mass = ridge.volume = 96.0;
    const PieceRaster raster = rasterOf(std::vector<MapPiece>{ridge}, 0.5, SiteSurface{}, Execution());
    const auto shown = [](const Eigen::Vector2d& p) {
        return std::abs(p.x() - 3.0) <= 6.0 && std::abs(p.y() - 1.0) <= 2.0 ? 2.0 : 0.0;
    };
    const SurveyInput input =
        readSurvey(surveyOfRidge(m_folder / "survey.tif", m_lies, shown), m_lies.frame, m_lies.site, Aabb(), Execution());
    SurveySettings settings;
    settings.fit = SurveyFit::Debris;
    settings.turn = m_lies.angle;
    const SurveyComparison made =
        compareWithSurvey(raster, input.survey, SiteSurface{}, Eigen::Vector2d::Zero(), settings, Execution());
    // Cells of half a metre along the rim may fall on either side.
    EXPECT_LT(made.shift.by.norm(), 0.15);
    EXPECT_GT(made.iou, 0.85);
    EXPECT_NEAR(made.survey.volume, 96.0, 8.0);
    // The difference goes back to where the survey was: the middle of the ridge is a pixel without a difference.
    const std::string path = m_folder / "difference.tif";
    MapOrigin origin = m_origin;
    writeSurveyTiff(path, made, origin, Execution());
    const GDALDatasetUniquePtr file = open(path, GDAL_OF_RASTER);
    ASSERT_TRUE(file);
    std::array<double, 6> g{};
    std::array<double, 6> back{};
    file->GetGeoTransform(g.data());
    ASSERT_TRUE(GDALInvGeoTransform(g.data(), back.data()));
    const Eigen::Vector2d at = m_lies.world({3.1, 1.1});
    std::array<double, 3> values{};
    for (int b = 1; b <= 3; ++b) {
        ASSERT_EQ(file->GetRasterBand(b)->RasterIO(GF_Read, static_cast<int>(back[0] + at.x() * back[1] + at.y() * back[2]),
                                                   static_cast<int>(back[3] + at.x() * back[4] + at.y() * back[5]), 1, 1,
                                                   &values[static_cast<std::size_t>(b - 1)], 1, 1, GDT_Float64, 0, 0, nullptr),
                  CE_None);
    }
    EXPECT_NEAR(values[0], 0.0, 0.1);
    EXPECT_NEAR(values[1], 2.0, 0.1);
    EXPECT_NEAR(values[2], 2.0, 1e-9);
    // Run-out is told by the directions of the world: the ridge reaches 9 m along local x.
    const auto sector = static_cast<std::size_t>(std::lround(m_lies.angle / (M_PI / 4.0)) + 8) % 8;
    EXPECT_NEAR(made.simulated.runOut[sector], 8.5, 0.8);
}

TEST_P(WorldPlace, WithoutASystemNothingClaimsOne) {
    m_origin.frame.crs.clear();
    const std::string tiff = m_folder / "map.tif";
    writeMapTiff(tiff, m_map, m_map.present(), m_origin, Execution());
    const std::string package = m_folder / "map.gpkg";
    writePackage(package);
    for (const auto& [path, kind] : {std::pair(tiff, GDAL_OF_RASTER), std::pair(package, GDAL_OF_VECTOR)}) {
        const GDALDatasetUniquePtr file = open(path, static_cast<unsigned>(kind));
        ASSERT_TRUE(file);
        const OGRSpatialReference* system = path == tiff ? file->GetSpatialRef() : file->GetLayer(0)->GetSpatialRef();
        EXPECT_TRUE(system == nullptr || system->GetAuthorityCode(nullptr) == nullptr) << path;
        EXPECT_TRUE(system == nullptr || !(system->IsProjected() || system->IsGeographic())) << path;
    }
}

INSTANTIATE_TEST_SUITE_P(Frames, WorldPlace,
                         testing::Values(byOrigin("z", {500000, 5700000, 100}), byOrigin("y", {500000, 100, -5700000}),
                                         byOrigin("x", {100, 500000, 5700000}), byOrigin("-z", {500000, -5700000, -100}),
                                         byPoints(30.0, 0.9996), byPoints(-135.0, 1.0), byPoints(0.0, 1.00025)));

TEST(WorldPlaceOfAFile, TheWayOutOfTheFrameIsTheWayInBackwards) {
    // A point of an FE file with y up, in millimetres: easting along x, northing against z.
    Frame frame;
    frame.upAxis = "y";
    frame.metresPerUnit = 0.001;
    frame.origin = {500000, 100, -5700000};
    frame.crs = "EPSG:25832";
    const Vec3 local = FrameTransform(frame).point(Vec3(500003125.0, 112250.0, -5700004500.0));
    const MapPlace place(frame, Site());
    EXPECT_NEAR(place(local.head<2>()).x(), 500003.125, 1e-9);
    EXPECT_NEAR(place(local.head<2>()).y(), 5700004.5, 1e-9);
    EXPECT_NEAR(local.z() + place.zeroHeight(), 112.25, 1e-9);
}

}  // namespace
}  // namespace rubble::io
