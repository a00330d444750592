#pragma once

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace rubble {

/// How far a thread has come, for others to wait for.
class alignas(64) Milestone {
public:
    /// Before any thread looks at it.
    void restart() { m_steps.store(0, std::memory_order_relaxed); }
    void pass(std::uint32_t steps) { m_steps.store(steps, std::memory_order_release); }
    bool reached(std::uint32_t steps) const { return m_steps.load(std::memory_order_acquire) >= steps; }

private:
    std::atomic<std::uint32_t> m_steps{0};
};

/// Waits of one of several threads that work together. Who waits for one that does not run, because others have its core, would
/// wait for each of its steps anew; so once a thread has waited for half of its time, all of them give up.
class Patience {
public:
    /// @param givenUp  of all of them
    explicit Patience(std::atomic<bool>& givenUp) : m_givenUp(givenUp) {}

    /// Returns whether it was reached, before anybody gave up.
    bool await(const Milestone& milestone, std::uint32_t steps);
    bool givenUp() const { return m_givenUp.load(std::memory_order_relaxed); }

private:
    std::atomic<bool>& m_givenUp;
    std::chrono::steady_clock::time_point m_from = std::chrono::steady_clock::now();
    double m_waited = 0.0;  ///< s
};

/// A few threads that share loops. Which thread does which part never reaches a result: parts write to places of their own. Each
/// thread begins with its own share of the parts, the same one of every loop of as many, and finds in its caches what it left
/// there.
class WorkerPool {
public:
    /// @param threads  at least 1, the calling thread included
    explicit WorkerPool(int threads);
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    /// Calls work(first, last) for [0, count) in parts of at most `grain`, in any order on any thread; returns when all are done.
    /// The parts are the same for any number of threads. A single part runs on the calling thread. What a part throws first reaches
    /// the caller when all have ended.
    template <class Work>
    void loop(std::size_t count, std::size_t grain, Work&& work) {
        if (m_workers.empty() || m_alone || count <= grain) {
            for (std::size_t first = 0; first < count; first += grain) {
                work(first, std::min(first + grain, count));
            }
            return;
        }
        share(count, grain, std::function<void(std::size_t, std::size_t)>(std::ref(work)));
    }

    std::size_t threads() const { return m_shares.size(); }
    /// From the next loop on the calling thread does all parts, or no longer. Not while it needs others in together().
    void workAlone(bool alone) { m_alone = alone; }
    /// Calls work(i) for [0, count) at the same time, so that they may wait for each other; returns when all are done.
    /// @param count  at most threads()
    template <class Work>
    void together(std::size_t count, Work&& work) {
        assert(count <= threads());
        assert(count <= 1 || !m_alone);
        // Who has a part takes no other one before it is done, and none is done before the others have begun or need not be waited
        // for.
        loop(count, 1, [&](std::size_t first, std::size_t) { work(first); });
    }

private:
    /// On a line of the cache of its own: one thread changes it while others look at others.
    struct alignas(64) Counter {
        std::atomic<std::uint32_t> count{0};
    };

    void share(std::size_t count, std::size_t grain, std::function<void(std::size_t, std::size_t)> work);
    void takeParts(std::size_t thread);
    void wait(std::size_t thread);
    /// First part of a thread's share.
    std::size_t shareBegin(std::size_t thread) const { return m_parts * thread / m_shares.size(); }

    bool m_alone = false;
    // Of the loop at hand. They stay as they are until the last part that somebody took is done, so who has a part may read them.
    std::function<void(std::size_t, std::size_t)> m_work;
    std::size_t m_count = 0;
    std::size_t m_grain = 1;
    std::size_t m_parts = 0;
    std::atomic<bool> m_failed{false};
    std::exception_ptr m_error;  ///< of the first part that failed
    // On the heap: the pool itself may lie in what is allocated without regard to lines of the cache.
    std::vector<Counter> m_shares;          ///< [threads] parts of each that nobody has
    std::unique_ptr<Counter> m_unfinished;  ///< parts
    std::unique_ptr<Counter> m_round;       ///< grows with every loop
    std::atomic<bool> m_stop{false};
    std::vector<std::thread> m_workers;
};

}  // namespace rubble
