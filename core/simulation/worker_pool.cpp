#include "core/simulation/worker_pool.h"

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

/// Leaves the core's units to others for a moment.
void pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

/// Looks at an atomic before a thread lets others go first, and after that, before it goes to sleep: most loops of a step follow
/// each other within microseconds, and all within some hundred; waking a thread takes longer than most of them.
constexpr int patience = 500;
constexpr int politePatience = 60;

/// Waits until the atomic is no longer `old`.
template <class T>
void waitWhile(const std::atomic<T>& atomic, T old) {
    for (int i = 0; i < patience; ++i) {
        if (atomic.load() != old) {
            return;
        }
        pause();
    }
    for (int i = 0; i < politePatience; ++i) {
        if (atomic.load() != old) {
            return;
        }
        std::this_thread::yield();
    }
    atomic.wait(old);
}

}  // namespace

WorkerPool::WorkerPool(int threads) {
    for (int i = 1; i < threads; ++i) {
        m_workers.emplace_back([this] { wait(); });
    }
}

WorkerPool::~WorkerPool() {
    m_stop = true;
    ++m_round;
    m_round.notify_all();
    for (std::thread& worker : m_workers) {
        worker.join();
    }
}

void WorkerPool::share(std::size_t count, std::size_t grain, std::function<void(std::size_t, std::size_t)> work) {
    m_work = std::move(work);
    m_count = count;
    m_grain = grain;
    m_next.store(0);
    m_busy.store(static_cast<int>(m_workers.size()));
    ++m_round;
    m_round.notify_all();
    takeParts();
    for (int busy = m_busy.load(); busy != 0; busy = m_busy.load()) {
        waitWhile(m_busy, busy);
    }
}

void WorkerPool::takeParts() {
    for (;;) {
        const std::size_t first = m_next.fetch_add(m_grain);
        if (first >= m_count) {
            return;
        }
        m_work(first, std::min(first + m_grain, m_count));
    }
}

void WorkerPool::wait() {
    unsigned seen = 0;
    for (;;) {
        waitWhile(m_round, seen);
        seen = m_round.load();
        if (m_stop) {
            return;
        }
        takeParts();
        if (m_busy.fetch_sub(1) == 1) {
            m_busy.notify_all();
        }
    }
}

}  // namespace rubble
