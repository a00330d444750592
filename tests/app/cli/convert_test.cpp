#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Convert : public testing::Test {
protected:
    io::TemporaryFolder m_folder;
    const std::string m_fe = writeSmallCollapse(m_folder / "small.exo");
};

TEST_F(Convert, EveryTargetIsTheSameCollapseToInspect) {
    const nlohmann::json original = cli({"inspect", m_fe, "--json"}).json();
    for (const std::string ending : {".exo", ".pvd", ".h5"}) {
        const std::string out = m_folder / "out" + ending;
        const Outcome outcome = cli({"convert", m_fe, out, "--json"});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        const nlohmann::json object = outcome.json();
        EXPECT_EQ(object["written"][0], out);
        EXPECT_EQ(object["states"], 6);
        EXPECT_EQ(object["from"], "Exodus II");
        EXPECT_GT(object["written_bytes"], 1000);
        const nlohmann::json converted = cli({"inspect", out, "--json"}).json();
        for (const char* key :
             {"nodes", "elements", "states", "time_last_s", "dead_per_state", "components", "mass_kg", "dead_mass_kg"}) {
            EXPECT_EQ(converted[key], original[key]) << ending << " " << key;
        }
    }
}

TEST_F(Convert, RefusesToWriteOverAnythingUnlessForced) {
    const std::string out = m_folder / "there.h5";
    std::ofstream(out) << "mine";
    const Outcome refused = cli({"convert", m_fe, out});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.err, HasSubstr("--force"));
    EXPECT_EQ(textOf(out), "mine");
    EXPECT_EQ(cli({"convert", m_fe, out, "--force"}).exitCode, 0);
    EXPECT_EQ(cli({"inspect", out}).exitCode, 0);
    EXPECT_EQ(cli({"convert", m_fe, m_fe, "--force"}).exitCode, 2);
    EXPECT_EQ(cli({"convert", m_fe, m_folder / "out.stl"}).exitCode, 2);
    EXPECT_EQ(cli({"inspect", m_fe}).exitCode, 0);
}

TEST_F(Convert, AFullDiskIsAClearErrorAndNothingElse) {
    for (const std::string ending : {".exo", ".pvd", ".h5"}) {
        const std::string out = m_folder / "full" + ending;
        const Outcome outcome = CommandRun().fileSizeLimit(3000).cli({"convert", m_fe, out});
        EXPECT_EQ(outcome.exitCode, 1) << ending;
        EXPECT_THAT(outcome.err, HasSubstr("File too large")) << ending;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 2) << ending << ": " << outcome.err;
        EXPECT_FALSE(fs::exists(out)) << ending;
    }
}

// Nobody can make a file there, whatever his rights.
TEST_F(Convert, WhereNothingCanBeMadeTheNameAskedForAndTheReasonAreSaid) {
    const std::string file = m_folder / "file";
    std::ofstream(file) << "no folder";
    for (const std::string ending : {".exo", ".pvd", ".h5"}) {
        const Outcome system = cli({"convert", m_fe, "/proc/rubble_out" + ending});
        EXPECT_EQ(system.exitCode, 1) << ending;
        EXPECT_THAT(system.err, HasSubstr(ending == ".pvd" ? "/proc/rubble_out: No such file"
                                                           : "/proc/rubble_out" + ending + ": No such file"));
        EXPECT_EQ(system.err.find(".part"), std::string::npos) << system.err;
        const Outcome below = cli({"convert", m_fe, file + "/out" + ending});
        EXPECT_EQ(below.exitCode, 1) << ending;
        EXPECT_THAT(below.err, testing::AllOf(HasSubstr(file), HasSubstr("Not a directory"))) << ending;
    }
    fs::create_directory(m_folder / "folder.exo");
    const Outcome folder = cli({"convert", m_fe, m_folder / "folder.exo", "--force"});
    EXPECT_NE(folder.exitCode, 0);
    EXPECT_THAT(folder.err, HasSubstr("folder.exo\" is not the name of a file"));
}

TEST_F(Convert, CachedResultsAreTheSameAndListed) {
    const std::string cache = m_folder / "cache";
    const auto run = [&](std::vector<std::string> words) { return CommandRun().with("RUBBLE_CACHE", cache).cli(std::move(words)); };
    const nlohmann::json plain = run({"size", m_fe, "--json"}).json();
    EXPECT_EQ(run({"size", m_fe, "--json", "--cached"}).json(), plain);
    EXPECT_EQ(run({"size", m_fe, "--json", "--cached"}).json(), plain);
    nlohmann::json list = run({"cache", "list", "--json"}).json();
    EXPECT_EQ(list["cache"], cache);
    ASSERT_EQ(list["entries"].size(), 1u);
    EXPECT_EQ(list["entries"][0]["kind"], "fe");
    EXPECT_EQ(list["entries"][0]["of"], m_fe);
    EXPECT_GT(list["bytes"], 1000);
    EXPECT_THAT(run({"cache", "list"}).out, HasSubstr("small.exo"));
    EXPECT_EQ(run({"cache", "clear", "--only", "worlds", "--json"}).json()["entries"].size(), 0u);
    EXPECT_EQ(run({"cache", "clear", "--json"}).json()["entries"].size(), 1u);
    EXPECT_EQ(run({"cache", "list", "--json"}).json()["bytes"], 0);
}

TEST_F(Convert, FollowSaysWhatHasCome) {
    const auto writeUpTo = [&](std::size_t states) {
        io::ExodusBuilder builder = smallCollapse();
        builder.times.resize(states);
        builder.write(m_folder / "next");
        fs::rename(m_folder / "next", m_folder / "growing.exo");
    };
    writeUpTo(3);
    const std::string out = m_folder / "out.txt", table = m_folder / "table.csv";
    bool grown = false, stopped = false;
    const auto begun = std::chrono::steady_clock::now();
    const Outcome outcome =
        CommandRun()
            .meanwhile([&](pid_t child) {
                // The table is there: the first report is done.
                if (!grown && fs::exists(table)) {
                    writeUpTo(6);
                    grown = true;
                }
                const bool told = grown && textOf(out).find("+3 states") != std::string::npos;
                if (!stopped && (told || std::chrono::steady_clock::now() - begun > std::chrono::minutes(2))) {
                    // A second one would end the program at once.
                    stopped = true;
                    ::kill(child, SIGINT);
                }
            })
            .run({"sh", "-c",
                  "exec " + cliPath() + " inspect " + m_folder / "growing.exo" + " --follow 0.1 --csv " + table + " > " + out});
    EXPECT_EQ(outcome.exitCode, 3) << outcome.err;
    EXPECT_THAT(textOf(out), HasSubstr("+3 states, 0 dead: now 6 states to 0.5 s"));
}

}  // namespace

}  // namespace rubble::cli
