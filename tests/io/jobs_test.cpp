#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/analysis/accuracy/prediction.h"
#include "core/base/build.h"
#include "core/base/error.h"
#include "io/jobs/distributed_study.h"
#include "io/jobs/job_record.h"
#include "io/jobs/program.h"
#include "io/jobs/slurm_jobs.h"
#include "tests/support/temporary_folder.h"

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
    record.request = {"--multiples", "1,2", "--vary", "friction=0.3,0.5"};
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
    EXPECT_EQ(back.request, record.request);
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

TEST(JobRecord, TheNewestOfAStudyAndOfThisBuildIsFound) {
    const TemporaryFolder folder;
    const auto any = [](const JobRecord&) { return true; };
    EXPECT_FALSE(newestJob(folder.path(), "ensemble", any));
    JobRecord record = twoTasks();
    keepJob(folder.path(), record);
    EXPECT_FALSE(newestJob(folder.path(), "ensemble", any)) << "of another build";
    record.build = std::string(buildText());
    keepJob(folder.path(), record);
    JobRecord damaged = record;
    damaged.id = "0123456789ab";
    keepJob(folder.path(), damaged);
    std::ofstream(folder / "jobs/0123456789ab/record.json") << "{";
    ASSERT_TRUE(newestJob(folder.path(), "ensemble", any));
    EXPECT_EQ(newestJob(folder.path(), "ensemble", any)->id, record.id);
    EXPECT_FALSE(newestJob(folder.path(), "accuracy", any));
    EXPECT_FALSE(newestJob(folder.path(), "ensemble", [](const JobRecord&) { return false; }));
    // A record of an older program does not say what was asked for.
    std::stringstream text;
    text << std::ifstream(folder / ("jobs/" + record.id + "/record.json")).rdbuf();
    nlohmann::json document = nlohmann::json::parse(text.str());
    document.erase("request");
    std::ofstream(folder / ("jobs/" + record.id + "/record.json")) << document;
    EXPECT_TRUE(loadJob(folder.path(), record.id).request.empty());
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

StudyTask taskWith(std::int64_t bodies) {
    StudyTask task;
    task.bodies = bodies;
    task.fragments = 60000;
    task.span = 4.0;
    task.collapse = 20.0;
    task.reference.key.bytes[0] = 7;
    return task;
}

TEST(DistributedStudy, ListsWhatTheStoreLacksAndRemovesWhatOnlyLooksLikeIt) {
    const TemporaryFolder folder;
    DistributedStudy study;
    study.name = "accuracy";
    study.store = folder.path();
    for (const std::uint8_t key : std::initializer_list<std::uint8_t>{1, 2, 1}) {
        StudyTask& task = study.tasks.emplace_back(taskWith(10));
        task.origin.key.bytes[0] = key;
        task.name = "world " + std::to_string(key);
    }
    study.request = {"--multiples", "", "--vary", "cluster_shape=hull"};
    study.setCommand("/opt/rubble cli/rubble-cli", "/jobs/it's.rubble");
    study.kept = [](const WorldOrigin& origin) { return origin.key.bytes[0] == 1; };
    fs::create_directories(folder / "worlds");
    const std::string damaged = folder / ("worlds/" + study.tasks[1].origin.key.hex() + ".world");
    std::ofstream(damaged) << "x";
    const std::vector<JobTask> missing = missingTasks(study, Execution());
    ASSERT_EQ(missing.size(), 1u);
    EXPECT_EQ(missing[0].name, "world 2");
    EXPECT_FALSE(fs::exists(damaged));
    EXPECT_EQ(study.jobTasks().size(), 2u) << "each world once";
    EXPECT_EQ(missing[0].command,
              "'/opt/rubble cli/rubble-cli' accuracy --multiples '' --vary cluster_shape=hull --threads 1 --cache " +
                  folder.path() + " --world " + missing[0].key + " -- '/jobs/it'\\''s.rubble'");
}

TEST(JobNeeds, GrowWithBodiesAndFallWithThreads) {
    const TemporaryFolder folder;
    const StudyFiles nothing(folder.path());
    const StudyTask small = taskWith(5000);
    const StudyTask large = taskWith(50000);
    const JobNeeds one = expectedNeeds({small, large}, 1, nothing, "here");
    EXPECT_EQ(one.predicted, 0u);
    EXPECT_DOUBLE_EQ(expectedNeeds({small, large}, 4, nothing, "here").seconds, one.seconds / 4.0);
    EXPECT_DOUBLE_EQ(expectedNeeds({small}, 1, nothing, "here").seconds, one.seconds / 10.0);
    EXPECT_GT(one.bytes, expectedNeeds({small}, 1, nothing, "here").bytes);
    // The reference of the stone arch: 340 ms a step on two threads, 60 steps a second.
    EXPECT_NEAR(one.seconds, 20.0 * 60.0 * 2.0 * 0.34, 0.05 * one.seconds);
}

TEST(JobNeeds, ArePredictedFromEarlierPointsOfTheSceneAndFromTheCalibration) {
    const TemporaryFolder folder;
    StudyFiles files(folder.path());
    const StudyTask task = taskWith(5000);
    constexpr int measuredWith = 2;
    for (const std::int64_t bodies : {1000, 2000, 4000, 6000, 8000}) {
        StudyTask earlier = taskWith(bodies);
        KnownPoint point = openPoint(earlier, "here", measuredWith);
        point.values[static_cast<std::size_t>(Predicted::WallSeconds)] = 0.02 * static_cast<double>(bodies);
        files.keep(point);
    }
    const JobNeeds one = expectedNeeds({task}, 1, files, "here");
    EXPECT_EQ(one.predicted, 1u);
    // 100 s with two threads: at most twice that with one, and the interval's upper end.
    EXPECT_GT(one.seconds, 200.0);
    EXPECT_LT(one.seconds, 200.0 * 1.5);
    EXPECT_NEAR(expectedNeeds({task}, measuredWith, files, "here").seconds, one.seconds / 2.0, 1e-9);
    // Another machine or another scene says nothing: then the rule holds.
    const double byRule = expectedNeeds({task}, 1, StudyFiles(folder / "empty"), "here").seconds;
    EXPECT_DOUBLE_EQ(expectedNeeds({task}, 1, files, "elsewhere").seconds, byRule);
    StudyTask other = task;
    other.reference.key.bytes[0] = 8;
    EXPECT_EQ(expectedNeeds({other}, 1, files, "here").predicted, 0u);
    // Only the curve of the machine is left.
    Calibration calibration;
    calibration.machine = "here";
    calibration.threads = measuredWith;
    calibration.othersShare = 0.0;
    calibration.complete = true;
    for (const std::int64_t bodies : {1000, 2000, 4000, 8000}) {
        for (const PileKind pile : {PileKind::Typical, PileKind::Worst}) {
            const double fps = (pile == PileKind::Worst ? 2.5e4 : 5e4) / static_cast<double>(bodies);
            calibration.points.push_back({pile, bodies, fps, fps, fps});
        }
    }
    files.keep(calibration);
    const JobNeeds curved = expectedNeeds({other}, 1, files, "here");
    EXPECT_EQ(curved.predicted, 1u);
    // 5 frames a second of the worst pile, 24 asked for, span and settling at most.
    EXPECT_GT(curved.seconds, 4.0 * 24.0 / 10.0);
    EXPECT_LT(curved.seconds, 2.0 * (4.0 + other.scenario.simulation.settleTime) * 24.0 / 5.0 * 2.0);
}

}  // namespace

}  // namespace rubble::io
