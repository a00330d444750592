#include "core/simulation/worker_pool.h"

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

/// Looks at an atomic before a thread goes to sleep: loops follow each other within microseconds.
constexpr int patience = 4000;

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
    for (int i = 0; m_busy.load() != 0; ++i) {
        if (i >= patience) {
            const int busy = m_busy.load();
            if (busy != 0) {
                m_busy.wait(busy);
            }
        }
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
        for (int i = 0; i < patience && m_round.load() == seen; ++i) {
        }
        m_round.wait(seen);
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
