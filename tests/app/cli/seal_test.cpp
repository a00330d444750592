#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "io/case/case_file.h"
#include "io/run/run_file.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// The small collapse as a case with a run, sealed by the shipped program.
class SealCommand : public SmallRun {
protected:
    void SetUp() override {
        m_case = m_folder / "small.rubble";
        Case theCase = io::caseForFe(m_path, m_case);
        theCase.title = "Two blocks";
        theCase.scenarios[0].scenario.simulation.settleTime = 0.2;
        io::saveCase(m_case, theCase);
        ASSERT_EQ(cli({"run", m_case, "--out", m_out}).exitCode, 0);
        m_key = key("key.pem");
        const Outcome sealed = seal({"--by", "A. Engineer"});
        ASSERT_EQ(sealed.exitCode, 0) << sealed.err;
    }
    std::string key(const std::string& name) {
        EXPECT_EQ(CommandRun().run({"openssl", "genpkey", "-algorithm", "ed25519", "-out", m_folder / name}).exitCode, 0);
        return m_folder / name;
    }
    Outcome seal(std::vector<std::string> more) {
        std::vector<std::string> words{"seal", m_case, "--runs", m_out, "--key", m_key, "--out", m_bundle};
        words.insert(words.end(), more.begin(), more.end());
        // Without a display: report and page are drawn on one of their own.
        return CommandRun().with("DISPLAY", std::nullopt).cli(words);
    }
    std::size_t filesHere() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_folder.path()), fs::directory_iterator()));
    }

    std::string m_case, m_key;
    std::string m_bundle = m_folder / "small.rubblecase";
};

TEST_F(SealCommand, OpensAsItWasSealedAndItsRunIsEqual) {
    const Outcome opened = cli({"open-sealed", m_bundle});
    EXPECT_EQ(opened.exitCode, 0) << opened.err;
    EXPECT_THAT(opened.out, HasSubstr("as it was sealed; every run is equal"));
    EXPECT_THAT(opened.out, HasSubstr("by A. Engineer"));
    EXPECT_THAT(opened.out, HasSubstr("data/runs/small.run.h5: equal"));
    const nlohmann::json checked = cli({"open-sealed", m_bundle, "--no-run", "--json", "--signer", m_key + ".pub"}).json();
    EXPECT_TRUE(checked.contains("error")) << "the public key is not there";
    // The fingerprint that the sealing printed is what the other side compares.
    const nlohmann::json sealed = seal({"--json"}).json();
    const Outcome expected = cli({"open-sealed", m_bundle, "--no-run", "--signer", sealed["key_sha256"].get<std::string>()});
    EXPECT_EQ(expected.exitCode, 0) << expected.out;
    EXPECT_THAT(expected.out, HasSubstr("Not proven\n  seal/seal.tsr: there is no time stamp: the time of sealing is the "
                                        "signer's word\n"));
    EXPECT_THAT(expected.out, testing::Not(HasSubstr("nobody vouches")));
}

TEST_F(SealCommand, NamesWhatWasAlteredAndOpensNothing) {
    std::string bytes = textOf(m_bundle);
    bytes[bytes.find("Two blocks")] = 'X';
    std::ofstream(m_bundle, std::ios::binary) << bytes;
    const Outcome opened = cli({"open-sealed", m_bundle, "--into", m_folder / "opened"});
    EXPECT_EQ(opened.exitCode, 1);
    EXPECT_THAT(opened.out, HasSubstr("not as it was sealed"));
    EXPECT_FALSE(fs::exists(m_folder / "opened"));
    std::ofstream(m_bundle, std::ios::binary) << bytes.substr(0, bytes.size() / 2);
    const Outcome cut = cli({"open-sealed", m_bundle});
    EXPECT_EQ(cut.exitCode, 1);
    EXPECT_THAT(cut.err, HasSubstr("cut short"));
}

TEST_F(SealCommand, CustodyAndAddendumGoBesideWhatWasSealed) {
    const nlohmann::json first = cli({"custody", m_bundle, "--received-by", "B. Clerk", "--received-from", "A. Engineer", "--where",
                                      "court", "--why", "file 7", "--json"})
                                     .json();
    ASSERT_EQ(first["records"].size(), 1u);
    EXPECT_EQ(first["records"][0]["received_by"], "B. Clerk");
    ASSERT_EQ(cli({"open-sealed", m_bundle, "--no-run", "--into", m_folder / "opened"}).exitCode, 0);
    const std::string theirs = m_folder / "opened/small.rubble";
    Case changed = io::loadCase(theirs);
    changed.scenarios[0].scenario.simulation.friction = 0.3;
    io::saveCase(theirs, changed);
    ASSERT_EQ(cli({"run", theirs, "--out", m_folder / "theirs.run.h5"}).exitCode, 0);
    const Outcome added = cli({"addendum", m_bundle, theirs, "--key", key("their.pem"), "--by", "C. Expert", "--note", "wet stone",
                               "--runs", m_folder / "theirs.run.h5"});
    EXPECT_EQ(added.exitCode, 0) << added.err;
    EXPECT_THAT(added.out, HasSubstr("scenarios/scenario-1/settings/friction: nothing became 0.3"));
    const nlohmann::json opened =
        cli({"open-sealed", m_bundle, "--json", "--digest", first["head_sha256"].get<std::string>()}).json();
    EXPECT_EQ(opened["ok"], true) << opened.dump(1);
    EXPECT_EQ(opened["records"].size(), 2u);
    EXPECT_EQ(opened["runs"].size(), 2u);
    EXPECT_EQ(cli({"custody", m_bundle}).exitCode, 0);
    const Outcome half = cli({"custody", m_bundle, "--received-by", "D"});
    EXPECT_EQ(half.exitCode, 2);
    EXPECT_THAT(half.err, HasSubstr("--received-from"));
}

TEST_F(SealCommand, ATimeStampIsRequestedAndItsAnswerVerified) {
    const std::string request = m_folder / "small.tsq";
    EXPECT_EQ(cli({"time-stamp", m_bundle, "--request", request}).exitCode, 0);
    const Outcome read = CommandRun().run({"openssl", "ts", "-query", "-in", request, "-text"});
    EXPECT_EQ(read.exitCode, 0) << read.err;
    EXPECT_THAT(read.out, HasSubstr("Hash Algorithm: sha256"));
    EXPECT_EQ(cli({"time-stamp", m_bundle}).exitCode, 2);
    const Outcome damaged = cli({"time-stamp", m_bundle, "--answer", request});
    EXPECT_EQ(damaged.exitCode, 1);
    EXPECT_THAT(damaged.err, HasSubstr("no answer of a time-stamping service"));
    const std::string before = textOf(m_bundle);
    const std::size_t files = filesHere();
    const Outcome service = seal({"--stamp-with", "echo no service >&2; false"});
    EXPECT_EQ(service.exitCode, 1);
    EXPECT_THAT(service.err, HasSubstr("no service"));
    EXPECT_EQ(textOf(m_bundle), before);
    EXPECT_EQ(filesHere(), files);
}

// What was checked is told though the run cannot be simulated here.
TEST_F(SealCommand, AnInputThatStayedHomeIsNamedAndCanBeGiven) {
    ASSERT_EQ(seal({"--leave-out", "fe-1"}).exitCode, 0);
    const Outcome without = cli({"open-sealed", m_bundle});
    EXPECT_EQ(without.exitCode, 1);
    EXPECT_THAT(without.out, HasSubstr("as it was sealed, but a run could not be simulated"));
    EXPECT_THAT(without.out, HasSubstr("--input ID=FILE"));
    const Outcome with = cli({"open-sealed", m_bundle, "--input", "fe-1=" + m_path});
    EXPECT_EQ(with.exitCode, 0) << with.err;
    EXPECT_EQ(cli({"open-sealed", m_bundle, "--input", "fe-1=" + m_case}).exitCode, 2);
}

TEST_F(SealCommand, SaysWhatIsMissing) {
    const Outcome noKey = cli({"seal", m_case, "--out", m_folder / "b.rubblecase"});
    EXPECT_EQ(noKey.exitCode, 2);
    EXPECT_THAT(noKey.err, HasSubstr("openssl genpkey"));
    EXPECT_EQ(cli({"seal", m_path, "--key", m_key, "--out", m_folder / "b.rubblecase"}).exitCode, 1);
    const Outcome nothing = seal({"--add", m_folder / "none.csv"});
    EXPECT_EQ(nothing.exitCode, 1);
    EXPECT_THAT(nothing.err, HasSubstr("none.csv"));
    const Outcome onInput = cli({"seal", m_case, "--key", m_key, "--out", m_case});
    EXPECT_EQ(onInput.exitCode, 2);
}

TEST_F(SealCommand, ExportsAndReportsGoAlong) {
    std::ofstream(m_folder / "fragments.csv") << "fragment_id\n";
    std::ofstream(m_folder / "fragments.csv.provenance.json") << "{}\n";
    fs::create_directories(m_folder / "report/pictures");
    std::ofstream(m_folder / "report/report.html") << "<html>";
    std::ofstream(m_folder / "report/pictures/1.png") << "png";
    const Outcome sealed = seal({"--add", m_folder / "fragments.csv", "--report", m_folder / "report", "--make", "page", "--json"});
    ASSERT_EQ(sealed.exitCode, 0) << sealed.err;
    EXPECT_EQ(sealed.json()["made"], nlohmann::json::array({"data/page/1-small.html"}));
    ASSERT_EQ(cli({"open-sealed", m_bundle, "--no-run", "--into", m_folder / "opened"}).exitCode, 0);
    for (const char* place : {"exports/fragments.csv", "exports/fragments.csv.provenance.json", "report/report.html",
                              "report/pictures/1.png", "page/1-small.html", "build/build.txt"}) {
        EXPECT_TRUE(fs::exists(m_folder / "opened/small/data/" + place)) << place;
    }
}

// What is made is of the run, and what was given is not made again.
TEST_F(SealCommand, WhatTheRunLacksIsMade) {
    const std::size_t files = filesHere();
    const std::vector<std::string> both{"--make", "report,page", "--repeats", "0", "--self-test", "none", "--json"};
    const Outcome sealed = seal(both);
    ASSERT_EQ(sealed.exitCode, 0) << sealed.err;
    EXPECT_EQ(sealed.json()["made"], nlohmann::json::array({"data/report/1-small", "data/page/1-small.html"}));
    EXPECT_EQ(filesHere(), files) << "it lies in the bundle alone";
    ASSERT_EQ(cli({"open-sealed", m_bundle, "--no-run", "--into", m_folder / "opened"}).exitCode, 0);
    const std::string data = m_folder / "opened/small/data/";
    const std::string hash = io::openRun(m_out)->result()->trajectoryHash.hex();
    const std::string report = textOf(data + "report/1-small/report.html");
    EXPECT_THAT(report, HasSubstr("Two blocks"));
    EXPECT_THAT(report, HasSubstr(hash));
    EXPECT_TRUE(fs::exists(data + "report/1-small/report.pdf"));
    EXPECT_THAT(textOf(data + "page/1-small.html"), HasSubstr(hash));
    std::vector<std::string> given{"--page", data + "page/1-small.html", "--report", data + "report/1-small"};
    given.insert(given.end(), both.begin(), both.end());
    const Outcome again = seal(given);
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_EQ(again.json()["made"], nlohmann::json::array());
    const Outcome unknown = seal({"--make", "chart"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_THAT(unknown.err, HasSubstr("report or page"));
}

}  // namespace

}  // namespace rubble::cli
