#include "core/engine/world/worker_pool.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/base/elapsed.h"

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

/// Looks at a milestone that are not worth a look at the clock.
constexpr int shortWait = 1000;
/// s, that a thread waits for others without giving up, beside half of its time.
constexpr double longestWait = 1e-3;

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

bool Patience::await(const Milestone& milestone, std::uint32_t steps) {
    for (int i = 0; i < shortWait; ++i) {
        if (milestone.reached(steps)) {
            return true;
        }
        pause();
    }
    const auto from = std::chrono::steady_clock::now();
    while (!milestone.reached(steps)) {
        for (int i = 0; i < shortWait / 4; ++i) {
            pause();
        }
        if (m_waited + secondsSince(from) > longestWait + 0.5 * secondsSince(m_from)) {
            m_givenUp.store(true, std::memory_order_relaxed);
        }
        if (givenUp()) {
            return false;
        }
    }
    m_waited += secondsSince(from);
    return true;
}

WorkerPool::WorkerPool(int threads)
    : m_shares(static_cast<std::size_t>(std::max(1, threads))),
      m_unfinished(std::make_unique<Counter>()),
      m_round(std::make_unique<Counter>()) {
    for (std::size_t thread = 1; thread < m_shares.size(); ++thread) {
        m_workers.emplace_back([this, thread] { wait(thread); });
    }
}

WorkerPool::~WorkerPool() {
    m_stop = true;
    ++m_round->count;
    m_round->count.notify_all();
    for (std::thread& worker : m_workers) {
        worker.join();
    }
}

void WorkerPool::share(std::size_t count, std::size_t grain, std::function<void(std::size_t, std::size_t)> work) {
    m_work = std::move(work);
    m_count = count;
    m_grain = grain;
    m_parts = (count + grain - 1) / grain;
    m_unfinished->count.store(static_cast<std::uint32_t>(m_parts));
    for (std::size_t thread = 0; thread < m_shares.size(); ++thread) {
        m_shares[thread].count.store(static_cast<std::uint32_t>(shareBegin(thread + 1) - shareBegin(thread)));
    }
    ++m_round->count;
    m_round->count.notify_all();
    takeParts(0);
    // Only for parts that others have begun; who comes late finds nothing and is not waited for.
    for (std::uint32_t left = m_unfinished->count.load(); left != 0; left = m_unfinished->count.load()) {
        waitWhile(m_unfinished->count, left);
    }
    if (m_failed.exchange(false)) {
        std::rethrow_exception(std::exchange(m_error, nullptr));
    }
}

void WorkerPool::takeParts(std::size_t thread) {
    // The own share first, then what others have not got to.
    for (std::size_t k = 0; k < m_shares.size(); ++k) {
        const std::size_t whose = (thread + k) % m_shares.size();
        std::atomic<std::uint32_t>& share = m_shares[whose].count;
        std::uint32_t untaken = share.load();
        while (untaken != 0) {
            if (!share.compare_exchange_weak(untaken, untaken - 1)) {
                continue;
            }
            const std::size_t first = (shareBegin(whose + 1) - untaken) * m_grain;
            try {
                m_work(first, std::min(first + m_grain, m_count));
            } catch (...) {
                if (!m_failed.exchange(true)) {
                    m_error = std::current_exception();
                }
            }
            if (m_unfinished->count.fetch_sub(1) == 1) {
                m_unfinished->count.notify_all();
            }
            untaken = share.load();
        }
    }
}

void WorkerPool::wait(std::size_t thread) {
    std::uint32_t seen = 0;
    for (;;) {
        waitWhile(m_round->count, seen);
        seen = m_round->count.load();
        if (m_stop) {
            return;
        }
        takeParts(thread);
    }
}

}  // namespace rubble
