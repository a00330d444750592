#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/command_run.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string data = buildPath("tests/fe/");

/// Results that are a row of files, from the first look to the proof that a run repeats.
class Series : public testing::Test {
protected:
    io::TemporaryFolder m_folder;
};

TEST_F(Series, InspectSaysWhatIsThereWhatIsMissingAndWhatItCosts) {
    const nlohmann::json anim = cli({"inspect", data + "frame-anim/FRAMEA009", "--json"}).json();
    EXPECT_EQ(anim["format"], "OpenRadioss animation");
    EXPECT_EQ(anim["files"], 21) << "twenty states and the starter deck";
    EXPECT_EQ(anim["bytes"], 20 * 50554 + 90546);
    EXPECT_GT(anim["index_s"], 0.0);
    EXPECT_EQ(anim["dead_total"], 43);
    EXPECT_TRUE(anim["missing"].empty()) << "the starter deck says the units";
    EXPECT_EQ(anim["units"]["system"], "kg-m-s") << "of the frame of a case, until somebody chooses";
    EXPECT_EQ(anim["units"]["fits"]["choice"], "t-mm-s") << anim["units"]["fits"]["reason"];
    const nlohmann::json chosen = cli({"inspect", data + "frame-anim", "--json", "--set", "units=t-mm-s"}).json();
    EXPECT_EQ(chosen["units"]["system"], "t-mm-s");
    EXPECT_NEAR(chosen["mass_kg"].get<double>(), 1000.0 * anim["mass_kg"].get<double>(), 1e-6 * chosen["mass_kg"].get<double>())
        << "tonnes";
    const nlohmann::json d3plot = cli({"inspect", data + "frame-d3plot", "--json"}).json();
    EXPECT_EQ(d3plot["dead_total"], 43);
    std::vector<std::string> missing;
    for (const nlohmann::json& fact : d3plot["missing"]) {
        missing.push_back(fact["what"]);
    }
    EXPECT_THAT(missing, testing::ElementsAre("density", "thickness", "section", "death_time", "units"));
    EXPECT_EQ(d3plot["missing"][1]["elements"], 48);
    const Outcome text = cli({"inspect", data + "frame-d3plot"});
    EXPECT_THAT(text.out, HasSubstr("Not in the file"));
    EXPECT_THAT(text.out, HasSubstr("thickness of 48 elements"));
}

TEST_F(Series, ARunOfAFamilyIsVerifiedAlsoWhereItWasMovedTo) {
    fs::copy(data + "d3plot/lasso-written-mixed", m_folder / "family");
    const std::string run = m_folder / "run.h5";
    ASSERT_EQ(cli({"run", m_folder / "family", "--out", run, "--set", "settle_time=0.5"}).exitCode, 0);
    EXPECT_EQ(cli({"verify", run}).exitCode, 0);
    // Beside the run the whole family is found, by any of its names.
    for (const auto& file : fs::directory_iterator(m_folder / "family")) {
        fs::copy(file.path(), m_folder.path());
    }
    fs::remove_all(m_folder / "family");
    const Outcome beside = cli({"verify", run});
    EXPECT_EQ(beside.exitCode, 0) << beside.err;
    EXPECT_EQ(cli({"verify", run, "--fe", m_folder / "d3plot03"}).exitCode, 0);
    fs::remove(m_folder / "d3plot06");
    EXPECT_EQ(cli({"verify", run}).exitCode, 1) << "a member is missing";
}

}  // namespace

}  // namespace rubble::cli
