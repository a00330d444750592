#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/command_run.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

/// Two heaps of blocks that cover the same ground: one is higher at its east end.
class WhichEvidence : public testing::Test {
protected:
    void SetUp() override {
        write("east", 10, 16.0);
        write("west", 4, 3.0);
    }
    void write(const std::string& name, int high, double at) {
        std::ofstream table(m_folder / (name + ".csv"));
        table << "mass_kg,side_x_m,side_y_m,side_z_m,x_m,y_m,z_m\n";
        for (int i = 0; i < 12; ++i) {
            for (int j = 0; j < 4; ++j) {
                table << "2400,1,1,1," << 1.6 * i << ',' << 1.6 * j << ",1\n";
            }
        }
        for (int k = 0; k < high; ++k) {
            table << "2400,1,1,1," << at << ",2.4," << 3.0 + 1.3 * k << '\n';
        }
    }
    Outcome compare(std::vector<std::string> words) {
        words.insert(words.begin(), {"compare", m_folder / "east.csv", m_folder / "west.csv", "--members", "10", "--which-evidence",
                                     "--cache", m_folder / "cache"});
        return cli(words);
    }
    io::TemporaryFolder m_folder;
};

TEST_F(WhichEvidence, IsRankedWithWhatIsAtHandAndGoesIntoTheReport) {
    const Outcome plain = compare({});
    ASSERT_EQ(plain.exitCode, 0) << plain.err;
    EXPECT_THAT(plain.out, HasSubstr("Which evidence would tell east, west apart"));
    EXPECT_THAT(plain.out, HasSubstr("flattered by chance"));
    const std::string run = m_folder / "east.run.h5";
    ASSERT_EQ(cli({"run", m_folder / "east.csv", "--out", run}).exitCode, 0);
    ASSERT_EQ(cli({"export", run, "--export", "footprint=" + (m_folder / "found.gpkg")}).exitCode, 0);
    const Outcome told = compare({"--against", "footprint=" + (m_folder / "found.gpkg"), "--json"});
    ASSERT_EQ(told.exitCode, 0) << told.err;
    const nlohmann::json further = told.json()["further_evidence"];
    EXPECT_FALSE(told.json()["told_apart"].get<bool>()) << "both cover the same ground";
    EXPECT_EQ(further["at_hand"]["trials"], 20);
    EXPECT_EQ(further["at_hand"]["right"], 0);
    EXPECT_EQ(further["ranked"][0]["words"], "heights of all debris");
    EXPECT_EQ(further["ranked"][0]["right"], 20);
    for (const nlohmann::json& row : further["ranked"]) {
        EXPECT_NE(row["kind"], "footprint") << "that is at hand";
    }
    const std::string compared = m_folder / "causes.json";
    std::ofstream(compared) << told.out;
    const Outcome report = cli({"report", run, "--out", m_folder / "report", "--causes", compared, "--repeats", "0", "--self-test",
                                "none", "--cache", m_folder / "cache"});
    ASSERT_EQ(report.exitCode, 0) << report.err;
    const std::string page = textOf(m_folder / "report/report.html");
    EXPECT_THAT(page, HasSubstr("the evidence cannot tell it from west"));
    EXPECT_THAT(page, HasSubstr("<td class=\"w\">and heights of all debris</td><td>100 %</td>"));
    // What else is a JSON file is refused by name.
    std::ofstream(compared) << "{\"run\": 1}";
    const Outcome refused = cli({"report", run, "--check", "--causes", compared, "--cache", m_folder / "cache"});
    EXPECT_NE(refused.exitCode, 0);
    EXPECT_THAT(refused.err, testing::AllOf(HasSubstr("causes.json"), HasSubstr("compare")));
}

TEST_F(WhichEvidence, IsNotLookedForUnasked) {
    const Outcome told =
        cli({"compare", m_folder / "east.csv", m_folder / "west.csv", "--members", "2", "--cache", m_folder / "cache", "--json"});
    ASSERT_EQ(told.exitCode, 0) << told.err;
    EXPECT_TRUE(told.json()["further_evidence"].is_null());
}

}  // namespace

}  // namespace rubble::cli
