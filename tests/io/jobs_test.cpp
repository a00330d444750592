#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/jobs/job_record.h"
#include "io/jobs/program.h"
#include "io/jobs/slurm_jobs.h"
#include "tests/io/temporary_folder.h"

namespace rubble::io {

namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

JobRecord twoTasks() {
    JobRecord record;
    record.study = "ensemble";
    record.subject = "/a/case of mine.rubble";
    record.islands = true;
    record.cpus = 4;
    record.sbatchOptions = {"--partition=long"};
    for (const char* key : {"b1", "a2"}) {
        JobTask& task = record.tasks.emplace_back();
        task.key = key;
        task.name = std::string("member ") + key;
        task.command = "cd '/with space' && exec make " + task.key;
        task.slurm = "12_" + task.key;
        task.bodies = 77;
        task.attempts = 2;
        task.minutes = 20;
        task.mebibytes = 1024;
        task.failure = "out of memory";
    }
    record.id = jobId(record.tasks);
    return record;
}

TEST(Program, WordsGoThroughTheShellAsTheyAre) {
    const std::vector<std::string> words{"plain-1.5", "", "with space", "it's", "$HOME `x` \"y\" \\z", "ä;|&<>*?"};
    std::vector<std::string> all{"printf", "<%s>"};
    all.insert(all.end(), words.begin(), words.end());
    const auto outcome = runProgram({"sh", "-c", shellLine(all)});
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->out, "<plain-1.5><><with space><it's><$HOME `x` \"y\" \\z><ä;|&<>*?>");
}

TEST(Program, TellsHowItEnded) {
    const auto outcome = runProgram({"sh", "-c", "echo out; echo err >&2; exit 7"});
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->exitCode, 7);
    EXPECT_EQ(outcome->out, "out\n");
    EXPECT_EQ(outcome->err, "err\n");
    EXPECT_EQ(runProgram({"sh", "-c", "kill -9 $$"})->exitCode, -1);
    EXPECT_FALSE(runProgram({"no-such-program-anywhere"}));
    // More than a pipe holds, on both at once.
    const auto much = runProgram({"sh", "-c", "head -c 300000 /dev/zero; head -c 300000 /dev/zero >&2"});
    EXPECT_EQ(much->out.size(), 300000u);
    EXPECT_EQ(much->err.size(), 300000u);
}

TEST(JobRecord, ComesBackAsItWasKept) {
    const TemporaryFolder folder;
    const JobRecord record = twoTasks();
    keepJob(folder.path(), record);
    const JobRecord back = loadJob(folder.path(), record.id);
    EXPECT_EQ(back.study, record.study);
    EXPECT_EQ(back.subject, record.subject);
    EXPECT_EQ(back.islands, true);
    EXPECT_EQ(back.cpus, 4);
    EXPECT_EQ(back.sbatchOptions, record.sbatchOptions);
    ASSERT_EQ(back.tasks.size(), 2u);
    EXPECT_EQ(back.tasks[0].command, record.tasks[0].command);
    EXPECT_EQ(back.tasks[1].slurm, "12_a2");
    EXPECT_EQ(back.tasks[1].attempts, 2);
    EXPECT_EQ(back.tasks[1].minutes, 20);
    EXPECT_EQ(back.tasks[1].mebibytes, 1024);
    EXPECT_EQ(back.tasks[1].failure, "out of memory");
    EXPECT_EQ(jobIds(folder.path()), std::vector<std::string>{record.id});
}

TEST(JobRecord, IsNamedByItsWorldsWhateverTheirOrder) {
    JobRecord record = twoTasks();
    std::swap(record.tasks[0], record.tasks[1]);
    EXPECT_EQ(jobId(record.tasks), twoTasks().id);
    record.tasks.pop_back();
    EXPECT_NE(jobId(record.tasks), twoTasks().id);
}

TEST(JobRecord, DamageAndAbsenceAreSaidWithTheirPlace) {
    const TemporaryFolder folder;
    EXPECT_THROW(loadJob(folder.path(), "0123456789ab"), WorldError);
    EXPECT_THROW(loadJob(folder.path(), "../../etc"), WorldError);
    const JobRecord record = twoTasks();
    keepJob(folder.path(), record);
    const std::string path = folder / ("jobs/" + record.id + "/record.json");
    const auto size = fs::file_size(path);
    for (const auto cut : {size / 3, size / 2, std::uintmax_t{0}}) {
        fs::resize_file(path, cut);
        EXPECT_THROW(loadJob(folder.path(), record.id), ParseError);
    }
    std::ofstream(path) << R"({"version": 2})";
    try {
        loadJob(folder.path(), record.id);
        FAIL() << "a newer version";
    } catch (const ParseError& error) {
        EXPECT_THAT(error.what(), HasSubstr("record.json"));
    }
}

TEST(JobRecord, AWorldCountsOnlyWithItsIslandsWhereTheyAreNeeded) {
    const TemporaryFolder folder;
    JobRecord record = twoTasks();
    fs::create_directories(folder / "worlds");
    fs::create_directories(folder / "islands");
    std::ofstream(folder / "worlds/b1.world") << "x";
    EXPECT_FALSE(isMade(folder.path(), record, record.tasks[0]));
    record.islands = false;
    EXPECT_TRUE(isMade(folder.path(), record, record.tasks[0]));
    EXPECT_FALSE(isMade(folder.path(), record, record.tasks[1]));
    record.islands = true;
    std::ofstream(folder / "islands/b1.json") << "{}";
    EXPECT_TRUE(isMade(folder.path(), record, record.tasks[0]));
}

TEST(JobNeeds, GrowWithBodiesAndFallWithThreads) {
    StudyTask small;
    small.bodies = 5000;
    StudyTask large;
    large.bodies = 50000;
    const JobNeeds one = expectedNeeds({small, large}, 20.0, 1);
    EXPECT_DOUBLE_EQ(expectedNeeds({small, large}, 20.0, 4).seconds, one.seconds / 4.0);
    EXPECT_DOUBLE_EQ(expectedNeeds({small}, 20.0, 1).seconds, one.seconds / 10.0);
    EXPECT_GT(one.bytes, expectedNeeds({small}, 20.0, 1).bytes);
    // The reference of the stone arch: 340 ms a step on two threads, 60 steps a second.
    EXPECT_NEAR(one.seconds, 20.0 * 60.0 * 2.0 * 0.34, 0.05 * one.seconds);
}

}  // namespace

}  // namespace rubble::io
