#include "io/run/checkpoint_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/analysis/accuracy/settled_world.h"
#include "core/base/error.h"
#include "io/base/machine.h"
#include "io/fe/fe_copy/fe_cache.h"
#include "io/run/settled_files.h"
#include "io/run/world_record.h"
#include "tests/scenes/fe_scenes.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

namespace fs = std::filesystem;

class Interval {
public:
    explicit Interval(const char* seconds) { ::setenv("RUBBLE_CHECKPOINT_SECONDS", seconds, 1); }
    ~Interval() { ::unsetenv("RUBBLE_CHECKPOINT_SECONDS"); }
};

TEST(CheckpointFile, KeepsTheLatestOne) {
    const TemporaryFolder folder;
    const std::string path = folder / "deep/down/one.checkpoint";
    CheckpointFile file(path);
    EXPECT_FALSE(file.latest()) << "and no folder is needed for that";
    file.keep("first");
    file.keep(std::string("se\0cond", 7));
    EXPECT_EQ(CheckpointFile(path).latest(), std::string("se\0cond", 7));
    EXPECT_EQ(file.interval(), checkpointInterval);
    file.remove();
    EXPECT_FALSE(file.latest());
    file.remove();
}

TEST(CheckpointFile, SaysWhenThereIsNoRoom) {
    const TemporaryFolder folder;
    std::ofstream(folder / "no_folder") << "a file";
    CheckpointFile file(folder / "no_folder/one.checkpoint");
    EXPECT_FALSE(file.latest());
    EXPECT_THROW(file.keep("first"), WorldError);
}

TEST(CheckpointFile, ClearsAwayWhatKilledProcessesLeftHalfWritten) {
    const TemporaryFolder folder;
    const std::string path = folder / "one.checkpoint";
    const auto age = [](const std::string& file, std::chrono::minutes minutes) {
        fs::last_write_time(file, fs::file_time_type::clock::now() - minutes);
    };
    for (const char* name : {"one.checkpoint.77-0.part", "one.checkpoint.78-0.part", "other.checkpoint.77-0.part", "one.txt"}) {
        std::ofstream(folder / name) << "half";
        age(folder / name, std::chrono::minutes(60));
    }
    age(folder / "one.checkpoint.78-0.part", std::chrono::minutes(1));
    CheckpointFile(path).latest();
    EXPECT_FALSE(fs::exists(folder / "one.checkpoint.77-0.part"));
    EXPECT_TRUE(fs::exists(folder / "one.checkpoint.78-0.part")) << "it may be being written";
    EXPECT_TRUE(fs::exists(folder / "other.checkpoint.77-0.part"));
    EXPECT_TRUE(fs::exists(folder / "one.txt"));
}

TEST(CheckpointSeconds, ComeFromTheEnvironment) {
    EXPECT_EQ(checkpointSeconds(), checkpointInterval);
    {
        const Interval interval("2.5");
        EXPECT_EQ(checkpointSeconds(), 2.5);
    }
    {
        const Interval interval("");
        EXPECT_EQ(checkpointSeconds(), checkpointInterval);
    }
    for (const char* wrong : {"0", "-1", "often", "1e999", "nan", "2,5"}) {
        const Interval interval(wrong);
        EXPECT_THROW(checkpointSeconds(), UsageError) << wrong;
    }
}

/// A world of a study in a folder, which other processes may be simulating.
class KilledWorld : public testing::Test {
protected:
    void SetUp() override {
        Scenario scenario;
        scenario.simulation.settleTime = 20.0;
        scenario.simulation.freeze = false;
        scenario.simulation.stepRate = 1000.0;  // a second of wall time
        const Inputs inputs{scenes::collapsingWall(5, 4), {}};
        const Results results = run(inputs, scenario, Stage::Clusters, {}, nullptr, Execution());
        m_description = describeRun(inputs, scenario, results);
        m_origin = originOf(inputs, scenario, 0, 0.0, "this machine");
    }
    SettledWorld simulate() {
        const std::unique_ptr<CheckpointStore> checkpoints = m_files.checkpoints(m_origin);
        return simulateSettled(m_description, Execution().withThreads(1), checkpoints.get());
    }
    /// Bytes of a world but for its figures of time.
    std::string bytesOf(SettledWorld settled) const {
        settled.world.wallSeconds = settled.world.stepMeanMs = settled.world.stepWorstMs = 0.0;
        return worldBytes(m_origin, settled.world);
    }
    std::string checkpoint() const { return m_files.worlds().checkpointPath(m_origin); }
    /// Simulates in a process that is killed with this signal once there is another checkpoint than before.
    void simulateUntilKilled() {
        std::error_code ignored;
        const auto before = fs::last_write_time(checkpoint(), ignored);
        const pid_t child = ::fork();
        if (child == 0) {
            simulate();
            ::_exit(0);
        }
        int status = 0;
        while (true) {
            ASSERT_EQ(::waitpid(child, &status, WNOHANG), 0) << "it was done before it left another checkpoint";
            const auto now = fs::last_write_time(checkpoint(), ignored);
            if (!ignored && now != before) {
                break;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        ::kill(child, SIGKILL);
        ::waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status)) << "it was done before it could be killed";
    }

    TemporaryFolder m_folder;
    SettledFiles m_files{m_folder.path()};
    RunDescription m_description;
    WorldOrigin m_origin;
};

TEST_F(KilledWorld, GoesOnInsideAndEndsBitForBit) {
    const SettledWorld whole = simulateSettled(m_description, Execution().withThreads(1));
    const Interval interval("0.03");
    for (int times = 0; times < 4; ++times) {
        simulateUntilKilled();
        ASSERT_TRUE(fs::exists(checkpoint()));
    }
    const SettledWorld resumed = simulate();
    ASSERT_TRUE(resumed.world.checkpoints.resumedAt);
    EXPECT_GT(*resumed.world.checkpoints.resumedAt, 0.1) << "inside, after the first hand-over";
    EXPECT_GT(resumed.world.wallSeconds, resumed.world.checkpoints.secondsBefore);
    EXPECT_GE(resumed.world.checkpoints.secondsBefore, 0.12) << "four processes of at least one interval";
    EXPECT_EQ(resumed.world.trajectoryHash, whole.world.trajectoryHash);
    EXPECT_EQ(bytesOf(resumed), bytesOf(whole));
    ASSERT_EQ(resumed.islands.size(), whole.islands.size());
    EXPECT_FALSE(whole.islands.empty()) << "the beam lives and falls on";
    for (std::size_t i = 0; i < whole.islands.size(); ++i) {
        EXPECT_EQ(resumed.islands[i].elements, whole.islands[i].elements);
        EXPECT_EQ(resumed.islands[i].moved.position, whole.islands[i].moved.position);
        EXPECT_EQ(resumed.islands[i].moved.orientation.coeffs(), whole.islands[i].moved.orientation.coeffs());
    }
    // What is done needs no checkpoint.
    EXPECT_TRUE(fs::exists(checkpoint()));
    m_files.keep(m_origin, resumed);
    EXPECT_FALSE(fs::exists(checkpoint()));
}

TEST_F(KilledWorld, IsMadeAnewWhereItsCheckpointIsDamaged) {
    const SettledWorld whole = simulateSettled(m_description, Execution().withThreads(1));
    const Interval interval("0.03");
    simulateUntilKilled();
    fs::resize_file(checkpoint(), fs::file_size(checkpoint()) / 2);
    const SettledWorld anew = simulate();
    EXPECT_FALSE(anew.world.checkpoints.resumedAt);
    EXPECT_EQ(anew.world.checkpoints.findings.count("simulation.checkpoint_damaged"), 1);
    EXPECT_EQ(bytesOf(anew), bytesOf(whole));
}

TEST_F(KilledWorld, LeavesACheckpointThatCountsAsCache) {
    const Interval interval("0.03");
    simulateUntilKilled();
    const std::vector<CacheEntry> entries = cacheEntries(m_folder.path());
    ASSERT_EQ(entries.size(), 1u);
    EXPECT_EQ(entries.front().kind, "checkpoints");
    EXPECT_EQ(entries.front().bytes, fs::file_size(checkpoint()));
    clearCache(m_folder.path(), {"checkpoints"});
    EXPECT_FALSE(fs::exists(checkpoint()));
}

}  // namespace
}  // namespace rubble::io
