#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/support/ascii_grid.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SurveyRun : public SmallRun {};

TEST_F(SurveyRun, AgreesWithASurveyOfItself) {
    run({}, "2");
    const std::string outline = m_folder / "outline.gpkg";
    ASSERT_EQ(cli({"map", m_out, "--cell", "0.05", "--live", "off", "--out", outline}).exitCode, 0);
    const std::string tif = m_folder / "D.TIF";  // endings count in capitals too
    const Outcome same = cli({"survey", m_out, "--survey", outline, "--cell", "0.05", "--least-height", "0", "--live", "off",
                              "--out", tif, "--csv", m_folder / "s.csv", "--json"});
    ASSERT_EQ(same.exitCode, 0) << same.err;
    const nlohmann::json made = same.json();
    EXPECT_GT(made["iou"], 0.9);
    EXPECT_EQ(made["survey"]["kind"], "footprint");
    EXPECT_EQ(made["directions"].size(), 8u);
    EXPECT_TRUE(made["surveyed"]["volume_m3"].is_null());
    EXPECT_TRUE(fs::exists(tif) && fs::exists(tif + ".provenance.json"));
    EXPECT_THAT(textOf(m_folder / "s.csv"), HasSubstr("direction,survey_run_out_m"));
}

/// What is said of fallen structure: the one finding of it, empty if there is none.
std::string saidOfFallen(const nlohmann::json& made) {
    std::string said;
    for (const nlohmann::json& warning : made["warnings"]) {
        const std::string id = warning["id"];
        if (id.starts_with("survey.fallen") || id == "survey.held") {
            EXPECT_TRUE(said.empty()) << said << ' ' << id;
            EXPECT_FALSE(warning["remedy"].get<std::string>().empty());
            said = id;
        }
    }
    return said;
}

TEST_F(SurveyRun, SaysWhereTheSidesHoldOtherFallenStructure) {
    run({}, "2");
    const std::string outline = m_folder / "outline.gpkg";
    ASSERT_EQ(cli({"map", m_out, "--live", "off", "--out", outline}).exitCode, 0);
    const auto compared = [&](const std::string& survey, std::vector<std::string> more) {
        more.insert(more.begin(), {"survey", m_out, "--survey", survey, "--json"});
        const Outcome outcome = cli(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.json();
    };
    const nlohmann::json unknown = compared(outline, {});
    EXPECT_EQ(saidOfFallen(unknown), "survey.fallen_unknown");
    EXPECT_TRUE(unknown["survey_live_structure"].is_null());
    EXPECT_EQ(unknown["fallen"]["elements"], 1);
    EXPECT_NEAR(unknown["fallen"]["volume_m3"].get<double>(), 1.0, 1e-6) << "the cube that lives";
    EXPECT_EQ(saidOfFallen(compared(outline, {"--survey-live", "on"})), "");
    EXPECT_EQ(saidOfFallen(compared(outline, {"--survey-live", "off"})), "survey.fallen_simulated_only");
    EXPECT_EQ(saidOfFallen(compared(outline, {"--survey-live", "on", "--live", "off"})), "survey.fallen_surveyed_only");
    EXPECT_EQ(saidOfFallen(compared(outline, {"--survey-live", "off", "--live", "off"})), "");
    // A map of our own has such structure in another band, and says so.
    const std::string map = m_folder / "map.tif";
    ASSERT_EQ(cli({"map", m_out, "--out", map}).exitCode, 0);
    const nlohmann::json ours = compared(map, {});
    EXPECT_EQ(ours["survey_live_structure"], false);
    EXPECT_EQ(saidOfFallen(ours), "survey.fallen_simulated_only");
    EXPECT_EQ(saidOfFallen(compared(map, {"--live", "off"})), "");
    EXPECT_EQ(cli({"survey", m_out, "--survey", outline, "--survey-live", "maybe"}).exitCode, 2);
}

TEST_F(SurveyRun, TakesHeightsOfADebrisMapAboveTheGround) {
    run({"--set", "ground_height=-3"}, "2");
    const std::string map = m_folder / "map.tif";
    ASSERT_EQ(cli({"map", m_out, "--cell", "0.25", "--live", "off", "--out", map}).exitCode, 0);
    const std::vector<std::string> words{"survey",         m_out, "--survey", map,   "--cell", "0.25",
                                         "--least-height", "0",   "--live",   "off", "--json"};
    const Outcome same = cli(words);
    ASSERT_EQ(same.exitCode, 0) << same.err;
    const nlohmann::json made = same.json();
    EXPECT_GT(made["iou"], 0.9);
    EXPECT_LT(made["height_rms_m"], 0.2) << "as elevations they would be 3 m off";
    EXPECT_EQ(made["not_surveyed"]["area_m2"], 0.0) << "where the map is empty lies no debris";
    const auto& warnings = made["warnings"];
    const auto told = [&](const char* id) {
        return std::any_of(warnings.begin(), warnings.end(), [&](const nlohmann::json& each) { return each["id"] == id; });
    };
    EXPECT_TRUE(told("survey.debris_map"));
    EXPECT_FALSE(told("terrain.bands") || told("terrain.short")) << warnings;
    std::vector<std::string> grounded = words;
    grounded.insert(grounded.end(), {"--register", "ground"});
    EXPECT_THAT(cli(grounded).err, HasSubstr("Heights above the ground have no ground"));
    // It is no ground itself, and a map without heights is no survey.
    const Outcome terrain = cli({"run", m_path, "--terrain", map});
    EXPECT_EQ(terrain.exitCode, 1);
    EXPECT_THAT(terrain.err, HasSubstr("is a debris map: its heights are above the ground"));
    const std::string masses = m_folder / "mass.tif";
    ASSERT_EQ(cli({"map", m_out, "--layers", "mass", "--out", masses}).exitCode, 0);
    EXPECT_THAT(cli({"survey", m_out, "--survey", masses}).err, HasSubstr("none of its bands holds heights"));
}

TEST_F(SurveyRun, SaysThatLooseStructureWasHeldInTheAir) {
    run({"--set", "live_islands=held", "--set", "loose_structure=fe"}, "0.5");
    const std::string outline = m_folder / "outline.gpkg";
    ASSERT_EQ(cli({"map", m_out, "--live", "off", "--out", outline}).exitCode, 0);
    const nlohmann::json made = cli({"survey", m_out, "--survey", outline, "--survey-live", "on", "--json"}).json();
    EXPECT_GT(made["fallen"]["held_parts"], 0);
    EXPECT_EQ(saidOfFallen(made), "survey.held");
}

TEST_F(SurveyRun, ComparesOnlyAnAreaOfInterest) {
    run({}, "2");
    const std::string map = m_folder / "map.tif";
    ASSERT_EQ(cli({"map", m_out, "--cell", "0.25", "--live", "off", "--out", map}).exitCode, 0);
    const auto polygon = [&](const char* name, double from, double to) {
        std::ostringstream text;
        text
            << R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[)"
            << '[' << from << ',' << from << "],[" << to << ',' << from << "],[" << to << ',' << to << "],[" << from << ',' << to
            << "],[" << from << ',' << from << "]]]}}]}";
        std::ofstream(m_folder / name) << text.str();
        return m_folder / name;
    };
    const auto compared = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"survey", m_out, "--survey", map, "--cell", "0.25", "--live", "off", "--json"});
        return cli(more);
    };
    const nlohmann::json all = compared({}).json();
    EXPECT_EQ(all["compared"]["whole"], true);
    EXPECT_EQ(all["noise"]["source"], "none");
    EXPECT_GT(all["reachable"]["iou"], 0.9);
    EXPECT_GT(all["like_for_like"]["iou"], 0.9);
    EXPECT_GT(all["volumes"]["fill_m3"], 0.0);
    const nlohmann::json wide = compared({"--area", polygon("wide.geojson", -500.0, 500.0)}).json();
    EXPECT_EQ(wide["iou"], all["iou"]);
    EXPECT_EQ(wide["compared"]["whole"], false);
    EXPECT_EQ(wide["compared"]["left_out_simulated_m2"], 0.0);
    const Outcome none = compared({"--leave-out", polygon("all.geojson", -500.0, 500.0)});
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_THAT(none.err, HasSubstr("left out holds all"));
    const Outcome missed = compared({"--area", polygon("away.geojson", 5000.0, 5010.0)});
    EXPECT_EQ(missed.exitCode, 2);
    EXPECT_THAT(missed.err, HasSubstr("area of interest reaches from x = 5"));
    EXPECT_EQ(compared({"--area", map}).exitCode, 1) << "a raster is no area";
    EXPECT_EQ(compared({"--noise", "-1"}).exitCode, 2);
    const nlohmann::json noisy = compared({"--noise", "0.3", "--ground-noise", "0.4"}).json();
    EXPECT_EQ(noisy["noise"]["source"], "none") << "a map of a run has none";
}

TEST_F(SurveyRun, WhatIsNotKnownOrNotCountedIsToldInWords) {
    run({}, "2");
    const std::string level = io::AsciiGrid().write(m_folder / "level.asc", [](double x, double) { return x > 0.0 ? 0.1 : -0.05; });
    const std::vector<std::string> words{"survey", m_out, "--survey", level, "--noise", "0.1", "--ground-noise", "0.1"};
    const Outcome noise = cli(words);
    ASSERT_EQ(noise.exitCode, 0) << noise.err;
    // 40 by 20 m of 0.1 m above the ground, and as many of 0.05 m below it; the middle of an edge cell is the last that counts.
    EXPECT_THAT(noise.out, HasSubstr("fill 80, cut 40, net 40 m3 also lie below the level of detection"));
    EXPECT_THAT(noise.out, HasSubstr("not known: the surveyed side has no debris"));
    std::vector<std::string> high = words;
    high.insert(high.end(), {"--least-height", "100"});
    const Outcome none = cli(high);
    ASSERT_EQ(none.exitCode, 0) << none.err;
    EXPECT_THAT(none.out, HasSubstr("none: neither side has debris"));
    EXPECT_THAT(none.out, HasSubstr("not known: neither side has debris"));
    for (const std::string& out : {noise.out, none.out}) {
        EXPECT_THAT(out, testing::Not(HasSubstr("not a number")));
        EXPECT_THAT(out, testing::Not(HasSubstr("nan")));
    }
    high.emplace_back("--json");
    const nlohmann::json made = cli(high).json();
    EXPECT_TRUE(made["iou"].is_null());
    EXPECT_NEAR(made["volumes"]["not_detected_fill_m3"].get<double>(), 80.0, 1e-6);
    EXPECT_NEAR(made["volumes"]["not_detected_cut_m3"].get<double>(), 40.0, 1e-6);
    EXPECT_NEAR(made["volumes"]["not_detected_m3"].get<double>(), 120.0, 1e-6);
}

TEST_F(SurveyRun, RefusesASurveyThatIsNone) {
    run({}, "0.5");
    EXPECT_EQ(cli({"survey", m_out}).exitCode, 2);
    EXPECT_EQ(cli({"survey", m_out, "--survey", m_folder / "none.tif"}).exitCode, 1);
    EXPECT_EQ(cli({"survey", m_out, "--survey", m_path, "--register", "sky"}).exitCode, 2);
    EXPECT_EQ(cli({"survey", m_out, "--survey", m_path, "--out", m_folder / "a.pdf"}).exitCode, 2);
}

}  // namespace

}  // namespace rubble::cli
