#include "io/exports/map_files.h"

#include <gdal_priv.h>
#include <gdal_utils.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/run/run_cautions.h"
#include "io/site/survey_file.h"
#include "io/site/surveys/evidence_origin.h"
#include "tests/core/analysis/debris_scene.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using testing::HasSubstr;

/// A field of tumbled blocks with some fallen live structure beside it, in a case far from its origin.
class MapFiles : public testing::Test {
protected:
    void SetUp() override {
        for (std::size_t f = 0; f < m_debris.fragments.size(); ++f) {
            Fragment fragment;
            fragment.component = idAt<ComponentId>(f % 2);
            fragment.birthTime = 0.5;
            m_set.list.push_back(fragment);
            m_arrivals.push_back(1.0 + 0.01 * static_cast<double>(f));
            m_energies.push_back(10.0 * static_cast<double>(f));
            m_ids.push_back(static_cast<std::int64_t>(70000 + f));
        }
        LiveStructure live;
        for (const DebrisFragment& lies : analysis_scene::randomField(8, 20, 3.0).fragments) {
            MapPiece piece;
            piece.box = lies.box;
            piece.box.centre.x() += 30.0;
            piece.centre = piece.box.centre;
            piece.mass = lies.mass;
            piece.volume = lies.volume;
            live.mass += piece.mass;
            live.volume += piece.volume;
            live.pieces.push_back(piece);
        }
        MapSettings settings;
        settings.cell = 0.25;
        m_map = makeDebrisMap(3.5, mapPieces(m_set, m_debris, m_arrivals, m_energies), true, &live, {"deck, upper", "pier"},
                              SiteSurface{}, settings, Execution());
        m_origin.frame.origin = {500000, 5700000, 100};
        m_origin.frame.crs = "EPSG:25832";
        m_origin.facts = {{"RUBBLE_TIME_S", "3.5"}, {"RUBBLE_FE_SHA256", "abc"}};
        m_origin.provenance = "{\"map\": 1}";
    }
    GDALDatasetUniquePtr open(const std::string& path, unsigned kind) {
        GDALAllRegister();
        return GDALDatasetUniquePtr(GDALDataset::FromHandle(GDALOpenEx(path.c_str(), kind, nullptr, nullptr, nullptr)));
    }
    void writeTiff() { writeMapTiff(m_tiff, m_map, m_map.present(), m_origin, Execution()); }
    void writePackage() {
        writeMapPackage(m_package, m_map, {&m_set, &m_debris, m_ids, m_arrivals, m_energies}, 0.5, m_origin, Execution());
    }

    TemporaryFolder m_folder;
    std::string m_tiff = m_folder / "map.tif";
    std::string m_package = m_folder / "map.gpkg";
    Debris m_debris = analysis_scene::randomField(4, 400, 12.0);
    FragmentSet m_set;
    std::vector<double> m_arrivals;
    std::vector<double> m_energies;
    std::vector<std::int64_t> m_ids;
    DebrisMap m_map;
    MapOrigin m_origin;
};

TEST_F(MapFiles, ATiffGivesBackEveryValueAtItsPlace) {
    writeTiff();
    const GDALDatasetUniquePtr file = open(m_tiff, GDAL_OF_RASTER);
    ASSERT_TRUE(file);
    std::array<double, 6> g{};
    ASSERT_EQ(file->GetGeoTransform(g.data()), CE_None);
    EXPECT_EQ(g[1], 0.25);
    EXPECT_EQ(g[5], -0.25);
    ASSERT_EQ(file->GetRasterCount(), 11);
    const int columns = file->GetRasterXSize();
    const int rows = file->GetRasterYSize();
    for (int b = 1; b <= file->GetRasterCount(); ++b) {
        const MapLayer layer = mapLayers()[static_cast<std::size_t>(b - 1)];
        std::vector<double> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
        ASSERT_EQ(file->GetRasterBand(b)->RasterIO(GF_Read, 0, 0, columns, rows, values.data(), columns, rows, GDT_Float64, 0, 0,
                                                   nullptr),
                  CE_None);
        std::size_t held = 0;
        for (std::size_t c = 0; c < m_map.cells.size(); ++c) {
            const double x = 500000.0 + 0.25 * (m_map.cells[c].i + 0.5);
            const double y = 5700000.0 + 0.25 * (m_map.cells[c].j + 0.5);
            const auto column = static_cast<int>(std::floor((x - g[0]) / g[1]));
            const auto row = static_cast<int>(std::floor((y - g[3]) / g[5]));
            const double value = values[static_cast<std::size_t>(row * columns + column)];
            const double expected = m_map.layer(layer)[c];
            EXPECT_EQ(value, std::isnan(expected) ? -9999.0 : expected);
            held += value != -9999.0;
        }
        EXPECT_EQ(static_cast<std::size_t>(std::count_if(values.begin(), values.end(), [](double v) { return v != -9999.0; })),
                  held)
            << "nothing where no debris is";
    }
}

TEST_F(MapFiles, ATiffSaysWhatItIs) {
    writeTiff();
    const GDALDatasetUniquePtr file = open(m_tiff, GDAL_OF_RASTER);
    ASSERT_TRUE(file);
    EXPECT_STREQ(file->GetMetadataItem("RUBBLE_TIME_S"), "3.5");
    EXPECT_STREQ(file->GetMetadataItem("RUBBLE_FE_SHA256"), "abc");
    ASSERT_NE(file->GetSpatialRef(), nullptr);
    EXPECT_STREQ(file->GetSpatialRef()->GetAuthorityCode(nullptr), "25832");
    GDALRasterBand& mass = *file->GetRasterBand(3);
    EXPECT_STREQ(mass.GetDescription(), "mass");
    EXPECT_STREQ(mass.GetUnitType(), "kg/m2");
    int known = 0;
    EXPECT_EQ(mass.GetNoDataValue(&known), -9999.0);
    EXPECT_TRUE(known);
    EXPECT_STREQ(file->GetRasterBand(6)->GetMetadataItem("COMPONENT_0"), "deck, upper");
    EXPECT_EQ(wholeFile(m_tiff + ".provenance.json"), "{\"map\": 1}\n");
}

TEST_F(MapFiles, AMapOfOursIsKnownByItsContentUnderAnyName) {
    const std::string run = "00112233445566778899aabbccddeeff";
    const auto renamed = [&](const std::string& path) {
        const std::string other = m_folder / ("found" + std::filesystem::path(path).extension().string());
        std::filesystem::copy_file(path, other, std::filesystem::copy_options::overwrite_existing);
        return other;
    };
    const auto check = [&](const std::string& named, bool ours) {
        for (const std::string& path : {m_tiff, m_package}) {
            const EvidenceOrigin origin = surveyOriginOf(renamed(path), {});
            EXPECT_EQ(origin.run, named) << path;
            EXPECT_EQ(origin.ours, ours) << path;
        }
    };
    writeTiff();
    writePackage();
    check({}, false);
    // A map of an ensemble is of several runs and names none.
    m_origin.facts = {{"RUBBLE_CLASS", "probability of debris"}};
    writeTiff();
    writePackage();
    check({}, true);
    m_origin.facts.emplace_back("RUBBLE_RUN", run);
    writeTiff();
    writePackage();
    check(run, true);
    // What is read as a survey says so.
    const SurveyInput read = readSurvey(renamed(m_package), m_origin.frame, Site(), Aabb(), Execution());
    EXPECT_EQ(read.ofRun, run);
    EXPECT_EQ(read.findings.count("evidence.of_run"), 1);
}

/// What the program gdalinfo prints: it is this function of the library.
std::string gdalInfo(GDALDataset& file) {
    const std::unique_ptr<GDALInfoOptions, decltype(&GDALInfoOptionsFree)> plain(GDALInfoOptionsNew(nullptr, nullptr),
                                                                                 GDALInfoOptionsFree);
    char* text = GDALInfo(GDALDataset::ToHandle(&file), plain.get());
    std::string printed(text);
    CPLFree(text);
    return printed;
}

TEST_F(MapFiles, GdalinfoPrintsSystemExtentUnitsAndNodata) {
    writeTiff();
    const GDALDatasetUniquePtr file = open(m_tiff, GDAL_OF_RASTER);
    ASSERT_TRUE(file);
    const std::string printed = gdalInfo(*file);
    for (const char* wanted :
         {"Driver: GTiff/GeoTIFF", "PROJCRS[\"ETRS89 / UTM zone 32N\"", "ID[\"EPSG\",25832]", "LENGTHUNIT[\"metre\",1]",
          "Pixel Size = (0.250000000000000,-0.250000000000000)", "RUBBLE_TIME_S=3.5", "AREA_OR_POINT=Area", "Description = mass",
          "Unit Type: kg/m2", "Description = height", "NoData Value=-9999"}) {
        EXPECT_THAT(printed, HasSubstr(wanted));
    }
    std::size_t nodata = 0;
    for (std::size_t at = 0; (at = printed.find("NoData Value=-9999", at)) != std::string::npos; ++at) {
        ++nodata;
    }
    EXPECT_EQ(nodata, m_map.present().size()) << "every band says what means nothing";
    // The corners hold all cells, and lie where the frame of the case puts them.
    std::array<double, 2> upper{};
    ASSERT_EQ(std::sscanf(printed.c_str() + printed.find("Upper Left"), "Upper Left  ( %lf, %lf)", &upper[0], &upper[1]), 2);
    std::int32_t west = m_map.cells.front().i;
    std::int32_t north = m_map.cells.front().j;
    for (const MapCell& cell : m_map.cells) {
        west = std::min(west, cell.i);
        north = std::max(north, cell.j);
    }
    EXPECT_NEAR(upper[0], 500000.0 + 0.25 * west, 0.26);
    EXPECT_NEAR(upper[1], 5700000.0 + 0.25 * (north + 1), 0.26);
}

TEST_F(MapFiles, ALocalCaseHasALocalSystemInMetres) {
    m_origin.frame = {};
    writeTiff();
    const GDALDatasetUniquePtr file = open(m_tiff, GDAL_OF_RASTER);
    ASSERT_TRUE(file);
    ASSERT_NE(file->GetSpatialRef(), nullptr);
    EXPECT_TRUE(file->GetSpatialRef()->IsLocal());
    EXPECT_EQ(file->GetSpatialRef()->GetLinearUnits(), 1.0);
}

TEST_F(MapFiles, ASystemThatTheModelHasNoPlaceInIsNotClaimed) {
    m_origin.frame.origin.setZero();
    writeTiff();
    writePackage();
    const GDALDatasetUniquePtr file = open(m_tiff, GDAL_OF_RASTER);
    ASSERT_TRUE(file);
    ASSERT_NE(file->GetSpatialRef(), nullptr);
    EXPECT_TRUE(file->GetSpatialRef()->IsLocal());
    const GDALDatasetUniquePtr package = open(m_package, GDAL_OF_VECTOR);
    ASSERT_TRUE(package);
    const OGRSpatialReference* system = package->GetLayerByName("footprint")->GetSpatialRef();
    EXPECT_TRUE(system == nullptr || system->GetAuthorityCode(nullptr) == nullptr ||
                std::string_view(system->GetAuthorityCode(nullptr)) != "25832");
    EXPECT_EQ(unplacedSystem(m_origin.frame, m_origin.site), "EPSG:25832");
    m_origin.frame.origin = {500000, 5700000, 100};
    EXPECT_EQ(unplacedSystem(m_origin.frame, m_origin.site), "");
    m_origin.frame.origin.setZero();
    for (const double x : {0.0, 10.0}) {
        m_origin.site.controlPoints.push_back({"P", Vec3(x, 0, 0), Vec3(500000.0 + x, 5700000.0, 0), true});
    }
    EXPECT_EQ(unplacedSystem(m_origin.frame, m_origin.site), "");
    m_origin.site.controlPoints[1].world = m_origin.site.controlPoints[0].world;
    m_origin.site.controlPoints[1].local = m_origin.site.controlPoints[0].local;
    EXPECT_EQ(unplacedSystem(m_origin.frame, m_origin.site), "EPSG:25832") << "points in one place are none";
}

TEST_F(MapFiles, ASystemInFeetGetsItsCoordinatesInFeet) {
    m_origin.frame.crs = "EPSG:2263";
    writeTiff();
    const GDALDatasetUniquePtr file = open(m_tiff, GDAL_OF_RASTER);
    ASSERT_TRUE(file);
    std::array<double, 6> g{};
    file->GetGeoTransform(g.data());
    EXPECT_NEAR(g[1], 0.25 * 3937.0 / 1200.0, 1e-12) << "US survey feet";
}

TEST_F(MapFiles, ASystemThatIsNoneOrInDegreesIsRefused) {
    for (const char* crs : {"EPSG:99999999", "somewhere", "EPSG:4326"}) {
        m_origin.frame.crs = crs;
        EXPECT_THROW(writeTiff(), UsageError) << crs;
        EXPECT_THROW(writePackage(), UsageError) << crs;
    }
    EXPECT_FALSE(std::filesystem::exists(m_tiff));
}

TEST_F(MapFiles, APieceThatFlewFarTakesNoRoomInATiff) {
    DebrisMap wide = m_map;
    wide.cells.push_back({40000, 40000});
    for (std::vector<double>& layer : wide.layers) {
        // A layer that is not there stays so.
        if (!layer.empty()) {
            layer.push_back(1.0);
        }
    }
    writeMapTiff(m_tiff, wide, wide.present(), m_origin, Execution());
    // 40,000 by 40,000 cells of 11 layers are 140 GB.
    EXPECT_LT(std::filesystem::file_size(m_tiff), 8u << 20);
    wide.cells.back() = {400000000, 400000000};
    EXPECT_THROW(writeMapTiff(m_tiff, wide, wide.present(), m_origin, Execution()), UsageError);
}

TEST_F(MapFiles, APackageHoldsFootprintContoursAndFragments) {
    writePackage();
    const GDALDatasetUniquePtr file = open(m_package, GDAL_OF_VECTOR);
    ASSERT_TRUE(file);
    ASSERT_EQ(file->GetLayerCount(), 3);
    std::map<std::string, double> area;
    for (const OGRFeatureUniquePtr& feature : *file->GetLayerByName("footprint")) {
        const double ofShape = feature->GetGeometryRef()->toPolygon()->get_Area();
        // Coordinates of 5.7 million metres hold nine places behind the point.
        EXPECT_NEAR(feature->GetFieldAsDouble("area_m2"), ofShape, 1e-3 * ofShape + 1e-3);
        EXPECT_TRUE(feature->GetGeometryRef()->IsValid());
        area[feature->GetFieldAsString("of")] += feature->GetFieldAsDouble("area_m2");
    }
    EXPECT_NEAR(area["fragments"], m_map.ledger.footprintArea, 1e-9);
    EXPECT_NEAR(area["live structure"], m_map.ledger.liveFootprintArea, 1e-9);
    EXPECT_EQ(file->GetLayerByName("fragments")->GetGeomType(), wkbPolygon) << "programs ask what to show of a mixed layer";
    double mass = 0.0;
    std::int64_t count = 0;
    for (const OGRFeatureUniquePtr& feature : *file->GetLayerByName("fragments")) {
        const auto f = static_cast<std::size_t>(feature->GetFieldAsInteger64("fragment_id"));
        mass += feature->GetFieldAsDouble("mass_kg");
        EXPECT_EQ(feature->GetFieldAsInteger64("element_id"), m_ids[f]);
        EXPECT_STREQ(feature->GetFieldAsString("component"), f % 2 == 0 ? "deck, upper" : "pier");
        EXPECT_EQ(feature->GetFieldAsDouble("arrival_s"), m_arrivals[f]);
        EXPECT_EQ(feature->GetFieldAsDouble("impact_energy_j"), m_energies[f]);
        OGRPoint centre;
        feature->GetGeometryRef()->toPolygon()->Centroid(&centre);
        EXPECT_NEAR(centre.getX(), 500000.0 + m_debris.fragments[f].centre.x(), 1e-5);
        EXPECT_NEAR(centre.getY(), 5700000.0 + m_debris.fragments[f].centre.y(), 1e-5);
        ++count;
    }
    EXPECT_EQ(count, m_map.ledger.fragments);
    EXPECT_NEAR(mass, m_map.ledger.mass, 1e-9 * mass);
    std::size_t lines = 0;
    for (const OGRFeatureUniquePtr& feature : *file->GetLayerByName("contours")) {
        EXPECT_TRUE(feature->GetGeometryRef()->toLineString()->get_IsClosed());
        EXPECT_GT(feature->GetFieldAsDouble("height_m"), 0.0);
        ++lines;
    }
    EXPECT_GT(lines, 5u);
    EXPECT_STREQ(file->GetLayer(0)->GetSpatialRef()->GetAuthorityCode(nullptr), "25832");
    EXPECT_STREQ(file->GetMetadataItem("RUBBLE_TIME_S"), "3.5");
}

TEST_F(MapFiles, TheSameMapGivesTheSameBytes) {
    writePackage();
    writeTiff();
    const std::string package = wholeFile(m_package);
    const std::string tiff = wholeFile(m_tiff);
    writePackage();
    writeTiff();
    EXPECT_TRUE(wholeFile(m_package) == package);
    EXPECT_TRUE(wholeFile(m_tiff) == tiff);
}

TEST_F(MapFiles, ATableHasARowForEachCell) {
    const std::string path = m_folder / "map.csv";
    writeMapCsv(path, m_map, {MapLayer::Mass, MapLayer::Component, MapLayer::LiveMass}, m_origin, Execution());
    std::istringstream in(wholeFile(path));
    std::string line;
    std::getline(in, line);
    EXPECT_EQ(line, "x_m,y_m,mass_kg_per_m2,component,live_mass_kg_per_m2");
    std::size_t rows = 0;
    double mass = 0.0;
    while (std::getline(in, line)) {
        double x = 0.0;
        double y = 0.0;
        ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf", &x, &y), 2);
        EXPECT_EQ(x, 500000.0 + 0.25 * (m_map.cells[rows].i + 0.5));
        EXPECT_EQ(y, 5700000.0 + 0.25 * (m_map.cells[rows].j + 0.5));
        const std::string third = line.substr(line.find(',', line.find(',') + 1) + 1);
        mass += third[0] == ',' ? 0.0 : std::stod(third) * 0.0625;
        const bool debris = !std::isnan(m_map.layer(MapLayer::Mass)[rows]);
        EXPECT_EQ(debris, line.find("deck, upper") != std::string::npos || line.find("pier") != std::string::npos);
        ++rows;
    }
    EXPECT_EQ(rows, m_map.cells.size());
    EXPECT_NEAR(mass, m_map.ledger.mass, 1e-9 * mass);
}

TEST_F(MapFiles, AnEmptyMapIsAFileToo) {
    DebrisMap empty = makeDebrisMap(0.0, {}, true, nullptr, {}, SiteSurface{}, {}, Execution());
    FragmentSet none;
    Debris nothing;
    writeMapTiff(m_tiff, empty, empty.present(), m_origin, Execution());
    writeMapPackage(m_package, empty, {&none, &nothing, {}, {}, {}}, 0.5, m_origin, Execution());
    writeMapCsv(m_folder / "map.csv", empty, empty.present(), m_origin, Execution());
    const GDALDatasetUniquePtr file = open(m_tiff, GDAL_OF_RASTER);
    ASSERT_TRUE(file);
    EXPECT_EQ(file->GetRasterCount(), 8);
    double value = 0.0;
    ASSERT_EQ(file->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, 1, 1, &value, 1, 1, GDT_Float64, 0, 0, nullptr), CE_None);
    EXPECT_EQ(value, -9999.0);
}

TEST_F(MapFiles, WhatCannotBeWrittenLeavesWhatWasThere) {
    m_tiff = m_folder / "no-such-folder/map.tif";
    EXPECT_THROW(writeTiff(), WorldError);
    m_package = m_folder.path();
    EXPECT_THROW(writePackage(), WorldError);
    const Execution cancelled;
    cancelled.cancel();
    m_tiff = m_folder / "map.tif";
    std::ofstream(m_tiff) << "before";
    EXPECT_THROW(writeMapTiff(m_tiff, m_map, m_map.present(), m_origin, cancelled), Cancelled);
    EXPECT_EQ(wholeFile(m_tiff), "before");
}

}  // namespace
}  // namespace rubble::io
