#include "core/base/execution.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "core/base/error.h"

namespace rubble {

namespace {

constexpr std::int64_t reportIntervalMs = 50;

std::int64_t nowMs() {
    using namespace std::chrono;
    return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Execution::Execution(Listener listener)
    : m_shared(std::make_shared<Shared>()), m_threads(static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))) {
    m_shared->listener = std::move(listener);
}

Execution Execution::withThreads(int threads) const {
    Execution copy = *this;
    copy.m_threads = std::max(1, threads);
    return copy;
}

void Execution::check() const {
    if (cancelled()) {
        throw Cancelled();
    }
}

void Execution::report(const Message& stage, double fraction) const {
    if (m_shared->listener) {
        const std::int64_t now = nowMs();
        const bool edge = fraction <= 0.0 || fraction >= 1.0;
        if (edge || now - m_shared->lastReport.load(std::memory_order_relaxed) >= reportIntervalMs) {
            m_shared->lastReport.store(now, std::memory_order_relaxed);
            m_shared->listener({stage, fraction});
        }
    }
    check();
}

}  // namespace rubble
