#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iterator>

#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

class InfluenceCommand : public testing::Test {
protected:
    std::vector<std::string> words(std::vector<std::string> more) const {
        more.insert(more.begin(), {"influence", m_path, "--set", "settle_time=0.5", "--set", "one_body_per_fragment=true",
                                   "--cache", m_folder / "cache"});
        return more;
    }
    io::TemporaryFolder m_folder;
    std::string m_path = writeSmallCollapse(m_folder / "small.exo");
};

TEST_F(InfluenceCommand, JsonHoldsRunFloorAndEffects) {
    const Outcome outcome =
        cli(words({"--json", "--set", "water_level=1.5", "--effects", "water,ties", "--tolerances", "0.05,0.5"}));
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json object = outcome.json();
    EXPECT_EQ(object["complete"], true);
    EXPECT_EQ(object["instant"], "rest");
    EXPECT_EQ(object["base"]["fragments"], smallDead);
    EXPECT_NEAR(object["base"]["mass_kg"], smallDead * 2000.0, 1e-3);
    ASSERT_EQ(object["repeat_floor"]["repeats"].size(), 2u);
    EXPECT_NE(object["repeat_floor"]["repeats"][0]["trajectory_hash"], object["base"]["trajectory_hash"]);
    ASSERT_EQ(object["effects"].size(), 2u);
    const nlohmann::json& water = object["effects"][0];
    EXPECT_EQ(water["effect"], "water");
    EXPECT_EQ(water["state"], "on");
    EXPECT_EQ(water["done"], true);
    EXPECT_TRUE(water["cannot"].is_null());
    EXPECT_GT(water["difference"]["median_distance_m"], 0.0);
    ASSERT_EQ(water["difference"]["accuracy_rate"].size(), 2u);
    EXPECT_EQ(water["difference"]["accuracy_rate"][1]["tolerance_m"], 0.5);
    const nlohmann::json& ties = object["effects"][1];
    EXPECT_EQ(ties["switchable"], false);
    EXPECT_THAT(ties["cannot"].get<std::string>(), HasSubstr("reinforced"));
}

TEST_F(InfluenceCommand, TheTableSaysWhatStandsAgainstTheFloor) {
    const std::string csv = m_folder / "influence.csv";
    const Outcome outcome = cli(words({"--instant", "fe_end", "--repeats", "3", "--threads", "1", "--csv", csv}));
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const char* text : {"Debris at the end of the FE result", "Repeat floor", "floor: worst of all pairs", "seed 4",
                             "terrain (off): cannot be switched", "footprint IoU", "within 0.2 m"}) {
        EXPECT_THAT(outcome.out, HasSubstr(text));
    }
    const std::string table = textOf(csv);
    EXPECT_EQ(
        table.substr(0, table.find('\n')),
        "effect,state,standing,mass_map_difference,core_iou,footprint_iou,run_out_m,height_rms_m,mean_height_m,centroid_shift_m,"
        "median_distance_m");
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 9) << "eight effects and the heading";
}

TEST_F(InfluenceCommand, RefusesWhatItDoesNotKnow) {
    const std::vector<std::vector<std::string>> wrong{{"--effects", "wind"},     {"--effects", "water,"}, {"--repeats", "1"},
                                                      {"--repeats", "two"},      {"--threads", "0"},      {"--instant", "noon"},
                                                      {"--tolerances", "0.1,0"}, {"--tolerances", "nan"}};
    for (const std::vector<std::string>& option : wrong) {
        const Outcome outcome = cli(words(option));
        EXPECT_EQ(outcome.exitCode, 2) << option[0] << ' ' << option[1];
        EXPECT_THAT(outcome.err, HasSubstr(option[0]));
    }
}

/// Threads of a process. A case is opened on one; worlds are simulated on threads of their own.
std::ptrdiff_t threadsOf(pid_t process) {
    std::error_code gone;
    const std::filesystem::directory_iterator threads("/proc/" + std::to_string(process) + "/task", gone);
    return gone ? 0 : std::distance(begin(threads), end(threads));
}

TEST_F(InfluenceCommand, CtrlCEndsItWithWhatIsDone) {
    bool sent = false;
    const auto interrupt = [&](pid_t program) {
        if (!sent && catches(program, SIGINT) && threadsOf(program) > 1) {
            sent = kill(program, SIGINT) == 0;
        }
    };
    // A million steps and more for each world.
    const Outcome outcome = CommandRun().meanwhile(interrupt).cli(
        words({"--json", "--threads", "2", "--set", "freeze=false", "--set", "settle_time=1000", "--set", "step_rate=10000"}));
    EXPECT_EQ(outcome.exitCode, 3) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("cancelled"));
    const nlohmann::json object = outcome.json();
    EXPECT_EQ(object["cancelled"], true);
    EXPECT_EQ(object["complete"], false);
}

}  // namespace

}  // namespace rubble::cli
