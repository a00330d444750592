#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/case/case_file.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/command_run.h"
#include "tests/support/places.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

/// A case of the small collapse, its run, and a scan of that which lies 0.6 m and 3 degrees out of place.
class EvidenceOfCase : public SmallRun {
protected:
    std::string m_case = m_folder / "small.rubble";
    std::string m_cloud = m_folder / "moved.csv";
    std::vector<std::string> m_scales{"--normal-scale", "0.4", "--projection-scale", "0.4", "--depth", "1", "--scanner", "-6,-6,3"};

    static Eigen::Vector3d misplaced(const Eigen::Vector3d& at) {
        const double angle = 3.0 * 3.14159265358979 / 180.0;
        return {std::cos(angle) * at.x() - std::sin(angle) * at.y() + 0.5,
                std::sin(angle) * at.x() + std::cos(angle) * at.y() - 0.3, at.z() + 0.2};
    }

    void SetUp() override {
        run({}, "2");
        io::saveCase(m_case, io::caseForFe(m_path, m_case));
        const std::string scan = m_folder / "scan.csv";
        ASSERT_EQ(cli({"scan", m_out, "--step", "0.4", "--range", "20", "--noise", "0.01", "--out", scan, "--scanner", "-6,-6,3"})
                      .exitCode,
                  0);
        std::ifstream in(scan);
        std::ofstream out(m_cloud);
        std::string line;
        std::getline(in, line);
        out << "x,y,z\n";
        while (std::getline(in, line)) {
            const Eigen::Vector3d at = misplaced(placeIn(line));
            out << at.x() << ',' << at.y() << ',' << at.z() << '\n';
        }
    }
    static Eigen::Vector3d placeIn(const std::string& line) {
        std::istringstream fields(line);
        Eigen::Vector3d at;
        char comma = 0;
        fields >> at.x() >> comma >> at.y() >> comma >> at.z();
        return at;
    }
    /// Pairs of four places as somebody picks them, to 2 mm.
    std::string pairs(double error = 0.002) {
        const std::string path = m_folder / "pairs.csv";
        std::ofstream out(path);
        out << "name,survey_x,survey_y,survey_z,x_m,y_m,z_m\n";
        double sign = 1.0;
        for (const Eigen::Vector3d& at :
             {Eigen::Vector3d(-3, -3, 0), Eigen::Vector3d(8, -2, 0), Eigen::Vector3d(7, 6, 2), Eigen::Vector3d(-2, 5, 1)}) {
            const Eigen::Vector3d from = misplaced(at);
            out << "p," << from.x() + sign * error << ',' << from.y() << ',' << from.z() - sign * error << ',' << at.x() << ','
                << at.y() << ',' << at.z() << '\n';
            sign = -sign;
        }
        return path;
    }
    nlohmann::json evidence(std::vector<std::string> more) {
        more.insert(more.begin(), {"evidence", m_case, "--json"});
        const Outcome outcome = cli(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.exitCode == 0 ? outcome.json() : nlohmann::json();
    }
    nlohmann::json compared(std::vector<std::string> more) {
        more.insert(more.begin(), {"cloud", m_cloud, "--against", m_out, "--json"});
        more.insert(more.end(), m_scales.begin(), m_scales.end());
        const Outcome outcome = cli(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.exitCode == 0 ? outcome.json() : nlohmann::json();
    }
    static bool warns(const nlohmann::json& made, const std::string& id) {
        for (const nlohmann::json& warning : made["warnings"]) {
            if (warning["id"] == id) {
                return true;
            }
        }
        return false;
    }
};

TEST_F(EvidenceOfCase, APlacedCloudLiesWhereItBelongsInEveryNumber) {
    const nlohmann::json before = compared({"--cell", "0.5"});
    EXPECT_LT(before["distance"]["median"], -0.15) << "the run lies below the cloud";
    EXPECT_LT(before["volumes"]["net_m3"], -5.0);
    EXPECT_TRUE(before["volumes"]["net_errors_m3"][1].is_null()) << "nobody stated how well it lies";

    const nlohmann::json made = evidence({"--survey", m_cloud, "--pairs", pairs(), "--taken", "2021-06-25T16:30"});
    ASSERT_EQ(made["evidence"].size(), 1u);
    const nlohmann::json& row = made["evidence"][0];
    EXPECT_EQ(row["taken"], "2021-06-25 16:30:00");
    EXPECT_EQ(row["placed"]["pairs"], 4);
    EXPECT_LT(row["placed"]["pairs_rms_m"], 0.005);
    EXPECT_NEAR(std::abs(row["placed"]["turn_deg"][2].get<double>()), 3.0, 0.1);
    EXPECT_GT(row["place_within_95_m"], 0.0);
    EXPECT_TRUE(row["placed"]["control_error_m"].is_null());
    EXPECT_THAT(cli({"evidence", m_case}).out, testing::HasSubstr("how accurate the control points are nobody stated"));
    // Points that are known to 0.1 m place no cloud better.
    const nlohmann::json known =
        evidence({"--survey", m_cloud, "--pairs", pairs(), "--pairs-error", "0.1"})["evidence"][0]["placed"];
    EXPECT_EQ(known["control_error_m"], 0.1);
    EXPECT_NEAR(known["error_m"].get<double>(), std::hypot(row["placed"]["error_m"].get<double>(), 0.1), 1e-9);
    EXPECT_EQ(cli({"evidence", m_case, "--survey", m_cloud, "--pairs-error", "0.1"}).exitCode, 2) << "of which pairs";
    evidence({"--survey", m_cloud, "--pairs", pairs()});

    const nlohmann::json placed = compared({"--case", m_case, "--cell", "0.5"});
    EXPECT_NEAR(placed["distance"]["median"], 0.0, 0.01);
    EXPECT_EQ(placed["registration_error"], row["placed"]["error_m"]);
    EXPECT_TRUE(warns(placed, "survey.placed"));
    EXPECT_LT(std::abs(placed["volumes"]["net_m3"].get<double>()), 1.0);
    EXPECT_FALSE(placed["volumes"]["net_errors_m3"][1].is_null());

    // The survey of the case is the same cloud, laid on a grid.
    const std::vector<std::string> survey{"survey", m_out, "--case", m_case, "--cell", "0.25", "--json"};
    const Outcome held = cli(survey);
    ASSERT_EQ(held.exitCode, 0) << held.err;
    EXPECT_EQ(held.json()["placed"]["pairs"], 4);
    EXPECT_EQ(held.json()["survey"]["taken"], "2021-06-25 16:30:00");
    EXPECT_FALSE(held.json()["volumes"]["net_systematic_m3"].is_null());
    EXPECT_LT(std::abs(held.json()["noise"]["offset_m"].get<double>()), 0.05);

    evidence({"--survey", m_cloud, "--unregister"});
    EXPECT_LT(compared({"--case", m_case})["distance"]["median"], -0.15);
}

TEST_F(EvidenceOfCase, PairsThenAFitToWhatDidNotMove) {
    // Picked to five centimetres; then the blocks and the ground about them are held against those of the run.
    evidence({"--survey", m_cloud, "--pairs", pairs(0.05)});
    const std::string near = m_folder / "near.geojson";
    std::ofstream(near)
        << R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::25832"}},)"
        << R"("features":[{"type":"Feature","properties":{},"geometry":)"
        << R"({"type":"Polygon","coordinates":[[[-1,-1],[8,-1],[8,3],[-1,3],[-1,-1]]]}}]})";
    const nlohmann::json fitted =
        evidence({"--survey", m_cloud, "--fit", near, "--radius", "0.3", "--run", m_out, "--scanner", "-6,-6,3"});
    const nlohmann::json& placed = fitted["evidence"][0]["placed"];
    EXPECT_EQ(placed["pairs"], 4) << "the fit goes on from the pairs";
    const std::vector<Vec3> scanners{Vec3(-6.0, -6.0, 3.0)};
    EXPECT_EQ(io::loadCase(m_case).inputs.back().scanners, scanners) << "who measures later sees it from there too";
    EXPECT_GT(placed["fitted_points"], 100);
    EXPECT_LE(placed["fit_rms_m"], placed["fit_rms_before_m"]);
    EXPECT_GT(placed["error_m"], 0.001) << "walls of a metre do not tell the turn to nothing";
    EXPECT_GT(fitted["evidence"][0]["iou"], 0.2) << "one scanner sees a side of the pile alone";
    EXPECT_NEAR(compared({"--case", m_case})["distance"]["median"], 0.0, 0.01);
    // Level ground alone leaves the place open.
    const Outcome open = cli({"evidence", m_case, "--survey", m_cloud, "--fit", "all", "--radius", "0.5"});
    EXPECT_EQ(open.exitCode, 2);
    EXPECT_THAT(open.err, HasSubstr("What did not move is level"));
    evidence({"--survey", m_cloud, "--registration-error", "0.04"});
    EXPECT_NEAR(compared({"--case", m_case})["registration_error"], 0.04, 1e-12);
}

TEST_F(EvidenceOfCase, EpochsDecideWhatIsCompared) {
    const std::string heap = m_folder / "heap.geojson";
    std::ofstream(heap) << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":)"
                        << R"({"type":"Polygon","coordinates":[[[-500,-500],[2,-500],[2,500],[-500,500],[-500,-500]]]}}]})";
    const nlohmann::json removed = evidence({"--removed", heap, "--since", "2021-06-26 08:00"});
    ASSERT_EQ(removed["removals"].size(), 1u);
    EXPECT_EQ(removed["removals"][0]["since"], "2021-06-26 08:00:00");
    evidence({"--survey", m_cloud, "--pairs", pairs()});
    const auto held = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"survey", m_out, "--case", m_case, "--json"});
        const Outcome outcome = cli(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.json();
    };
    const nlohmann::json unknown = held({});
    EXPECT_TRUE(warns(unknown, "survey.removal_unknown"));
    EXPECT_EQ(unknown["compared"]["left_out_simulated_m2"], 0.0);
    evidence({"--survey", m_cloud, "--taken", "2021-06-25 10:00"});
    EXPECT_EQ(held({})["compared"]["left_out_simulated_m2"], 0.0) << "the day before";
    evidence({"--survey", m_cloud, "--taken", "2021-06-26 10:00"});
    const nlohmann::json after = held({});
    EXPECT_TRUE(warns(after, "survey.removed"));
    EXPECT_GT(after["compared"]["left_out_simulated_m2"], 0.1);
    EXPECT_GT(compared({"--case", m_case})["points_beyond"], 0) << "points where debris was taken away count no more";
    const auto cut = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"section", m_out, "--line", "-6,0.5,9,0.5", "--points", m_cloud, "--json"});
        const Outcome outcome = cli(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.exitCode == 0 ? outcome.json() : nlohmann::json();
    };
    const nlohmann::json section = cut({"--case", m_case});
    EXPECT_TRUE(warns(section, "distance.beyond")) << "nor do they in a section";
    EXPECT_GT(section["time_s"], 0.6);
    // The instant that it shows is that of the simulated debris.
    evidence({"--survey", m_cloud, "--instant", "0.25"});
    EXPECT_NEAR(held({})["time_s"], 0.25, 1e-9);
    EXPECT_NEAR(compared({"--case", m_case})["time_s"], 0.25, 1e-9);
    EXPECT_NEAR(cut({"--case", m_case})["time_s"], 0.25, 1e-9);
    EXPECT_GT(cut({"--case", m_case, "--time", "end"})["time_s"], 0.6) << "unless another is asked for";
    EXPECT_GT(held({"--time", "end"})["time_s"], 0.6) << "unless another is asked for";
    evidence({"--survey", m_cloud, "--before", "on"});
    const Outcome before = cli({"survey", m_out, "--case", m_case, "--survey", m_cloud});
    EXPECT_EQ(before.exitCode, 2);
    EXPECT_THAT(before.err, HasSubstr("before the collapse"));
}

TEST_F(EvidenceOfCase, ASectionHoldsMeasuredPointsAgainstThePile) {
    const auto cut = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"section", m_out, "--line", "-6,0.5,9,0.5", "--json"});
        const Outcome outcome = cli(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.exitCode == 0 ? outcome.json() : nlohmann::json();
    };
    const std::string picture = m_folder / "section.png";
    const nlohmann::json made =
        cut({"--points", m_folder / "scan.csv", "--width", "1", "--out", picture, "--csv", m_folder / "section.csv"});
    EXPECT_NEAR(made["length_m"], 15.0, 1e-9);
    EXPECT_GT(made["points_compared"], 100);
    // Sides of blocks that a scanner sees lie below their tops.
    EXPECT_GT(made["difference_mean_m"], -0.05);
    EXPECT_LT(made["difference_mean_m"], 1.0);
    ASSERT_TRUE(std::filesystem::exists(picture) && std::filesystem::exists(picture + ".provenance.json"));
    // A scan of the run is no evidence, and who sees the section reads that.
    EXPECT_TRUE(warns(made, "evidence.of_this_run"));
    EXPECT_THAT(textOf(picture + ".provenance.json"), HasSubstr("made from the very run"));
    EXPECT_THAT(textOf(m_folder / "section.csv"), HasSubstr("along_m,ground_m,simulated_m,of,points,measured_m,difference_m"));
    // Points of a total station on the level ground, 10 cm above it.
    const std::string station = m_folder / "station.csv";
    std::ofstream(station) << "Point,Easting,Northing,Elevation\n1,-5.5,0.5,0.1\n2,-5,0.5,0.1\n3,8.5,0.5,0.1\n4,8.5,7,0.1\n";
    const nlohmann::json level = cut({"--points", station});
    EXPECT_EQ(level["points"], 3) << "one lies beside the section";
    EXPECT_FALSE(warns(level, "evidence.of_this_run"));
    EXPECT_NEAR(level["difference_mean_m"], -0.1, 1e-6);
    // Both in one section: each agrees by itself, and both are in the mean of all.
    const nlohmann::json both = cut({"--points", station, "--points", m_folder / "scan.csv", "--width", "1"});
    ASSERT_EQ(both["sources"].size(), 2u);
    EXPECT_EQ(both["sources"][0]["name"], "station.csv");
    EXPECT_NEAR(both["sources"][0]["difference_mean_m"], -0.1, 1e-6);
    EXPECT_EQ(both["sources"][1]["points"], made["points"]);
    EXPECT_NEAR(both["sources"][1]["difference_mean_m"], made["difference_mean_m"], 1e-12);
    EXPECT_EQ(both["points"].get<int>(), 3 + made["points"].get<int>());
    EXPECT_TRUE(cut({})["difference_mean_m"].is_null());
    EXPECT_TRUE(cut({})["measured_area_m2"].is_null()) << "no point tells of it";
    // Without a line it goes along the points; what lies beside it is counted.
    std::ofstream(m_folder / "along.csv")
        << "Point,Easting,Northing,Elevation\n1,-5,0.5,0.1\n2,0,0.5,0.1\n3,3,0.5,0.1\n4,8,0.5,0.1\n";
    const Outcome along = cli({"section", m_out, "--points", m_folder / "along.csv", "--json"});
    ASSERT_EQ(along.exitCode, 0) << along.err;
    EXPECT_EQ(along.json()["along_points"], true);
    EXPECT_EQ(along.json()["points"], 4);
    EXPECT_NEAR(along.json()["line_m"][0], -5.5, 1e-9);
    EXPECT_NEAR(along.json()["line_m"][2], 8.5, 1e-9);
    EXPECT_FALSE(warns(along.json(), "section.beside"));
    EXPECT_TRUE(warns(cli({"section", m_out, "--points", station, "--json"}).json(), "section.beside"));
    EXPECT_EQ(cut({})["along_points"], false);
    EXPECT_EQ(cli({"section", m_out}).exitCode, 2) << "neither a line nor points";
    EXPECT_EQ(cli({"section", m_out, "--line", "1,2,3"}).exitCode, 2);
    EXPECT_EQ(cli({"section", m_out, "--line", "1,2,1,2"}).exitCode, 2);
}

TEST_F(EvidenceOfCase, WhatItIsComparedWithBelongsToTheCase) {
    evidence({"--survey", m_cloud});
    Case theCase = io::loadCase(m_case);
    theCase.evidence.cell = 1.25;
    theCase.evidence.leastHeight = 0.4;
    theCase.evidence.surveysWithFallen = false;
    io::saveCase(m_case, theCase);
    const auto held = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"survey", m_out, "--survey", m_cloud, "--case", m_case, "--json"});
        return cli(more).json();
    };
    const nlohmann::json made = held({});
    EXPECT_EQ(made["cell_m"], 1.25);
    EXPECT_EQ(made["live_structure"], false);
    EXPECT_EQ(held({"--cell", "0.5", "--live", "on"})["cell_m"], 0.5) << "unless another is asked for";
    // The list of evidence scores it alike.
    const nlohmann::json all = evidence({"--run", m_out});
    bool found = false;
    for (const nlohmann::json& row : all["evidence"]) {
        found = found || (row["iou"].is_number() && std::abs(row["iou"].get<double>() - made["iou"].get<double>()) < 1e-12);
    }
    EXPECT_TRUE(found) << all["evidence"].dump(1);
}

TEST_F(EvidenceOfCase, MeasuredPointsSayWhatTheyAreHeldToSay) {
    const std::string station = m_folder / "station.csv";
    std::ofstream(station) << "Point,Easting,Northing,Elevation\n1,-3,-3,0.1\n2,8,-3,0.1\n3,8,6,0.1\n4,-3,6,0.1\n";
    const auto row = [&](std::vector<std::string> more) {
        const nlohmann::json all = evidence(std::move(more));
        for (const nlohmann::json& each : all["evidence"]) {
            if (each["kind"] == "measured") {
                return each;
            }
        }
        return nlohmann::json();
    };
    // Unless something else is said they are for sections, and so it stands there.
    nlohmann::json said = row({"--survey", station});
    EXPECT_EQ(said["held_as"], "section");
    const Outcome noSurface = cli({"survey", m_out, "--survey", station, "--case", m_case});
    EXPECT_EQ(noSurface.exitCode, 2);
    EXPECT_THAT(noSurface.err, HasSubstr("held for sections"));
    EXPECT_FALSE(said["kind_by_ending"]);
    EXPECT_THAT(said["shows"].get<std::string>(), HasSubstr("sections"));
    EXPECT_TRUE(row({"--run", m_out})["iou"].is_null());
    // The edge of the debris is held against the run, as every outline is, and the case keeps it.
    EXPECT_EQ(row({"--survey", station, "--held-as", "outline"})["held_as"], "outline");
    said = row({"--run", m_out});
    EXPECT_EQ(said["held_as"], "outline");
    EXPECT_GT(said["iou"], 0.0);
    const nlohmann::json held = cli({"survey", m_out, "--survey", station, "--case", m_case, "--json"}).json();
    EXPECT_NEAR(held["iou"].get<double>(), said["iou"].get<double>(), 1e-12) << "one number in list and comparison";
    EXPECT_NEAR(held["surveyed"]["area_m2"].get<double>(), 99.0, 1.0);
    // As control they show no debris, which every command says.
    EXPECT_EQ(row({"--survey", station, "--held-as", "control", "--run", m_out})["held_as"], "control");
    EXPECT_TRUE(row({"--run", m_out})["iou"].is_null());
    const Outcome refused = cli({"survey", m_out, "--survey", station, "--case", m_case});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.err, HasSubstr("held as control"));
    EXPECT_EQ(cli({"section", m_out, "--line", "-6,0.5,9,0.5", "--points", station, "--case", m_case}).exitCode, 2);
    // Only measured points are held to say something.
    EXPECT_EQ(cli({"evidence", m_case, "--survey", m_cloud, "--held-as", "outline"}).exitCode, 2);
    EXPECT_EQ(cli({"evidence", m_case, "--survey", station, "--held-as", "truth"}).exitCode, 2);
    EXPECT_EQ(cli({"evidence", m_case, "--held-as", "outline"}).exitCode, 2);
}

TEST_F(EvidenceOfCase, SystemAndColumnsOfACloudBelongToTheCase) {
    const std::string metric = m_folder / "scan.csv";
    const std::string feet = m_folder / "feet.xyz";
    const std::string station = m_folder / "station.txt";
    std::ifstream in(metric);
    std::ofstream inFeet(feet);
    std::ofstream numbered(station);
    inFeet.precision(12);
    numbered.precision(12);
    inFeet << "x,y,z\n";
    std::string line;
    std::getline(in, line);
    for (int number = 1; std::getline(in, line); ++number) {
        const Eigen::Vector3d at = placeIn(line);
        inFeet << at.x() / 0.3048 << ',' << at.y() / 0.3048 << ',' << at.z() / 0.3048 << '\n';
        numbered << number << ',' << at.y() << ',' << at.x() << ',' << at.z() << ",TOPO\n";
    }
    inFeet.close();
    numbered.close();
    const auto volume = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"survey", m_out, "--json"});
        const Outcome outcome = cli(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.exitCode == 0 ? outcome.json()["surveyed"]["volume_m3"].get<double>() : 0.0;
    };
    const std::string system = R"(LOCAL_CS["site",UNIT["foot",0.3048],AXIS["x",EAST],AXIS["y",NORTH]])";
    const std::string columns = "skip,y,x,z,skip";
    const double right = volume({"--survey", metric});
    ASSERT_GT(right, 0.1);
    EXPECT_NEAR(volume({"--survey", feet, "--crs", system}), right, 0.01 * right);
    EXPECT_NEAR(volume({"--survey", station, "--columns", columns}), right, 0.01 * right);
    // What is stated once is kept, and seen as a cloud whatever the file is called.
    const nlohmann::json told = evidence({"--survey", feet, "--crs", system});
    EXPECT_EQ(told["evidence"][0]["kind"], "cloud");
    EXPECT_EQ(io::loadCase(m_case).inputs.back().read.crs, system);
    evidence({"--survey", station, "--columns", columns});
    EXPECT_NEAR(volume({"--case", m_case, "--survey", feet}), right, 0.01 * right);
    EXPECT_NEAR(volume({"--case", m_case, "--survey", station}), right, 0.01 * right);
    const auto points = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"section", m_out, "--line", "-6,0.5,9,0.5", "--json"});
        const Outcome outcome = cli(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.exitCode == 0 ? outcome.json()["points"].get<int>() : 0;
    };
    EXPECT_EQ(points({"--points", station, "--columns", columns}), points({"--points", metric}));
    EXPECT_EQ(points({"--points", station, "--points", feet, "--case", m_case}), 2 * points({"--points", metric}));
    // A raster names its system itself.
    const std::string heights =
        io::AsciiGrid{20, 20, -10.0, -10.0}.write(m_folder / "flat.asc", [](double, double) { return 0.5; });
    EXPECT_EQ(cli({"survey", m_out, "--survey", heights, "--crs", system}).exitCode, 2);
    EXPECT_NE(cli({"evidence", m_case, "--survey", heights, "--crs", system}).exitCode, 0);
    EXPECT_EQ(cli({"evidence", m_case, "--survey", feet, "--crs", "EPSG:1"}).exitCode, 2);
}

TEST_F(EvidenceOfCase, RefusesWhatCannotBeMeant) {
    EXPECT_EQ(cli({"evidence", m_out}).exitCode, 2) << "a run is no case";
    EXPECT_EQ(cli({"evidence", m_case, "--pairs", pairs()}).exitCode, 2) << "of which survey";
    EXPECT_EQ(cli({"evidence", m_case, "--survey", m_cloud, "--fit", "all"}).exitCode, 2) << "within which radius";
    EXPECT_EQ(cli({"evidence", m_case, "--survey", m_cloud, "--taken", "yesterday"}).exitCode, 2);
    EXPECT_EQ(cli({"evidence", m_case, "--survey", m_cloud, "--unregister", "--pairs", pairs()}).exitCode, 2);
    EXPECT_EQ(cli({"evidence", m_case, "--removed", m_cloud}).exitCode, 2) << "since when";
    EXPECT_TRUE(io::loadCase(m_case).inputs.size() == 1u) << "the case stays as it was";
    EXPECT_EQ(cli({"cloud", m_cloud, "--against", m_cloud, "--case", m_case}).exitCode, 2) << "two clouds have no case";
}

TEST_F(EvidenceOfCase, PicturesWithoutAPinholeAndAPoseAreNotTakenAsPhotographs) {
    const std::string cloud = sourcePath("tests/data/clouds/tiny_pc_and_images.e57");
    const Outcome none = cli({"evidence", m_case, "--photographs-of", cloud});
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_THAT(none.err, HasSubstr("holds no picture with a pinhole and a pose"));
    EXPECT_TRUE(io::loadCase(m_case).photographs.empty());
}

}  // namespace

}  // namespace rubble::cli
