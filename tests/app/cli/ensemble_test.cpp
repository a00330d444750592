#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>

#include "io/case/case_file.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Ensemble : public testing::Test {
protected:
    Outcome cli(std::vector<std::string> words) {
        words.insert(words.end(), {"--set", "settle_time=1", "--cache", m_cache, "--json"});
        return CommandRun().with("DISPLAY", std::nullopt).cli(words);
    }
    nlohmann::json ensemble(const std::string& members, std::vector<std::string> more) {
        more.insert(more.begin(), {"ensemble", m_path, "--members", members, "--vary", "friction=uniform:0.1:0.9"});
        const Outcome outcome = cli(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.json();
    }

    io::TemporaryFolder m_folder;
    std::string m_path = writeSmallCollapse(m_folder / "small.exo");
    std::string m_cache = m_folder / "cache";
};

TEST_F(Ensemble, MapsProbabilitiesAndKeepsItsMembers) {
    const std::string out = m_folder / "maps/";
    const nlohmann::json object = ensemble("4", {"--out", out});
    EXPECT_EQ(object["done"], 4);
    EXPECT_TRUE(object["complete"]);
    EXPECT_GT(object["figures"]["footprint_m2"]["mean"].get<double>(), 5.0);
    EXPECT_NEAR(object["figures"]["mass_kg"]["mean"].get<double>(), 2000.0 * (smallDead + 1), 1.0) << "with the cube that lives";
    EXPECT_EQ(object["convergence"].back()["members"], 4);
    for (const char* name : {"probability.tif", "probability.csv", "probability-probability.png", "probability-above_second.png",
                             "members.csv", "convergence.csv", "probability.tif.provenance.json"}) {
        EXPECT_TRUE(fs::exists(out + name)) << name;
    }
    const nlohmann::json provenance = nlohmann::json::parse(textOf(out + "probability.tif.provenance.json"));
    EXPECT_EQ(provenance["members"].size(), 4u);
    EXPECT_EQ(provenance["inputs"][0]["role"], "fe");
    // A second start takes what is there, and more members go on from there.
    const nlohmann::json again = ensemble("5", {"--jobs", "1"});
    for (int m = 0; m < 4; ++m) {
        EXPECT_TRUE(again["list"][m]["kept"]);
        EXPECT_EQ(again["list"][m]["trajectory_hash"], object["list"][m]["trajectory_hash"]);
    }
}

/// As other commands open it: scenarios by id or name, no FE input that would have to be named, debris on the surroundings.
TEST_F(Ensemble, OpensACaseAsEveryCommandDoes) {
    std::ofstream(m_folder / "house.obj") << "v 4 -1 0\nv 6 -1 0\nv 4 1 1\nf 1 2 3\n";
    io::AsciiGrid().writeLevel(m_folder / "level.asc", -1.5);
    const std::string casePath = m_folder / "small.rubble";
    Case theCase = io::caseForFe(m_path, casePath);
    theCase.inputs.push_back({"terrain-1", InputRole::Terrain, "level.asc", {}});
    theCase.inputs.push_back({"surroundings-1", InputRole::Surroundings, "house.obj", {}});
    theCase.site.collide = true;
    theCase.scenarios[0].feInput.clear();
    theCase.scenarios.push_back(theCase.scenarios[0]);
    theCase.scenarios[1].id = "scenario-2";
    theCase.scenarios[1].name = "slippery";
    theCase.scenarios[1].scenario.simulation.friction = 0.1;
    io::saveCase(casePath, theCase);
    m_path = casePath;
    const std::string out = m_folder / "maps/";
    const nlohmann::json object = ensemble("2", {"--vary", "scenario=choice:scenario-1:slippery", "--out", out});
    EXPECT_EQ(object["done"], 2);
    const nlohmann::json provenance = nlohmann::json::parse(textOf(out + "probability.tif.provenance.json"));
    std::vector<std::string> roles;
    for (const nlohmann::json& input : provenance["inputs"]) {
        roles.push_back(input["role"]);
    }
    EXPECT_EQ(roles, (std::vector<std::string>{"fe", "terrain", "surroundings"}));
    const Outcome refused = cli({"ensemble", casePath, "--scenario", "none of these"});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.err, HasSubstr("scenario-2 (slippery)"));
}

TEST_F(Ensemble, GoesOnAfterItWasKilled) {
    const std::vector<std::string> words{"ensemble", m_path,          "--members", "12",    "--jobs", "1",
                                         "--set",    "settle_time=1", "--cache",   m_cache, "--json"};
    const Outcome killed = CommandRun()
                               .meanwhile([&](pid_t process) {
                                   std::error_code ignored;
                                   std::size_t worlds = 0;
                                   for (fs::directory_iterator it(fs::path(m_cache) / "worlds", ignored), end; it != end; ++it) {
                                       worlds += it->path().extension() == ".world" ? 1 : 0;
                                   }
                                   if (worlds >= 2) {
                                       ::kill(process, SIGKILL);
                                   }
                               })
                               .cli(words);
    EXPECT_EQ(killed.signal, SIGKILL);
    const Outcome whole = CommandRun().cli(words);
    ASSERT_EQ(whole.exitCode, 0) << whole.err;
    EXPECT_TRUE(whole.json()["list"][0]["kept"]);
    EXPECT_FALSE(whole.json()["list"][11]["kept"]);
    EXPECT_EQ(whole.json()["done"], 12);
}

TEST_F(Ensemble, SaysWhatCannotBe) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{"--vary", "friction=uniform:2:1"},
                                                  {"--vary", "frction=uniform:1:2"},
                                                  {"--members", "0"},
                                                  {"--heights", "1,0.5,2"},
                                                  {"--layers", "mass"},
                                                  {"--out", m_folder / "map.gpkg"},
                                                  {"--instant", "later"}}) {
        std::vector<std::string> all{"ensemble", m_path};
        all.insert(all.end(), words.begin(), words.end());
        EXPECT_EQ(cli(all).exitCode, 2) << words.front() << ' ' << words.back();
    }
}

/// Two causes of one collapse: as the file has it, and the same six metres to the east.
class Compare : public Ensemble {
protected:
    nlohmann::json compare(std::vector<std::string> more) {
        more.insert(more.begin(), {"compare", m_path, m_other, "--members", "8", "--vary", "friction=uniform:0.3:0.5"});
        const Outcome outcome = cli(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.json();
    }
    void SetUp() override {
        io::ExodusBuilder builder = smallCollapse();
        for (Vec3& node : builder.nodes) {
            node.x() += 6.0;
        }
        builder.write(m_other);
    }
    /// What a survey of a cause would find, with a friction that no member has.
    static Outcome map(const std::string& fe, std::vector<std::string> more) {
        more.insert(more.begin(), {"map", fe, "--set", "friction=0.43", "--set", "settle_time=1", "--cell", "0.5"});
        return rubble::cli::cli(more);
    }
    std::string m_other = m_folder / "other.exo";
};

TEST_F(Compare, FindsTheHiddenCause) {
    const std::string tiff = m_folder / "truth.tif";
    const std::string package = m_folder / "truth.gpkg";
    const Outcome truth = map(m_other, {"--out", tiff, "--out", package});
    ASSERT_EQ(truth.exitCode, 0) << truth.err;
    const std::string out = m_folder / "out/";
    const nlohmann::json object =
        compare({"--against", "height=" + tiff, "--against", "footprint=" + package, "--out", out, "--blind"});
    EXPECT_EQ(object["closest"], "other");
    EXPECT_TRUE(object["told_apart"]);
    EXPECT_EQ(object["evidence"].size(), 2u);
    EXPECT_EQ(object["ranking"][0]["cause"], "other");
    EXPECT_TRUE(fs::exists(out + "separation.tif"));
    EXPECT_TRUE(fs::exists(out + "separation-separation.png"));
    EXPECT_EQ(object["blind_tests"].size(), 2u);
    EXPECT_EQ(object["blind_tests"][1]["wrong"], 0);
}

TEST_F(Compare, FindsTheHiddenCauseByAPointCloud) {
    const std::string cloud = m_folder / "truth.las";
    const Outcome scan = rubble::cli::cli(
        {"scan", m_other, "--set", "friction=0.43", "--set", "settle_time=1", "--step", "0.25", "--range", "30", "--out", cloud});
    ASSERT_EQ(scan.exitCode, 0) << scan.err;
    const nlohmann::json object = compare({"--against", "surface=" + cloud});
    EXPECT_EQ(object["closest"], "other");
    EXPECT_EQ(object["ranking"][0]["cause"], "other");
    EXPECT_THAT(object["warnings"].dump(), HasSubstr("cloud.gridded"));
}

TEST_F(Compare, OneCauseUnderTwoNamesIsNotToldApart) {
    fs::copy_file(m_path, m_other, fs::copy_options::overwrite_existing);
    const std::string tiff = m_folder / "truth.tif";
    ASSERT_EQ(map(m_path, {"--out", tiff}).exitCode, 0);
    const nlohmann::json object = compare({"--against", "height=" + tiff});
    EXPECT_FALSE(object["told_apart"]);
    EXPECT_EQ(object["not_told_from"].size(), 1u);
}

TEST_F(Compare, SaysWhatItAssumesOfEvidenceAsSurveyDoes) {
    // Half a metre of debris beside a place that was not surveyed, in a unit that the file does not name.
    const std::string grid = io::AsciiGrid().write(
        m_folder / "heights.asc", [](double, double y) { return y > 18.0 ? std::numeric_limits<double>::quiet_NaN() : 0.5; });
    const auto counted = [](const nlohmann::json& made, const std::string& id) {
        for (const nlohmann::json& warning : made["warnings"]) {
            if (warning["id"] == id) {
                return warning["count"].get<int>();
            }
        }
        return 0;
    };
    const nlohmann::json made = compare({"--against", "height=" + grid});
    EXPECT_EQ(counted(made, "terrain.height_unit"), 1) << made["warnings"];
    EXPECT_EQ(counted(made, "survey.gaps"), 80) << made["warnings"];
    const Outcome surveyed = rubble::cli::cli({"survey", m_path, "--set", "settle_time=1", "--survey", grid, "--json"});
    ASSERT_EQ(surveyed.exitCode, 0) << surveyed.err;
    EXPECT_EQ(counted(surveyed.json(), "terrain.height_unit"), 1);
    EXPECT_GT(counted(surveyed.json(), "survey.gaps"), 0);
    // What is no raster of heights is refused by name.
    const std::string pointer = m_folder / "heights.vrt";
    std::ofstream(pointer) << "<VRTDataset rasterXSize=\"40\" rasterYSize=\"40\"/>";
    const Outcome refused = cli({"compare", m_path, m_other, "--against", "surface=" + pointer});
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.err, HasSubstr(pointer));
    EXPECT_THAT(refused.err, HasSubstr("gdal_translate"));
}

TEST_F(Compare, WithoutEvidenceSaysWhatEvidenceCouldTell) {
    const nlohmann::json object = compare({});
    ASSERT_EQ(object["blind_tests"].size(), 2u);
    EXPECT_EQ(object["blind_tests"][0]["evidence"], "footprint");
    EXPECT_EQ(object["blind_tests"][0]["trials"], 16);
    EXPECT_EQ(cli({"compare", m_path, m_other, "--against", "guess=x"}).exitCode, 2);
    EXPECT_EQ(cli({"compare", m_path, m_other, "--against", "height=" + m_folder.path() + "/none.tif"}).exitCode, 1);
}

}  // namespace

}  // namespace rubble::cli
