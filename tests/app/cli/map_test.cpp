#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "io/case/case_file.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"

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

/// The numbers of a table's columns by name, row by row; an empty field is zero.
std::vector<std::vector<double>> columnsOf(const std::string& path, const std::vector<std::string>& names) {
    std::istringstream in(textOf(path));
    std::string line;
    std::getline(in, line);
    const auto split = [](const std::string& text) {
        std::vector<std::string> fields(1);
        bool quoted = false;
        for (const char c : text) {
            quoted = quoted != (c == '"');
            if (c == ',' && !quoted) {
                fields.emplace_back();
            } else {
                fields.back() += c;
            }
        }
        return fields;
    };
    const std::vector<std::string> heads = split(line);
    std::vector<std::vector<double>> rows;
    while (std::getline(in, line)) {
        const std::vector<std::string> fields = split(line);
        std::vector<double>& row = rows.emplace_back();
        for (const std::string& name : names) {
            const auto head = std::find(heads.begin(), heads.end(), name);
            EXPECT_NE(head, heads.end()) << name;
            const std::string& text = fields.at(static_cast<std::size_t>(head - heads.begin()));
            row.push_back(text.empty() ? 0.0 : std::stod(text));
        }
    }
    return rows;
}

TEST_F(Map, LiesWhereControlPointsPutTheCase) {
    // A quarter turn: local x points north, local y west.
    Case theCase = io::caseForFe(m_path, m_folder / "small.rubble");
    theCase.frame.crs = "EPSG:25832";
    for (const Vec3& local : {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 10, 5)}) {
        const Vec3 world(600000.0 - local.y(), 5600000.0 + local.x(), local.z() + 120.0);
        theCase.site.controlPoints.push_back({"P", local, world, true});
    }
    io::saveCase(m_folder / "small.rubble", theCase);
    const std::string placed = m_folder / "placed.run.h5";
    ASSERT_EQ(cli({"run", m_folder / "small.rubble", "--out", placed, "--set", "settle_time=1"}).exitCode, 0);
    for (const auto& [run, name] : {std::pair(m_out, "local"), std::pair(placed, "placed")}) {
        const Outcome outcome = cli({"export", run, "--export", "fragments=" + (m_folder / (std::string(name) + ".csv")),
                                     "--export", "debris-map=" + (m_folder / (std::string(name) + "-map.csv"))});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    }
    const std::vector<std::string> finals{"final_x_m", "final_y_m", "final_z_m"};
    const auto local = columnsOf(m_folder / "local.csv", finals);
    const auto world = columnsOf(m_folder / "placed.csv", finals);
    ASSERT_EQ(local.size(), static_cast<std::size_t>(smallDead));
    ASSERT_EQ(world.size(), local.size());
    for (std::size_t f = 0; f < local.size(); ++f) {
        EXPECT_NEAR(world[f][0], 600000.0 - local[f][1], 1e-6);
        EXPECT_NEAR(world[f][1], 5600000.0 + local[f][0], 1e-6);
        EXPECT_NEAR(world[f][2], local[f][2] + 120.0, 1e-6);
    }
    const auto cells = columnsOf(m_folder / "local-map.csv", {"x_m", "y_m", "fragments"});
    const auto placedCells = columnsOf(m_folder / "placed-map.csv", {"x_m", "y_m", "fragments"});
    ASSERT_EQ(cells.size(), placedCells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
        EXPECT_NEAR(placedCells[c][0], 600000.0 - cells[c][1], 1e-6);
        EXPECT_NEAR(placedCells[c][1], 5600000.0 + cells[c][0], 1e-6);
        EXPECT_EQ(placedCells[c][2], cells[c][2]);
    }
    const nlohmann::json said = nlohmann::json::parse(textOf(m_folder / "placed-map.csv.provenance.json"));
    EXPECT_EQ(said["map"]["crs"], "ETRS89 / UTM zone 32N");
    EXPECT_THAT(said["coordinates"].get<std::string>(), HasSubstr("control points"));
    EXPECT_EQ(said["site"]["control_points"].size(), 3u);
}

// A system that counts in feet, and points that are twice as far apart as the model has them.
TEST_F(Map, WhatMakesPlacesUncertainIsToldByRunMapAndReport) {
    Case theCase = io::caseForFe(m_path, m_folder / "feet.rubble");
    theCase.frame.crs = "EPSG:2263";
    for (const double x : {0.0, 10.0}) {
        theCase.site.controlPoints.push_back(
            {"P" + std::to_string(int(x)), Vec3(x, 0, 0), Vec3(300000.0 + 2.0 * x, 60000.0, 5.0), true});
    }
    io::saveCase(m_folder / "feet.rubble", theCase);
    const std::string placed = m_folder / "feet.run.h5";
    const Outcome made = cli({"run", m_folder / "feet.rubble", "--out", placed, "--json"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    const auto told = [](const nlohmann::json& cautions) {
        std::string words;
        for (const auto& each : cautions) {
            words += each["key"] == "place_doubt" ? each["text"].get<std::string>() : std::string();
        }
        return words;
    };
    EXPECT_THAT(told(made.json()["cautions"]), HasSubstr("the model is 0.5 times as large"));
    const std::string map = m_folder / "feet";
    const Outcome written = cli({"map", placed, "--out", map + ".tif", "--out", map + ".csv", "--out", map + ".gpkg", "--json"});
    ASSERT_EQ(written.exitCode, 0) << written.err;
    EXPECT_THAT(told(written.json()["cautions"]), HasSubstr("0.5 times"));
    for (const char* file : {".tif", ".gpkg"}) {
        const nlohmann::json said = nlohmann::json::parse(textOf(map + file + ".provenance.json"));
        EXPECT_THAT(said["coordinates"].get<std::string>(),
                    HasSubstr("units of the coordinate system, 0.3048 m each, heights in metres"));
        EXPECT_THAT(told(said["cautions"]), HasSubstr("0.5 times"));
    }
    const nlohmann::json table = nlohmann::json::parse(textOf(map + ".csv.provenance.json"));
    EXPECT_THAT(table["coordinates"].get<std::string>(), testing::StartsWith("metres")) << "as its columns say";
    const Outcome report = CommandRun()
                               .with("DISPLAY", std::nullopt)
                               .cli({"report", placed, "--case", m_folder / "feet.rubble", "--out", m_folder / "report", "--cache",
                                     m_folder / "cache", "--self-test", "none", "--repeats", "0"});
    ASSERT_EQ(report.exitCode, 0) << report.err;
    const std::string page = textOf(m_folder / "report/report.html");
    EXPECT_THAT(page, HasSubstr("The model lies in the coordinate system EPSG:2263 by 2 of 2 control points"));
    EXPECT_THAT(page, HasSubstr("300020, 60000, 5")) << "a control point in metres";
    EXPECT_THAT(page, HasSubstr("the model is 0.5 times as large"));
}

TEST_F(Map, ASystemWithoutAPlaceOfTheModelIsNamedByNobodyAndToldByAll) {
    Case theCase = io::caseForFe(m_path, m_folder / "named.rubble");
    theCase.frame.crs = "EPSG:25832";
    io::saveCase(m_folder / "named.rubble", theCase);
    const std::string named = m_folder / "named.run.h5";
    const Outcome made = cli({"run", m_folder / "named.rubble", "--out", named, "--set", "settle_time=1", "--json"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    const auto tells = [](const nlohmann::json& cautions) {
        return std::any_of(cautions.begin(), cautions.end(), [](const auto& each) { return each["key"] == "no_place"; });
    };
    EXPECT_TRUE(tells(made.json()["cautions"])) << made.out;
    const std::string map = m_folder / "named-map.csv";
    const Outcome written = cli({"map", named, "--out", map, "--out", m_folder / "named-map.tif", "--json"});
    ASSERT_EQ(written.exitCode, 0) << written.err;
    EXPECT_TRUE(tells(written.json()["cautions"])) << written.out;
    const nlohmann::json said = nlohmann::json::parse(textOf(map + ".provenance.json"));
    EXPECT_EQ(said["map"]["crs"], "local, metres");
    EXPECT_THAT(said["coordinates"].get<std::string>(), HasSubstr("axes of the model"));
    EXPECT_TRUE(tells(said["cautions"])) << said;
    EXPECT_THAT(cli({"map", named}).out, HasSubstr("has no place in it"));
}

TEST_F(Map, APlaceThatCannotBeRightIsToldByEveryDoor) {
    // Easting and northing are changed for each other.
    Case theCase = io::caseForFe(m_path, m_folder / "odd.rubble");
    theCase.frame.crs = "EPSG:25832";
    theCase.site.controlPoints = {{"P", Vec3(0, 0, 0), Vec3(5600000, 600000, 0), true},
                                  {"Q", Vec3(10, 0, 0), Vec3(5600000, 600010, 0), true}};
    io::saveCase(m_folder / "odd.rubble", theCase);
    const std::string placed = m_folder / "odd.run.h5";
    const Outcome made = cli({"run", m_folder / "odd.rubble", "--out", placed, "--set", "settle_time=1", "--json"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    EXPECT_THAT(made.out, HasSubstr("site.swapped"));
    EXPECT_THAT(cli({"map", placed, "--json"}).out, HasSubstr("site.swapped"));
    EXPECT_THAT(cli({"inspect", m_folder / "odd.rubble", "--json"}).out, HasSubstr("site.swapped"));
    const Outcome written = cli({"export", placed, "--export", "fragments=" + (m_folder / "odd.csv")});
    EXPECT_THAT(written.err, HasSubstr("changed for each other"));
    for (const char* command : {"run", "effects", "influence", "accuracy", "ensemble", "map", "survey"}) {
        const Outcome moved = cli({command, m_folder / "odd.rubble", "--mesh-offset", "1,2,3"});
        EXPECT_NE(moved.exitCode, 0) << command;
        EXPECT_THAT(moved.err, HasSubstr("no mesh of surroundings")) << command;
    }
    EXPECT_THAT(cli({"map", placed, "--mesh-offset", "1,2,3"}).err, HasSubstr("recorded already"));
    EXPECT_NE(cli({"run", m_folder / "odd.rubble", "--mesh-offset", "1,2"}).exitCode, 0);
}

TEST_F(Map, FollowsTheTimeAndTheSwitch) {
    run({"--set", "birth_window=0"}, "1");
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
    EXPECT_EQ(map({"--out", m_folder / "none/a.tif"}).exitCode, 0) << "the folder is made";
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
