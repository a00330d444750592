#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/case/case_file.h"
#include "tests/support/command_run.h"
#include "tests/support/places.h"
#include "tests/support/run_tests.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::vector<std::string> scales{"--normal-scale", "0.4", "--projection-scale", "0.4", "--depth", "1"};

class ScanOfRun : public SmallRun {
protected:
    nlohmann::json compared(const std::string& cloud, std::vector<std::string> more) {
        more.insert(more.begin(), {"cloud", cloud, "--against", m_out, "--registration-error", "0", "--json"});
        more.insert(more.end(), scales.begin(), scales.end());
        const Outcome outcome = cli(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.json();
    }
};

double significantShare(const nlohmann::json& made) {
    return made["significant"].get<double>() / made["with_level_of_detection"].get<double>();
}

bool warns(const nlohmann::json& made, const std::string& id) {
    for (const nlohmann::json& warning : made["warnings"]) {
        if (warning["id"] == id) {
            return true;
        }
    }
    return false;
}

TEST_F(ScanOfRun, LiesWithinTheLevelOfDetectionOfItsRun) {
    run({}, "2");
    const std::string las = m_folder / "scan.las";
    const std::string csv = m_folder / "scan.csv";
    const Outcome outcome = cli({"scan", m_out, "--step", "0.25", "--range", "20", "--noise", "0.01", "--out", las, "--out", csv,
                                 "--out", m_folder / "scan.ply", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json scan = outcome.json();
    EXPECT_EQ(scan["scanners"].size(), 4u);
    EXPECT_GT(scan["points_on"]["debris"], 200);
    EXPECT_GT(scan["points_on"]["structure"], 50);
    EXPECT_EQ(scan["debris"]["fragments_seen"].get<int>() + scan["debris"]["fragments_not_seen"].get<int>(), smallDead);
    EXPECT_TRUE(fs::exists(las + ".provenance.json"));
    const nlohmann::json told = cli({"cloud", las, "--json"}).json();
    EXPECT_EQ(told["scans"].size(), 4u) << "it says where its scanners stood";
    EXPECT_EQ(told["scans"][2]["points"], scan["scanners"][2]["points"]);
    EXPECT_EQ(told["points"], scan["points"]);
    EXPECT_EQ(cli({"cloud", m_folder / "scan.ply", "--json"}).json()["points"], scan["points"]);

    const nlohmann::json itself =
        compared(las, {"--out", m_folder / "d.las", "--out", m_folder / "d.ply", "--csv", m_folder / "d.csv"});
    EXPECT_EQ(itself["seen_from"], "cloud");
    EXPECT_GT(itself["with_level_of_detection"], 300);
    // Some 400 distances: the share strays from 0.05 by 0.011.
    EXPECT_LT(significantShare(itself), 0.09);
    EXPECT_EQ(itself["second"]["points"], scan["points"]) << "each ray meets what it met";
    for (const char* name : {"d.las", "d.ply", "d.csv"}) {
        EXPECT_TRUE(fs::exists(m_folder / name)) << name;
        const nlohmann::json from = nlohmann::json::parse(io::wholeFile(m_folder / name + ".provenance.json"));
        EXPECT_EQ(from["cloud_distances"]["cloud"], "scan.las") << name;
        EXPECT_THAT(from["cautions"].front()["text"].get<std::string>(), HasSubstr("made from the very run")) << name;
    }
    EXPECT_EQ(itself["time_s"], scan["time_s"]);
    EXPECT_EQ(itself["cautions"], scan["cautions"]);
    EXPECT_FALSE(itself["tainted"]);
    EXPECT_EQ(itself["exports"].size(), 2u);
    std::vector<std::string> words{"cloud", las, "--against", m_out};
    words.insert(words.end(), scales.begin(), scales.end());
    EXPECT_THAT(cli(words).out, HasSubstr("caution: one set of assumptions"));
    EXPECT_GE(itself["debris"]["fragments_seen"], 1);
    // The same at another instant, when the blocks had not fallen yet.
    const nlohmann::json before = compared(las, {"--time", "0.05"});
    EXPECT_NEAR(before["time_s"], 0.05, 0.02);
    EXPECT_EQ(before["debris"]["fragments_seen"], 0);
    EXPECT_EQ(before["debris"]["fragments_not_seen"], 0);
    // A table does not say where its scanners stood.
    const nlohmann::json above = compared(csv, {});
    EXPECT_EQ(above["seen_from"], "above");
    EXPECT_TRUE(warns(above, "distance.from_above"));
    const nlohmann::json asked = compared(csv, {"--scanner", "0,0,3", "--scanner", "9,9,3"});
    EXPECT_EQ(asked["seen_from"], "asked");
    EXPECT_TRUE(warns(asked, "distance.nearest_scanner"));
}

/// A stone bridge that falls, scanned as `scan` does unless told otherwise.
class ScanOfBridge : public testing::Test {
protected:
    void SetUp() override {
        const Outcome outcome = cli(
            {"run", buildPath("tests/fe/causes/pier.exo"), "--out", m_run, "--set", "bodies_max=300", "--set", "settle_time=1"});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    }
    nlohmann::json compared(const std::string& cloud) {
        const Outcome outcome = cli({"cloud", cloud, "--against", m_run, "--normal-scale", "0.5", "--projection-scale", "0.25",
                                     "--depth", "2", "--registration-error", "0", "--json"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.json();
    }

    io::TemporaryFolder m_folder;
    std::string m_run = m_folder / "bridge.run.h5";
};

TEST_F(ScanOfBridge, LiesWithinTheLevelOfDetectionForNinetyFiveOfAHundred) {
    double within = 0.0;
    double all = 0.0;
    const int seeds = sizedTo(1, 20);
    for (int seed = 1; seed <= seeds; ++seed) {
        const std::string las = m_folder / "scan.las";
        ASSERT_EQ(cli({"scan", m_run, "--seed", std::to_string(seed), "--out", las}).exitCode, 0);
        const nlohmann::json made = compared(las);
        const double levels = made["with_level_of_detection"];
        EXPECT_GT(levels, 10'000) << seed;
        EXPECT_GT(1.0 - significantShare(made), 0.91) << seed;
        all += levels;
        within += levels - made["significant"].get<double>();
    }
    EXPECT_GE(within / all, 0.93);
    EXPECT_LE(within / all, 0.97);
}

TEST_F(ScanOfRun, MovedByTwentyCentimetresItIsNot) {
    run({}, "2");
    const std::string csv = m_folder / "scan.csv";
    const std::vector<std::string> scanner{"--scanner", "-6,-6,3"};
    std::vector<std::string> words{"scan", m_out, "--step", "0.2", "--range", "20", "--noise", "0.01", "--out", csv};
    words.insert(words.end(), scanner.begin(), scanner.end());
    ASSERT_EQ(cli(words).exitCode, 0);
    std::ifstream in(csv);
    std::ofstream out(m_folder / "moved.csv");
    std::string line;
    std::getline(in, line);
    out << line << '\n';
    while (std::getline(in, line)) {
        const auto first = line.find(',');
        const auto second = line.find(',', first + 1);
        const auto third = line.find(',', second + 1);
        out << line.substr(0, second + 1) << std::stod(line.substr(second + 1, third)) + 0.2 << line.substr(third) << '\n';
    }
    out.close();
    EXPECT_LT(significantShare(compared(csv, scanner)), 0.1);
    const nlohmann::json moved = compared(m_folder / "moved.csv", scanner);
    EXPECT_GT(significantShare(moved), 0.8);
    EXPECT_NEAR(moved["distance"]["median"], -0.2, 0.02) << "the run lies below the cloud";
    // Level ground alone does not say where the cloud belongs in plan.
    const std::string ground = m_folder / "ground.geojson";
    std::ofstream(ground) << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":)"
                          << R"({"type":"Polygon","coordinates":[[[-500,-500],[-4,-500],[-4,500],[-500,500],[-500,-500]]]}}]})";
    std::vector<std::string> fitting{"cloud", m_folder / "moved.csv", "--against", m_out, "--fit", ground};
    fitting.insert(fitting.end(), scales.begin(), scales.end());
    const Outcome open = cli(fitting);
    EXPECT_EQ(open.exitCode, 2);
    EXPECT_THAT(open.err, HasSubstr("What did not move is level"));
}

TEST_F(ScanOfRun, WhatIsHiddenIsNotSeenAndNotMissing) {
    run({}, "2");
    const std::string las = m_folder / "scan.las";
    // From one side alone, from low down.
    const nlohmann::json scan =
        cli({"scan", m_out, "--step", "0.1", "--range", "20", "--scanner", "-12,0.5,0.5", "--out", las, "--json"}).json();
    const nlohmann::json made = compared(las, {});
    EXPECT_EQ(made["debris"]["fragments_seen"], scan["debris"]["fragments_seen"]);
    EXPECT_LT(significantShare(made), 0.09) << "shadows are no differences";
}

/// A PTX of the points of a scan. @param told  scanner in its head, @param shift  of its matrix: the points are moved against it
std::string writePtx(const std::string& path, const std::vector<Eigen::Vector3d>& places, const std::string& told,
                     const Eigen::Vector3d& shift) {
    std::ofstream out(path);
    out << places.size() << "\n1\n"
        << told << "\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
        << shift.x() << ' ' << shift.y() << ' ' << shift.z() << " 1\n";
    for (const Eigen::Vector3d& place : places) {
        out << (place - shift).transpose() << " 0.5\n";
    }
    return path;
}

TEST_F(ScanOfRun, APoseThatIsNoneIsNotTakenAsTheScanner) {
    run({}, "2");
    const std::string csv = m_folder / "scan.csv";
    ASSERT_EQ(cli({"scan", m_out, "--step", "0.2", "--range", "20", "--out", csv, "--scanner", "-6,-5,3"}).exitCode, 0);
    std::vector<Eigen::Vector3d> places;
    std::ifstream in(csv);
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) {
        std::istringstream fields(line);
        char comma = 0;
        Eigen::Vector3d& at = places.emplace_back();
        fields >> at.x() >> comma >> at.y() >> comma >> at.z();
    }
    const Eigen::Vector3d stand(-6.0, -5.0, 3.0);
    const Eigen::Vector3d none(0.0, 0.0, 0.0);
    const nlohmann::json truly = compared(writePtx(m_folder / "true.ptx", places, "-6 -5 3", stand), {});
    const nlohmann::json head = compared(writePtx(m_folder / "head.ptx", places, "-6 -5 3", none), {});
    const std::string registered = writePtx(m_folder / "none.ptx", places, "0 0 0", none);
    const nlohmann::json above = compared(registered, {});
    EXPECT_EQ(truly["seen_from"], "cloud");
    EXPECT_EQ(head["seen_from"], "cloud");
    EXPECT_EQ(head["debris"], truly["debris"]);
    EXPECT_NEAR(head["with_level_of_detection"].get<double>(), truly["with_level_of_detection"].get<double>(), 5.0);
    EXPECT_FALSE(warns(truly, "cloud.pose_unknown") || warns(head, "cloud.pose_unknown"));
    EXPECT_EQ(above["seen_from"], "above") << "nobody stood at 0, 0, 0";
    EXPECT_TRUE(warns(above, "cloud.pose_unknown"));
    EXPECT_GT(above["debris"]["fragments_seen"], 0);
    EXPECT_TRUE(cli({"cloud", registered, "--json"}).json()["scans"][0]["pose"].is_null());
    EXPECT_THAT(cli({"cloud", registered}).out, HasSubstr("no pose"));
}

TEST_F(ScanOfRun, IsNoEvidenceUnderAnyName) {
    run({}, "2");
    const std::string las = m_folder / "scan.las";
    const std::string copy = m_folder / "site.las";
    ASSERT_EQ(cli({"scan", m_out, "--step", "0.25", "--range", "20", "--out", las}).exitCode, 0);
    fs::copy_file(las, copy);
    const std::string theCase = m_folder / "case.rubble";
    io::saveCase(theCase, io::caseForFe(m_path, theCase));
    const auto about = [](const std::string& path) {
        std::ifstream in(path + ".provenance.json");
        return nlohmann::json::parse(in);
    };
    const std::string fingerprint = about(las)["fingerprint"];
    const auto first = [](const nlohmann::json& told) { return told["warnings"][0]["id"]; };

    // At once, in the list, without a run.
    const nlohmann::json one = cli({"evidence", theCase, "--survey", copy, "--json"}).json();
    EXPECT_EQ(first(one), "evidence.of_run") << one["warnings"];
    EXPECT_EQ(one["evidence"][0]["of_run"], fingerprint);
    EXPECT_EQ(one["evidence"][0]["shows"], "a simulated run: no evidence");
    const nlohmann::json two = cli({"evidence", theCase, "--survey", las, "--json"}).json();
    EXPECT_TRUE(warns(two, "evidence.same")) << "of one content";
    EXPECT_EQ(two["evidence"][1]["made_by_program"], true);
    const Outcome listed = cli({"evidence", theCase});
    EXPECT_THAT(listed.out, testing::AllOf(HasSubstr("a simulated run: no evidence"), HasSubstr("one piece of evidence")));
    EXPECT_TRUE(warns(cli({"evidence", theCase, "--run", m_out, "--json"}).json(), "evidence.of_this_run"));

    // In front of all else, and in what is written.
    const std::string tif = m_folder / "difference.tif";
    const std::string png = m_folder / "difference.png";
    const Outcome compared = cli({"survey", m_out, "--case", theCase, "--survey", copy, "--out", tif, "--out", png, "--json"});
    ASSERT_EQ(compared.exitCode, 0) << compared.err;
    EXPECT_EQ(first(compared.json()), "evidence.of_this_run") << compared.json()["warnings"];
    for (const std::string& path : {tif, png}) {
        const nlohmann::json told = about(path);
        EXPECT_EQ(told["survey_comparison"]["survey"], "site.las");
        EXPECT_EQ(told["survey_comparison"]["of_run"], fingerprint);
        EXPECT_THAT(told["survey_comparison"]["subject"].get<std::string>(), HasSubstr("case.rubble"));
        EXPECT_EQ(told["cautions"][0]["key"], "no_evidence") << told["cautions"];
    }
}

TEST_F(ScanOfRun, SaysHowManyStillMove) {
    const nlohmann::json whole = run({}, "2");
    const auto moving = [&](const std::string& time) {
        const Outcome made =
            cli({"scan", m_out, "--step", "1", "--range", "20", "--time", time, "--out", m_folder / "s.las", "--json"});
        EXPECT_EQ(made.exitCode, 0) << made.err;
        std::ifstream in(m_folder / "s.las.provenance.json");
        EXPECT_EQ(nlohmann::json::parse(in)["scan"]["moving"], made.json()["moving"]);
        return made.json();
    };
    const nlohmann::json falling = moving("0.75");
    EXPECT_GT(falling["moving"], 0);
    EXPECT_LE(falling["moving"], falling["bodies"]);
    EXPECT_EQ(moving("end")["moving"], whole["still_moving"]);
    EXPECT_THAT(cli({"scan", m_out, "--step", "1", "--range", "20", "--time", "0.75", "--out", m_folder / "s.las"}).out,
                HasSubstr("still move then"));
}

TEST_F(ScanOfRun, OfAnInstantSaysSoAndIsHeldAgainstThatInstant) {
    run({}, "2");
    const std::vector<std::string> how{"--step", "0.3", "--range", "20", "--noise", "0", "--scanner", "-6,-6,3"};
    const auto scan = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"scan", m_out, "--json"});
        more.insert(more.end(), how.begin(), how.end());
        const Outcome outcome = cli(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.json();
    };
    const std::string las = m_folder / "falling.las";
    const std::string ply = m_folder / "falling.ply";
    const std::string csv = m_folder / "falling.csv";
    const std::string rest = m_folder / "rest.las";
    const double falling = 0.75;
    const nlohmann::json made = scan({"--time", "0.75", "--out", las, "--out", ply, "--out", csv});
    EXPECT_EQ(made["time_s"], falling);
    EXPECT_FALSE(made["at_rest"]);
    EXPECT_TRUE(warns(made, "scan.instant_unsaid")) << "a table cannot keep it";
    EXPECT_TRUE(scan({"--out", rest})["at_rest"]);
    for (const std::string& path : {las, ply, csv}) {
        std::ifstream in(path + ".provenance.json");
        EXPECT_EQ(nlohmann::json::parse(in)["scan"]["time_s"], falling) << path;
    }
    EXPECT_EQ(cli({"cloud", las, "--json"}).json()["instant_s"], falling);
    EXPECT_EQ(cli({"cloud", ply, "--json"}).json()["instant_s"], falling);
    EXPECT_TRUE(cli({"cloud", rest, "--json"}).json()["instant_s"].is_null());
    // Unasked it is held against its own instant, and that is said.
    const nlohmann::json then = compared(las, {});
    EXPECT_EQ(then["time_s"], falling);
    EXPECT_TRUE(warns(then, "survey.scanned_instant"));
    EXPECT_GT(compared(rest, {})["time_s"], falling);
    EXPECT_GT(compared(las, {"--time", "end"})["time_s"], falling) << "who asks is answered";
    const nlohmann::json survey = cli({"survey", m_out, "--survey", ply, "--json"}).json();
    EXPECT_EQ(survey["time_s"], falling);
}

TEST_F(ScanOfRun, RefusesWhatCannotBeMeant) {
    run({}, "0.5");
    EXPECT_EQ(cli({"scan", m_out, "--scanner", "1,2"}).exitCode, 2);
    EXPECT_EQ(cli({"scan", m_out, "--out", m_folder / "scan.xyz"}).exitCode, 2);
    EXPECT_EQ(cli({"scan", m_out, "--step", "0.0001"}).exitCode, 2);
    const Outcome nothing = cli({"scan", m_out, "--scanner", "0,0,500", "--range", "5"});
    EXPECT_EQ(nothing.exitCode, 2);
    EXPECT_THAT(nothing.err, HasSubstr("see nothing within 5 m"));
    EXPECT_THAT(cli({"scan", m_out, "--scanner", "0,0,-3", "--step", "2"}).out, HasSubstr("scanners stand below the ground"));
    const std::string csv = m_folder / "far.csv";
    std::ofstream(csv) << "x,y,z\n500000,5000000,1\n500001,5000000,1\n500000,5000001,1\n500001,5000001,1\n";
    std::vector<std::string> words{"cloud", csv, "--against", m_out};
    words.insert(words.end(), scales.begin(), scales.end());
    const Outcome far = cli(words);
    EXPECT_EQ(far.exitCode, 1);
    EXPECT_THAT(far.err, HasSubstr("lies elsewhere"));
    words.insert(words.end(), {"--cores", csv});
    EXPECT_EQ(cli(words).exitCode, 2);
    EXPECT_EQ(cli({"cloud", csv, "--scanner", "0,0,1"}).exitCode, 2) << "without anything to hold it against";
    words[3] = csv;
    words.insert(words.end(), {"--scanner", "0,0,1"});
    EXPECT_EQ(cli(words).exitCode, 2) << "two clouds have no scanners";
}

}  // namespace

}  // namespace rubble::cli
