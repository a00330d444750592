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

TEST_F(SurveyRun, RefusesASurveyThatIsNone) {
    run({}, "0.5");
    EXPECT_EQ(cli({"survey", m_out}).exitCode, 2);
    EXPECT_EQ(cli({"survey", m_out, "--survey", m_folder / "none.tif"}).exitCode, 1);
    EXPECT_EQ(cli({"survey", m_out, "--survey", m_path, "--register", "sky"}).exitCode, 2);
    EXPECT_EQ(cli({"survey", m_out, "--survey", m_path, "--out", m_folder / "a.pdf"}).exitCode, 2);
}

}  // namespace

}  // namespace rubble::cli
