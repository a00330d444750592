#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>

#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/study_comparison.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// Studies whose worlds others make, from a list of command lines.
class Executor : public testing::Test {
protected:
    Outcome run(std::vector<std::string> words, const std::string& cache) {
        words.insert(words.end(), {"--set", "settle_time=0.5", "--cache", m_folder / cache});
        return CommandRun().with("DISPLAY", std::nullopt).with("PATH", m_path).cli(words);
    }
    /// The list, the worlds one after the other, and what the same command says then.
    nlohmann::json listed(std::vector<std::string> words, std::size_t worlds) {
        words.insert(words.end(), {"--json", "--executor", "commands", "--tasks", m_tasks});
        const Outcome outcome = run(words, "listed");
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_EQ(outcome.json()["worlds"], worlds);
        EXPECT_EQ(outcome.json()["kept"], 0);
        const std::string text = textOf(m_tasks);
        EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), worlds);
        const Outcome made = CommandRun().run({"sh", "-c", "while read -r line; do sh -c \"$line\" || exit 1; done <" + m_tasks});
        EXPECT_EQ(made.exitCode, 0) << made.err;
        const Outcome collected = run(words, "listed");
        EXPECT_EQ(collected.exitCode, 0) << collected.err;
        return collected.json();
    }
    nlohmann::json local(std::vector<std::string> words) {
        words.push_back("--json");
        const Outcome outcome = run(words, "local");
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.json();
    }

    io::TemporaryFolder m_folder;
    std::string m_fe = writeSmallCollapse(m_folder / "small collapse.exo");
    std::string m_tasks = m_folder / "tasks";
    std::optional<std::string> m_path = std::string(std::getenv("PATH"));
};

TEST_F(Executor, AnAccuracySweepFromAListIsThatOfThisProgram) {
    const std::vector<std::string> words{"accuracy",       m_fe,       "--multiples", "1,2", "--set",
                                         "birth_window=0", "--no-fps", "--no-timing"};
    const nlohmann::json listed = this->listed(words, 5);  // multiple 1 is the reference
    EXPECT_EQ(listed["complete"], true);
    EXPECT_EQ(withoutTimes(listed), withoutTimes(local(words)));
}

TEST_F(Executor, InfluenceFromAListIsThatOfThisProgram) {
    const std::vector<std::string> words{"influence", m_fe, "--set", "water_level=1.5", "--effects", "water,ground"};
    EXPECT_EQ(withoutTimes(listed(words, 5)), withoutTimes(local(words)));
}

TEST_F(Executor, AnEnsembleFromAListIsThatOfThisProgram) {
    const std::vector<std::string> words{"ensemble", m_fe, "--members", "4", "--vary", "friction=uniform:0.1:0.9"};
    EXPECT_EQ(withoutTimes(listed(words, 4)), withoutTimes(local(words)));
}

TEST_F(Executor, AComparisonOfCausesGoesIntoOneList) {
    const std::string other = m_folder / "other.exo";
    io::ExodusBuilder builder = smallCollapse();
    for (Vec3& node : builder.nodes) {
        node.x() += 6.0;
    }
    builder.write(other);
    const std::vector<std::string> words{"compare", m_fe, other, "--members", "3", "--vary", "friction=uniform:0.3:0.5"};
    EXPECT_EQ(withoutTimes(listed(words, 6)), withoutTimes(local(words)));
}

TEST_F(Executor, AListThatRunsTwiceDoesNoHarm) {
    const std::vector<std::string> words{"ensemble", m_fe, "--members", "3"};
    const nlohmann::json first = listed(words, 3);
    std::map<std::string, std::string> before;
    for (const auto& entry : fs::directory_iterator(m_folder / "listed/worlds")) {
        before[entry.path().filename()] = textOf(entry.path());
    }
    const Outcome again = CommandRun().run({"sh", m_tasks});
    EXPECT_EQ(again.exitCode, 0) << again.err;
    for (const auto& entry : fs::directory_iterator(m_folder / "listed/worlds")) {
        EXPECT_EQ(before[entry.path().filename()], textOf(entry.path()));
    }
    EXPECT_EQ(local(words)["list"][2]["trajectory_hash"], first["list"][2]["trajectory_hash"]);
}

TEST_F(Executor, OnlyWhatIsMissingOrDamagedIsListedAgain) {
    const std::vector<std::string> words{"ensemble", m_fe, "--members", "3"};
    const nlohmann::json first = listed(words, 3);
    const fs::path damaged = fs::directory_iterator(m_folder / "listed/worlds")->path();
    fs::resize_file(damaged, fs::file_size(damaged) / 2);
    std::vector<std::string> again = words;
    again.insert(again.end(), {"--json", "--executor", "commands", "--tasks", m_tasks});
    const Outcome outcome = run(again, "listed");
    EXPECT_EQ(outcome.json()["kept"], 2) << outcome.err;
    EXPECT_THAT(textOf(m_tasks), HasSubstr(damaged.stem()));
    EXPECT_EQ(CommandRun().run({"sh", m_tasks}).exitCode, 0);
    EXPECT_EQ(withoutTimes(run(again, "listed").json()), withoutTimes(first));
}

TEST_F(Executor, AWorldOfAnotherStudyIsRefused) {
    const std::string key(32, '0');
    const Outcome outcome = run({"accuracy", m_fe, "--multiples", "2", "--world", key}, "cache");
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_THAT(outcome.err, HasSubstr("has no world " + key));
    EXPECT_THAT(outcome.err, HasSubstr("one build of Rubble"));
}

TEST_F(Executor, ATaskWithoutRoomFailsAndSaysWhy) {
    std::vector<std::string> words{"ensemble", m_fe, "--members", "2", "--executor", "commands", "--tasks", m_tasks};
    ASSERT_EQ(run(words, "full").exitCode, 0);
    const Outcome full = CommandRun().fileSizeLimit(64).run({"sh", m_tasks});
    EXPECT_EQ(full.exitCode, 1);
    EXPECT_THAT(full.err, HasSubstr("was not made"));
    // With room again the same line makes it.
    EXPECT_EQ(CommandRun().run({"sh", m_tasks}).exitCode, 0);
}

TEST_F(Executor, WithoutSlurmThereIsAClearMessage) {
    m_path = "/nonexistent";
    const Outcome outcome = run({"ensemble", m_fe, "--members", "2", "--executor", "slurm"}, "cache");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("Slurm is not installed here"));
    EXPECT_THAT(outcome.err, HasSubstr("--executor commands"));
}

TEST_F(Executor, OptionsThatDoNotGoTogetherAreRefused) {
    for (const std::vector<std::string>& more : {std::vector<std::string>{"--executor", "cloud"},
                                                 {"--executor", "commands"},
                                                 {"--tasks", m_tasks},
                                                 {"--detach"},
                                                 {"--sbatch=--partition=long", "--executor", "commands", "--tasks", m_tasks},
                                                 {"--world", "12"},
                                                 {"--world", std::string(32, 'a'), "--executor", "slurm"}}) {
        std::vector<std::string> words{"ensemble", m_fe};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run(words, "cache");
        EXPECT_EQ(outcome.exitCode, 2) << more.front();
        EXPECT_THAT(outcome.err, HasSubstr("--")) << more.front();
    }
    // The list never takes the place of what it is made from.
    EXPECT_NE(run({"ensemble", m_fe, "--executor", "commands", "--tasks", m_fe}, "cache").exitCode, 0);
    const std::string cache = m_folder / "cache";
    EXPECT_THAT(cli({"jobs", "wait", "--cache", cache}).err, HasSubstr("list, follow, cancel or clear"));
    EXPECT_EQ(cli({"jobs", "follow", "--cache", cache}).exitCode, 2) << "there is none to follow";
    const Outcome unknown = cli({"jobs", "follow", "0123456789ab", "--cache", cache});
    EXPECT_EQ(unknown.exitCode, 1);
    EXPECT_THAT(unknown.err, HasSubstr("There is no job 0123456789ab"));
}

}  // namespace

}  // namespace rubble::cli
