#include "io/site/surveys/measured_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "core/base/error.h"
#include "io/site/survey_file.h"
#include "io/site/surveys/named_points.h"
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

// Each reader of drawings: points, the edge, an outline, names.
TEST_F(MeasuredPoints, ADrawingInFeetIsBroughtToMetres) {
    const std::string metres = layDrawing(m_folder / "metres.dxf", 101.0);
    std::ifstream in(metres);
    std::stringstream body;
    body << in.rdbuf();
    const std::string feet = m_folder / "feet.dxf";
    std::ofstream(feet) << "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n 70\n     2\n0\nENDSEC\n" << body.str();
    m_frame.origin.setZero();
    const std::vector<Vec3> inMetres = read(metres);
    EXPECT_EQ(m_said.count("drawing.unit_unsaid"), 1);
    const std::vector<Vec3> inFeet = read(feet);
    EXPECT_EQ(m_said.count("drawing.unit"), 1);
    ASSERT_EQ(inFeet.size(), inMetres.size());
    for (std::size_t p = 0; p < inFeet.size(); ++p) {
        EXPECT_LT((inFeet[p] - 0.3048 * inMetres[p]).norm(), 1e-6);
    }
    const auto middle = [&](const std::string& path) {
        const SurveyInput input = readSurvey(path, m_frame, {}, Aabb(), Execution());
        return Eigen::Vector2d(input.survey.bounds().first + input.survey.bounds().second);
    };
    EXPECT_LT((middle(feet) - 0.3048 * middle(metres)).norm(), 1e-6);
    const std::string named =
        "0\nSECTION\n2\nENTITIES\n0\nPOINT\n8\n0\n10\n100\n20\n50\n30\n10\n0\nTEXT\n8\n0\n10\n100\n20\n50\n"
        "30\n10\n40\n1\n1\nA1\n0\nENDSEC\n0\nEOF\n";
    std::ofstream(feet) << "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n21\n0\nENDSEC\n" << named;
    const std::vector<NamedPoint> points = readNamedPoints(feet, m_said, Execution());
    ASSERT_EQ(points.size(), 1u);
    EXPECT_NEAR(points[0].place.x(), 100.0 * 1200.0 / 3937.0, 1e-9);
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

TEST_F(MeasuredPoints, RowsOfATableAreTheEdgeOfTheDebrisInTheirOrder) {
    const std::string path = m_folder / "edge.csv";
    std::ofstream(path) << "name,easting,northing,height\n1,500000,5400000,101\n2,500008,5400000,101\n3,500008,5400006,102\n"
                           "4,500000,5400006,101\n";
    EXPECT_TRUE(holdsMeasuredPoints(path));
    SurveyRequest request;
    request.edge = true;
    Registration east;
    east.shift = Vec3(2.0, 0.0, 0.0);
    request.registration = east;
    const SurveyInput input = readSurvey(path, m_frame, {}, Aabb(), Execution(), request);
    ASSERT_TRUE(input.survey.isFootprint);
    EXPECT_LT((input.survey.bounds().first - Eigen::Vector2d(2.0, 0.0)).norm(), 1e-9);
    EXPECT_LT((input.survey.bounds().second - Eigen::Vector2d(10.0, 6.0)).norm(), 1e-9);
    ASSERT_EQ(input.findings.count("measured.closed"), 1);
    const auto closed = std::find_if(input.findings.list().begin(), input.findings.list().end(),
                                     [](const Finding& finding) { return finding.what.id == "measured.closed"; });
    EXPECT_EQ(englishText(closed->what), "the measured edge is open; it was closed by straight lines, the longest over 6 m");
    // Held for sections the same file has heights.
    request.edge = false;
    EXPECT_FALSE(readSurvey(path, m_frame, {}, Aabb(), Execution(), request).survey.isFootprint);
}

TEST_F(MeasuredPoints, LinesOfADrawingAreJoinedToAnEdge) {
    const std::string path = m_folder / "edge.dxf";
    std::ofstream out(path);
    out << "0\nSECTION\n2\nENTITIES\n0\nPOINT\n8\n0\n10\n500003\n20\n5400003\n30\n101\n";
    for (const char* line :
         {"10\n500000\n20\n5400000\n11\n500008\n21\n5400000\n", "10\n500008\n20\n5400006\n11\n500008\n21\n5400000\n",
          "10\n500008\n20\n5400006\n11\n500000\n21\n5400006\n"}) {
        out << "0\nLINE\n8\n0\n" << line;
    }
    out << "0\nENDSEC\n0\nEOF\n";
    out.close();
    ASSERT_TRUE(holdsMeasuredPoints(path));
    const Outline edge = readMeasuredEdge({path, {}, m_frame, {}}, m_said, Execution());
    ASSERT_EQ(edge.polygons.size(), 1u);
    EXPECT_EQ(edge.polygons[0][0].size(), 4u);
    EXPECT_LT((edge.bounds().second - Eigen::Vector2d(8.0, 6.0)).norm(), 1e-9);
    EXPECT_EQ(m_said.count("measured.points_beside"), 1);
    EXPECT_EQ(m_said.count("measured.closed"), 1);
    EXPECT_EQ(m_said.count("measured.unplaced"), 1);
}

TEST_F(MeasuredPoints, AnEdgeThatEnclosesNothingOrCrossesItselfIsRefused) {
    const auto refusal = [&](const char* rows) {
        const std::string path = m_folder / "edge.csv";
        std::ofstream(path) << "name,easting,northing,height\n" << rows;
        try {
            readMeasuredEdge({path, {}, m_frame, {}}, m_said, Execution());
        } catch (const Error& error) {
            return error.message().id;
        }
        return std::string();
    };
    EXPECT_EQ(refusal("1,500000,5400000,101\n2,500008,5400000,101\n"), "measured.no_edge");
    EXPECT_EQ(refusal("1,500000,5400000,1\n2,500008,5400006,1\n3,500008,5400000,1\n4,500000,5400006,1\n"), "measured.crossed");
    EXPECT_EQ(refusal("1,500000,5400000,1\n2,500008,5400000,1\n3,500008,5400006,1\n"), "");
}

TEST_F(MeasuredPoints, AFileOfNoPointsIsRefused) {
    const std::string path = m_folder / "none.csv";
    std::ofstream(path) << "Easting,Northing,Elevation\n";
    EXPECT_THROW(read(path), Error);
    EXPECT_THROW(read(m_folder / "missing.dxf"), Error);
}

}  // namespace

}  // namespace rubble::io
