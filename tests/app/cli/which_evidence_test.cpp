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
    // Which of the two comes closest is chance: they cover the same ground.
    EXPECT_THAT(page, testing::AnyOf(HasSubstr("the evidence cannot tell it from west"),
                                     HasSubstr("the evidence cannot tell it from east")));
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

/// Two tables whose bodies come to lie alike; in one the last fall two seconds later.
class TimeAsEvidence : public testing::Test {
protected:
    void SetUp() override {
        write("soon", 0.0);
        write("late", 2.0);
    }
    void write(const std::string& name, double after) {
        std::ofstream table(m_folder / (name + ".csv"));
        table << "mass_kg,side_x_m,side_y_m,side_z_m,x_m,y_m,z_m,time_s\n2400,1,1,1,0,0,2,0\n";
        for (int k = 0; k < 3; ++k) {
            table << "2400,1,1,1,30," << 3 * k << ",2," << after << '\n';
        }
    }
    nlohmann::json compare(const std::string& time) {
        const Outcome outcome = cli({"compare", m_folder / "soon.csv", m_folder / "late.csv", "--members", "10", "--against", time,
                                     "--cache", m_folder / "cache", "--json"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.json();
    }
    io::TemporaryFolder m_folder;
};

TEST_F(TimeAsEvidence, NamesTheCauseAndSaysWhereNoneFits) {
    const nlohmann::json told = compare("time=2.1,30,3,6");
    EXPECT_TRUE(told["told_apart"].get<bool>()) << told["words"];
    EXPECT_EQ(told["closest"], "late");
    EXPECT_EQ(told["evidence"][0]["kind"], "time");
    EXPECT_FALSE(told["unexplained"].get<bool>());
    EXPECT_TRUE(compare("time=9,30,3,6")["unexplained"].get<bool>());
    EXPECT_FALSE(compare("time=1,30,3,6,3")["told_apart"].get<bool>()) << "within its accuracy both are right";
}

TEST_F(TimeAsEvidence, IsRankedWithItsAccuracy) {
    const Outcome told = cli({"compare", m_folder / "soon.csv", m_folder / "late.csv", "--members", "10", "--which-evidence",
                              "--cache", m_folder / "cache", "--json"});
    ASSERT_EQ(told.exitCode, 0) << told.err;
    const nlohmann::json first = told.json()["further_evidence"]["ranked"][0];
    EXPECT_EQ(first["kind"], "time");
    EXPECT_EQ(first["accuracy_s"], 0.5);
    EXPECT_EQ(first["right"], 20);
}

TEST_F(TimeAsEvidence, IsSaidOfEachMember) {
    const auto ensemble = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"ensemble", m_folder / "late.csv", "--members", "3", "--cache", m_folder / "cache"});
        return cli(more);
    };
    const Outcome said = ensemble({"--reached", "30,3,6", "--reached", "-40,0", "--json"});
    ASSERT_EQ(said.exitCode, 0) << said.err;
    const nlohmann::json reached = said.json()["reached"];
    ASSERT_EQ(reached.size(), 2u);
    // A fall of a metre takes 0.45 s for all, so two seconds stay between them; frames are 1/24 s apart.
    EXPECT_NEAR(reached[0]["time_s"]["mean"].get<double>(), 2.0, 0.1);
    EXPECT_EQ(reached[0]["members_s"].size(), 3u);
    EXPECT_EQ(reached[1]["radius_m"], 5.0);
    EXPECT_TRUE(reached[1]["members_s"][0].is_null()) << "none came there";
    EXPECT_THAT(ensemble({"--reached", "30,3"}).out, HasSubstr("When debris first lies there"));
}

TEST_F(TimeAsEvidence, RefusesWhatIsNoTime) {
    for (const char* time : {"time=", "time=4", "time=4,1", "time=4,1,x", "time=-1,0,0", "time=4,0,0,0", "time=4,0,0,1,-1",
                             "time=4,0,0,1,1,1", "time=nan,0,0", "time=inf,0,0"}) {
        const Outcome outcome = cli({"compare", m_folder / "soon.csv", m_folder / "late.csv", "--against", time});
        EXPECT_EQ(outcome.exitCode, 2) << time;
        EXPECT_THAT(outcome.err, HasSubstr("time=SECONDS,X,Y")) << time;
    }
    for (const char* place : {"", "3", "3,x", "3,4,0", "1,2,3,4"}) {
        EXPECT_EQ(cli({"ensemble", m_folder / "soon.csv", "--reached", place}).exitCode, 2) << place;
    }
}

}  // namespace

}  // namespace rubble::cli
