#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

class Effects : public testing::Test {
protected:
    nlohmann::json json(const std::string& command, std::vector<std::string> more) {
        more.insert(more.begin(), {command, m_path, "--json"});
        const Outcome outcome = cli(std::move(more));
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.json();
    }
    static nlohmann::json of(const nlohmann::json& object, const std::string& effect) {
        for (const nlohmann::json& row : object["effects"]) {
            if (row["effect"] == effect) {
                return row;
            }
        }
        ADD_FAILURE() << effect;
        return {};
    }

    io::TemporaryFolder m_folder;
    std::string m_path = writeSmallCollapse(m_folder / "small.exo");
};

TEST_F(Effects, EveryOneHasAStateAndAReason) {
    const nlohmann::json object = json("effects", {});
    ASSERT_EQ(object["effects"].size(), 8u);
    for (const nlohmann::json& row : object["effects"]) {
        EXPECT_EQ(row["asked"], "auto");
        EXPECT_TRUE(row["state"] == "on" || row["state"] == "off");
        EXPECT_FALSE(row["reason"].get<std::string>().empty());
    }
    EXPECT_EQ(of(object, "ground")["state"], "on");
    EXPECT_EQ(of(object, "water")["state"], "off");
}

TEST_F(Effects, ASettingIsObeyedAndSaysWhatAutoWouldDo) {
    const nlohmann::json ground = of(json("effects", {"--set", "ground=false"}), "ground");
    EXPECT_EQ(ground["asked"], "off");
    EXPECT_EQ(ground["state"], "off");
    EXPECT_THAT(ground["reason"].get<std::string>(), HasSubstr("auto would be on"));
    EXPECT_EQ(of(json("effects", {"--set", "water_level=100"}), "water")["state"], "on");
}

TEST_F(Effects, HeldIsSaidNotToHoldWhatTheEngineCarries) {
    const auto said = [this](std::vector<std::string> more) {
        const nlohmann::json object = json("effects", std::move(more));
        for (const nlohmann::json& finding : object["warnings"]) {
            if (finding["id"] == "effect.not_held") {
                EXPECT_THAT(finding["remedy"].get<std::string>(), HasSubstr("loose_structure = fe"));
                return true;
            }
        }
        return false;
    };
    EXPECT_FALSE(said({}));
    EXPECT_TRUE(said({"--set", "live_islands=held"}));
    EXPECT_FALSE(said({"--set", "live_islands=held", "--set", "loose_structure=fe"}));
}

TEST_F(Effects, ARunDecidesTheSameAndSaysWhatEachCost) {
    const nlohmann::json before = json("effects", {"--set", "settle_time=0.2"});
    const nlohmann::json run = json("run", {"--set", "settle_time=0.2"});
    ASSERT_EQ(run["effects"].size(), before["effects"].size());
    for (const nlohmann::json& row : run["effects"]) {
        EXPECT_EQ(row["state"], of(before, row["effect"])["state"]) << row["effect"];
        EXPECT_EQ(row["reason"], of(before, row["effect"])["reason"]) << row["effect"];
        if (row["state"] == "off") {
            EXPECT_EQ(row["ms_per_step"], 0.0) << row["effect"];
        }
    }
}

TEST_F(Effects, ARunShowsTheAccountOfAStep) {
    const nlohmann::json run = json("run", {"--set", "settle_time=2"});
    const nlohmann::json& costs = run["ms_per_step_costs"];
    double effects = 0.0;
    for (const nlohmann::json& row : run["effects"]) {
        effects += row["ms_per_step"].get<double>();
    }
    const double measured = run["ms_per_step_all"];
    const double sum = costs["sum"];
    EXPECT_NEAR(costs["effects"], effects, 1e-12);
    EXPECT_NEAR(sum, effects + run["ms_per_step_rest"].get<double>(), 1e-12);
    EXPECT_EQ(costs["measured"], measured);
    EXPECT_NEAR(costs["difference_percent"], 100.0 * (sum - measured) / measured, 1e-9);
    EXPECT_GT(costs["recording"], 0.0);
    const Outcome text = cli({"run", m_path, "--set", "settle_time=2", "--tables"});
    for (const char* row :
         {"motion, freezing", "health monitor", "bookkeeping", "measured step", "differs from the measured step by"}) {
        EXPECT_THAT(text.out, HasSubstr(row));
    }
}

TEST_F(Effects, TheTableGoesToAFile) {
    const std::string file = m_folder / "effects.csv";
    const Outcome outcome = cli({"effects", m_path, "--csv", file});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("air_drag is "));
    EXPECT_EQ(cli({"effects", m_path, "--set", "pair[stone,siol].friction=1"}).exitCode, 2);
}

}  // namespace

}  // namespace rubble::cli
