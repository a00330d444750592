#include "io/site/surveys/survey_reach.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "io/site/clouds/point_writer.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

/// A structure of 40 m by 10 m and 12 m of height: a site is read as far as 120 m from it.
class ReachOfSurveys : public testing::Test {
protected:
    Findings checked(const std::string& path, const std::optional<Registration>& placed = std::nullopt) {
        return checkSurveyReach(path, placed, Frame(), Site(), Aabb(Vec3(-20.0, -5.0, 0.0), Vec3(20.0, 5.0, 12.0)), Execution());
    }
    /// Beside the structure, where no degrees of latitude are.
    std::string outlineAt(double x) {
        const std::string path = m_folder / "outline.geojson";
        std::ofstream(path) << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":)"
                            << R"({"type":"Polygon","coordinates":[[[)" << x << ",100],[" << x + 10.0 << ",100],[" << x + 10.0
                            << ",110],[" << x << ",100]]]}}]}";
        return path;
    }
    std::string heightsAt(double x) {
        const AsciiGrid around{80, 40, x - 40.0, -20.0};
        return around.write(m_folder / "heights.asc", [](double, double) { return 1.0; });
    }
    std::string lasAt(double x) {
        WrittenCloud cloud;
        cloud.points = 100;
        cloud.box = Aabb(Vec3(x, 0.0, 0.0), Vec3(x + 9.0, 9.0, 1.0));
        writePoints(m_folder / "cloud.las", cloud, [&](std::size_t k, WrittenPoint& point) {
            point.place = Vec3(x + static_cast<double>(k % 10), static_cast<double>(k / 10), k == 0 ? 1.0 : 0.0);
        });
        return m_folder / "cloud.las";
    }
    std::string tableAt(double x) {
        const std::string path = m_folder / "cloud.csv";
        std::ofstream out(path);
        out << "x,y,z\n";
        for (int k = 0; k < 100; ++k) {
            // On no grid, or it would be taken for a raster.
            out << x + k % 10 + 0.01 * (k * 7 % 13) << ',' << k / 10 + 0.01 * (k * 5 % 11) << ",0.5\n";
        }
        return path;
    }
    TemporaryFolder m_folder;
};

TEST_F(ReachOfSurveys, OneThatLiesThereHasNothingSaid) {
    for (const std::string& path : {outlineAt(0.0), heightsAt(0.0), lasAt(0.0), tableAt(0.0)}) {
        EXPECT_TRUE(checked(path).empty()) << path;
    }
    EXPECT_TRUE(checked(outlineAt(50.0)).empty()) << "debris may go as far";
}

TEST_F(ReachOfSurveys, OneKilometresAwayIsSaid) {
    EXPECT_EQ(checked(outlineAt(3000.0)).count("survey.far"), 1);
    EXPECT_EQ(checked(lasAt(3000.0)).count("survey.far"), 1);
    EXPECT_EQ(checked(tableAt(30'000.0)).count("survey.far"), 1);
    EXPECT_TRUE(checked(tableAt(3000.0)).empty()) << "the first points of a table may be the end of a long one";
    EXPECT_EQ(checked(heightsAt(3000.0)).count("terrain.elsewhere"), 1);
}

TEST_F(ReachOfSurveys, OneWithoutAPlaceInTheSystemOfTheCaseIsSaid) {
    // Degrees by its format, and none that there are.
    Frame frame;
    frame.crs = "EPSG:25832";
    frame.origin = {500'000, 5'700'000, 100};
    const Aabb structure(Vec3(-20.0, -5.0, 0.0), Vec3(20.0, 5.0, 12.0));
    const Findings said = checkSurveyReach(outlineAt(5000.0), std::nullopt, frame, Site(), structure, Execution());
    EXPECT_EQ(said.count("survey.corner"), 1);
}

TEST_F(ReachOfSurveys, WhereItWasPlacedCounts) {
    Registration placed;
    placed.shift = Vec3(-3000.0, 0.0, 0.0);
    for (const std::string& path : {outlineAt(3000.0), heightsAt(3000.0), lasAt(3000.0)}) {
        EXPECT_TRUE(checked(path, placed).empty()) << path;
    }
    placed.shift = Vec3(0.0, 5000.0, 0.0);
    EXPECT_EQ(checked(lasAt(0.0), placed).count("survey.far"), 1);
}

TEST_F(ReachOfSurveys, WhatIsNoSurveyIsRefusedAsElsewhere) {
    std::ofstream(m_folder / "notes.txt") << "no heights here";
    EXPECT_THROW(checked(m_folder / "notes.txt"), Error);
}

}  // namespace
}  // namespace rubble::io
