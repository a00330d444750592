#include "io/site/clouds/cloud_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "core/base/unknown.h"
#include "io/site/clouds/distance_files.h"
#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

/// Rows of numbers of a table with a heading in quotes; not a number where there is none.
std::vector<std::map<std::string, double>> rowsOf(const std::string& path) {
    const auto fields = [](const std::string& line) {
        std::vector<std::string> all;
        std::istringstream parts(line);
        for (std::string part; std::getline(parts, part, ',');) {
            std::erase(part, '"');
            all.push_back(part);
        }
        return all;
    };
    std::ifstream in(path);
    std::string line;
    std::getline(in, line);
    const std::vector<std::string> names = fields(line);
    std::vector<std::map<std::string, double>> rows;
    while (std::getline(in, line)) {
        const std::vector<std::string> values = fields(line);
        rows.emplace_back();
        for (std::size_t c = 0; c < names.size(); ++c) {
            double number = unknown;
            std::from_chars(values[c].data(), values[c].data() + values[c].size(), number);
            rows.back()[names[c]] = number;
        }
    }
    return rows;
}

CloudComparisonRequest autzen() {
    const std::string folder = sourcePath("tests/data/clouds/m3c2/autzen-bmx-");
    CloudComparisonRequest request;
    request.first = folder + "2010.las";
    request.second = folder + "2023.las";
    request.cores = folder + "largersample.txt";
    request.settings = {1.390432, 2.890432, 5.5, std::nullopt};
    return request;
}

std::vector<MadePoint> level(int height, int from = 0) {
    std::vector<MadePoint> points;
    for (int i = 0; i < 40; ++i) {
        for (int j = 0; j < 40; ++j) {
            points.push_back({{from + 10 * i, 10 * j, height}});
        }
    }
    return points;
}

class CloudPair : public testing::Test {
protected:
    TemporaryFolder m_folder;

    std::string lay(const std::string& name, std::vector<MadePoint> points, const std::string& wkt = "") {
        MadeLas las;
        las.points = std::move(points);
        las.wkt = wkt;
        las.minor = 4;
        las.format = 6;
        return layCloud(m_folder / name, las.bytes());
    }
    static std::string refusal(const CloudComparisonRequest& request) {
        try {
            compareClouds(request, Execution());
        } catch (const Error& error) {
            return error.message().id;
        }
        return "compared";
    }
};

// The two programs differ among themselves at 9 of the cores by a point on the rim of a cylinder.
TEST_F(CloudPair, GivesWhatPdalAndCloudCompareGive) {
    const std::string folder = sourcePath("tests/data/clouds/m3c2/autzen-bmx-");
    const auto pdal = rowsOf(folder + "m3c2.txt");
    const auto other = rowsOf(folder + "cc.txt");
    const CloudComparison made = compareClouds(autzen(), Execution());
    ASSERT_EQ(made.distances.size(), 103u);
    std::size_t alike = 0;
    std::size_t levelsAlike = 0;
    std::size_t significanceAlike = 0;
    for (std::size_t k = 0; k < made.distances.size(); ++k) {
        const CoreDistance& core = made.distances[k];
        const auto near = [&](double value, double p, double c) {
            return std::min(std::abs(value - p), std::abs(value - c)) <= 0.002;
        };
        if (core.state == CoreState::Measured) {
            alike += near(core.distance, pdal[k].at("m3c2_distance"), other[k].at("M3C2 distance")) ? 1 : 0;
            levelsAlike += near(core.detection, pdal[k].at("m3c2_uncertainty"), other[k].at("distance uncertainty")) ? 1 : 0;
            significanceAlike += core.significant() == (pdal[k].at("m3c2_significant") == 1.0) ? 1 : 0;
            const Vec3 normal(other[k].at("NormalX"), other[k].at("NormalY"), other[k].at("NormalZ"));
            EXPECT_NEAR(core.normal.dot(normal), 1.0, 0.001) << k;
        } else if (core.state == CoreState::NoNormal) {
            // There CloudCompare writes a normal of zeros and PDAL counts no point.
            EXPECT_EQ(other[k].at("NormalZ"), 0.0) << k;
            EXPECT_EQ(pdal[k].at("m3c2_count1"), 0.0) << k;
        } else {
            EXPECT_EQ(core.state, CoreState::NoSecond) << k;
            EXPECT_TRUE(std::isnan(other[k].at("M3C2 distance"))) << k;
        }
    }
    EXPECT_EQ(alike, 91u);
    // Two cores have two and three points of the second cloud, which tell no roughness.
    EXPECT_EQ(levelsAlike, 89u);
    EXPECT_EQ(significanceAlike, 90u);
    EXPECT_EQ(made.findings.count("distance.no_normal"), 6);
    EXPECT_EQ(made.findings.count("distance.no_second"), 6);
    EXPECT_EQ(made.findings.count("distance.few_points"), 2);
    EXPECT_EQ(made.findings.count("distance.mixed_units"), 1);
    EXPECT_EQ(made.findings.count("distance.registration_unknown"), 1);
    EXPECT_EQ(made.findings.count("distance.system_taken"), 0) << "core points are of no system of their own";
    EXPECT_TRUE(std::isnan(made.unit));
}

TEST_F(CloudPair, NoResultDependsOnTheStripsThatMemoryTakes) {
    CloudComparisonRequest request = autzen();
    request.settings = {1.4, 1.4, 3.0, 0.1};
    const CloudComparison whole = compareClouds(request, Execution());
    request.heldPoints = 300;
    const CloudComparison parted = compareClouds(request, Execution());
    EXPECT_EQ(whole.parts, 1);
    EXPECT_GT(parted.parts, 3);
    for (std::size_t k = 0; k < whole.distances.size(); ++k) {
        EXPECT_EQ(whole.distances[k].state, parted.distances[k].state) << k;
        if (whole.distances[k].state == CoreState::Measured) {
            EXPECT_EQ(whole.distances[k].distance, parted.distances[k].distance) << k;
            EXPECT_EQ(whole.distances[k].first.roughness, parted.distances[k].first.roughness) << k;
        }
    }
}

TEST_F(CloudPair, MetresTakeTheUnitsOfPlanAndHeights) {
    const auto system = [](const std::string& unit) {
        return "COMPD_CS[\"made\",LOCAL_CS[\"site\",UNIT[\"metre\",1]],VERT_CS[\"heights\",VERT_DATUM[\"zero\",2005],UNIT[\"" +
               unit + "\",0.3048]]]";
    };
    CloudComparisonRequest request;
    request.first = lay("low.las", level(0), system("foot"));
    request.second = lay("high.las", level(100), system("foot"));
    request.settings = {0.5, 0.5, 2.0, 0.0};
    const CloudComparison numbers = compareClouds(request, Execution());
    EXPECT_EQ(numbers.findings.count("distance.registration_unknown"), 0);
    request.metres = true;
    const CloudComparison metres = compareClouds(request, Execution());
    EXPECT_EQ(metres.unit, 1.0);
    ASSERT_GT(metres.distances.size(), 20u) << "cores are points of the first cloud, one to each cube";
    EXPECT_NEAR(numbers.distances[25].distance, 1.0, 1e-9);
    EXPECT_NEAR(metres.distances[25].distance, 0.3048, 1e-9);
}

TEST_F(CloudPair, DistancesAreWrittenAsCloudsThatAreReadBack) {
    const CloudComparison made = compareClouds(autzen(), Execution());
    for (const char* name : {"distances.las", "distances.ply"}) {
        writeDistanceCloud(m_folder / name, made);
        const WholeCloud read = readCloud(m_folder / name);
        ASSERT_EQ(read.points.size(), made.cores.size()) << name;
        EXPECT_THAT(read.head.unread, testing::Contains("distance")) << name;
        EXPECT_THAT(read.head.unread, testing::Contains("significant")) << name;
        EXPECT_EQ(read.summary.findings.count("cloud.bounds_differ"), 0) << name;
        for (std::size_t k = 0; k < made.cores.size(); ++k) {
            EXPECT_LT((read.points.places[k] - made.cores[k]).norm(), 1e-4) << name;
            const auto& colour = read.points.colours[k];
            const bool grey = colour[0] == colour[1] && colour[1] == colour[2];
            EXPECT_EQ(grey, !made.distances[k].significant()) << name << ' ' << k;
            EXPECT_EQ(colour[0] > colour[2], made.distances[k].significant() && made.distances[k].distance > 0.0)
                << name << ' ' << k;
        }
    }
    EXPECT_EQ(readCloud(m_folder / "distances.las").head.units.heightSystem, "NAVD88 height (ftUS)");
}

TEST_F(CloudPair, SaysWhatCannotBeHeldAgainstEachOther) {
    CloudComparisonRequest request;
    request.first = lay("here.las", level(0));
    request.second = lay("there.las", level(0, 100'000));
    request.settings = {0.5, 0.5, 2.0, std::nullopt};
    EXPECT_EQ(refusal(request), "distance.elsewhere");
    request.second = lay("empty.las", {});
    EXPECT_EQ(refusal(request), "distance.empty");
    request.second = lay("here too.las", level(0));
    request.cores = request.second;
    EXPECT_EQ(refusal(request), "compared");
    request.pairs =
        layCloud(m_folder / "pairs.csv", std::string("name,survey_x_m,survey_y_m,survey_z_m,x_m,y_m,z_m\na,1,2,3,4,5,6\n"));
    EXPECT_EQ(refusal(request), "pairs.of_case");
    request.pairs.clear();
    request.read.crs = "EPSG:4326";
    EXPECT_EQ(refusal(request), "distance.degrees");
    const CloudComparisonRequest feet = [&] {
        CloudComparisonRequest made = autzen();
        made.second = sourcePath("tests/data/clouds/1.0_1.las");
        return made;
    }();
    EXPECT_EQ(refusal(feet), "distance.other_system");
}

}  // namespace

}  // namespace rubble::io
