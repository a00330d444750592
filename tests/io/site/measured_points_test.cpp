#include "io/site/surveys/measured_points.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "io/site/survey_file.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

/// A drawing with two points, a line, and a closed polyline of a square of 10 m.
std::string layDrawing(const std::string& path, double height) {
    std::ofstream out(path);
    out.precision(12);
    const auto put = [&](int code, const auto& value) { out << code << '\n' << value << '\n'; };
    put(0, "SECTION");
    put(2, "ENTITIES");
    for (const double x : {1.0, 2.5}) {
        put(0, "POINT");
        put(8, "points");
        put(10, 500000.0 + x);
        put(20, 5400000.0 + 4.0);
        put(30, height + x);
    }
    put(0, "LINE");
    put(8, "ridge");
    put(10, 500000.0);
    put(20, 5400000.0);
    put(30, height);
    put(11, 500008.0);
    put(21, 5400006.0);
    put(31, height + 2.0);
    put(0, "LWPOLYLINE");
    put(8, "edge");
    put(90, 4);
    put(70, 1);
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(10, 0), std::pair(10, 10), std::pair(0, 10)}) {
        put(10, 500000 + x);
        put(20, 5400000 + y);
    }
    put(0, "ENDSEC");
    put(0, "EOF");
    return path;
}

class MeasuredPoints : public testing::Test {
protected:
    TemporaryFolder m_folder;
    Frame m_frame;
    Findings m_said;

    MeasuredPoints() {
        m_frame.origin << 500000.0, 5400000.0, 100.0;
        m_frame.crs = "EPSG:25832";
    }
    std::vector<Vec3> read(const std::string& path, const std::optional<Registration>& placed = std::nullopt) {
        MeasuredRequest request{path, {}, m_frame, {}};
        request.placed = placed;
        return readMeasuredPoints(request, m_said, Execution());
    }
};

TEST_F(MeasuredPoints, ATableOfATotalStationIsReadByItsHeading) {
    const std::string path = m_folder / "station.csv";
    std::ofstream(path) << "Point,Easting,Northing,Elevation,Code\n1,500001.5,5400002.5,101.25,edge\n2,500003,5400004,102,top\n";
    const std::vector<Vec3> places = read(path);
    ASSERT_EQ(places.size(), 2u);
    EXPECT_LT((places[0] - Vec3(1.5, 2.5, 1.25)).norm(), 1e-9);
    Registration up;
    up.shift = Vec3(0.0, 0.0, 0.5);
    EXPECT_LT((read(path, up)[1] - Vec3(3.0, 4.0, 2.5)).norm(), 1e-9);
}

TEST_F(MeasuredPoints, ADrawingGivesItsPointsAndTheCornersOfItsLines) {
    const std::vector<Vec3> places = read(layDrawing(m_folder / "site.dxf", 101.0));
    // The edge has no heights: as a section it would lie at the sea.
    ASSERT_EQ(places.size(), 4u);
    EXPECT_LT((places[0] - Vec3(1.0, 4.0, 2.0)).norm(), 1e-9);
    EXPECT_LT((places[3] - Vec3(8.0, 6.0, 3.0)).norm(), 1e-9);
    EXPECT_GE(m_said.count("measured.level"), 4);
    EXPECT_EQ(m_said.count("measured.unplaced"), 1);
}

TEST_F(MeasuredPoints, ClosedLinesOfADrawingAreAnOutline) {
    const SurveyInput input = readSurvey(layDrawing(m_folder / "site.dxf", 101.0), m_frame, {}, Aabb(), Execution());
    ASSERT_TRUE(input.survey.isFootprint);
    ASSERT_EQ(input.survey.footprint.polygons.size(), 1u);
    EXPECT_EQ(input.survey.footprint.polygons[0][0].size(), 4u);
    EXPECT_LT((input.survey.bounds().second - Eigen::Vector2d(10.0, 10.0)).norm(), 1e-9);
    EXPECT_EQ(input.findings.count("survey.closed_lines"), 1);
    EXPECT_EQ(input.findings.count("survey.other_shapes"), 3);
}

TEST_F(MeasuredPoints, AFileOfNoPointsIsRefused) {
    const std::string path = m_folder / "none.csv";
    std::ofstream(path) << "Easting,Northing,Elevation\n";
    EXPECT_THROW(read(path), Error);
    EXPECT_THROW(read(m_folder / "missing.dxf"), Error);
}

}  // namespace

}  // namespace rubble::io
