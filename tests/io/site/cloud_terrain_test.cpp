#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "io/case/terrain_reader.h"
#include "io/site/evidence_surface.h"
#include "io/site/height_reading.h"
#include "io/site/survey_file.h"
#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

class CloudTerrain : public testing::Test {
protected:
    TemporaryFolder m_folder;
    Frame m_frame;
    Aabb m_structure{Vec3(-5.0, -5.0, 0.0), Vec3(5.0, 5.0, 4.0)};

    /// Points at random places of a square about zero, in steps of a centimetre.
    template <class Height>
    static std::vector<MadePoint> scattered(std::size_t count, double half, const Height& height, std::uint8_t kind = 2) {
        std::mt19937 engine(7);
        const auto place = [&] { return std::lround(100.0 * half * (2.0 * ((engine() + 0.5) / 4294967296.0) - 1.0)); };
        std::vector<MadePoint> points(count);
        for (MadePoint& point : points) {
            const long x = place();
            const long y = place();
            const double z = height(0.01 * static_cast<double>(x), 0.01 * static_cast<double>(y));
            point.place = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                           static_cast<std::int32_t>(std::lround(100.0 * z))};
            point.kind = kind;
        }
        return points;
    }
    std::string lay(std::vector<MadePoint> points, const std::string& wkt = "", const Vec3& offset = Vec3::Zero(),
                    double scale = 0.01) {
        MadeLas las;
        las.minor = 4;
        las.format = 7;
        las.points = std::move(points);
        las.wkt = wkt;
        las.offset = offset;
        las.scale = Vec3::Constant(scale);
        return layCloud(m_folder / ("made" + std::to_string(m_made++) + ".las"), las.bytes());
    }
    HeightReading read(const std::string& path, bool surface = false) const {
        return readHeights(path, m_frame, {}, m_structure, Execution(), {.alongAxes = !surface, .surface = surface});
    }
    std::string refusal(const std::string& path, bool surface = false) const {
        try {
            read(path, surface);
        } catch (const Error& error) {
            return error.message().id;
        }
        return "read";
    }
    /// Largest distance of the heights from a surface, m; every tenth height or more must be there.
    template <class Height>
    static double apart(const HeightReading& reading, const Height& height) {
        double most = 0.0;
        std::size_t there = 0;
        for (std::size_t k = 0; k < reading.raster.heights.size(); ++k) {
            const double x = reading.raster.x0 + reading.raster.dx * static_cast<double>(k % reading.raster.nx);
            const double y = reading.raster.y0 + reading.raster.dy * static_cast<double>(k / reading.raster.nx);
            if (std::isfinite(reading.raster.heights[k])) {
                ++there;
                most = std::max(most, std::abs(reading.raster.heights[k] - height(x, y)));
            }
        }
        EXPECT_GT(there, reading.raster.heights.size() / 10);
        return most;
    }

private:
    int m_made = 0;
};

double slope(double x, double y) {
    return 1.0 + 0.2 * x - 0.1 * y;
}

TEST_F(CloudTerrain, ATiltedPlaneIsTheSamePlaneAtTheNodes) {
    const HeightReading plane = read(lay(scattered(20'000, 20.0, slope)));
    // Heights of the points are rounded to a centimetre.
    EXPECT_LT(apart(plane, slope), 0.012);
    EXPECT_EQ(plane.findings.count("cloud.gridded"), 1);
    EXPECT_EQ(plane.findings.count("cloud.ground"), 20'000);
    // 12.5 points to a square metre: six fall into cells of 0.69 m, told with two digits.
    EXPECT_NEAR(plane.raster.dx, 0.7, 0.05);
    EXPECT_LT(countGaps(plane.raster), static_cast<std::int64_t>(plane.raster.heights.size() / 50));
}

TEST_F(CloudTerrain, OnlyTheGroundIsTerrainAndPlantsAreNoDebris) {
    std::vector<MadePoint> points = scattered(20'000, 20.0, slope);
    const auto over = [&](std::uint8_t kind, double height) {
        const std::vector<MadePoint> more = scattered(5'000, 20.0, [&](double x, double y) { return slope(x, y) + height; }, kind);
        points.insert(points.end(), more.begin(), more.end());
    };
    over(5, 8.0);
    over(1, 2.0);
    over(7, -30.0);
    const std::string path = lay(points);
    const HeightReading ground = read(path);
    EXPECT_LT(apart(ground, slope), 0.012);
    EXPECT_EQ(ground.findings.count("cloud.noise"), 5'000);
    // Of a survey what stands there counts as well: a fifth of the points lie 2 m higher, and lift the mean.
    const HeightReading surface = read(path, true);
    EXPECT_EQ(surface.findings.count("cloud.plants"), 5'000);
    EXPECT_NEAR(heightOn(surface.raster, {1.0, 1.0}), slope(1.0, 1.0) + 0.4, 0.5);
    EXPECT_GT(apart(surface, slope), 0.3);
    EXPECT_EQ(refusal(lay(scattered(2'000, 20.0, slope, 4))), "cloud.plants_alone");
    EXPECT_EQ(refusal(lay(scattered(2'000, 20.0, slope, 4)), true), "cloud.plants_alone");
    EXPECT_EQ(read(lay(scattered(20'000, 20.0, slope, 1))).findings.count("cloud.no_ground"), 1);
}

TEST_F(CloudTerrain, FeetAndAnotherSystemComeToTheMetresOfTheCase) {
    m_frame.crs = "EPSG:2993";  // Oregon, m
    m_frame.origin << 400'000, 100'000, 100;
    // The same place in international feet: 1 ft is exactly 0.3048 m.
    const auto feet = [](double x, double y) { return (100.0 + slope(0.3048 * x, 0.3048 * y)) / 0.3048; };
    std::vector<MadePoint> points = scattered(20'000, 65.0, feet);
    for (MadePoint& point : points) {
        point.place[2] -= 30'000;
    }
    const Vec3 offset(400'000 / 0.3048, 100'000 / 0.3048, 300.0);
    const std::string wkt =
        "COMPD_CS[\"made\",PROJCS[\"NAD83(HARN) / Oregon LCC "
        "(ft)\",GEOGCS[\"NAD83(HARN)\",DATUM[\"NAD83_High_Accuracy_Reference_Network\","
        "SPHEROID[\"GRS 1980\",6378137,298.257222101]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],"
        "PROJECTION[\"Lambert_Conformal_Conic_2SP\"],PARAMETER[\"latitude_of_origin\",41.75],PARAMETER[\"central_meridian\",-120.5]"
        ","
        "PARAMETER[\"standard_parallel_1\",43],PARAMETER[\"standard_parallel_2\",45.5],PARAMETER[\"false_easting\",1312335.958],"
        "PARAMETER[\"false_northing\",0],UNIT[\"foot\",0.3048]],VERT_CS[\"heights\",VERT_DATUM[\"zero\",2005],UNIT[\"foot\",0.3048]"
        "]]";
    const HeightReading read = this->read(lay(points, wkt, offset));
    EXPECT_LT(apart(read, slope), 0.012);
    EXPECT_EQ(read.findings.count("terrain.projected"), 1);
    // Without its system nobody knows of the feet, and the cloud lies elsewhere.
    m_frame = Frame();
    m_frame.origin << 400'000, 100'000, 0;
    const std::string path = lay(points, "", offset);
    EXPECT_EQ(refusal(path), "terrain.elsewhere");
    try {
        this->read(path);
    } catch (const Error& error) {
        EXPECT_THAT(englishText(error.remedy()), testing::HasSubstr("seem to be feet"));
    }
}

TEST_F(CloudTerrain, WhatNoTerrainCanBeMadeOfIsSaid) {
    const auto place = [](const Vec3& at) {
        return std::vector<MadePoint>{{{0, 0, 0}}, {{1, 1, 1}}, {{static_cast<std::int32_t>(at.x()), 2, 3}}};
    };
    EXPECT_EQ(refusal(lay(scattered(1'000, 20.0, slope), "", Vec3(1e5, 0.0, 0.0))), "terrain.elsewhere");
    const std::string degrees =
        "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],"
        "UNIT[\"degree\",0.0174532925199433],AUTHORITY[\"EPSG\",\"4326\"]]";
    EXPECT_EQ(refusal(lay(scattered(1'000, 20.0, slope), degrees, Vec3(9.0, 48.0, 0.0), 1e-7)), "terrain.degrees");
    EXPECT_EQ(refusal(lay(place(Vec3(5, 0, 0)))), "cloud.in_line") << "three points in one place";
    // Points of a line make no surface, whichever way it goes, and also where they lie a little beside it.
    const auto line = [](double east, double north) {
        std::vector<MadePoint> points;
        for (int k = 0; k < 200; ++k) {
            const double beside = k % 2 == 0 ? 100.0 : -100.0;
            points.push_back({{static_cast<std::int32_t>(std::lround(100.0 * k * east + beside * north)),
                               static_cast<std::int32_t>(std::lround(100.0 * k * north - beside * east)), 100 * (k % 7)}});
        }
        return points;
    };
    EXPECT_EQ(refusal(lay(line(1.0, 0.0))), "cloud.in_line");
    EXPECT_EQ(refusal(lay(line(0.6, 0.8))), "cloud.in_line");
    EXPECT_EQ(refusal(lay({})), "cloud.no_points");
    std::vector<MadePoint> echoless = scattered(20'000, 20.0, slope);
    echoless.resize(echoless.size() + 100'000);
    const HeightReading told = read(lay(echoless));
    EXPECT_EQ(told.findings.count("cloud.no_return"), 100'000);
    EXPECT_LT(apart(told, slope), 0.012);
}

TEST_F(CloudTerrain, DegreesBecomeMetresWhereTheCaseHasASystem) {
    m_frame.crs = "EPSG:32632";
    m_frame.origin << 500'000, 5'316'300, 0;  // 9 degrees east, 48 north to some metres
    std::vector<MadePoint> points = scattered(40'000, 2'000.0, [](double, double) { return 0.0; });
    for (MadePoint& point : points) {
        point.place[2] = 120'000'000;
    }
    const std::string degrees =
        "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],"
        "UNIT[\"degree\",0.0174532925199433],AUTHORITY[\"EPSG\",\"4326\"]]";
    const HeightReading told = read(lay(points, degrees, Vec3(9.0, 47.998, 0.0), 1e-7));
    EXPECT_EQ(told.findings.count("cloud.degrees"), 1);
    EXPECT_LT(apart(told, [](double, double) { return 12.0; }), 1e-6);
}

TEST_F(CloudTerrain, CoordinatesKeptCoarselyAndColoursOfEitherDepthAreSaid) {
    const std::string head =
        "ply\nformat binary_little_endian 1.0\nelement vertex 1600\nproperty float x\nproperty float y\nproperty float "
        "z\nend_header\n";
    CloudBytes ply(head.begin(), head.end());
    for (int i = 0; i < 1'600; ++i) {
        for (const int value : {5'000'000 + i % 40 - 20, i / 40 - 20, 3}) {
            putNumber(ply, ply.size(), static_cast<float>(value));
        }
    }
    m_frame.origin << 5'000'000, 0, 0;
    const HeightReading coarse = read(layCloud(m_folder / "coarse.ply", ply));
    EXPECT_EQ(coarse.findings.count("cloud.coarse"), 1);
    EXPECT_LT(apart(coarse, [](double, double) { return 3.0; }), 1e-9);
    m_frame = Frame();
    std::vector<MadePoint> points = scattered(20'000, 20.0, slope);
    for (MadePoint& point : points) {
        point.colour = {200, 100, 50};
    }
    const HeightReading bytes = read(lay(points));
    EXPECT_EQ(bytes.findings.count("cloud.colours_of_8_bits"), 1);
    for (MadePoint& point : points) {
        point.colour = {51'400, 25'700, 12'850};
    }
    const HeightReading words = read(lay(points));
    EXPECT_EQ(words.findings.count("cloud.colours_of_8_bits"), 0);
    EXPECT_EQ(bytes.raster.heights.size(), words.raster.heights.size());
    EXPECT_LT(apart(words, slope), 0.012);
}

TEST_F(CloudTerrain, APlyOfPointsIsACloudAndOneOfFacesAMesh) {
    std::string points = "ply\nformat ascii 1.0\nelement vertex 1681\nproperty double x\nproperty double y\nproperty double z\n";
    const std::string none = "element face 0\nproperty list uchar int vertex_indices\n";
    const std::string one = "element face 2\nproperty list uchar int vertex_indices\n";
    std::string rows = "end_header\n";
    for (int k = 0; k < 1'681; ++k) {
        const double x = k % 41 - 20;
        const double y = k / 41 - 20;
        rows += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(slope(x, y)) + "\n";
    }
    const auto opened = [&](const std::string& name, const std::string& text) {
        return openTerrain(layCloud(m_folder / name, text), m_frame, m_structure, Execution());
    };
    for (const std::string& text : {points + rows, points + none + rows}) {
        const TerrainInput cloud = opened("points.ply", text);
        EXPECT_EQ(cloud.findings.count("cloud.gridded"), 1);
        EXPECT_NEAR(cloud.grid->height(2.0, 3.0), slope(2.0, 3.0), 1e-3);
    }
    const TerrainInput mesh = opened("mesh.ply", points + one + rows + "3 0 40 1680\n3 0 1680 1640\n");
    EXPECT_EQ(mesh.findings.count("cloud.gridded"), 0);
    EXPECT_NEAR(mesh.grid->height(2.0, 3.0), slope(2.0, 3.0), 1e-3);
}

TEST_F(CloudTerrain, TextIsARasterWhereItIsOneAndElseACloud) {
    std::string lattice;
    std::string cloud = "x,y,z\n";
    const std::vector<MadePoint> points = scattered(5'000, 20.0, slope);
    for (int k = 0; k < 1'600; ++k) {
        lattice += std::to_string(k % 40 - 20) + " " + std::to_string(20 - k / 40) + " " +
                   std::to_string(slope(k % 40 - 20, 20 - k / 40)) + "\n";
    }
    for (const MadePoint& point : points) {
        cloud += std::to_string(0.01 * point.place[0]) + "," + std::to_string(0.01 * point.place[1]) + "," +
                 std::to_string(0.01 * point.place[2]) + "\n";
    }
    const HeightReading asRaster = read(layCloud(m_folder / "lattice.xyz", lattice));
    EXPECT_EQ(asRaster.findings.count("cloud.gridded"), 0);
    EXPECT_EQ(asRaster.raster.dx, 1.0);
    const HeightReading asCloud = read(layCloud(m_folder / "cloud.csv", cloud));
    EXPECT_EQ(asCloud.findings.count("cloud.gridded"), 1);
    EXPECT_LT(apart(asCloud, slope), 0.012);
    EXPECT_EQ(refusal(layCloud(m_folder / "words.txt", "neither heights nor points\n")), "terrain.unknown_format");
}

TEST_F(CloudTerrain, HolesAreToldOfTerrainAndSurvey) {
    std::vector<MadePoint> points = scattered(40'000, 20.0, slope);
    std::erase_if(points, [](const MadePoint& point) { return std::hypot(point.place[0] - 1'000, point.place[1]) < 400; });
    const std::string path = lay(points);
    const TerrainInput terrain = openTerrain(path, m_frame, m_structure, Execution());
    EXPECT_GT(terrain.findings.count("terrain.filled"), 50);
    EXPECT_NEAR(terrain.grid->height(10.0, 0.0), slope(10.0, 0.0), 0.5);
    const SurveyInput survey = readSurvey(path, m_frame, {}, m_structure, Execution());
    EXPECT_GT(survey.findings.count("survey.gaps"), 50);
    EXPECT_TRUE(std::isnan(survey.survey.heights.at(10.0, 0.0))) << "nothing was seen there, which is not nothing";
    EXPECT_NEAR(survey.survey.heights.at(-10.0, 0.0), slope(-10.0, 0.0), 0.02);
    EXPECT_EQ(survey.sha256, terrain.sha256);
}

TEST_F(CloudTerrain, ACloudIsEvidenceOfCausesAsARasterIs) {
    const auto heap = [](double x, double y) { return std::abs(x) < 5.0 && std::abs(y) < 3.0 ? 2.0 : 0.0; };
    const SurveyInput input = readSurvey(lay(scattered(100'000, 15.0, heap, 1)), m_frame, {}, m_structure, Execution());
    const SurfaceEvidence evidence = surfaceEvidence(input, {}, 0.5, SiteSurface(), Execution());
    // The heap covers 10 x 6 m; its edge cuts cells along 32 m. The ground around it was seen as well.
    double covered = 0.0;
    for (std::size_t c = 0; c < evidence.seen.cells.size(); ++c) {
        covered += evidence.holds(evidence.seen, static_cast<std::ptrdiff_t>(c)) ? 0.25 : 0.0;
    }
    EXPECT_NEAR(covered, 60.0, 16.0);
    EXPECT_NEAR(0.25 * static_cast<double>(evidence.seen.cells.size()), 900.0, 31.0);
}

TEST_F(CloudTerrain, TheClassesThatAreTheGroundAreChosen) {
    // Ground at 0, water (9) at 0.5 beside it, and a roof (6) at 3 m over all.
    std::vector<MadePoint> points = scattered(8000, 12.0, [](double, double) { return 0.0; });
    for (MadePoint& point : points) {
        if (point.place[0] > 0) {
            point.kind = 9;
            point.place[2] = 50;
        }
    }
    const std::vector<MadePoint> roof = scattered(4000, 12.0, [](double, double) { return 3.0; }, 6);
    points.insert(points.end(), roof.begin(), roof.end());
    const std::string path = lay(points);
    const auto with = [&](std::vector<std::uint16_t> classes, bool surface) {
        Site site;
        site.groundClasses = std::move(classes);
        return readHeights(path, m_frame, site, m_structure, Execution(), {.alongAxes = !surface, .surface = surface});
    };
    const auto highest = [](const HeightReading& reading) {
        double most = -1e9;
        for (const double height : reading.raster.heights) {
            most = std::isfinite(height) ? std::max(most, height) : most;
        }
        return most;
    };
    EXPECT_NEAR(highest(with({}, false)), 0.0, 1e-6) << "class 2 unless something else is asked for";
    const HeightReading both = with({2, 9}, false);
    EXPECT_NEAR(highest(both), 0.5, 0.05) << "planes through the shore overshoot";
    ASSERT_EQ(both.findings.count("cloud.ground"), 8000);
    EXPECT_NEAR(highest(with({6}, false)), 3.0, 1e-6);
    EXPECT_EQ(with({6}, true).findings.count("cloud.ground"), 0) << "a survey takes all that stands there";
    try {
        with({11}, false);
        FAIL() << "no point is of that class";
    } catch (const ParseError& error) {
        EXPECT_EQ(error.message().id, "cloud.no_class");
    }
}

}  // namespace

}  // namespace rubble::io
