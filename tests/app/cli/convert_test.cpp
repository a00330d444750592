#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>

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

/// A result of so many states, replaced by the test while another process follows it.
struct Followed {
    std::string name;
    std::string opened;
    std::function<void(const io::TemporaryFolder& folder, std::size_t states)> write;
};

void PrintTo(const Followed& followed, std::ostream* out) {
    *out << followed.name;
}

class FollowedConvert : public Convert, public testing::WithParamInterface<Followed> {};

void followExodus(const io::TemporaryFolder& folder, std::size_t states) {
    io::ExodusBuilder builder = smallCollapse();
    builder.times.resize(states);
    builder.write(folder / "next");
    fs::rename(folder / "next", folder / "growing.exo");
}

/// Files of all states lie in another folder; those of the first ones are taken over.
void followGrids(const io::TemporaryFolder& folder, std::size_t states) {
    if (!fs::exists(folder / "all.pvd")) {
        ASSERT_EQ(cli({"convert", folder / "small.exo", folder / "all.pvd"}).exitCode, 0);
        fs::create_directory(folder / "growing");
    }
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
        if (entry.path().extension() == ".vtu" && entry.path().parent_path().filename() != "growing") {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    ASSERT_EQ(files.size(), 6u);
    for (std::size_t k = 0; k < states; ++k) {
        const fs::path file = fs::path(folder / "growing") / ("s" + std::to_string(k) + ".vtu");
        if (!fs::exists(file)) {
            fs::copy_file(files[k], folder / "next");
            fs::rename(folder / "next", file);
        }
    }
}

void followIndex(const io::TemporaryFolder& folder, std::size_t states) {
    followGrids(folder, states);
    std::string text = "<VTKFile type=\"Collection\"><Collection>";
    for (std::size_t k = 0; k < states; ++k) {
        text += "<DataSet timestep=\"0." + std::to_string(k) + "\" file=\"growing/s" + std::to_string(k) + ".vtu\"/>";
    }
    std::ofstream(folder / "next") << text << "</Collection></VTKFile>";
    fs::rename(folder / "next", folder / "growing.pvd");
}

TEST_P(FollowedConvert, SaysWhatHasCome) {
    const auto writeUpTo = [&](std::size_t states) { GetParam().write(m_folder, states); };
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
                const bool told = grown && textOf(out).find("now 6 states") != std::string::npos;
                if (!stopped && (told || std::chrono::steady_clock::now() - begun > std::chrono::minutes(2))) {
                    // A second one would end the program at once.
                    stopped = true;
                    ::kill(child, SIGINT);
                }
            })
            .run({"sh", "-c",
                  "exec " + cliPath() + " inspect " + m_folder / GetParam().opened + " --follow 0.1 --csv " + table + " > " + out});
    EXPECT_EQ(outcome.exitCode, 3) << outcome.err;
    EXPECT_THAT(textOf(out), HasSubstr("states, 0 dead: now 6 states to "));
    EXPECT_THAT(textOf(out), HasSubstr(GetParam().name == "Grids" ? "" : "now 6 states to 0.5 s"));
}

INSTANTIATE_TEST_SUITE_P(Formats, FollowedConvert,
                         testing::Values(Followed{"Exodus", "growing.exo", followExodus},
                                         Followed{"Grids", "growing/s0.vtu", followGrids},
                                         Followed{"Index", "growing.pvd", followIndex}),
                         [](const auto& followed) { return followed.param.name; });

}  // namespace

}  // namespace rubble::cli
