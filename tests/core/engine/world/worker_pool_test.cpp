#include "core/engine/world/worker_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
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

TEST(WorkerPool, WhatAPartThrowsReachesTheCallerWhenAllHaveEnded) {
    for (const int threads : {1, 3}) {
        WorkerPool pool(threads);
        for (int round = 0; round < 50; ++round) {
            std::atomic<int> running{0};
            const auto work = [&](std::size_t first, std::size_t) {
                ++running;
                const bool fails = first % 5 == 3;
                --running;
                if (fails) {
                    throw std::runtime_error("part");
                }
            };
            EXPECT_THROW(pool.loop(40, 1, work), std::runtime_error);
            EXPECT_EQ(running, 0);
            std::atomic<int> done{0};
            pool.loop(40, 1, [&](std::size_t, std::size_t) { ++done; });
            EXPECT_EQ(done, 40) << "the next loop knows nothing of it";
        }
    }
}

TEST(WorkerPool, OneThreadDoesThePartsThatSeveralDo) {
    using Part = std::pair<std::size_t, std::size_t>;
    const auto partsOn = [](int threads, std::size_t count, std::size_t grain) {
        WorkerPool pool(threads);
        std::mutex mutex;
        std::set<Part> parts;
        pool.loop(count, grain, [&](std::size_t first, std::size_t last) {
            const std::lock_guard lock(mutex);
            EXPECT_TRUE(parts.emplace(first, last).second);
        });
        return parts;
    };
    // Who keeps a place for each part by first / grain never finds all of them in one place.
    EXPECT_EQ(partsOn(1, 20, 7), (std::set<Part>{{0, 7}, {7, 14}, {14, 20}}));
    EXPECT_EQ(partsOn(1, 1000, 128), partsOn(3, 1000, 128));
    EXPECT_TRUE(partsOn(1, 0, 7).empty());
}

TEST(WorkerPool, RunsWhatWaitsForEachOtherAtTheSameTimeOrGivesUp) {
    // Each goes on when the others have: in more threads than cores they give up sooner or later, all of them, none for ever.
    for (const int threads : {2, 5}) {
        WorkerPool pool(threads);
        std::vector<Milestone> reached(static_cast<std::size_t>(threads));
        std::vector<std::uint32_t> steps(reached.size(), 0);
        std::atomic<bool> givenUp{false};
        pool.together(reached.size(), [&](std::size_t own) {
            Patience patience(givenUp);
            for (std::uint32_t step = 0; step < 400; ++step) {
                if (!std::ranges::all_of(reached, [&](const Milestone& m) { return patience.await(m, step); })) {
                    return;
                }
                ++steps[own];
                reached[own].pass(step + 1);
            }
        });
        const auto [least, most] = std::minmax_element(steps.begin(), steps.end());
        EXPECT_TRUE(givenUp || *least == 400u);
        EXPECT_LE(*most - *least, 1u) << "nobody goes on without the others";
    }
}

TEST(WorkerPool, GivesUpOnWhoNeverComes) {
    Milestone never;
    std::atomic<bool> givenUp{false};
    Patience patience(givenUp);
    EXPECT_TRUE(patience.await(never, 0));
    EXPECT_FALSE(patience.givenUp());
    EXPECT_FALSE(patience.await(never, 1));
    EXPECT_TRUE(givenUp);
}

}  // namespace
}  // namespace rubble
