#include "app/cli/frame/interruption.h"

#include <csignal>
#include <ctime>

#include <unistd.h>

#include <atomic>
#include <cassert>
#include <cstdint>

namespace rubble::cli {

namespace {

std::atomic<const Execution*> executionToCancel{nullptr};
static_assert(std::atomic<const Execution*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

// Seconds without work after which a program that was told to end counts as one that waits, for a file that never opens.
constexpr int mostIdle = 3;
constexpr std::int64_t leastWork = 5'000'000;  // ns of processor time a second

std::atomic<std::int64_t> workBefore{0};
std::atomic<int> idleSeconds{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

std::int64_t processorTime() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

// Once a second: whoever works goes on to where it looks at the cancellation, whoever waits would never get there.
void endIfIdle(int) {
    const std::int64_t work = processorTime();
    idleSeconds.store(work - workBefore.exchange(work) < leastWork ? idleSeconds.load() + 1 : 0);
    if (idleSeconds.load() >= mostIdle) {
        std::signal(SIGTERM, SIG_DFL);
        raise(SIGTERM);
    }
    alarm(1);
}

void cancelOnSignal(int signal) {
    if (const Execution* execution = executionToCancel.load()) {
        execution->cancel();
    }
    // Whoever asks twice does not want to wait for the current step.
    std::signal(signal, SIG_DFL);
    workBefore.store(processorTime());
    idleSeconds.store(0);
    std::signal(SIGALRM, endIfIdle);
    alarm(1);
}

void handle(void (*handler)(int)) {
    struct sigaction action{};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

Interruption::Interruption(const Execution& execution) {
    assert(executionToCancel.load() == nullptr);
    executionToCancel.store(&execution);
    handle(cancelOnSignal);
}

Interruption::~Interruption() {
    alarm(0);
    handle(SIG_DFL);
    executionToCancel.store(nullptr);
}

}  // namespace rubble::cli
