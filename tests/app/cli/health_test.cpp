#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A run that falls out of its site because there is no ground, and one that does not.
class Health : public testing::Test {
protected:
    nlohmann::json run(const std::vector<std::string>& more = {}) {
        std::vector<std::string> words{"run", m_path, "--out", m_out, "--json"};
        words.insert(words.end(), more.begin(), more.end());
        m_outcome = cli(words);
        EXPECT_EQ(m_outcome.exitCode, 0) << m_outcome.err;
        return m_outcome.json();
    }
    nlohmann::json fall() { return run({"--set", "ground=off", "--set", "settle_time=6"}); }

    io::TemporaryFolder m_folder;
    std::string m_path = writeSmallCollapse(m_folder / "small.exo");
    std::string m_out = m_folder / "small.run.h5";
    std::string m_sidecar = m_out + ".acknowledged.json";
    Outcome m_outcome;
};

TEST_F(Health, ASoundRunIsNotTainted) {
    const nlohmann::json object = run({"--set", "settle_time=2"});
    EXPECT_EQ(object["tainted"], false) << object["health"].dump(1);
    EXPECT_TRUE(object["health"]["breaches"].empty());
    EXPECT_TRUE(object["acknowledged"].is_null());
    EXPECT_GT(object["health"]["contacts_peak"], 0);
    EXPECT_EQ(m_outcome.err, "");
    const Outcome refused = cli({"acknowledge", m_out, "--by", "Ada", "--note", "fine"});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.err, HasSubstr("no health breaches"));
    EXPECT_FALSE(fs::exists(m_sidecar));
}

TEST_F(Health, ABreachTaintsTheRunUntilItIsAcknowledged) {
    const nlohmann::json object = fall();
    EXPECT_EQ(object["tainted"], true);
    ASSERT_FALSE(object["health"]["breaches"].empty());
    const nlohmann::json& breach = object["health"]["breaches"].back();
    EXPECT_EQ(breach["check"], "outside_site") << object["health"].dump(1);
    EXPECT_GT(breach["worst"], breach["limit"]);
    EXPECT_EQ(breach["to_s"], object["time_end_s"]);
    EXPECT_EQ(breach["worst_at_s"], breach["to_s"]) << "it flies further and further";
    EXPECT_EQ(breach["place_m"].size(), 3u);
    EXPECT_EQ(breach["grade"], "tainted");
    EXPECT_THAT(breach["why"].get<std::string>(), HasSubstr("nothing of this collapse falls there"));
    EXPECT_EQ(breach["times_s"].size(), 1u);
    EXPECT_EQ(breach["times_s"][0][1], breach["to_s"]);
    EXPECT_EQ(object["cautions"][0]["key"], "tainted");
    EXPECT_THAT(object["cautions"][0]["text"].get<std::string>(), HasSubstr("nobody vouches"));
    EXPECT_THAT(m_outcome.err, HasSubstr("nobody has acknowledged"));
    EXPECT_THAT(m_outcome.err, HasSubstr("rubble-cli acknowledge " + m_out));

    const std::string table = m_folder / "f.csv";
    const Outcome tainted = cli({"export", m_out, "--export", "fragments=" + table});
    EXPECT_EQ(tainted.exitCode, 0);
    EXPECT_THAT(tainted.err, HasSubstr("nobody has acknowledged"));
    EXPECT_EQ(nlohmann::json::parse(textOf(table + ".provenance.json"))["health"]["tainted"], true);
    EXPECT_EQ(nlohmann::json::parse(textOf(table + ".provenance.json"))["cautions"][0]["key"], "tainted");
    const Outcome map = cli({"map", m_out, "--out", m_folder / "m.tif", "--json"});
    EXPECT_EQ(map.json()["cautions"][0]["key"], "tainted") << map.err;

    const Outcome done = cli({"acknowledge", m_out, "--by", "Ada", "--note", "no ground on purpose", "--json"});
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_EQ(done.json()["tainted"], false);
    EXPECT_EQ(done.json()["acknowledged"]["by"], "Ada");
    EXPECT_EQ(done.json()["sidecar"], m_sidecar);

    const Outcome clean = cli({"export", m_out, "--export", "fragments=" + table, "--json"});
    EXPECT_EQ(clean.err, "");
    EXPECT_EQ(clean.json()["tainted"], false);
    const nlohmann::json provenance = nlohmann::json::parse(textOf(table + ".provenance.json"));
    EXPECT_EQ(provenance["health"]["acknowledged"]["note"], "no ground on purpose");
    EXPECT_EQ(cli({"verify", m_out}).exitCode, 0) << "the run file is untouched";

    EXPECT_EQ(fall()["tainted"], false) << "the same run made anew is the same run";
    EXPECT_EQ(run({"--set", "ground=off", "--set", "settle_time=5.5"})["tainted"], true) << "another one is not";
}

TEST_F(Health, TheReportListsTheBreaches) {
    const Outcome summary = cli({"run", m_path, "--set", "ground=off", "--set", "settle_time=6"});
    EXPECT_EQ(summary.exitCode, 0);
    EXPECT_THAT(summary.out, HasSubstr("not acknowledged: "));
    EXPECT_THAT(summary.out, HasSubstr("first to do"));
    EXPECT_THAT(summary.out, Not(HasSubstr("outside_site"))) << "words, not names of checks";
    const Outcome outcome = cli({"run", m_path, "--set", "ground=off", "--set", "settle_time=6", "--tables"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.out, HasSubstr("passed, tainted"));
    EXPECT_THAT(outcome.out, HasSubstr("outside_site"));
    EXPECT_THAT(outcome.out, HasSubstr("from the structure"));
    EXPECT_THAT(outcome.err, HasSubstr("nobody has acknowledged"));
}

TEST_F(Health, WrongRequestsSaySo) {
    fall();
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{{"acknowledge", m_out},
                                                                                       {"acknowledge", m_out, "--by", "Ada"},
                                                                                       {"acknowledge", m_out, "--note", "fine"},
                                                                                       {"acknowledge"}}) {
        EXPECT_EQ(cli(words).exitCode, 2);
    }
    EXPECT_EQ(cli({"acknowledge", m_path, "--by", "Ada", "--note", "fine"}).exitCode, 1) << "no run";
    EXPECT_EQ(cli({"acknowledge", m_folder / "none", "--by", "Ada", "--note", "fine"}).exitCode, 1);
    std::ofstream(m_sidecar) << "{\"format\": ";
    const Outcome garbage = cli({"acknowledge", m_out, "--by", "Ada", "--note", "fine"});
    EXPECT_EQ(garbage.exitCode, 1);
    EXPECT_THAT(garbage.err, HasSubstr(m_sidecar));
    const Outcome exported = cli({"export", m_out, "--export", "fragments=" + (m_folder / "f.csv")});
    EXPECT_EQ(exported.exitCode, 0) << "what cannot be read acknowledges nothing, and keeps nobody from exporting";
    EXPECT_THAT(exported.err, HasSubstr(m_sidecar));
}

}  // namespace

}  // namespace rubble::cli
