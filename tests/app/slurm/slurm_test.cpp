#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <future>
#include <optional>
#include <sstream>
#include <thread>

#include "tests/app/slurm/one_node.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/study_comparison.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// Sweeps on a Slurm of one node with two processors.
class SlurmSweep : public testing::Test {
protected:
    void TearDown() override { OneNode::restore(); }
    static std::string slurm(const std::vector<std::string>& words) { return OneNode::slurm(words); }
    static std::string node() { return OneNode::node(); }
    static std::size_t tasksIn(const std::string& state) { return OneNode::tasksIn(state); }
    static void drain() { OneNode::drain(); }
    static void resume() { OneNode::resume(); }

    /// A sweep of six worlds, each of which takes a second or two.
    std::vector<std::string> sweep(std::vector<std::string> more, const std::string& cache = "cache") const {
        more.insert(more.begin(),
                    {"accuracy", m_fe, "--multiples", "1,2", "--no-fps", "--no-timing", "--json", "--set", "settle_time=20",
                     "--set", "freeze=false", "--set", "step_rate=4000", "--set", "substeps=8", "--cache", m_folder / cache});
        return more;
    }
    Outcome onSlurm(std::function<void(pid_t)> meanwhile = {}, std::vector<std::string> more = {}) {
        more.insert(more.end(), {"--executor", "slurm"});
        return CommandRun().meanwhile(std::move(meanwhile)).cli(sweep(more));
    }
    nlohmann::json local() { return cli(sweep({}, "local")).json(); }
    std::size_t made() const {
        std::error_code ignored;
        std::size_t count = 0;
        for (fs::directory_iterator it(m_folder / "cache/worlds", ignored), end; it != end; it.increment(ignored)) {
            count += it->path().extension() == ".world";
        }
        return count;
    }
    nlohmann::json jobs() const { return cli({"jobs", "list", "--json", "--cache", m_folder / "cache"}).json()["jobs"]; }

    /// A task of this sweep that runs, with the process that makes its world.
    struct Running {
        std::string task;  ///< "12_3"
        pid_t process = -1;
    };
    /// @param wanted  "12_3"; empty: any
    std::optional<Running> running(const std::string& wanted = {}) const {
        std::error_code ignored;
        for (fs::directory_iterator it("/proc", ignored), end; it != end; it.increment(ignored)) {
            // Processes come and go: what cannot be read is not ours.
            const auto read = [&](const char* name) {
                const std::ifstream stream(it->path() / name, std::ios::binary);
                std::ostringstream text;
                text << stream.rdbuf();
                return text.str();
            };
            const std::string words = read("cmdline");
            const std::string variables = read("environ");
            const bool ours = words.find("--world") != std::string::npos && words.find(m_folder / "cache") != std::string::npos &&
                              words.find("rubble-cli") < words.find('\0');
            const auto variable = [&](const std::string& name) {
                const std::size_t at = variables.find('\0' + name + '=');
                return at == std::string::npos ? std::string() : std::string(variables.c_str() + at + name.size() + 2);
            };
            const std::string task = variable("SLURM_ARRAY_JOB_ID") + "_" + variable("SLURM_ARRAY_TASK_ID");
            if (ours && (wanted.empty() ? task != "_" : task == wanted)) {
                return Running{task, static_cast<pid_t>(std::stoi(it->path().filename()))};
            }
        }
        return {};
    }
    /// Memory of a process in use; 0 if there is no such process.
    static double residentMiB(pid_t process) {
        std::ifstream stream("/proc/" + std::to_string(process) + "/statm");
        double all = 0.0, resident = 0.0;
        stream >> all >> resident;
        return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
    }
    /// Keeps a process from going on, whoever wakes it up.
    static void hold(pid_t process) {
        if (process > 0) {
            kill(process, SIGSTOP);
        }
    }
    /// What was asked for the world of which a value is this, "slurm" or "key", in its latest submission; null if there is none.
    nlohmann::json task(const char* name, const nlohmann::json& value) const {
        const nlohmann::json all = tasks();
        const auto found = std::find_if(all.begin(), all.end(), [&](const nlohmann::json& each) { return each[name] == value; });
        return found == all.end() ? nlohmann::json() : *found;
    }
    nlohmann::json tasks() const { return record()["tasks"]; }
    nlohmann::json record() const {
        return nlohmann::json::parse(textOf(m_folder / ("cache/jobs/" + jobs()[0]["job"].get<std::string>() + "/record.json")));
    }

    io::TemporaryFolder m_folder;
    std::string m_fe = writeSmallCollapse(m_folder / "small.exo");
};

TEST_F(SlurmSweep, ANodeDrainedHalfWayDelaysItAndChangesNoBit) {
    int phase = 0;
    std::size_t madeWhenDrained = 0;
    std::size_t waitedThen = 0;
    const Outcome outcome = onSlurm([&](pid_t) {
        if (phase == 0 && made() >= 1) {
            drain();
            phase = 1;
        } else if (phase == 1 && tasksIn("RUNNING,COMPLETING") == 0) {
            // What had begun has come to its end, and nothing follows.
            madeWhenDrained = made();
            waitedThen = tasksIn("PENDING");
            resume();
            phase = 2;
        }
    });
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(phase, 2);
    EXPECT_LT(madeWhenDrained, 6u);
    EXPECT_GT(waitedThen, 0u);
    EXPECT_THAT(outcome.err, HasSubstr("6 of 6 worlds submitted"));
    EXPECT_EQ(withoutTimes(outcome.json()), withoutTimes(local()));
    const nlohmann::json list = jobs();
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0]["made"], 6);
    EXPECT_EQ(list[0]["study"], "accuracy");
}

TEST_F(SlurmSweep, WholeANodeThatFailsLosesNothing) {
    bool failed = false;
    const Outcome outcome = onSlurm([&](pid_t) {
        if (!failed && tasksIn("RUNNING") > 0) {
            slurm({"scontrol", "update", "nodename=" + node(), "state=down", "reason=test"});
            resume();
            failed = true;
        }
    });
    EXPECT_TRUE(failed);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(withoutTimes(outcome.json()), withoutTimes(local()));
}

TEST_F(SlurmSweep, ClosingTheProgramStopsNothingAndTheSecondStartFollows) {
    bool told = false;
    const Outcome closed = onSlurm([&](pid_t program) {
        if (!told && tasksIn("RUNNING") > 0) {
            kill(program, SIGINT);
            told = true;
        }
    });
    EXPECT_EQ(closed.exitCode, 3);
    EXPECT_THAT(closed.err, HasSubstr("the job goes on: rubble-cli jobs follow"));
    // Two more of the same: neither submits anything.
    const Outcome detached = onSlurm({}, {"--detach"});
    EXPECT_EQ(detached.exitCode, 0) << detached.err;
    EXPECT_EQ(detached.json()["submitted"], 0);
    EXPECT_THAT(detached.err, HasSubstr("was submitted before"));
    const Outcome second = onSlurm();
    ASSERT_EQ(second.exitCode, 0) << second.err;
    EXPECT_EQ(second.json()["complete"], true);
    const std::string folder = m_folder / ("cache/jobs/" + detached.json()["job"].get<std::string>());
    EXPECT_TRUE(fs::exists(folder + "/array-1.sh"));
    EXPECT_FALSE(fs::exists(folder + "/array-2.sh"));
}

TEST_F(SlurmSweep, WholeACancelledTaskIsLeftAloneUntilItIsAskedForAgain) {
    // One while it runs, one while it waits.
    int cancelled = 0;
    const Outcome outcome = onSlurm([&](pid_t) {
        for (const char* state : {"RUNNING", "PENDING"}) {
            const std::string tasks = slurm({"squeue", "--noheader", "--array", std::string("--states=") + state, "--format=%i"});
            if (cancelled < 2 && !tasks.empty() && (cancelled == 0) == (std::string(state) == "RUNNING")) {
                slurm({"scancel", tasks.substr(0, tasks.find('\n'))});
                ++cancelled;
            }
        }
    });
    EXPECT_EQ(cancelled, 2);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("was not made: cancelled"));
    // Slurm lets a task that runs go on for KillWait: it may have come to its end.
    const std::size_t left = 6 - made();
    EXPECT_TRUE(left == 1 || left == 2) << left;
    EXPECT_EQ(jobs()[0]["failed"].size(), left);
    const Outcome again = onSlurm();
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_THAT(again.err, HasSubstr(std::to_string(left) + " of 6 worlds submitted"));
    EXPECT_EQ(withoutTimes(again.json()), withoutTimes(local()));
}

TEST_F(SlurmSweep, JobsListFollowsAndCancels) {
    drain();
    const Outcome detached = onSlurm({}, {"--detach"});
    ASSERT_EQ(detached.exitCode, 0) << detached.err;
    const std::string id = detached.json()["job"];
    EXPECT_EQ(jobs()[0]["waiting"], 6);
    const std::string cache = m_folder / "cache";
    const Outcome cancelled = cli({"jobs", "cancel", id, "--cache", cache});
    EXPECT_EQ(cancelled.exitCode, 0) << cancelled.err;
    EXPECT_EQ(jobs()[0]["failed"].size(), 6u);
    resume();
    ASSERT_EQ(onSlurm({}, {"--detach"}).json()["submitted"], 6);
    const Outcome followed = cli({"jobs", "follow", "--cache", cache});
    EXPECT_EQ(followed.exitCode, 0) << followed.err;
    EXPECT_THAT(followed.out, HasSubstr(id));
    EXPECT_EQ(made(), 6u);
    EXPECT_THAT(cli({"jobs", "clear", "--cache", cache}).out, HasSubstr(id + " is forgotten"));
    EXPECT_TRUE(jobs().empty());
}

// Somebody's work of a partition that goes first takes both processors: Slurm sends the tasks back to the queue.
TEST_F(SlurmSweep, WholeTasksThatArePreemptedRunAgain) {
    std::string preempted;
    pid_t process = -1;
    bool back = false;
    const Outcome outcome = onSlurm([&](pid_t) {
        if (preempted.empty()) {
            if (const auto now = running()) {
                // Held, since it could come to its end before Slurm looks at the urgent work.
                process = now->process;
                hold(process);
                preempted = now->task;
                slurm({"sbatch", "--partition=urgent", "--cpus-per-task=2", "--output=/dev/null", "--wrap=sleep 2"});
            }
        } else if (!back) {
            if (running(preempted)) {
                hold(process);
            }
            // Slurm lets what it sent back wait for two minutes; nobody needs to here.
            const std::string state = slurm({"squeue", "--noheader", "--array", "--jobs=" + preempted, "--format=%T %r"});
            if (state.starts_with("PENDING")) {
                slurm({"scontrol", "update", "jobid=" + preempted.substr(0, preempted.find('_')), "starttime=now"});
                back = true;
            }
        }
    });
    EXPECT_TRUE(back) << preempted << " was not sent back";
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(withoutTimes(outcome.json()), withoutTimes(local()));
    const nlohmann::json all = tasks();
    for (const nlohmann::json& each : all) {
        EXPECT_EQ(each["attempts"], 1) << "Slurm starts it again by itself";
    }
}

// A process that hangs until the least limit that Slurm knows: a minute.
TEST_F(SlurmSweep, WholeATaskThatRunsOutOfTimeIsGivenTwiceAsMuch) {
    nlohmann::json stopped;
    pid_t process = -1;
    const Outcome outcome = onSlurm([&](pid_t) {
        if (const auto now = running(); process < 0 && now) {
            process = now->process;
            kill(process, SIGSTOP);
            stopped = task("slurm", now->task);
            slurm({"scontrol", "update", "jobid=" + now->task, "timelimit=1"});
        }
        hold(process);
    });
    ASSERT_FALSE(stopped.is_null());
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(withoutTimes(outcome.json()), withoutTimes(local()));
    const nlohmann::json after = task("key", stopped["key"]);
    EXPECT_NE(after["slurm"], stopped["slurm"]);
    EXPECT_EQ(after["attempts"], 2);
    EXPECT_EQ(after["minutes"], 2 * stopped["minutes"].get<int>());
    EXPECT_EQ(after["mebibytes"], stopped["mebibytes"]);
}

// Slurm looks at the memory once a second: the process is held until then.
TEST_F(SlurmSweep, WholeATaskThatRunsOutOfMemoryIsGivenTwiceAsMuch) {
    drain();
    ASSERT_EQ(onSlurm({}, {"--detach"}).exitCode, 0);
    const nlohmann::json first = tasks()[0];
    // Ten mebibytes hold no world.
    slurm({"scontrol", "update", "jobid=" + first["slurm"].get<std::string>(), "minmemorynode=10"});
    pid_t process = -1;
    bool resumed = false;
    const Outcome outcome = onSlurm([&](pid_t) {
        if (!resumed) {
            resumed = true;
            resume();
        }
        if (const auto now = running(first["slurm"]); process < 0 && now) {
            process = now->process;
        }
        // It stays at what Slurm is to find too much.
        if (residentMiB(process) > 20.0) {
            hold(process);
        }
    });
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_GE(process, 0);
    EXPECT_EQ(withoutTimes(outcome.json()), withoutTimes(local()));
    const nlohmann::json after = task("key", first["key"]);
    EXPECT_NE(after["slurm"], first["slurm"]);
    EXPECT_EQ(after["mebibytes"], 2 * first["mebibytes"].get<int>());
    EXPECT_EQ(after["minutes"], first["minutes"]);
}

TEST_F(SlurmSweep, TwoSubmissionsAtOnceAreOne) {
    drain();
    auto beside = std::async(std::launch::async, [this] { return onSlurm({}, {"--detach"}); });
    const Outcome one = onSlurm({}, {"--detach"});
    const Outcome other = beside.get();
    ASSERT_EQ(one.exitCode, 0) << one.err;
    ASSERT_EQ(other.exitCode, 0) << other.err;
    EXPECT_EQ(one.json()["submitted"].get<int>() + other.json()["submitted"].get<int>(), 6);
    EXPECT_EQ(one.json()["job"], other.json()["job"]);
    EXPECT_EQ(tasksIn("PENDING"), 6u);
    resume();
    const Outcome collected = onSlurm();
    ASSERT_EQ(collected.exitCode, 0) << collected.err;
    EXPECT_EQ(withoutTimes(collected.json()), withoutTimes(local()));
}

TEST_F(SlurmSweep, WholeAFullDiskEndsItWithTheReasonAndRoomMendsIt) {
    const std::string worlds = m_folder / "cache/worlds";
    fs::create_directories(worlds);
    ASSERT_EQ(mount("none", worlds.c_str(), "tmpfs", 0, "size=4k"), 0) << "root may mount, or the test cannot fill a disk";
    {
        std::ofstream(worlds + "/full") << std::string(8192, 'x');
    }
    const Outcome full = onSlurm();
    umount(worlds.c_str());
    EXPECT_EQ(full.exitCode, 1);
    EXPECT_THAT(full.err, HasSubstr("was not made: failed"));
    const Outcome again = onSlurm();
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_EQ(withoutTimes(again.json()), withoutTimes(local()));
}

TEST_F(SlurmSweep, WholeAWorldOfSomethingElseIsMadeAnew) {
    ASSERT_EQ(onSlurm().exitCode, 0);
    std::vector<fs::path> worlds;
    for (const auto& entry : fs::directory_iterator(m_folder / "cache/worlds")) {
        worlds.push_back(entry.path());
    }
    // What another build or another study left under this name.
    fs::copy_file(worlds[0], worlds[1], fs::copy_options::overwrite_existing);
    const Outcome again = onSlurm();
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_THAT(again.err, HasSubstr("1 of 6 worlds submitted"));
    EXPECT_EQ(withoutTimes(again.json()), withoutTimes(local()));
}

TEST_F(SlurmSweep, AClusterThatCannotBeReachedIsSaid) {
    const std::string conf = m_folder / "slurm.conf";
    std::string text = textOf(std::getenv("SLURM_CONF"));
    const std::size_t port = text.find("SlurmctldPort=");
    text.replace(port, text.find('\n', port) - port, "SlurmctldPort=1");
    std::ofstream(conf) << text << "MessageTimeout=2\n";
    const Outcome outcome = CommandRun().with("SLURM_CONF", conf).cli(sweep({"--executor", "slurm"}));
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("Slurm"));
    EXPECT_THAT(outcome.err, HasSubstr("sinfo"));
}

}  // namespace

}  // namespace rubble::cli
