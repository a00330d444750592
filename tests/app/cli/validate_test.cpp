#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "io/validation/kept_validation.h"
#include "tests/support/command_run.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// The first tosses of the shipped set, in a folder of their own.
class ValidateRun : public testing::Test {
protected:
    void SetUp() override {
        const fs::path from = sourcePath("resources/validation/tosses");
        for (const char* name : {"LICENSE", "README.md"}) {
            fs::copy_file(from / name, fs::path(m_folder.path()) / name);
        }
        std::ifstream table(from / "cube_tosses.csv");
        std::ofstream few(m_folder / "cube_tosses.csv");
        std::string line;
        for (int i = 0; i < 17 && std::getline(table, line); ++i) {
            few << line << '\n';
        }
    }
    io::TemporaryFolder m_folder;
};

TEST_F(ValidateRun, HoldsAFewTossesAgainstTheirMeasurements) {
    const Outcome outcome =
        cli({"validate", "--data", m_folder.path(), "--csv", m_folder / "v.csv", "--pictures", m_folder / "svg", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json set = outcome.json()["sets"][0];
    EXPECT_EQ(set["id"], "tosses");  // known by the names of its tables
    EXPECT_EQ(set["bodies"], 16);
    EXPECT_THAT(set["licence"].get<std::string>(), HasSubstr("BSD"));
    ASSERT_EQ(set["variants"].size(), 3u);
    const nlohmann::json fitted = set["variants"][2];
    EXPECT_TRUE(fitted["fitted"].get<bool>());
    EXPECT_EQ(fitted["bodies"], 16);
    ASSERT_EQ(fitted["parameters"].size(), 3u);
    EXPECT_EQ(fitted["parameters"][1]["source"], "fitted on one half, judged on the other");
    EXPECT_EQ(fitted["parameters"][2]["source"], "fitted on the other half, judged on the one");
    EXPECT_EQ(fitted["criteria"].size(), 3u);
    for (const nlohmann::json& variant : set["variants"]) {
        EXPECT_EQ(variant["lost"], 0) << variant["name"];
        // A cube that slides half a metre: an error of that is one of the comparison.
        EXPECT_LT(std::abs(variant["quantities"][0]["error"]["value"].get<double>()), 0.3) << variant["name"];
    }
    // Three quantities and a map of each variant.
    EXPECT_EQ(outcome.json()["pictures"].size(), 12u);
    EXPECT_THAT(textOf(m_folder / "svg/tosses-blind-run_out_m.svg"),
                testing::AllOf(HasSubstr("<svg"), HasSubstr("run-out [m]"), HasSubstr("</svg>")));
    EXPECT_THAT(textOf(m_folder / "v.csv"), HasSubstr("tosses,fitted,position_error_m.median,m,"));
}

TEST_F(ValidateRun, KeepsWhatCameOfWholeSetsForReports) {
    const auto run = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"validate", "--data", m_folder.path()});
        return CommandRun().with("RUBBLE_CACHE", m_folder / "cache").cli(std::move(more));
    };
    Findings findings;
    ASSERT_EQ(run({"--repeats", "1"}).exitCode, 0);
    EXPECT_TRUE(io::keptValidations(m_folder / "cache", findings).empty()) << "not as the set stands";
    ASSERT_EQ(run({}).exitCode, 0);
    const std::vector<ValidationRecord> kept = io::keptValidations(m_folder / "cache", findings);
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(kept[0].id, "tosses");
    EXPECT_EQ(kept[0].bodies, 16u);
}

TEST_F(ValidateRun, RefusesASetWithoutLicence) {
    fs::remove(m_folder / "LICENSE");
    const Outcome outcome = cli({"validate", "--data", m_folder.path()});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("licence"));
}

TEST(Validate, NamesItsSets) {
    const Outcome outcome = cli({"validate", "--only", "toses"});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr("tosses"), HasSubstr("tschamut")));
}

}  // namespace

}  // namespace rubble::cli
