#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "tests/app/cli/command_run.h"
#include "tests/app/cli/small_collapse.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Map : public SmallRun {
protected:
    void SetUp() override { run({}, "1"); }
    Outcome map(std::vector<std::string> more) {
        more.insert(more.begin(), {"map", m_out});
        return CommandRun().with("DISPLAY", std::nullopt).cli(more);
    }
    nlohmann::json mapJson(std::vector<std::string> more) {
        more.push_back("--json");
        const Outcome outcome = map(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.json();
    }
};

TEST_F(Map, AgreesWithTheLedgerAndWritesEveryKind) {
    std::vector<std::string> words{"--cell", "0.5"};
    for (const char* ending : {"tif", "gpkg", "csv", "png"}) {
        words.insert(words.end(), {"--out", m_folder / (std::string("map.") + ending)});
    }
    const nlohmann::json object = mapJson(words);
    EXPECT_EQ(object["fragments"], smallDead);
    EXPECT_NEAR(object["mass_kg"], 2000.0 * smallDead, 1e-6);
    EXPECT_NEAR(object["volume_m3"], 1.0 * smallDead, 1e-9);
    double mass = -1.0;
    for (const nlohmann::json& layer : object["layers"]) {
        if (layer["layer"] == "mass") {
            mass = layer["mean"].get<double>() * layer["cells"].get<double>() * 0.25;
            EXPECT_NEAR(layer["cells"].get<double>() * 0.25, object["footprint_m2"], 1e-9);
        }
    }
    EXPECT_NEAR(mass, object["mass_kg"], 1e-6);
    EXPECT_EQ(object["live_structure"]["elements"], 1) << "the girder's last cube has fallen from 2 m and lives";
    ASSERT_EQ(object["exports"].size(), 4u);
    for (const nlohmann::json& path : object["exports"]) {
        EXPECT_GT(fs::file_size(path.get<std::string>()), 100u) << path;
        const nlohmann::json origin = nlohmann::json::parse(textOf(path.get<std::string>() + ".provenance.json"));
        EXPECT_EQ(origin["map"]["class"], "simulated");
        EXPECT_EQ(origin["map"]["ledger"]["fragments"], smallDead);
        EXPECT_EQ(origin["inputs"][0]["sha256"].get<std::string>().size(), 64u);
    }
}

TEST_F(Map, OfACaseIsThatOfItsRun) {
    const nlohmann::json ofRun = mapJson({});
    const Outcome outcome = cli({"map", m_path, "--set", "settle_time=1", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.json()["layers"], ofRun["layers"]);
}

TEST_F(Map, IsAnExportToo) {
    const std::string tiff = m_folder / "map.tif";
    const std::string package = m_folder / "debris.gpkg";
    const Outcome outcome =
        cli({"export", m_out, "--export", "debris-map=" + tiff, "--export", "footprint=" + package, "--cell", "1"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.out, tiff + "\n" + package + "\n");
    EXPECT_EQ(map({"--cell", "1", "--out", m_folder / "same.tif"}).exitCode, 0);
    EXPECT_TRUE(textOf(tiff) == textOf(m_folder / "same.tif")) << "two commands, one exporter";
    EXPECT_EQ(cli({"export", m_out, "--export", "footprint=" + tiff}).exitCode, 2);
}

TEST_F(Map, FollowsTheTimeAndTheSwitch) {
    EXPECT_EQ(mapJson({"--time", "0"})["fragments"], 0);
    EXPECT_EQ(mapJson({"--time", "0.15"})["fragments"], 2);
    EXPECT_EQ(mapJson({"--time", "fe_end"})["time_s"], 0.5);
    const nlohmann::json off = mapJson({"--live", "off"});
    EXPECT_TRUE(off["live_structure"].is_null());
    EXPECT_EQ(off["layers"].size(), 8u);
    EXPECT_EQ(mapJson({"--layers", "mass,height"})["layers"].size(), 2u);
    const std::string csv = m_folder / "layers.csv";
    mapJson({"--csv", csv});
    EXPECT_THAT(textOf(csv), testing::StartsWith("layer,unit,cells,least,mean,most\nheight,m,"));
}

TEST_F(Map, WrongRequestsAreRefused) {
    const std::string out = m_folder / "a.tif";
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"--time", "99"},
                                                                                       {"--time", "soon"},
                                                                                       {"--cell", "0"},
                                                                                       {"--cell", "-1"},
                                                                                       {"--cell", "1e-9"},
                                                                                       {"--layers", "beauty"},
                                                                                       {"--layers", "live_mass", "--live", "off"},
                                                                                       {"--live", "maybe"},
                                                                                       {"--live-threshold", "-1"},
                                                                                       {"--set", "multiple=2"},
                                                                                       {"--out", m_folder / "a.shp"}}) {
        std::vector<std::string> all = words;
        all.insert(all.end(), {"--out", out});
        EXPECT_EQ(map(all).exitCode, 2) << words[0] << " " << words[1];
    }
    EXPECT_EQ(map({"--out", m_folder / "a.gpkg", "--contours", "0.0001"}).exitCode, 2);
    EXPECT_EQ(map({"--out", m_folder / "none/a.tif"}).exitCode, 1);
    EXPECT_FALSE(fs::exists(out));
}

TEST_F(Map, AFullDiskLeavesWhatWasThere) {
    for (const char* ending : {"tif", "gpkg", "csv"}) {
        const std::string path = m_folder / (std::string("map.") + ending);
        ASSERT_EQ(map({"--cell", "0.05", "--out", path}).exitCode, 0);
        const std::string before = textOf(path);
        const Outcome full = CommandRun().fileSizeLimit(2048).cli({"map", m_out, "--cell", "0.04", "--out", path});
        EXPECT_EQ(full.exitCode, 1) << ending;
        EXPECT_THAT(full.err, HasSubstr("free space"));
        EXPECT_TRUE(textOf(path) == before) << ending;
    }
    for (const auto& entry : fs::directory_iterator(m_folder.path())) {
        EXPECT_NE(entry.path().extension(), ".part") << entry.path();
    }
}

}  // namespace

}  // namespace rubble::cli
