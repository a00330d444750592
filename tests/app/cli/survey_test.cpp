#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/app/cli/command_run.h"
#include "tests/app/cli/small_collapse.h"
#include "tests/io/temporary_folder.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SurveyRun : public SmallRun {};

TEST_F(SurveyRun, AgreesWithASurveyOfItself) {
    run({}, "2");
    const std::string outline = m_folder / "outline.gpkg";
    ASSERT_EQ(cli({"map", m_out, "--cell", "0.05", "--live", "off", "--out", outline}).exitCode, 0);
    const std::string tif = m_folder / "d.tif";
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

TEST_F(SurveyRun, SaysThatLooseStructureWasHeldInTheAir) {
    run({"--set", "live_islands=held"}, "0.5");
    const std::string outline = m_folder / "outline.gpkg";
    ASSERT_EQ(cli({"map", m_out, "--live", "off", "--out", outline}).exitCode, 0);
    const nlohmann::json made = cli({"survey", m_out, "--survey", outline, "--survey-live", "on", "--json"}).json();
    EXPECT_GT(made["fallen"]["held_parts"], 0);
    EXPECT_EQ(saidOfFallen(made), "survey.held");
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
