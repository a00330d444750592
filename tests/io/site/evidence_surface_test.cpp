#include "io/site/cause_evidence.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "core/base/csv_text.h"
#include "core/base/error.h"
#include "io/exports/ensemble_origin.h"
#include "io/exports/map_files.h"
#include "io/site/survey_file.h"
#include "tests/core/analysis/debris_scene.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

/// A map of tumbled blocks with fallen structure beside them, as this program writes it.
class EvidenceSurface : public testing::Test {
protected:
    void SetUp() override {
        m_frame.origin = {500000, 5600000, 100};
        std::vector<MapPiece> pieces;
        const Debris field = analysis_scene::randomField(4, 60, 8.0);
        for (const DebrisFragment& lies : field.fragments) {
            pieces.push_back({lies.box, lies.centre, lies.mass, lies.volume});
        }
        LiveStructure live;
        const DebrisFragment girder = analysis_scene::boxAt(Vec3(2.25, 0.25, 4.0), 1000.0, Vec3(3.0, 1.0, 0.5));
        live.pieces.push_back({girder.box, girder.centre, girder.mass, girder.volume});
        MapSettings settings;
        settings.cell = 0.5;
        m_map = makeDebrisMap(3.5, pieces, false, &live, {"all"}, SiteSurface{}, settings, Execution());
        m_origin.frame = m_frame;
        m_origin.facts = {{"RUBBLE_CLASS", "simulated"}};
        m_origin.provenance = "{}";
    }

    SurfaceEvidence read(EvidenceFile::Kind kind, const std::string& path, double cell = 0.5, bool withFallen = true) {
        SurfaceSettings settings;
        settings.cell = cell;
        settings.withFallen = withFallen;
        return readEvidence({kind, path}, {m_frame, Site(), SiteSurface{}}, {}, settings, m_said, Execution());
    }
    SurfaceEvidence readFootprint(const std::string& path, double cell = 0.5, bool withFallen = true) {
        return read(EvidenceFile::Kind::Footprint, path, cell, withFallen);
    }
    SurfaceEvidence readHeights(const std::string& path, bool withFallen = true) {
        return read(EvidenceFile::Kind::Heights, path, 0.5, withFallen);
    }

    Findings m_said;
    Frame m_frame;
    DebrisMap m_map;
    MapOrigin m_origin;
    TemporaryFolder m_folder;
};

TEST_F(EvidenceSurface, HeightsOfAMapComeBack) {
    const std::string path = m_folder / "map.tif";
    writeMapTiff(path, m_map, m_map.present(), m_origin, Execution());
    for (const bool withFallen : {false, true}) {
        const SurfaceEvidence evidence = readHeights(path, withFallen);
        EXPECT_TRUE(evidence.everywhere);
        std::size_t expected = 0;
        for (std::size_t c = 0; c < m_map.cells.size(); ++c) {
            double height = m_map.layer(MapLayer::Height)[c];
            if (withFallen) {
                height = std::fmax(height, m_map.layer(MapLayer::LiveHeight)[c]);
            }
            if (!(height > 0.0)) {
                continue;
            }
            ++expected;
            const std::ptrdiff_t at = evidence.seen.find(m_map.cells[c]);
            ASSERT_GE(at, 0);
            EXPECT_NEAR(evidence.seen.heights[static_cast<std::size_t>(at)], height, 1e-5);
        }
        EXPECT_EQ(evidence.seen.cells.size(), expected);
    }
}

TEST_F(EvidenceSurface, FootprintOfAPackageComesBack) {
    const std::string path = m_folder / "map.gpkg";
    FragmentSet none;
    Debris nothing;
    writeMapPackage(path, m_map, MapFragments{&none, &nothing, {}, {}, {}}, 0.5, m_origin, Execution());
    const SurfaceEvidence all = readFootprint(path);
    EXPECT_EQ(all.seen.cells, m_map.cells) << "polygons that overlap do not cancel";
    EXPECT_TRUE(all.reached) << "of cells that debris reaches into";
    const SurfaceEvidence fragments = readFootprint(path, 0.5, false);
    EXPECT_LT(fragments.seen.cells.size(), all.seen.cells.size());
    EXPECT_GT(fragments.seen.cells.size(), 0u);
}

TEST_F(EvidenceSurface, AnExactOutlineDepartsFromItsOwnDebrisByNothing) {
    // Of blocks that lie askew on cells as large as they are: each polygon is the outline of one of them.
    std::vector<MapPiece> pieces;
    std::string features;
    for (int k = 0; k < 12; ++k) {
        const Quat turn(Eigen::AngleAxisd(0.3 * k, Vec3::UnitZ()));
        const DebrisFragment block = analysis_scene::boxAt(Vec3(1.7 * k, 0.9 * k, 0.5), 1000.0, Vec3(1.4, 0.9, 0.5), turn);
        pieces.push_back({block.box, block.centre, block.mass, block.volume});
        std::string ring;
        for (const auto& [x, y] : std::array<std::pair<double, double>, 5>{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}}) {
            const Vec3 corner = block.centre + turn * Vec3(1.4 * x, 0.9 * y, 0.0);
            ring +=
                (ring.empty() ? "[" : ",[") + exactNumber(500000.0 + corner.x()) + "," + exactNumber(5600000.0 + corner.y()) + "]";
        }
        features += (features.empty() ? "" : ",") +
                    (R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[)" + ring + "]]}}");
    }
    const std::string path = m_folder / "exact.geojson";
    std::ofstream(path) << R"({"type":"FeatureCollection","features":[)" << features << "]}";
    const SurfaceEvidence evidence = readFootprint(path, 1.0);
    EXPECT_FALSE(evidence.reached);
    const PieceRaster raster = rasterOf(pieces, 1.0, SiteSurface{}, Execution());
    MemberSurface debris;
    debris.cells = raster.cells;
    debris.heights.assign(raster.height.begin(), raster.height.end());
    debris.covered.assign(raster.covered.begin(), raster.covered.end());
    // Points stand for areas: a cell that is covered by close to a half may count on one side.
    EXPECT_LT(departureFrom(evidence, debris), 0.08);
    SurfaceEvidence wholly = evidence;
    wholly.reached = true;
    EXPECT_GT(departureFrom(wholly, debris), 0.15) << "as it was when any touch was debris";
}

TEST_F(EvidenceSurface, APolygonCoversCellsByHalfOfTheirArea) {
    const std::string path = m_folder / "outline.geojson";
    std::ofstream(path)
        << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":{"type":"Polygon",
        "coordinates":[[[500000,5600000],[500010,5600000],[500010,5600004],[500000,5600004],[500000,5600000]],
                       [[500002,5600001],[500004,5600001],[500004,5600003],[500002,5600003],[500002,5600001]]]}}]})";
    const SurfaceEvidence evidence = readFootprint(path, 1.0);
    EXPECT_EQ(evidence.seen.cells.size(), 40u - 4u);
    EXPECT_LT(evidence.seen.find({1, 2}), 0) << "in the hole";
    EXPECT_GE(evidence.seen.find({3, 9}), 0);
    EXPECT_EQ(m_said.count("survey.no_degrees"), 1) << "GeoJSON says degrees";
}

TEST_F(EvidenceSurface, WhatIsNoEvidenceIsRefused) {
    EXPECT_THROW(readFootprint(m_folder / "none.gpkg"), WorldError);
    EXPECT_THROW(readHeights(m_folder / "none.tif"), WorldError);
    const std::string text = m_folder / "text.tif";
    std::ofstream(text) << "no raster";
    EXPECT_THROW(readHeights(text), ParseError);
    const std::string points = m_folder / "points.geojson";
    std::ofstream(points) << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},
        "geometry":{"type":"Point","coordinates":[1,2]}}]})";
    EXPECT_THROW(readFootprint(points), ParseError);
    const std::string far = m_folder / "far.geojson";
    std::ofstream(far) << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":{"type":"Polygon",
        "coordinates":[[[0,0],[1e300,0],[1e300,1e300],[0,0]]]}}]})";
    EXPECT_THROW(readFootprint(far), ParseError);
}

TEST_F(EvidenceSurface, AMapOfAnEnsembleSaysWhatItIs) {
    EnsembleReport report;
    report.settings.members = 2;
    for (const float height : {1.0F, 2.0F}) {
        EnsembleMember& member = report.members.emplace_back();
        member.done = true;
        member.surface = std::make_shared<const MemberSurface>(
            MemberSurface{{{0, 0}, {0, 1}}, {height, height}, {100.0F, 100.0F}, {1.0F, 1.0F}});
    }
    const DebrisMap map = probabilityMap(report, usualThresholds);
    const MapOrigin origin = ensembleOrigin(report, map, {{{"fe", "a.exo", std::string(64, 'b')}}, m_frame, Site(), {}});
    const std::string path = m_folder / "probability.tif";
    writeMapTiff(path, map, map.present(), origin, Execution());
    // Its median of heights is evidence too.
    const SurfaceEvidence evidence = readHeights(path);
    ASSERT_EQ(evidence.seen.cells.size(), 2u);
    EXPECT_NEAR(evidence.seen.heights[0], 1.5, 1e-6);
    EXPECT_NE(origin.provenance.find(std::string(64, 'b')), std::string::npos);
    // So it is for a survey, though it is a single row of cells.
    const Aabb around(Vec3(0.0, 0.0, 0.0), Vec3(1.0, 1.0, 1.0));
    const SurveyInput survey = readSurvey(path, m_frame, Site(), around, Execution());
    EXPECT_EQ(survey.survey.heights.ny, 1u);
    EXPECT_NEAR(survey.survey.heights.at(0.75, 0.25), 1.5, 1e-6);
}

}  // namespace
}  // namespace rubble::io
