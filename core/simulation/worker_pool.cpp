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

/// Looks at an atomic before a thread goes to sleep: most loops of a step follow each other within microseconds, and waking a
/// thread takes longer than most of them. No thread lets others go first: on a machine with other work it would get its core back
/// milliseconds later.
constexpr int patience = 20000;

/// Waits until the atomic is no longer `old`.
template <class T>
void waitWhile(const std::atomic<T>& atomic, T old) {
    for (int i = 0; i < patience; ++i) {
        if (atomic.load() != old) {
            return;
        }
        pause();
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
    const auto parts = static_cast<std::uint32_t>((count + grain - 1) / grain);
    m_unfinished.store(parts);
    m_untaken.store(parts);
    ++m_round;
    m_round.notify_all();
    takeParts();
    // Only for parts that others have begun; who comes late finds nothing and is not waited for.
    for (std::uint32_t left = m_unfinished.load(); left != 0; left = m_unfinished.load()) {
        waitWhile(m_unfinished, left);
    }
}

void WorkerPool::takeParts() {
    std::uint32_t untaken = m_untaken.load();
    while (untaken != 0) {
        if (!m_untaken.compare_exchange_weak(untaken, untaken - 1)) {
            continue;
        }
        const std::size_t parts = (m_count + m_grain - 1) / m_grain;
        const std::size_t first = (parts - untaken) * m_grain;
        m_work(first, std::min(first + m_grain, m_count));
        if (m_unfinished.fetch_sub(1) == 1) {
            m_unfinished.notify_all();
        }
        untaken = m_untaken.load();
    }
}

void WorkerPool::wait() {
    std::uint32_t seen = 0;
    for (;;) {
        waitWhile(m_round, seen);
        seen = m_round.load();
        if (m_stop) {
            return;
        }
        takeParts();
    }
}

}  // namespace rubble
