#include "core/simulation/worker_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace rubble {
namespace {

TEST(WorkerPool, DoesEveryPartOnceWhoeverComesLate) {
    // More threads than cores, so that some come when the loop they were called for is over.
    WorkerPool pool(7);
    std::vector<int> done(997);
    for (int round = 0; round < 3000; ++round) {
        const std::size_t count = 1 + static_cast<std::size_t>(round * 31 % 997);
        const std::size_t grain = 1 + static_cast<std::size_t>(round % 13);
        std::fill(done.begin(), done.end(), 0);
        pool.loop(count, grain, [&](std::size_t first, std::size_t last) {
            EXPECT_LE(last - first, grain);
            for (std::size_t i = first; i < last; ++i) {
                ++done[i];
            }
        });
        ASSERT_EQ(std::count(done.begin(), done.begin() + static_cast<std::ptrdiff_t>(count), 1),
                  static_cast<std::ptrdiff_t>(count))
            << round;
        ASSERT_EQ(std::count(done.begin() + static_cast<std::ptrdiff_t>(count), done.end(), 0),
                  static_cast<std::ptrdiff_t>(done.size() - count));
    }
}

TEST(WorkerPool, WaitsForPartsThatOthersHaveBegun) {
    WorkerPool pool(3);
    std::atomic<int> finished{0};
    for (int round = 0; round < 20; ++round) {
        finished = 0;
        pool.loop(6, 1, [&](std::size_t, std::size_t) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            ++finished;
        });
        ASSERT_EQ(finished.load(), 6);
    }
}

TEST(WorkerPool, OneThreadNeedsNoOther) {
    WorkerPool pool(1);
    std::size_t sum = 0;
    pool.loop(100, 7, [&](std::size_t first, std::size_t last) { sum += last - first; });
    EXPECT_EQ(sum, 100u);
    pool.loop(0, 7, [&](std::size_t, std::size_t) { sum = 0; });
    EXPECT_EQ(sum, 100u);
}

}  // namespace
}  // namespace rubble
