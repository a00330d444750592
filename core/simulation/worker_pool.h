#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace rubble {

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
    /// The parts are the same for any number of threads. A single part runs on the calling thread. `work` must not throw.
    template <class Work>
    void loop(std::size_t count, std::size_t grain, Work&& work) {
        if (m_workers.empty() || count <= grain) {
            for (std::size_t first = 0; first < count; first += grain) {
                work(first, std::min(first + grain, count));
            }
            return;
        }
        share(count, grain, std::function<void(std::size_t, std::size_t)>(std::ref(work)));
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

    // Of the loop at hand. They stay as they are until the last part that somebody took is done, so who has a part may read them.
    std::function<void(std::size_t, std::size_t)> m_work;
    std::size_t m_count = 0;
    std::size_t m_grain = 1;
    std::size_t m_parts = 0;
    // On the heap: the pool itself may lie in what is allocated without regard to lines of the cache.
    std::vector<Counter> m_shares;          ///< [threads] parts of each that nobody has
    std::unique_ptr<Counter> m_unfinished;  ///< parts
    std::unique_ptr<Counter> m_round;       ///< grows with every loop
    std::atomic<bool> m_stop{false};
    std::vector<std::thread> m_workers;
};

}  // namespace rubble
