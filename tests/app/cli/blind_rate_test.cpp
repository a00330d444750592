#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/support/command_run.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

/// tests/blind/blind_rate.py, which hides causes and says how often they are found.
class BlindRate : public testing::Test {
protected:
    /// @param causes  their files
    /// @param more    further words
    nlohmann::json collapses(const std::vector<std::string>& causes, const std::vector<std::string>& more) {
        std::vector<std::string> words{"python3", sourcePath("tests/blind/blind_rate.py"), cliPath()};
        words.insert(words.end(), causes.begin(), causes.end());
        words.insert(words.end(), {"--cache", m_folder / "cache", "--json", m_folder / "found.json"});
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = CommandRun().run(words);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        m_table = outcome.out;
        return nlohmann::json::parse(textOf(m_folder / "found.json"));
    }
    static int count(const nlohmann::json& collapses, const std::string& key, const nlohmann::json& value) {
        return static_cast<int>(std::ranges::count_if(collapses, [&](const nlohmann::json& each) { return each[key] == value; }));
    }

    io::TemporaryFolder m_folder;
    std::string m_table;
};

/// A floor of blocks and a pile on it.
std::string writeHeap(const std::string& path, double at) {
    std::ofstream table(path);
    table << "mass_kg,side_x_m,side_y_m,side_z_m,x_m,y_m,z_m\n";
    for (int i = 0; i < 12; ++i) {
        for (int j = 0; j < 4; ++j) {
            table << "2400,1,1,1," << 1.6 * i << ',' << 1.6 * j << ",1\n";
        }
    }
    for (int k = 0; k < 10; ++k) {
        table << "2400,1,1,1," << at << ",2.4," << 3.0 + 1.3 * k << '\n';
    }
    return path;
}

TEST_F(BlindRate, OfThreeHeapsNoneIsNamedWronglyAndWhatIsLeftOutIsMissed) {
    const nlohmann::json found = collapses(
        {writeHeap(m_folder / "west.csv", 1.0), writeHeap(m_folder / "middle.csv", 9.0), writeHeap(m_folder / "east.csv", 16.0)},
        {"--collapses", "3", "--noise", "0"});
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(count(found, "truth", "west"), 1) << "each cause in turn";
    EXPECT_EQ(count(found, "truth", "east"), 1);
    EXPECT_EQ(count(found, "answer", "wrong"), 0) << m_table;
    EXPECT_GE(count(found, "answer", "right"), 1) << m_table;
    EXPECT_THAT(m_table, HasSubstr("| all | 3 |"));
    EXPECT_THAT(m_table, HasSubstr("Right when it answers: 100 %"));
    // Heaps of ten equal blocks scatter: one may be taken for a neighbour.
    const int noticed = count(found, "noticed", true);
    EXPECT_GE(noticed, 2) << m_table;
    EXPECT_THAT(m_table, HasSubstr(std::string("None of these, where the true cause was left out: ") +
                                   (noticed == 3 ? "100 % (44 to 100)" : "67 % (21 to 94)")))
        << "Wilson (1927)";
}

// The manual's table, with the criteria that the method has to hold.
TEST_F(BlindRate, WholeOfTheStoneBridgeAnswersAreRight) {
    std::vector<std::string> causes;
    for (const char* cause : {"west", "both", "pier", "crown"}) {
        causes.push_back(buildPath("tests/fe/causes/") + cause + ".exo");
    }
    const nlohmann::json found = collapses(
        causes, {"--collapses", "40", "--set", "bodies_max=300", "--set", "settle_time=1", "--set", "loose_structure=at_once"});
    ASSERT_EQ(found.size(), 40U);
    const int right = count(found, "answer", "right");
    const int wrong = count(found, "answer", "wrong");
    EXPECT_GE(right, 9 * (right + wrong) / 10.0) << m_table;
    EXPECT_LE(wrong, 0.02 * 40) << m_table;
    EXPECT_GE(right, 20) << "one that never answers is never wrong\n" << m_table;
    EXPECT_GE(count(found, "noticed", true), 36) << m_table;
}

}  // namespace

}  // namespace rubble::cli
