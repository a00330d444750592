#include "core/analysis/accuracy/machine_load.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>

namespace rubble {
namespace {

using Clock = std::chrono::steady_clock;

/// Works on one processor for so long.
void work(double seconds) {
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    volatile double number = 1.0;
    while (Clock::now() < end) {
        number = std::sqrt(number + 1.0);
    }
}

TEST(MachineLoad, IsAShareAndKnowsNothingAtOnce) {
    const MachineLoad load;
    EXPECT_TRUE(std::isnan(load.othersShare()));
    work(0.4);
    EXPECT_GE(load.othersShare(), 0.0);
    EXPECT_LE(load.othersShare(), 1.0);
}

// Whatever else goes on: a program beside this one that takes what it gets shows as others, and more so than its absence.
TEST(MachineLoad, SeesAnotherProgramAtWork) {
    const pid_t child = fork();
    if (child == 0) {
        work(30.0);
        _exit(0);
    }
    const MachineLoad load;
    usleep(600000);
    const double share = load.othersShare();
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    // One processor of all, or what the scheduler leaves of it: at least a quarter of one.
    EXPECT_GT(share, 0.25 / static_cast<double>(sysconf(_SC_NPROCESSORS_ONLN)));
}

}  // namespace
}  // namespace rubble
