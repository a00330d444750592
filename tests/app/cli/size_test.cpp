#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

class Size : public testing::Test {
protected:
    nlohmann::json size(std::vector<std::string> more) {
        more.insert(more.begin(), {"size", m_path, "--json"});
        const Outcome outcome = cli(std::move(more));
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.json();
    }

    io::TemporaryFolder m_folder;
    std::string m_path = writeSmallCollapse(m_folder / "small.exo");
};

// A result of microseconds: the window of collapses of seconds joins all of its births, and says so with what fits.
TEST_F(Size, TellsThatBirthsOfABlastAreJoined) {
    io::ExodusBuilder builder = smallCollapse();
    for (double& time : builder.times) {
        time *= 1.4e-4;
    }
    m_path = m_folder / "blast.exo";
    builder.write(m_path);
    const auto told = [this](std::vector<std::string> more) {
        const nlohmann::json sized = size(std::move(more));
        for (const nlohmann::json& warning : sized["warnings"]) {
            if (warning["id"] == "fragments.birth_window") {
                return warning.dump();
            }
        }
        return std::string();
    };
    EXPECT_THAT(told({}), HasSubstr("deaths of 2 states become debris at 1, up to 1.4e-05 s early"));
    EXPECT_THAT(told({}), HasSubstr("Set birth_window to a hundredth of that, 7e-07 s"));
    EXPECT_EQ(told({"--set", "birth_window=7e-7"}), "");
}

TEST_F(Size, JsonHasTheDocumentedKeys) {
    const nlohmann::json object = size({});
    EXPECT_EQ(object["fragments"], smallDead);
    EXPECT_EQ(object["fps_target"], 24.0);
    EXPECT_EQ(object["bodies_max"], 4500);
    for (const char* axis : {"x", "y", "z"}) {
        EXPECT_TRUE(object["mean_distance"][axis].is_number());
        EXPECT_TRUE(object["multiple"][axis].is_number());
        EXPECT_TRUE(object["clamped_by"][axis].is_string());
        for (const char* bound : {"h_eff_min", "h_acc_min", "h_acc_max"}) {
            EXPECT_TRUE(object["bounds"][axis][bound].is_number()) << axis << ' ' << bound;
        }
    }
    // Cubes of 1 m; the smallest component is 1 m in y and z.
    EXPECT_NEAR(object["bounds"]["x"]["h_acc_min"], 1.0, 1e-6);
    EXPECT_NEAR(object["bounds"]["x"]["h_acc_max"], 3.0, 1e-6);
    EXPECT_NEAR(object["bounds"]["z"]["h_acc_max"], 1.0, 1e-6);
    for (const char* edge : {"l", "w", "h"}) {
        EXPECT_GT(object["grid"][edge], 0.0);
    }
    EXPECT_EQ(object["stopped_by"], "efficiency");
    EXPECT_LE(object["clusters"], smallDead);
}

TEST_F(Size, SaysWhatMovesBesideTheBodiesThatAreAllowed) {
    const nlohmann::json object = size({});
    // Both blocks of three fall; at 0.1 s one cube of the six lives on for good.
    EXPECT_GT(object["loose_beside"]["elements"], 0);
    EXPECT_LE(object["loose_beside"]["elements"], 6);
    EXPECT_GE(object["loose_beside"]["islands"], 1);
    EXPECT_LE(object["loose_beside"]["time_s"], 0.5);
    EXPECT_THAT(object["warnings"].dump(), HasSubstr("sizing.loose_beside"));
    const Outcome told = cli({"size", m_path});
    EXPECT_THAT(told.out, HasSubstr("fragments alone"));
    EXPECT_THAT(told.out, HasSubstr("loose_structure = fe"));
    const nlohmann::json byFe = size({"--set", "loose_structure=fe"});
    EXPECT_TRUE(byFe["loose_beside"].is_null());
    EXPECT_THAT(byFe["warnings"].dump(), testing::Not(HasSubstr("sizing.loose_beside")));
    EXPECT_THAT(cli({"size", m_path, "--set", "loose_structure=fe"}).out, testing::Not(HasSubstr("fragments alone")));
}

TEST_F(Size, TheMultipleCanBeSetByHand) {
    const nlohmann::json object = size({"--set", "multiple=2"});
    EXPECT_EQ(object["stopped_by"], "user");
    EXPECT_EQ(object["common_multiple"], 2.0);
}

TEST_F(Size, OneBodyForEachFragmentCountsThemAll) {
    EXPECT_EQ(size({"--set", "one_body_per_fragment=true"})["clusters"], smallDead);
}

TEST_F(Size, TheTableNamesEveryBoundAndWhatStoppedTheSearch) {
    const Outcome outcome = cli({"size", m_path});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const char* word :
         {"h_eff_min", "h_acc_min", "h_acc_max", "clamped by", "stopped by", "largest fragment", "smallest component"}) {
        EXPECT_THAT(outcome.out, HasSubstr(word));
    }
}

TEST_F(Size, BothArchesEndOutOfReachOfTheTargetAlongAxesAndWithinItNested) {
    for (const char* arch : {"stone-arch", "rc-arch"}) {
        const std::string path = sourcePath(std::string("resources/samples/") + arch + ".exo");
        const Outcome nested = cli({"size", path, "--json"});
        ASSERT_EQ(nested.exitCode, 0) << nested.err;
        EXPECT_EQ(nested.json()["stopped_by"], "efficiency") << arch;
        EXPECT_LE(nested.json()["clusters"], 4500) << arch;
        const Outcome outcome = cli({"size", path, "--json", "--set", "grouping=axes"});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        const nlohmann::json object = outcome.json();
        EXPECT_EQ(object["stopped_by"], "fps_unreachable") << arch;
        EXPECT_GT(object["clusters"], 4500) << arch;
        EXPECT_LT(object["fps_reachable"], 24.0) << arch;
        EXPECT_FALSE(object["warnings"].empty()) << arch;
    }
}

}  // namespace

}  // namespace rubble::cli
