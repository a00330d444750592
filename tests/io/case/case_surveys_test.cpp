#include "io/case/case_surveys.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/base/error.h"
#include "core/evidence/evidence_list.h"
#include "tests/io/site/clouds/made_clouds.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

class CaseSurveys : public testing::Test {
protected:
    TemporaryFolder m_folder;

    SurveyKind kindOf(const std::string& name, const std::string& text, const CloudRequest& read = {}) {
        const std::string path = m_folder / name;
        std::ofstream(path) << text;
        return surveyKindOf(path, read);
    }
};

/// Nodes of a regular grid in the order of a raster of text.
std::string lattice(const std::string& heading, const std::string& front = "") {
    std::string text = heading;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            text += front + std::to_string(column) + " " + std::to_string(10 - row) + " " + std::to_string(column * row) + "\n";
        }
    }
    return text;
}

/// Places that follow no lattice: steps of two irrational numbers.
std::string scattered() {
    std::string text;
    for (int k = 0; k < 500; ++k) {
        text += std::to_string(40.0 * std::fmod(0.754877666 * k, 1.0)) + " " +
                std::to_string(40.0 * std::fmod(0.569840291 * k, 1.0)) + " 1\n";
    }
    return text;
}

TEST_F(CaseSurveys, AreCloudsWhereTheirContentIsPoints) {
    EXPECT_EQ(kindOf("named.xyz", lattice("x y z\n")), SurveyKind::Cloud) << "a table that names its columns is one of points";
    EXPECT_EQ(kindOf("scattered.xyz", scattered()), SurveyKind::Cloud);
    EXPECT_EQ(kindOf("pnezd.txt", "101,5,4,3,TOPO\n102,6,4,3,TOPO\n", {{}, {"skip", "y", "x", "z", "skip"}}), SurveyKind::Cloud);
    MadeLas las;
    las.points = {MadePoint{}};
    EXPECT_EQ(surveyKindOf(layCloud(m_folder / "cloud.tif", las.bytes()), {}), SurveyKind::Cloud) << "whatever its name says";
}

TEST_F(CaseSurveys, AreMeasuredPointsWhereATableNamesThemOrADrawingHasNoArea) {
    EXPECT_EQ(kindOf("station.csv", "name,easting,northing,height\nP1,1,2,3\nP2,2,2,3\n"), SurveyKind::Points);
    const std::string line =
        "0\nSECTION\n2\nENTITIES\n0\nPOLYLINE\n8\n0\n66\n1\n70\n0\n0\nVERTEX\n8\n0\n10\n0\n20\n0\n30\n1\n0\n"
        "VERTEX\n8\n0\n10\n5\n20\n0\n30\n2\n0\nSEQEND\n0\nENDSEC\n0\nEOF\n";
    EXPECT_EQ(kindOf("line.dxf", line), SurveyKind::Points);
    EXPECT_NE(kindOf("none.dxf", "no drawing\n"), SurveyKind::Points);
    std::string many = "id,x,y,z\n";
    while (many.size() <= (std::size_t{1} << 20)) {
        many += "7,1.25,2.5,3.75\n8,2.25,3.5,4.75\n";
    }
    EXPECT_EQ(kindOf("numbered.csv", many), SurveyKind::Cloud) << "no station measures so many";
}

TEST_F(CaseSurveys, LeaveOpenWhatTheirFilesDoNotSay) {
    const auto open = [&](const std::string& name, const std::string& text, const std::string& crs) {
        CaseInput survey{"survey-1", InputRole::Survey, name, ""};
        survey.kind = kindOf(name, text);
        Frame frame;
        frame.crs = crs;
        return readingLeftOpen(survey, m_folder / name, frame);
    };
    EXPECT_FALSE(open("named.csv", "x,y,z\n1,2,3\n4,5,7\n", "").any());
    EXPECT_TRUE(open("named.csv", "x,y,z\n1,2,3\n4,5,7\n", "EPSG:25832").system);
    EXPECT_TRUE(open("bare.txt", "7 1 2 0.5\n7 10 3 0.5\n7 4 9 1.5\n", "").columns);
    EXPECT_TRUE(open("odd.csv", "a,b,c\n1,2,3\n4,5,7\n", "").columns) << "its heading says nothing that is known";
    EXPECT_FALSE(open("notes.txt", "no heights here", "").any()) << "it is no table";
    // Stated once it can be read so, and left alone otherwise.
    CaseInput survey{"survey-1", InputRole::Survey, "odd.csv", ""};
    survey.kind = SurveyKind::Heights;
    EXPECT_THROW(stateReading(survey, m_folder / "odd.csv", {{}, {"x", "y"}}), Error);
    EXPECT_TRUE(survey.read.empty());
    stateReading(survey, m_folder / "odd.csv", {{}, {"y", "x", "z"}});
    EXPECT_EQ(survey.kind, SurveyKind::Cloud);
    EXPECT_EQ(survey.read.columns.front(), "y");
}

TEST_F(CaseSurveys, AreHeightsWhereARasterIsRead) {
    EXPECT_EQ(kindOf("lattice.xyz", lattice("")), SurveyKind::Heights);
    const AsciiGrid grid{4, 4, 0.0, 0.0};
    EXPECT_EQ(surveyKindOf(grid.write(m_folder / "grid.txt", [](double x, double y) { return x + y; }), {}), SurveyKind::Heights);
    EXPECT_EQ(kindOf("lattice.txt", lattice(""), {{}, {"x", "y", "z"}}), SurveyKind::Cloud) << "columns are asked for of points";
}

TEST_F(CaseSurveys, AreOutlinesWhereTheReaderOfPolygonsTakesThem) {
    EXPECT_EQ(kindOf("edge.dxf",
                     "0\nSECTION\n2\nENTITIES\n0\nPOLYLINE\n8\n0\n66\n1\n70\n1\n0\nVERTEX\n8\n0\n10\n0\n20\n0\n0\n"
                     "VERTEX\n8\n0\n10\n5\n20\n0\n0\nVERTEX\n8\n0\n10\n5\n20\n5\n0\nSEQEND\n0\nENDSEC\n0\nEOF\n"),
              SurveyKind::Outline);
    EXPECT_EQ(kindOf("edge.txt", R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":)"
                                 R"({"type":"Polygon","coordinates":[[[0,0],[5,0],[5,5],[0,0]]]}}]})"),
              SurveyKind::Outline);
}

TEST_F(CaseSurveys, OfAnOldCaseAreSaidToBeOtherwiseThanTheirNames) {
    // A table of a station: by its ending it is listed as a cloud.
    const std::string station = m_folder / "station.csv";
    std::ofstream(station) << "name,easting,northing,height\nP1,1,2,3\nP2,2,2,3\n";
    CaseInput survey{"survey-1", InputRole::Survey, "station.csv", ""};
    ASSERT_EQ(evidenceFormOf(survey), EvidenceForm::Cloud);
    const Findings said = checkKind(survey, station);
    ASSERT_EQ(said.count("evidence.other_kind"), 1);
    EXPECT_EQ(englishText(said.list().front().what), "the ending of its name says otherwise, but this file holds measured points");
    const std::string points = m_folder / "points.csv";
    std::ofstream(points) << "x,y,z\n1,2,3\n4,5,7\n";
    EXPECT_TRUE(checkKind(survey, points).empty()) << "it is what its name says";
    // The same file added once more: what it holds is kept from then on.
    Case theCase;
    theCase.inputs.push_back(survey);
    EXPECT_EQ(takeSurvey(theCase, m_folder / "a.rubble", station), 0u);
    EXPECT_EQ(theCase.inputs[0].kind, SurveyKind::Points);
    EXPECT_TRUE(checkKind(theCase.inputs[0], station).empty());
}

TEST_F(CaseSurveys, HeldAsControlGiveTheirNames) {
    std::ofstream(m_folder / "a.csv") << "name,easting,northing,height\nP1,1,2,3\nP2,2,2,3\n";
    std::ofstream(m_folder / "b.csv") << "name,easting,northing,height\nP2,9,9,9\nP3,3,2,3\n";
    Case theCase;
    for (const char* name : {"a.csv", "b.csv"}) {
        theCase.inputs[takeSurvey(theCase, m_folder / "a.rubble", m_folder / name)].held = PointsHeld::Control;
    }
    theCase.inputs[1].registration.emplace().shift = Vec3(0.0, 0.0, 0.5);
    const SitePlace place{Frame(), Site()};
    Findings said;
    const std::vector<NamedPoint> points = controlPointsOfCase(theCase, m_folder / "a.rubble", place, said, Execution());
    ASSERT_EQ(points.size(), 3u);
    EXPECT_EQ(points[1].place, Vec3(2.0, 2.0, 3.0)) << "the first file counts";
    EXPECT_EQ(points[2].name, "P3");
    EXPECT_LT((points[2].place - Vec3(3.0, 2.0, 3.5)).norm(), 1e-9) << "its file is registered";
    EXPECT_EQ(said.count("control.of_another_file"), 1);
    theCase.inputs[0].held = theCase.inputs[1].held = PointsHeld::Outline;
    EXPECT_TRUE(controlPointsOfCase(theCase, m_folder / "a.rubble", place, said, Execution()).empty());
    // Read as a cloud, they are held to say nothing of their own any more.
    stateReading(theCase.inputs[0], m_folder / "a.csv", {{}, {"skip", "x", "y", "z"}});
    EXPECT_EQ(theCase.inputs[0].held, theCase.inputs[0].kind == SurveyKind::Points ? PointsHeld::Outline : PointsHeld::Section);
}

TEST_F(CaseSurveys, AreLookedIntoWhenTheyAreTaken) {
    std::ofstream(m_folder / "points.xyz") << "x y z\n1 2 3\n";
    Case theCase;
    const std::size_t at = takeSurvey(theCase, m_folder / "a.rubble", m_folder / "points.xyz");
    EXPECT_EQ(theCase.inputs[at].kind, SurveyKind::Cloud);
}

}  // namespace

}  // namespace rubble::io
