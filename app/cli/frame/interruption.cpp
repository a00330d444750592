#include "app/cli/frame/interruption.h"

#include <csignal>

#include <atomic>
#include <cassert>

namespace rubble::cli {

namespace {

std::atomic<const Execution*> executionToCancel{nullptr};
static_assert(std::atomic<const Execution*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

void cancelOnSignal(int signal) {
    if (const Execution* execution = executionToCancel.load()) {
        execution->cancel();
    }
    // Whoever asks twice does not want to wait for the current step.
    std::signal(signal, SIG_DFL);
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
    handle(SIG_DFL);
    executionToCancel.store(nullptr);
}

}  // namespace rubble::cli
